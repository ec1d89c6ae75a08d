#pragma once
/// \file
/// What linkages need and keep clear of, in all poses of a fine scan: for tests of rooms and regions.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <nlohmann/json.hpp>
#include <numbers>
#include <string>
#include <vector>

#include "synthesis/document/document.h"
#include "synthesis/mechanism/drawing/motion_row.h"
#include "synthesis/problem/reader.h"
#include "synthesis/program/assess.h"
#include "synthesis/report/drawing/finished.h"
#include "tests/checked.h"
#include "tests/mechanism/linkage_texts.h"

namespace mechwright::linkage_scans {

using Json = nlohmann::ordered_json;
using testing::count_of_stated;
using testing::expect_verified;
using testing::is_refused;
using Places = std::vector<Vector<double>>;

inline constexpr double one_degree = std::numbers::pi / 180;

/// A crank-rocker with a coupler point.
inline const std::string rocking_room = testing::head + R"(
[dimensions]
ground = 5
crank = 2
coupler = 4.5
rocker = 4
along = 2.5
across = 3
[placement]
origin-x = 1
origin-y = -2
tilt = 20
[links]
frame = { A = [0, 0], D = ["ground", 0] }
crank = { A = [0, 0], B = ["crank", 0] }
coupler = { B = [0, 0], C = ["coupler", 0], P = ["along", "across"] }
rocker = { D = [0, 0], C = ["rocker", 0] }
[drive]
link = "crank"
)";

struct AnalysedRoom {
    Json document;
    FinishedDesign design;
};

inline AnalysedRoom analysed_room(const std::string& text) {
    const ReadProblem read = testing::read_without_fault(text);
    if (!read.ok()) return {};
    const Solution solution = evaluate_given(read.problem);
    return {analysis_document(read.problem, solution), finished_design(read.problem, solution.design)};
}

inline double value_in(const Json& document, const std::string& quantity) {
    EXPECT_TRUE(document["quantities"].contains(quantity)) << quantity;
    return document["quantities"].value(quantity, std::numeric_limits<double>::quiet_NaN());
}

/// Positions of all its points at many crank angles of the motion.
struct ScannedRoom {
    std::vector<std::vector<Vector<double>>> poses{};

    ScannedRoom(const FinishedDesign& design, const std::vector<std::string>& points, int steps) {
        for (int i = 0; i <= steps; ++i) {
            const double at =
                design.motion.from + (design.motion.to - design.motion.from) * i / static_cast<double>(steps);
            const MotionRow row(design, at);
            if (!row.assembled()) continue;
            poses.emplace_back();
            for (const std::string& point : points)
                poses.back().push_back(row.vector(point));
        }
    }
    double least(const std::function<double(const Places&)>& of) const {
        double least = std::numeric_limits<double>::infinity();
        for (const Places& pose : poses)
            least = std::min(least, of(pose));
        return least;
    }
};

inline double along_way(const Vector<double>& at, double degrees) {
    return at.x * std::cos(degrees * one_degree) + at.y * std::sin(degrees * one_degree);
}

/// A segment from a to b keeps from a place by so much.
inline double from_segment(const Vector<double>& at, const Vector<double>& a, const Vector<double>& b) {
    const Vector<double> side = b - a, way = at - a;
    const double along = std::clamp(dot(side, way) / dot(side, side), 0.0, 1.0);
    const Vector<double> from = way - along * side;
    return std::hypot(from.x, from.y);
}

/// The least distance of two outlines that do not overlap.
inline double between_outlines(const Places& a, const Places& b) {
    double least = std::numeric_limits<double>::infinity();
    for (const auto& [one, other] : {std::pair(&a, &b), {&b, &a}})
        for (const Vector<double>& at : *one)
            for (std::size_t i = 0; i < other->size(); ++i) {
                const Vector<double>&from = (*other)[i], &to = (*other)[(i + 1) % other->size()];
                const bool point = other->size() == 1;
                least = std::min(least, point ? std::hypot(at.x - from.x, at.y - from.y) : from_segment(at, from, to));
            }
    return least;
}

/// A document that states one of these quantities by a ten millionth too great is refused.
inline void expect_refused_if_off(const Json& document, const std::vector<std::string>& quantities) {
    for (const std::string& quantity : quantities) {
        Json changed = document;
        changed["quantities"][quantity] = value_in(document, quantity) * (1 + 1e-7);
        EXPECT_TRUE(is_refused(changed)) << quantity;
    }
}

/// Derivatives of quantities by differences with two steps, so that what is left of these is 1e-9.
inline void expect_room_slopes(const std::string& text, const std::vector<std::string>& names) {
    const ReadProblem read = testing::read_without_fault(text);
    ASSERT_TRUE(read.ok());
    const Mechanism& m = *read.problem.mechanism;
    std::vector<double> arguments;
    for (const DimensionRange& range : read.problem.dimensions)
        arguments.push_back(range.start.value_or(range.min));
    const Solution solution = evaluate_given(read.problem);
    Motion motion = finished_design(read.problem, solution.design).motion;
    for (const std::string& name : names) {
        const Quantity& quantity = m.quantities[static_cast<std::size_t>(find_quantity(m, name))];
        motion.model = m.model.data();
        motion.of = quantity.of.data();
        const std::size_t n = arguments.size(), count = quantity.components(motion);
        std::vector<double> value(count), gradient(count * n), moved(count);
        quantity.measure(motion, arguments, {value, gradient, {}});
        for (std::size_t i = 0; i < n; ++i) {
            const double here = arguments[i];
            const auto at = [&](double h) {
                arguments[i] = here + h;
                quantity.measure(motion, arguments, {moved, {}, {}});
                arguments[i] = here;
                return moved[0];
            };
            constexpr double h = 2e-3;
            const double once = (at(h) - at(-h)) / (2 * h), twice = (at(2 * h) - at(-2 * h)) / (4 * h),
                         thrice = (at(3 * h) - at(-3 * h)) / (6 * h);
            EXPECT_NEAR(gradient[i], 1.5 * once - 0.6 * twice + 0.1 * thrice, 1e-9)
                << name << " by " << m.dimensions[i].name;
        }
        testing::expect_slopes(m, quantity, motion, arguments);
    }
}

}  // namespace mechwright::linkage_scans

#pragma once
/// \file
/// What tests of linkages with targets share: a four-bar that is described by its links, and slopes against
/// differences.

#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <span>
#include <string>
#include <vector>

#include "synthesis/document/document.h"
#include "synthesis/problem/reader.h"
#include "synthesis/program/assess.h"
#include "synthesis/verify/verify.h"

namespace mechwright::testing {

inline const std::string four_bar_links = R"(
[links]
frame = { A = [0, 0], D = ["ground", 0] }
crank = { A = [0, 0], B = ["crank", 0] }
coupler = { B = [0, 0], C = ["coupler", 0], P = ["along", "across"] }
rocker = { D = [0, 0], C = ["rocker", 0] }
[drive]
link = "crank"
[assembly]
C = "either"
)";

inline const std::string head = "schema = 1\nmechanism = \"linkage\"\n";

inline const std::string free_four_bar = head + R"(
[dimensions]
ground = { min = 1, max = 10 }
crank = { min = 0.5, max = 10 }
coupler = { min = 1, max = 10 }
rocker = { min = 1, max = 10 }
along = { min = -10, max = 10 }
across = { min = -10, max = 10 }
[placement]
origin-x = { min = -10, max = 10 }
origin-y = { min = -10, max = 10 }
tilt = { min = 0, max = 360 }
)" + four_bar_links;

inline ReadProblem read_without_fault(const std::string& text) {
    ReadProblem read = parse_problem(text, "linkage.toml");
    for (const Message& message : read.messages)
        ADD_FAILURE() << to_string(message);
    return read;
}

struct KnownQuantity {
    std::string name;
    double value;
    double size = 1;  ///< of what the tolerance is a part
};

/// Quantities of a linkage of given dimensions, whose document verifies.
inline void expect_quantities(std::string text, const std::vector<KnownQuantity>& known, double tolerance) {
    for (const KnownQuantity& quantity : known)
        text += "\n[[require]]\nquantity = \"" + quantity.name + "\"\nmin = -1e9\n";
    const ReadProblem read = read_without_fault(text);
    if (!read.ok()) return;
    const Solution solution = evaluate_given(read.problem);
    EXPECT_TRUE(solution.feasible);
    const nlohmann::ordered_json document = analysis_document(read.problem, solution);
    for (const KnownQuantity& quantity : known) {
        ASSERT_TRUE(document["quantities"].contains(quantity.name)) << quantity.name;
        EXPECT_NEAR(document["quantities"][quantity.name].get<double>(), quantity.value, tolerance * quantity.size)
            << quantity.name;
    }
    for (const Check& check : verify(document))
        EXPECT_TRUE(check.passed) << check.name << ": " << check.detail;
}

/// One of a list of numbers, or of a triangle's.
inline void expect_near(std::span<const double> a, std::span<const double> b, double within, const char* what) {
    for (std::size_t i = 0; i < a.size(); ++i)
        EXPECT_NEAR(a[i], b[i], within * (1 + std::abs(b[i]))) << what << ' ' << i;
}

inline std::string first_error(const std::string& text) {
    const ReadProblem read = parse_problem(text, "linkage.toml");
    for (const Message& message : read.messages)
        if (!message.warning) return message.text;
    return {};
}

/// The derivatives of a quantity over a motion by its arguments against differences of these.
inline void expect_slopes(const Mechanism& m, const Quantity& quantity, Motion motion, std::vector<double> arguments) {
    const std::size_t n = arguments.size(), pairs = n * (n + 1) / 2;
    motion.model = m.model.data();
    motion.of = quantity.of.data();
    const std::size_t count = quantity.components(motion);
    const auto values = [&] {
        std::vector<double> value(count);
        quantity.measure(motion, arguments, {value, {}, {}});
        return value;
    };
    const auto slopes = [&] {
        std::vector<double> value(count), gradient(count * n);
        quantity.measure(motion, arguments, {value, gradient, {}});
        return gradient;
    };
    std::vector<double> value(count), gradient(count * n), hessian(count * pairs);
    quantity.measure(motion, arguments, {value, gradient, hessian});
    expect_near(gradient, slopes(), 1e-12, quantity.name.c_str());
    for (std::size_t i = 0; i < n; ++i) {
        constexpr double h = 1e-5;
        const double here = arguments[i];
        arguments[i] = here + h;
        const auto above = values(), steeper = slopes();
        arguments[i] = here - h;
        const auto below = values(), flatter = slopes();
        arguments[i] = here;
        for (std::size_t k = 0; k < count; ++k) {
            EXPECT_NEAR(gradient[k * n + i], (above[k] - below[k]) / (2 * h), 1e-7)
                << quantity.name << ' ' << k << " by " << i;
            for (std::size_t j = 0; j <= i; ++j)
                EXPECT_NEAR(hessian[k * pairs + i * (i + 1) / 2 + j],
                            (steeper[k * n + j] - flatter[k * n + j]) / (2 * h), 1e-6)
                    << quantity.name << ' ' << k << " by " << i << ", " << j;
        }
    }
}

}  // namespace mechwright::testing

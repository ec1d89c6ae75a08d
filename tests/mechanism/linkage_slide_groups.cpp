// Links that are placed together while a slide drives them, against the inverse motion in closed form: where a leg
// stands, the platform follows by intersected circles, and the slide from a quadratic equation.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>
#include <string>
#include <vector>

#include "synthesis/document/document.h"
#include "synthesis/problem/reader.h"
#include "synthesis/program/assess.h"
#include "synthesis/program/quantity_value.h"
#include "synthesis/verify/verify.h"
#include "tests/mechanism/linkage_known.h"
#include "tests/mechanism/linkage_texts.h"

namespace mechwright {

namespace {

constexpr double group_degree = std::numbers::pi / 180;

/// A platform on two legs, of 2 each, pushed by a rod from a block that slides from (1.2, 2) in a direction of 30
/// degrees.
struct PushedPlatform {
    Vector<double> p, q, r;
    double turn;

    explicit PushedPlatform(double leg) {
        p = {2 * std::cos(leg), 2 * std::sin(leg)};
        const Vector<double> base = Vector<double>{2.5, 0} - p;
        const double apart = std::hypot(base.x, base.y), up = std::sqrt(4 - apart * apart / 4);
        q = p + 0.5 * base + up / apart * Vector<double>{-base.y, base.x};
        turn = std::atan2(q.y - p.y, q.x - p.x);
        r = p + Vector<double>{std::cos(turn) + 1.5 * std::sin(turn), std::sin(turn) - 1.5 * std::cos(turn)};
    }
    /// The displacement of a block whose rod has a length, on the side nearer to `near`.
    double displacement(double rod, double near) const {
        const Vector<double> along{std::cos(30 * group_degree), std::sin(30 * group_degree)},
            away = r - Vector<double>{1.2, 2};
        const double middle = dot(away, along), height = cross(along, away),
                     half = std::sqrt(rod * rod - height * height);
        return std::abs(middle - half - near) < std::abs(middle + half - near) ? middle - half : middle + half;
    }
};

TEST(SlideDrivenGroups, ABlockPushesAPlatformOnThreeLegs) {
    const double at_start = 0.3, leg = 70 * group_degree;
    const PushedPlatform start(leg);
    const Vector<double> block{1.2 + at_start * std::cos(30 * group_degree),
                               2 + at_start * std::sin(30 * group_degree)};
    const double rod = std::hypot(start.r.x - block.x, start.r.y - block.y);
    std::string text = fmt::format(R"(
schema = 1
mechanism = "linkage"
[dimensions]
rod = {:.17g}
[links]
frame = {{ A = [0, 0], B = [2.5, 0] }}
block = {{ C = [0, 0] }}
left = {{ A = [0, 0], P = [2, 0] }}
platform = {{ P = [0, 0], Q = [2, 0], R = [1, -1.5] }}
right = {{ B = [0, 0], Q = [2, 0] }}
rod = {{ C = [0, 0], R = ["rod", 0] }}
[[slide]]
name = "ram"
link = "block"
on = "frame"
point = [1.2, 2]
direction = 30
[drive]
slide = "ram"
[sketch]
crank = {:.17g}
points = {{ P = [{:.6f}, {:.6f}], Q = [{:.6f}, {:.6f}], R = [{:.6f}, {:.6f}] }}
[signals]
left = {{ angle = "left" }}
swing = {{ angle = "platform" }}
)",
                                   rod, at_start, start.p.x, start.p.y, start.q.x, start.q.y, start.r.x, start.r.y);
    std::vector<known_linkages::KnownQuantity> known;
    for (const double more : {-3., -1., 0., 2.}) {
        const PushedPlatform there(leg + more * group_degree);
        const double at = there.displacement(rod, at_start);
        known.push_back({fmt::format("left.at({:.17g})", at), 70 + more});
        known.push_back({fmt::format("swing.at({:.17g})", at), there.turn / group_degree});
    }
    // By differences of the inverse motion: degrees of the leg for a unit of displacement.
    constexpr double h = 1e-5;
    known.push_back(
        {fmt::format("left.speed.at({:.17g})", at_start), 2 * h /
                                                              (PushedPlatform(leg + h).displacement(rod, at_start) -
                                                               PushedPlatform(leg - h).displacement(rod, at_start))});
    for (const auto& quantity : known)
        text += "\n[[require]]\nquantity = \"" + quantity.name + "\"\nmin = -1e9\n";
    const ReadProblem read = testing::read_without_fault(text);
    ASSERT_TRUE(read.ok());
    const Solution solution = evaluate_given(read.problem);
    EXPECT_TRUE(solution.feasible);
    const nlohmann::ordered_json document = analysis_document(read.problem, solution);
    for (std::size_t i = 0; i < known.size(); ++i)
        EXPECT_NEAR(document["quantities"][known[i].name].get<double>(), known[i].value,
                    i + 1 < known.size() ? 1e-11 : 1e-8)
            << known[i].name;
    // It moves between dead points, where the leg turns back.
    const Motion motion = motion_of(read.problem, solution.design);
    EXPECT_FALSE(motion.full_turn);
    for (const Check& check : verify(document))
        EXPECT_TRUE(check.passed) << check.name << ": " << check.detail;
}

}  // namespace

}  // namespace mechwright

// Targets of a path in any order that are nearest to the end of a motion that is no full turn: they are met where it is
// sure where the point is, a little before that end.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "analysis/four_bar.h"
#include "synthesis/document/document.h"
#include "synthesis/problem/reader.h"
#include "synthesis/solve/solve.h"
#include "synthesis/verify/verify.h"

namespace mechwright::test {
namespace {

using Json = nlohmann::ordered_json;

const FourBar<double> triple_rocker{2.477, 2.211, 3.502, 1.555};
const CouplerPoint<double> guided{3.183, -4.17};

Vector<double> point_at(double crank_angle) {
    return position(triple_rocker, guided, pose(triple_rocker, crank_angle, Assembly::open));
}

/// Places straight on from both ends of the path, and one beside its middle.
Json solved() {
    const CrankRange<double> range = assembled_range(triple_rocker);
    const auto beyond = [](double end, double inside) {
        const Vector<double> last = point_at(end), way = last - point_at(inside);
        return last + 0.5 / std::hypot(way.x, way.y) * way;
    };
    const Vector<double> first = beyond(range.from + 1e-12, range.from + 1e-4),
                         last = beyond(range.to - 1e-12, range.to - 1e-4), middle = point_at(3.0);
    const ReadProblem read = parse_problem(
        fmt::format("schema = 1\nmechanism = \"four-bar\"\n[dimensions]\nground = 2.477\ncrank = 2.211\n"
                    "coupler = 3.502\nrocker = 1.555\npoint-along = 3.183\npoint-across = -4.17\norigin-x = 0\n"
                    "origin-y = 0\ntilt = 0\nassembly = \"open\"\n[path]\ntiming = \"none\"\n"
                    "points = [[{:.17g}, {:.17g}], [{:.17g}, {:.17g}], [{:.17g}, {:.17g}]]\n"
                    "[[require]]\nquantity = \"path-rms\"\nmax = 1\n",
                    first.x, first.y, middle.x + 0.01, middle.y, last.x, last.y),
        "ends.toml");
    EXPECT_TRUE(read.ok());
    return mechwright::document(read.problem, solve(read.problem, {}));
}

bool passes_all(const std::vector<Check>& checks) {
    return std::all_of(checks.begin(), checks.end(), [](const Check& check) { return check.passed; });
}

TEST(NearestAtLimits, AreMetWhereItIsSureWhereThePointIs) {
    const Json document = solved();
    EXPECT_EQ(document["status"], "solved") << document.dump(1);
    const CrankRange<double> range = assembled_range(triple_rocker);
    const double degree = std::acos(-1.0) / 180;
    const Json& path = document["path"];
    for (const std::size_t i : {0u, 2u}) {
        const double at = path["crank_angles"][i].get<double>() * degree, end = i == 0 ? range.from : range.to;
        const double way = i == 0 ? at - end : end - at;
        EXPECT_GT(way, 0);
        EXPECT_LT(way, 1e-8);
        // The point of the limit itself is nearer by the root of the way.
        EXPECT_NEAR(path["distances"][i].get<double>(), 0.5, 1e-4);
        EXPECT_GT(path["distances"][i].get<double>(), 0.5);
    }
    EXPECT_TRUE(passes_all(verify(document)));
}

/// What counts by a place that is not so close to the limit is refused.
TEST(NearestAtLimits, AreNotMetAnywhereElse) {
    Json document = solved();
    Json& path = document["path"];
    const double degree = std::acos(-1.0) / 180;
    const double inside = path["crank_angles"][0].get<double>() + 1e-3;
    const Vector<double> there = point_at(inside * degree), target{path["points"][0][0], path["points"][0][1]};
    path["crank_angles"][0] = inside;
    path["reached"][0] = {there.x, there.y};
    path["distances"][0] = std::hypot(there.x - target.x, there.y - target.y);
    bool refused = false;
    for (const Check& check : verify(document))
        refused = refused || (!check.passed && check.name == "every point counts by the nearest point of the curve");
    EXPECT_TRUE(refused);
}

}  // namespace
}  // namespace mechwright::test

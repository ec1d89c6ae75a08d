// Placement, size and guided point of a start, fitted to a path: a design that only these part from one whose point
// meets the path exactly becomes that one.

#include <gtest/gtest.h>

#include <numbers>

#include "synthesis/problem/reader.h"
#include "synthesis/search/starts.h"
#include "synthesis/target/path/fit.h"

namespace mechwright {

namespace {

using std::numbers::pi;

/// The problem of a path with prescribed crank angles through which the guided point of a design goes.
Problem through_points_of(const std::string& mechanism, const std::vector<double>& design, const std::string& ranges) {
    std::string points, angles;
    const Mechanism& m = *find_mechanism(mechanism);
    for (int k = 0; k < 6; ++k) {
        PathMiss miss{};
        m.point->miss(m.form(0), design, k * pi / 6, {0, 0}, miss);
        points += (k ? ", [" : "[") + std::to_string(-miss.miss.x) + ", " + std::to_string(-miss.miss.y) + "]";
        angles += (k ? ", " : "") + std::to_string(30 * k);
    }
    const ReadProblem read = parse_problem(
        "schema = 1\nmechanism = \"" + mechanism + "\"\n[dimensions]\n" + ranges + "[path]\npoints = [" + points +
            "]\ntiming = \"prescribed\"\ncrank_angles = [" + angles + "]\n[objective]\nminimize = \"path-sse\"\n",
        "path.toml");
    for (const Message& message : read.messages)
        ADD_FAILURE() << to_string(message);
    return read.problem;
}

/// The design that a start with other numbers is fitted to; points are written with six digits.
void expect_fitted(const Problem& problem, const std::vector<double>& design, const std::vector<double>& start) {
    const Program program = build_program(problem, variants(problem).front());
    Design from;
    from.dimensions = start;
    Eigen::VectorXd x = point_of(program, from);
    fit_placement(program, x);
    const Design fitted = design_at(program, x);
    for (std::size_t i = 0; i < design.size(); ++i)
        EXPECT_NEAR(fitted.dimensions[i], design[i], 2e-5) << problem.mechanism->dimensions[i].name;
}

const std::string placement =
    "point-along = { min = -99, max = 99 }\npoint-across = { min = -99, max = 99 }\norigin-x = { min = -99, max = 99 "
    "}\norigin-y = { min = -99, max = 99 }\ntilt = { min = -180, max = 180 }\n";

/// Dimensions of a mechanism, after which problems of a timed path have crank-start.
std::vector<double> design_of(std::vector<double> dimensions) {
    dimensions.push_back(0);
    return dimensions;
}

/// Links of another size, `links` of them, without a placement of its own.
std::vector<double> moved(std::vector<double> design, std::size_t links, double size) {
    for (std::size_t i = 0; i < links + 5; ++i)
        design[i] *= i < links ? size : 0;
    return design;
}

constexpr const char* free_links = "crank = { min = 1, max = 99 }\nrod = { min = 1, max = 199 }\n";

TEST(Placement, OfASliderCrankScalesItsOffset) {
    const auto design = design_of({10, 40, 6, 15, 7, 3, -8, 0.4});
    const Problem problem = through_points_of(
        "slider-crank", design, free_links + std::string("offset = { min = -50, max = 50 }\n") + placement);
    expect_fitted(problem, design, moved(design, 3, 0.5));
}

TEST(Placement, OfAnOffsetThatIsGivenKeepsTheSize) {
    auto design = design_of({10, 40, 6, 15, 7, 3, -8, 0});
    const Problem problem =
        through_points_of("slider-crank", design, free_links + std::string("offset = 6\n") + placement);
    expect_fitted(problem, design, moved(design, 3, 1));
}

TEST(Placement, OfAFourBarIsFound) {
    const auto design = design_of({40, 10, 30, 35, 15, 7, 3, -8, 0.4});
    const Problem problem = through_points_of("four-bar", design,
                                              "ground = { min = 1, max = 99 }\ncrank = { min = 1, max = 99 }\ncoupler "
                                              "= { min = 1, max = 99 }\nrocker = { min = 1, max = 99 }\n" +
                                                  placement);
    expect_fitted(problem, design, moved(design, 4, 0.5));
}

}  // namespace

}  // namespace mechwright

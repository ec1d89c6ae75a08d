// A task in another unit is the same task: all lengths times a number that is no power of two, the answer times that
// number.

#include <cmath>
#include <string>

#include "tests/known_optima/solved.h"
#include "tests/long_form.h"

namespace mechwright {

namespace {

using testing::shipped;

/// How a number of this unit grows when all lengths grow.
double grown(Unit unit, double size) {
    switch (unit) {
        case Unit::length:
        case Unit::force: return size;
        case Unit::area:
        case Unit::torque: return size * size;
        case Unit::curvature: return 1 / size;
        case Unit::none:
        case Unit::rate:
        case Unit::angle: break;
    }
    return 1;
}

Problem scaled(Problem problem, double size) {
    const Mechanism& mechanism = *problem.mechanism;
    for (std::size_t i = 0; i < problem.dimensions.size(); ++i) {
        if (!scales(mechanism.dimensions[i].kind)) continue;
        DimensionRange& range = problem.dimensions[i];
        range.tie.constant *= size;
        range.min *= size;
        range.max *= size;
        if (range.start) *range.start *= size;
    }
    for (Requirement& r : problem.requirements)
        for (std::optional<double>* limit : {&r.equal, &r.min, &r.max})
            if (*limit) **limit *= grown(mechanism.quantities[r.quantity].unit, size);
    // Of several terms each stays as great as it was.
    if (problem.objective && problem.objective->terms.size() > 1)
        for (ObjectiveTerm& term : problem.objective->terms)
            term.weight /= grown(mechanism.quantities[term.quantity].unit, size);
    if (problem.path) {
        for (Vector<double>& point : problem.path->points)
            point = size * point;
        problem.path->body_length *= size;
    }
    return problem;
}

TEST(ScaledTasks, HaveTheSameAnswer) {
    RunOptions options;
    options.jobs = 2;
    for (const auto& [folder, file] : {std::pair{"path", "case-2.toml"},
                                       {"path", "case-4-margin.toml"},
                                       {"poses", "tipper.toml"},
                                       {"line", "lambda-120.toml"},
                                       {"function", "ram-square.toml"},
                                       {"four-bar", "crank-rocker-compact.toml"},
                                       {"quick-return", "slider-crank-compact.toml"}}) {
        // The longest search is left to the long form.
        if (!in_long_form() && std::string_view(file) == "case-4-margin.toml") continue;
        const std::string text = shipped(file, folder);
        const Problem problem =
            parse_problem(text, std::string(MECHWRIGHT_SOURCE_DIR "/problems/") + folder + "/" + file).problem;
        const Result plain = solve(problem, options);
        ASSERT_TRUE(plain.best) << file;
        EXPECT_EQ(plain.status, Status::solved) << file;
        const auto& terms = problem.objective->terms;
        const Unit unit = terms.size() > 1 ? Unit::none : problem.mechanism->quantities[terms.front().quantity].unit;
        for (const double size : {731.7}) {
            const Result other = solve(scaled(problem, size), options);
            EXPECT_EQ(other.status, Status::solved) << file << " times " << size;
            ASSERT_TRUE(other.best) << file;
            EXPECT_NEAR(other.best->objective / grown(unit, size) / plain.best->objective, 1, 1e-6)
                << file << " times " << size;
        }
    }
}

}  // namespace

}  // namespace mechwright

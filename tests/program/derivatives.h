#pragma once
/// \file
/// Gradients and Hessians of whole programs against differences of their values and gradients: the assembly of the
/// program (scatter to variables, epigraphs, weights, path sums) is what is tested here; the formulas beneath are
/// tested against fifty digits in tests/properties.

#include <gtest/gtest.h>

#include <string>

#include "synthesis/problem/reader.h"
#include "synthesis/program/program.h"
#include "synthesis/search/starts.h"

namespace mechwright::testing {

/// The links of a four-bar.
inline constexpr const char* head = R"(schema = 1
mechanism = "four-bar"
[dimensions]
ground = { min = 20, max = 60 }
crank = { min = 5, max = 15 }
coupler = { min = 20, max = 60 }
rocker = { min = 20, max = 60 }
)";
/// Where it is, and its coupler point.
inline constexpr const char* placement = R"(point-along = { min = -30, max = 60 }
point-across = { min = -30, max = 60 }
origin-x = { min = -30, max = 30 }
origin-y = { min = -30, max = 30 }
tilt = { min = 0, max = 360 }
)";

inline Problem problem_of(const std::string& text) {
    ReadProblem read = parse_problem(text, "test.toml");
    for (const Message& m : read.messages)
        ADD_FAILURE() << to_string(m);
    return read.problem;
}

/// Derivatives of a program at a point against central differences, relative to the greatest entry. Whether the
/// mechanism assembles there.
inline bool has_exact_derivatives(const Program& program, const Eigen::VectorXd& x) {
    constexpr double h = 1e-6;
    const std::string name = name_of(*program.problem, program.variant);
    ProgramValues at;
    evaluate(program, x, true, at);
    if (!at.assembled) return false;
    const auto n = static_cast<Eigen::Index>(program.size());
    const Eigen::VectorXd multipliers =
        Eigen::VectorXd::LinSpaced(static_cast<Eigen::Index>(program.rows.size()), -1.0, 1.3);
    LagrangianHessian second;
    lagrangian_hessian(program, x, 0.7, multipliers, second);
    const Eigen::MatrixXd& hessian = second.value;
    const double slope = 1 + at.gradient.cwiseAbs().maxCoeff();
    const double curvature = 1 + hessian.cwiseAbs().maxCoeff();
    for (Eigen::Index i = 0; i < n; ++i) {
        ProgramValues up, down, far_up, far_down;
        Eigen::VectorXd y = x;
        const auto at_step = [&](double step, ProgramValues& values) {
            y[i] = x[i] + step;
            evaluate(program, y, true, values);
        };
        at_step(h, up);
        at_step(-h, down);
        at_step(2 * h, far_up);
        at_step(-2 * h, far_down);
        // Of fourth order: next to steep places the difference of two would have an error of its own.
        const auto difference = [&](const auto& of) -> decltype(of(up)) {
            return (8 * (of(up) - of(down)) - (of(far_up) - of(far_down))) / (12 * h);
        };
        EXPECT_NEAR(at.gradient[i], difference([](const ProgramValues& v) { return v.objective; }), 1e-7 * slope)
            << name << ", " << program.variables[static_cast<std::size_t>(i)].name;
        for (Eigen::Index r = 0; r < at.rows.size(); ++r)
            EXPECT_NEAR(at.jacobian(r, i), difference([&](const ProgramValues& v) { return v.rows[r]; }),
                        1e-7 * (1 + at.jacobian.row(r).cwiseAbs().maxCoeff()))
                << program.rows[static_cast<std::size_t>(r)].name;
        const Eigen::VectorXd column = difference([&](const ProgramValues& v) {
            return Eigen::VectorXd(0.7 * v.gradient + v.jacobian.transpose() * multipliers);
        });
        EXPECT_LE((hessian.col(i) - column).cwiseAbs().maxCoeff(), 1e-6 * curvature)
            << name << ", " << program.variables[static_cast<std::size_t>(i)].name;
    }
    return true;
}

/// Those of the program of every variant, at its start point.
inline void expect_exact_derivatives(const Problem& problem) {
    int tested = 0;
    for (const Variant& variant : variants(problem)) {
        const Program program = build_program(problem, variant);
        tested += has_exact_derivatives(program, start_point(program, 3, 1, 50)) ? 1 : 0;
    }
    EXPECT_GT(tested, 0);
}

}  // namespace mechwright::testing

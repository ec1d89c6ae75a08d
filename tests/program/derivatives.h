#pragma once
/// \file
/// Gradients and Hessians of whole programs against differences of their values and gradients: the assembly of the
/// program (scatter to variables, epigraphs, weights, path sums) is what is tested here; the formulas beneath are
/// tested against fifty digits in tests/properties.

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
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
/// The same with ranges that differ: where coupler and rocker are equal, margins of assembly have a kink.
inline const std::string uneven_links = R"(schema = 1
mechanism = "four-bar"
[dimensions]
ground = { min = 20, max = 62 }
crank = { min = 5, max = 15 }
coupler = { min = 22, max = 65 }
)";
inline const std::string uneven_head = uneven_links + "rocker = { min = 20, max = 58 }\n";

/// A four-bar by its links, with a point and its placement.
inline const std::string linkage_head = R"(schema = 1
mechanism = "linkage"
[dimensions]
ground = { min = 1, max = 10 }
crank = { min = 0.5, max = 10 }
coupler = { min = 1, max = 10 }
rocker = { min = 1, max = 10 }
along = { min = -10, max = 10 }
across = { min = -10, max = 10 }
[placement]
origin-x = { min = -10, max = 10 }
tilt = { min = 0, max = 360 }
[links]
frame = { A = [0, 0], D = ["ground", 0] }
crank = { A = [0, 0], B = ["crank", 0] }
coupler = { B = [0, 0], C = ["coupler", 0], P = ["along", "across"] }
rocker = { D = [0, 0], C = ["rocker", 0] }
[drive]
link = "crank"
)";

/// Where a built-in one is, and its coupler point.
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

/// How far a difference with steps h of values of a size may be from the derivative: by the rounding of the values, of
/// which some are differences of numbers of order one, and by a part of the derivative itself.
inline double difference_error(double derivative, double size, double h, double part) {
    constexpr double roundings = 32;
    return part * std::abs(derivative) + roundings * std::numeric_limits<double>::epsilon() * (1 + size) / h;
}

/// Derivatives of a program at a point against central differences, each by its own size. Whether the mechanism
/// assembles there.
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
    const auto gradient_of = [&](const ProgramValues& v) {
        return Eigen::VectorXd(0.7 * v.gradient + v.jacobian.transpose() * multipliers);
    };
    // Of all that is added up in a gradient.
    const double slope =
        (0.7 * at.gradient.cwiseAbs() + at.jacobian.cwiseAbs().transpose() * multipliers.cwiseAbs()).maxCoeff();
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
        EXPECT_NEAR(at.gradient[i], difference([](const ProgramValues& v) { return v.objective; }),
                    difference_error(at.gradient[i], std::abs(at.objective), h, 1e-7))
            << name << ", " << program.variables[static_cast<std::size_t>(i)].name;
        for (Eigen::Index r = 0; r < at.rows.size(); ++r)
            EXPECT_NEAR(at.jacobian(r, i), difference([&](const ProgramValues& v) { return v.rows[r]; }),
                        difference_error(at.jacobian(r, i), std::abs(at.rows[r]), h, 1e-7))
                << program.rows[static_cast<std::size_t>(r)].name;
        const Eigen::VectorXd column = difference(gradient_of);
        for (Eigen::Index j = 0; j < n; ++j)
            EXPECT_NEAR(hessian(j, i), column[j], difference_error(hessian(j, i), slope, h, 1e-6))
                << name << ", " << program.variables[static_cast<std::size_t>(i)].name << " and "
                << program.variables[static_cast<std::size_t>(j)].name;
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

#pragma once
/// \file
/// The outputs that a path adds to a program, and their derivatives.

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "synthesis/program/program.h"

namespace mechwright {

/// The dimensions of the program at x, those that are variables taken from there.
void set_dimensions(const Program& program, const Eigen::VectorXd& x, std::vector<double>& dimensions);
std::vector<double> dimensions_at(const Program& program, const Eigen::VectorXd& x);

/// What inputs are divided by in the program: displacements of a driven slide as all lengths, crank angles by nothing.
double unit_of_input(const Program& program);

/// The stroke of the slide that drives, in the program's lengths; absent where a crank does, which may turn on.
std::optional<std::array<double, 2>> stroke_of(const Program& program);

/// The crank angle at a point of the path, or the displacement, and the variable it depends on (-1: none).
struct PathAngle {
    double angle;
    std::ptrdiff_t variable;
};

PathAngle path_angle(const Program& program, std::span<const double> dimensions, const Eigen::VectorXd& x,
                     std::size_t point);

/// Writes the outputs of the path, which have their places already. False where the mechanism does not assemble at a
/// target, or a number is not finite.
bool evaluate_path(const Program& program, const Eigen::VectorXd& x, bool derivatives, Outputs& out);

/// Adds the second derivatives of the path's outputs, by the weights and dimensions of `out`, to its value. With q the
/// squared distance of a point, a sum takes q, the root of the mean q / (2 W rms) less the square of its gradient, a
/// distance q / (2 d) less the square of its gradient.
void add_path_hessian(const Program& program, const Eigen::VectorXd& x, LagrangianHessian& out);

}  // namespace mechwright

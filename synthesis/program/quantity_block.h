#pragma once
/// \file
/// The blocks of outputs that a quantity adds to a program. Like the path's (target/path/rows), a block writes its
/// outputs and their derivatives into memory of the caller, and says whether it could.

#include <array>
#include <cstddef>
#include <span>

#include "synthesis/program/program.h"

namespace mechwright {

/// The arguments of a quantity's measure at a point of the program, with the variables that each follows from; the
/// first `count` are set.
struct BlockArguments {
    std::size_t count = 0;
    std::array<double, Reads::most> value;
    std::array<std::span<const LinearTerm>, Reads::most> source;
    std::array<LinearTerm, 6 * Reads::most> ends;  ///< what start and range of a stretch follow from
};

/// Adds an argument that follows from a dimension alone.
void add_dimension(const Program& program, std::span<const double> dimensions, std::size_t dimension,
                   BlockArguments& arguments);

/// Writes the outputs of a block, which have their places already, and with derivatives their part of the Jacobian,
/// which is zero before. The dimensions of `out` are set. False where one is not finite: there the quantity has no
/// value. Allocates nothing.
bool evaluate_block(const Program& program, const QuantityBlock& block, const Eigen::VectorXd& x, bool derivatives,
                    Outputs& out);

/// Adds the second derivatives of a block's outputs, by the weights and dimensions of `out`, to its value.
void add_block_hessian(const Program& program, const QuantityBlock& block, const Eigen::VectorXd& x,
                       LagrangianHessian& out);

}  // namespace mechwright

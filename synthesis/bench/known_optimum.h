#pragma once
/// \file
/// The best design that is known of a problem, as a point of its program: what searches are measured against.

#include <Eigen/Core>
#include <optional>

#include "synthesis/program/program.h"
#include "synthesis/solve/solve.h"

namespace mechwright::bench {

struct KnownOptimum {
    Program program;  ///< of the variant that it lies in
    Eigen::VectorXd x;
    double objective;  ///< of the program
};

/// A design as a point of the program in which it is worth most, polished. Nothing where it lies in none. `problem`
/// must outlive it.
std::optional<KnownOptimum> optimum_at(const Problem& problem, const Design& design);

/// The verified design that the problem's own method finds. Nothing where there is none, or no objective.
std::optional<KnownOptimum> known_optimum(const Problem& problem, const RunOptions& options);

/// How far an objective is from the known one: relative, or absolute (in the program's units, which are those of the
/// problem's size) where that is zero by rounding; or the violation, if that is greater.
double error_of(double objective, double violation, double known);

}  // namespace mechwright::bench

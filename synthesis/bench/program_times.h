#pragma once
/// \file
/// What it takes to evaluate the program of a problem: the only place here that knows how programs are evaluated.

#include <optional>
#include <vector>

#include "synthesis/bench/timing.h"
#include "synthesis/program/program.h"

namespace mechwright::bench {

/// A program at a point where its mechanism assembles and all derivatives are finite.
struct ProgramPoint {
    Program program;
    Eigen::VectorXd x;
};

/// The first such point among the first starts of a search; nothing where nothing is to be designed or no start will
/// do. `problem` must outlive it.
std::optional<ProgramPoint> program_point(const Problem& problem);

/// Pieces for `timed`. `at` must outlive them.
Piece values(const ProgramPoint& at);
Piece values_and_gradients(const ProgramPoint& at);
/// By forward differences: a value more than there are variables.
Piece differences(const ProgramPoint& at);
/// Of the Lagrangian, all multipliers 1.
Piece hessians(const ProgramPoint& at);

/// Of one evaluation without derivatives; nothing beyond `most`.
std::optional<long> instructions_of_values(const ProgramPoint& at, long most);

}  // namespace mechwright::bench

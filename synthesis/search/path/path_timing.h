#pragma once
/// \file
/// Guesses of the crank angles at which the points of a path are met.

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "analysis/numbers/low_discrepancy.h"
#include "synthesis/program/program.h"

namespace mechwright {

/// What a guess is drawn from: numbers in (0, 1).
struct PathTiming {
    double start;     ///< of the first angle
    double span;      ///< of an open path, from a tenth to nearly a whole turn
    double evenness;  ///< steps between even (1) and in proportion to the distances between the points (0)
    double swell;     ///< how much faster than that the crank turns somewhere
    double where;     ///< and where
};

inline constexpr std::size_t path_timing_numbers = 5;

/// Crank angles of an untimed path from a guess. They rise or fall in the direction of the program's variant and stay
/// within a turn.
std::vector<double> path_angles(const Program& program, const PathTiming& timing);

/// Guess number k of a sequence for a program with a path: the crank angles at its points, and in x the variables that
/// they belong to (the angles themselves, or the start of a timed path, where it is one).
std::vector<double> random_path_angles(const Program& program, const LowDiscrepancy& sequence, std::uint64_t k,
                                       Eigen::VectorXd& x);

/// Takes crank angles of a design less or more whole cycles, so that from each point of a target to the next the crank
/// turns in a direction (1 or -1) by less than a cycle.
void meet_in_order(const Problem& problem, int direction, Design& design);

}  // namespace mechwright

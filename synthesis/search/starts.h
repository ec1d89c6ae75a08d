#pragma once
/// \file
/// Where local searches start: low-discrepancy candidates in the ranges of the design variables that meet the
/// conditions of motion, with placement, size and coupler point fitted to a target path where they are free.

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "synthesis/program/program.h"

namespace mechwright {

/// Start number `index` of a program, a function of (seed, index) alone: the best of `candidates` screened points.
/// Index 0 begins with the preferred values (or the middles of the ranges).
Eigen::VectorXd start_point(const Program& program, std::uint64_t seed, int index, int candidates);

/// The best starts of round `round` of a path's program by what is left of the targets once placement, size and guided
/// point are fitted: one from each of `groups` groups of eight candidates that share their crank angles, the best
/// `keep` of them, best first. A function of (seed, round) alone.
std::vector<Eigen::VectorXd> screened_starts(const Program& program, std::uint64_t seed, int round, int groups,
                                             int keep);

/// Fits origin, size with tilt, and guided point of x to the target points by linear least squares, as far as they are
/// design variables, and keeps them in their ranges. With complex numbers the points are O + Z p_i + Y w_i: p_i the
/// guiding link's own point and w_i its direction at unit size and no tilt, both known from the link lengths and crank
/// angles; O, Z and Y the unknowns.
void fit_placement(const Program& program, Eigen::VectorXd& x);

}  // namespace mechwright

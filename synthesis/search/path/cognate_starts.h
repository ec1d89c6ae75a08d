#pragma once
/// \file
/// Cognates of linkages (mechanism/linkage/targets/cognates.h) among the designs of a problem with a path: they come
/// as close to its points and differ in all else, so that one may meet limits that another does not.

#include <Eigen/Core>
#include <cstddef>
#include <optional>
#include <vector>

#include "synthesis/program/program.h"

namespace mechwright {

/// A point of one of some programs.
struct PointOfProgram {
    std::size_t program;
    Eigen::VectorXd x;
};

/// The point of a design whose crank angles are all more by as much, brought into the ranges; nothing where they are
/// given.
std::optional<Eigen::VectorXd> turned_on(const Program& program, Design design, double crank_angle);

/// Whether a problem is that of one path, without poses, that a linkage follows whose dimensions have no ties.
bool is_path_of_linkage(const Problem& problem);

/// The cognates of a design as points of programs with the same motion and direction, brought into their ranges; none
/// where the mechanism has none, or the problem has several targets or poses.
std::vector<PointOfProgram> cognates_of(const std::vector<Program>& programs, std::size_t program,
                                        const Eigen::VectorXd& x);

}  // namespace mechwright

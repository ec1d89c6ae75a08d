#pragma once
/// \file
/// The stretch of the crank between the first and the last target of a path, longer at its ends by what a range of use
/// has there. A design serves the path only if it stays assembled on one branch all along the stretch: families whose
/// crank turns fully do, of the others it is asked. Over a range of use all else is judged that depends on the motion.

#include <Eigen/Core>
#include <span>

#include "synthesis/program/quantity_block.h"

namespace mechwright {

/// Whether designs of a family have to be kept assembled between the targets of the problem's path.
bool needs_stretch(const Problem& problem, const Family& family);

/// The crank angles between which a design meets its path, the first less than the last, and a range of use beyond
/// them; radians. Of an ordered path the crank may turn either way: what is before the first target is beyond the
/// greater angle where it turns clockwise. Of several targets it is the shortest stretch in which all are met.
struct CrankStretch {
    double first;
    double last;
};

CrankStretch stretch_of(const Problem& problem, std::span<const double> path_angles);

/// The least margin of assembly along the stretch of a design, in the unit of its lengths; < 0 where it comes apart.
/// Margins are taken wherever they can be least (Mechanism::input_margin).
double least_margin_along(const Problem& problem, const Design& design);

/// The block of margins along the stretch, where the program has one.
const QuantityBlock* stretch_block(const Program& program);

/// Whether any block depends on where the stretch ends.
bool depends_on_stretch(const Program& program);

/// Adds start and range of the stretch to the arguments of a measure.
void add_stretch(const Program& program, std::span<const double> dimensions, const Eigen::VectorXd& x,
                 BlockArguments& arguments);

/// The points of the path at the ends of the stretch, whose own crank angles an untimed path has as variables.
struct StretchEnds {
    std::size_t first = 0;
    std::size_t last = 0;
    double turns = 0;  ///< whole turns, in radians, by which that of the last is greater in the stretch
};

StretchEnds stretch_ends(const Program& program, const Eigen::VectorXd& x);

}  // namespace mechwright

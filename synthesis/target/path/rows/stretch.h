#pragma once
/// \file
/// The stretch of the crank between the first and the last target of a path, longer at its ends by what a range of use
/// has there; or that over the input ranges of functions, lines and arcs, and a path beside them. A design serves these
/// only if it stays assembled on one branch all along the stretch: families whose crank turns fully do, of the others
/// it is asked. Over a range of use, and over several targets of which one has an input range, all else is judged that
/// depends on the motion.

#include <Eigen/Core>
#include <optional>
#include <span>

#include "synthesis/program/quantity_block.h"

namespace mechwright {

/// Whether designs of a family have to be kept assembled between the targets of the problem's path, or over several
/// input ranges.
bool needs_stretch(const Problem& problem, const Family& family);

/// The crank angles between which a design meets its path, the first less than the last, and a range of use beyond
/// them; radians. Of an ordered path the crank may turn either way: what is before the first target is beyond the
/// greater angle where it turns clockwise. Of several targets it is the shortest stretch in which all are met; of
/// stretches that are equally short to 1e-9 the one that begins with the earliest of paths, poses, functions, lines and
/// arcs.
struct CrankStretch {
    double first;
    double last;
};

/// Nothing where the design has no crank angles for a path.
std::optional<CrankStretch> stretch_of(const Problem& problem, const Design& design);

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

/// An end of the stretch: where a point of the path is met, or where an input range begins or ends.
struct StretchEnd {
    std::optional<std::size_t> point{};      ///< its crank angle an untimed path has as a variable
    std::size_t input_start = no_dimension;  ///< of an input range: the dimension at which it starts
    bool after_range = false;                ///< it ends there
};

struct StretchEnds {
    StretchEnd first{};
    StretchEnd last{};
    double turns = 0;  ///< whole turns, in radians, by which that of the last is greater in the stretch
};

StretchEnds stretch_ends(const Program& program, const Eigen::VectorXd& x);

}  // namespace mechwright

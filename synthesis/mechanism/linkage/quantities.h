#pragma once
/// \file
/// The quantities of linkages: what is made of signals over the motion, and those that every linkage has. One function
/// measures them all; which one, `Quantity::of` says.

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "analysis/linkage/measuring/course.h"
#include "synthesis/mechanism/quantity.h"

namespace mechwright {

/// What a quantity of a linkage is.
struct LinkageMeasure {
    enum class Kind {
        // Of a signal, or of a derivative of it:
        least,
        greatest,
        range,       ///< greatest less least
        mean,        ///< over the crank angle
        rms,         ///< root of the mean of squares
        deviation,   ///< half of the range
        at,          ///< at one input
        sampled,     ///< at inputs all along the stretch, each a component
        time_ratio,  ///< of the two parts of a full cycle between the global extremes, the longer over the shorter
        // Of every linkage:
        transmission_angle_worst,  ///< of all dyads, folded at 90 degrees
        total_length,              ///< of the distances of links' origins to their pins, but those that are 0
        link_ratio,                ///< the longest of these over the shortest
        full_turn_margin,          ///< the least of all margins over all turns of the motion, in lengths
        assembly_margin,           ///< the same over the motion
        joint_distance_least,      ///< between pins that have no link in common
        // Of the guided point, over an input range, from what it follows:
        distance_greatest,  ///< without its sign
        extent,             ///< how far it follows
        // Of the signal that is to be a function of the input, over an input range; `asked` is its error:
        function_greatest,  ///< the greatest error, without its sign
        function_rms,       ///< the root of the mean of its square
        // Of a box about parts over the motion:
        room_width,
        room_height,
        room_area,
        // Of one that is turned so that this is least:
        turned_width,
        turned_area,
        // Of the path of a point over the motion:
        self_distance,  ///< from itself (rooms/approach.h)
        // Of the line between two points over the motion:
        swept_area,
        uncovered,  ///< what of the room's screen it does not sweep
        // Of parts over the motion:
        region_margin  ///< how far they keep inside of a region, or outside; negative where they do not
    };
    Kind kind = Kind::least;
    std::vector<linkage::Signal> signals{};          ///< those that it needs, and those that they need
    linkage::Asked asked{};                          ///< which of these
    std::optional<std::array<double, 2>> stretch{};  ///< inputs of the master, radians or length; the whole motion
    double input = 0;                                ///< of `at`
    std::size_t over_input = 0;                      ///< of what is asked over an input range: which of the targets
    std::size_t of_room = 0;                         ///< which room, or which region
};

struct LinkageModel;

/// The unit of what is made of a signal: velocities by an angle have that of the signal, turns of links by an angle
/// none; by the displacement of a driven slide none has one.
Unit unit_of(const LinkageModel& model, const LinkageMeasure& measure);

/// A quantity of a linkage whose model is a LinkageModel, with everything but `measure_again`. It reads the first
/// `dimensions` of the mechanism: at most Reads::most. Angles of lines and dyads of no length have no part in margins.
/// `motion.to` of a full turn is that of all turns of a cycle. Where the linkage does not close over the motion, or a
/// stretch lies outside of it, the values are not numbers; derivatives that are infinite, as speeds are at the ends of
/// a limited motion, are so.
Quantity linkage_quantity(std::string name, Unit unit, std::string meaning, LinkageMeasure measure,
                          std::size_t dimensions);

/// The same over an input range: start and range are its last arguments, after those that it reads
/// (InputRange::quantities); after these come the numbers of what the guided point follows, for quantities of
/// that, or start and range of the output, for quantities of a function.
Quantity over_input(Quantity quantity);

/// As Mechanism::nearest_limit: the dyad whose margin is the least of a motion, and where it is at its limit.
std::string nearest_limit_of_linkage(const Motion& motion, std::span<const double> dimensions);

}  // namespace mechwright

#pragma once
/// \file
/// Geared five-bars: two cranks on the frame that gears or a belt join, and a dyad between them whose common pin is
/// guided.
///
/// Seen from one crank, the guided point is the end of a link whose other end, the crank pin, turns about the crank's
/// pivot: with d the point, a the pivot, and the crank pin at a - x T once the crank has turned by theta,
/// T = e^(i theta), |d + x T - a| does not change. That is the equation of a dyad (poses/dyads.h) whose body turns as
/// the crank does. The other crank says the same with a pivot and a pin of its own, and e^(i n theta) for T, n being
/// the ratio of the gears. So
/// * at given crank angles each crank is a dyad through as many poses, of which five say it: 4 and 4 over the complex
///   numbers;
/// * at any crank angles, where n = 1, both turn as one body: each four-bar whose coupler point passes the points is a
///   geared five-bar through them, and the other way round. (S. Roberts, "On three-bar motion in plane space", 1875.)

#include <cstddef>
#include <optional>
#include <span>
#include <string>

#include "synthesis/exact/exact_designs.h"
#include "synthesis/exact/poses/dyads.h"
#include "synthesis/mechanism/linkage/model.h"

namespace mechwright {

/// One crank of a geared five-bar, and the rod from its pin to the guided point; by numbers in the structure.
struct GearedCrank {
    std::size_t link = 0;
    std::size_t pivot = 0;
    std::size_t pin = 0;
    std::size_t rod = 0;
};

struct GearedFiveBar {
    std::size_t point = 0;  ///< the pin that is guided
    GearedCrank driving, driven;
    std::size_t gear = 0;
    bool drives_first = true;  ///< the crank that drives is the first of the gear
};

/// The geared five-bar whose common pin a problem guides; nothing where it guides otherwise.
std::optional<GearedFiveBar> geared_five_bar(const Problem& problem);

/// The ratio of the gears; nothing where that is not given, or 0.
std::optional<double> ratio_of_gears(const Problem& problem, const GearedFiveBar& bars);

/// How many times as fast as the driving crank the driven one turns; nothing where that is not given, or 0.
std::optional<double> speed_of_driven(const Problem& problem, const GearedFiveBar& bars);

/// Whether the points of a problem are met by a geared five-bar whose cranks turn alike, at any crank angles.
bool is_five_bar_like_four_bar(const Problem& problem);

/// Why dimensions do not follow from where the pins of the five-bar are; empty if they do.
std::string why_no_geared_design(const Problem& problem, const GearedFiveBar& bars);

/// How many coordinates of the pivot of a crank are given in the drawing.
std::size_t given_coordinates(const Problem& problem, const GearedCrank& crank);

/// Why not all that a family of geared five-bars may choose is open beside the given coordinates of its pivots; empty
/// if it is.
std::string why_no_geared_family(const Problem& problem, std::size_t given_of_pivots);

/// Two cranks as dyads, and the places of the guided point with how the driving crank turns: both from the first place.
struct GearedParts {
    Dyad driving, driven;
    std::span<const Displacement> displacements;  ///< of all places, the first among them
    std::span<const double> turned;               ///< radians: the arguments of their turns, with whole turns
};

/// The design of these parts, in the best assembly.
ExactDesign geared_design(const Problem& problem, const GearedFiveBar& bars, const GearedParts& parts,
                          const DrawingPlace& place);

}  // namespace mechwright

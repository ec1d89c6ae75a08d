#pragma once
/// \file
/// All four-bars or slider-cranks through poses and points.

#include <cstddef>
#include <optional>
#include <vector>

#include "synthesis/exact/homotopy/guidance_start.h"
#include "synthesis/mechanism/mechanism.h"

namespace mechwright::homotopy {

/// One member of every orbit that was found, and what became of all paths that were followed.
struct GuidanceSolutions {
    std::vector<GuidanceValues> solutions;  ///< regular and distinct
    std::size_t tracked = 0;                ///< paths
    std::size_t at_infinity = 0;            ///< ended at linkages that are infinitely large
    std::size_t singular = 0;               ///< ended where solutions meet, or at families of them
    std::size_t lost = 0;                   ///< neither: how they end is not known

    /// Whether every path is accounted for.
    bool complete() const { return lost == 0 && solutions.size() + at_infinity + singular == tracked; }
};

/// Follows all solutions of the start system to the target; what double does not suffice for, and paths that end at the
/// same place, again in extended precision and by shorter steps, then by another way. The same for any number of jobs.
/// Where `end` is reached before, what was found of the real ones until then; the others are lost.
GuidanceSolutions solve_guidance(const StartSystem& start, const GuidanceParameters& target, int jobs,
                                 const RunEnd& end = {});

/// The parameters of real places: displacements from the first pose, which may stand anywhere among the places, scaled
/// to about 1.
struct GuidanceTarget {
    GuidanceSystem system;
    GuidanceParameters parameters{};
    Complex<double> origin;  ///< of the first pose
    double size = 1;         ///< a length of 1 in the parameters
    /// Each place's displacement among the parameters; nothing for the first pose itself.
    std::vector<std::optional<std::size_t>> places;
};

/// A place with the angle (radians) in which a body faces there, if that is asked for.
struct GuidedPlace {
    Complex<double> point;
    std::optional<double> direction;
};

/// Places of a system with as many poses. What they have too few or too many of is for the caller to see.
GuidanceTarget guidance_target(const std::vector<GuidedPlace>& places, SecondDyad second = SecondDyad::rocker);

/// The parameters in fifty digits, of the same places.
GuidanceSystem::Parameters<Digits50> exact_parameters(const GuidanceTarget& target,
                                                      const std::vector<GuidedPlace>& places);

/// Refines a solution. Whether it is one, isolated, and stands for a linkage.
bool refined_to_regular(const GuidanceSystem& system, GuidanceValues& solution, const GuidanceParameters& target);

/// Whether the conjugates of a solution are those of its numbers, but for rounding: then it is a linkage.
bool is_real(const GuidanceValues& solution);

}  // namespace mechwright::homotopy

#pragma once
/// \file
/// Limits in closed form on what mechanisms can do, whatever their dimensions and whatever is made greatest or least.

#include <limits>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "synthesis/problem/problem.h"
#include "synthesis/program/proof.h"

namespace mechwright {

/// What a problem asks of a quantity, by all its requirements together.
struct Asked {
    double least = -std::numeric_limits<double>::infinity();
    double greatest = std::numeric_limits<double>::infinity();
};
Asked asked_of(const Problem& problem, std::string_view quantity);

/// Of a quantity of every design that meets the other requirements; angles in radians. The names are
///   possible-values:  what the quantity means;
///   swing:            the worst transmission angle of a crank-rocker is at most (180 deg - swing) / 2 (VDI 2130);
///   swing-time-ratio: a crank-rocker's time ratio is less than (540 deg + swing) / (180 deg - swing);
///   family:           the best crank-rocker of a swing and a time ratio, see analysis/four_bar/best_crank_rocker.h;
///   time-ratio:       that of a slider-crank whose crank turns fully is less than 3, for its ram's limits are seen
///   from
///                     the crank pivot under less than a right angle;
///   ratio-family:     the best slider-crank of a time ratio, see analysis/slider_crank/best_slider_crank.h;
///   stroke:           the rod of some drives of a ram slopes at least so that its sine is half of the stroke over the
///                     rod (Mechanism::rod_sloped_by_stroke).
struct KnownLimit {
    std::string_view name;
    std::size_t quantity;
    double least;
    double greatest;
    std::string why;  ///< half a sentence
};
std::vector<KnownLimit> known_limits(const Problem& problem);

/// Why no design meets the requirements, where a limit shows it; null where none does. What the tolerance lets pass is
/// not excluded.
std::shared_ptr<const Proof> proof_by_limits(const Problem& problem);

}  // namespace mechwright

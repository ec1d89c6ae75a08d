#pragma once
/// \file
/// What ends the motion of a linkage, in words.

#include <span>
#include <string>

#include "analysis/linkage/motion/travel.h"

namespace mechwright {

/// "the stop 'max' of slide 'ram'": of a step that is a stop.
std::string stop_text(const linkage::Step& step, std::span<const std::string> pins,
                      std::span<const std::string> slides);

/// "where the dyad closed at 'C' is stretched out", "at the stop 'max' of slide 'ram'"; empty where nothing ends it.
std::string limit_text(const linkage::Order& order, const linkage::Limit& limit, std::span<const std::string> links,
                       std::span<const std::string> pins, std::span<const std::string> slides);

}  // namespace mechwright

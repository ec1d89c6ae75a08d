#pragma once
/// \file
/// Registry entries of the mechanisms that drive a ram (see mechanism.h).

#include "synthesis/mechanism/mechanism.h"

namespace mechwright {

std::shared_ptr<const Mechanism> slider_crank_mechanism();
std::shared_ptr<const Mechanism> crank_shaper_mechanism();
std::shared_ptr<const Mechanism> whitworth_mechanism();
std::shared_ptr<const Mechanism> drag_link_mechanism();

/// Whether a mechanism is of the kind.
bool is_slider_crank(const Mechanism& mechanism);
bool is_whitworth(const Mechanism& mechanism);

}  // namespace mechwright

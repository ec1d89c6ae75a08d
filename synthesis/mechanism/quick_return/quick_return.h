#pragma once
/// \file
/// Registry entries of the mechanisms that drive a ram (see mechanism.h).

#include "synthesis/mechanism/mechanism.h"

namespace mechwright {

const Mechanism& slider_crank_mechanism();
const Mechanism& crank_shaper_mechanism();
const Mechanism& whitworth_mechanism();
const Mechanism& drag_link_mechanism();

}  // namespace mechwright

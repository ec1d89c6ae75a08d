#pragma once
/// \file
/// How linkages are drawn. The model of the design's motion is a LinkageModel.

#include "synthesis/mechanism/linkage/drawing/link_bodies.h"
#include "synthesis/mechanism/linkage/model.h"
#include "synthesis/mechanism/mechanism.h"

namespace mechwright {

/// Bodies are the links that move, the driven one first, then in the order of the model; the ground is the frame. A
/// link of two places is a bar, one of more a plate; slots and guides reach as far as their pins and blocks go.
Drawing linkage_drawing();

/// The link that is body 0: the driven one, or the one against which the frame is driven.
std::size_t driven_link(const LinkageModel& model);

/// A linkage placed at an angle or displacement of its motion, as near to it as it closes: ends of a motion lie where
/// it just closes, and rounding can put them beyond. False where it does not close within a millionth of the motion.
bool place_within(linkage::Driven<double>& linkage, const Motion& motion, double master);

}  // namespace mechwright

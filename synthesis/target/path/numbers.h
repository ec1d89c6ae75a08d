#pragma once
/// \file
/// What paths and poses bring to a mechanism whose point or body they guide.

#include <vector>

#include "synthesis/mechanism/mechanism.h"

namespace mechwright {

/// crank-start, from which prescribed crank angles are counted; of an instant it is the crank angle. Of targets with
/// names each has its own, NAME.crank-start.
void add_crank_start(Mechanism& mechanism);

/// body-angle, from the guiding link to a guided body; of poses with names NAME.body-angle.
void add_body_angle(Mechanism& mechanism);

std::vector<Quantity> path_quantities();
std::vector<Quantity> pose_quantities();

/// Of a mechanism whose targets have names: those of all together, which are called as those of a path where there is
/// one, else as those of poses; then those of each, NAME.path-rms.
std::vector<Quantity> quantities_of_targets(const Mechanism& mechanism);

}  // namespace mechwright

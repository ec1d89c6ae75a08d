#pragma once
/// \file
/// What paths and poses bring to a mechanism whose point or body they guide.

#include <vector>

#include "synthesis/mechanism/mechanism.h"

namespace mechwright {

/// crank-start, from which prescribed crank angles are counted; of an instant it is the crank angle.
void add_crank_start(Mechanism& mechanism);

/// body-angle, from the guiding link to a guided body.
void add_body_angle(Mechanism& mechanism);

std::vector<Quantity> path_quantities();
std::vector<Quantity> pose_quantities();

}  // namespace mechwright

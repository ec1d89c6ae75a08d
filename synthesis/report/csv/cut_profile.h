#pragma once
/// \file
/// The curves of a part with a profile, such as a cam, for the machine that cuts it: pitch curve, profile and the path
/// of a cutter's centre, in the part's own plane as it lies at crank angle 0. Precondition of all: Mechanism::profile.

#include <string>
#include <vector>

#include "synthesis/report/drawing/finished.h"

namespace mechwright {

struct CutPath {
    std::string layer;  ///< "PROFILE", "PITCH" or "CUTTER"
    double offset = 0;  ///< outward from the profile; the pitch curve lies a roller radius off
};

/// The profile; the pitch curve where there is a roller; and the cutter's path where its radius is not 0.
std::vector<CutPath> cut_paths(const FinishedDesign& design, double cutter_radius);

/// Least radius of the hollow parts of the profile, infinite where there is none: a cutter must not be larger.
double least_hollow_radius(const FinishedDesign& design);

/// "cam-angle, pitch-x, ..., cutter-y": a line for each step of the cam angle, lengths of the problem.
std::string profile_csv(const FinishedDesign& design, double cutter_radius, int steps);

/// A drawing for DXF release 12: each curve a closed polyline of circular arcs, on a layer of its own, nowhere farther
/// from the curve than the tolerance and with arcs as long as that allows.
std::string profile_dxf(const FinishedDesign& design, double cutter_radius, double tolerance);

}  // namespace mechwright

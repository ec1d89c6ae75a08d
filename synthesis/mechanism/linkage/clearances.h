#pragma once
/// \file
/// Clearance in the pins of a linkage: where the pin touches its hole is off by half of the clearance. It is as if the
/// hole lay elsewhere on its link.

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "synthesis/mechanism/linkage/model.h"

namespace mechwright {

/// A pin on one of its links.
struct PinOnLink {
    std::size_t pin = 0;
    std::size_t point = 0;  ///< of the pin's
};

/// One for each pin joint, a pin of k links being k - 1: where its hole is. Joints of links that others make redundant
/// are left out, and those of which both holes carry the line of a slide.
std::vector<PinOnLink> holes_of(const LinkageModel& model);

/// How joints are called: by the pin, of several at a pin with the link: "C", "P on rod".
std::vector<std::string> names_of_joints(const LinkageModel& model);

/// The linkage with each hole moved on its link, in the frame of that link; in the drawing's lengths.
Model with_moved_holes(const Model& model, std::span<const double> dimensions, std::span<const Vector<double>> by);

}  // namespace mechwright

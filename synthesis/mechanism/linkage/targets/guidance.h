#pragma once
/// \file
/// A linkage that guides a point of one of its links, or that link as a body (LinkageModel::guided).

#include <cstddef>
#include <span>

#include "synthesis/mechanism/linkage/model.h"
#include "synthesis/mechanism/mechanism.h"

namespace mechwright {

/// The guided point and the guided body of a linkage that has them. They read the first `dimensions` of the mechanism,
/// at most PointGuidance::most_reads. Angles of a body are counted from the x axis of its link.
PointGuidance linkage_point_guidance(const LinkageModel& model, std::size_t dimensions);
BodyGuidance linkage_body_guidance(const LinkageModel& model, std::size_t dimensions);

/// The guided point in the drawing; where the linkage does not close, with its dyads at their limits.
Vector<double> guided_point_of_linkage(Form form, std::span<const double> dimensions, double crank_angle);

}  // namespace mechwright

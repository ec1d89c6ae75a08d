#pragma once
/// \file
/// A linkage that guides a point of one of its links, or that link as a body (LinkageModel::guided); or several of
/// them.

#include <cstddef>
#include <span>

#include "synthesis/mechanism/linkage/model.h"
#include "synthesis/mechanism/mechanism.h"

namespace mechwright {

/// Guided points of a linkage that has some, with the roles of the first, and one of its guided bodies. They read the
/// first `dimensions` of the mechanism, at most PointGuidance::most_reads. Angles of a body are counted from the x axis
/// of its link. Which of the points is meant the form says (Form::guided).
PointGuidance linkage_point_guidance(const LinkageModel& model, std::size_t dimensions);
BodyGuidance linkage_body_guidance(const LinkageModel& model, const GuidedPoint& guided, std::size_t dimensions);

/// What a guided point or body depends on, with the margins that keep it assembled: all but those to ends of the
/// stroke.
linkage::Needed needed_for_guidance(const LinkageModel& model, const GuidedPoint& guided);

/// Which dimensions play which part for a guided point: its own coordinates only where nothing else depends on them.
PathRoles linkage_path_roles(const LinkageModel& model, const GuidedPoint& guided);

/// The guided point in the drawing; where the linkage does not close, with its dyads at their limits.
Vector<double> guided_point_of_linkage(Form form, std::span<const double> dimensions, double crank_angle);

}  // namespace mechwright

#include "synthesis/exact/exact.h"

#include <algorithm>
#include <array>

#include "synthesis/exact/accuracy_points.h"
#include "synthesis/exact/extreme_velocity_ratio.h"
#include "synthesis/exact/geared/geared_five_bar.h"
#include "synthesis/exact/geared/geared_points.h"
#include "synthesis/exact/guided_parts.h"
#include "synthesis/exact/instant.h"
#include "synthesis/exact/output_dyads/output_points.h"
#include "synthesis/exact/places.h"
#include "synthesis/exact/poses/poses.h"
#include "synthesis/exact/poses/slider_crank_poses.h"
#include "synthesis/exact/poses/slider_crank_timed.h"
#include "synthesis/mechanism/slider_crank/slider_crank.h"

namespace mechwright {

namespace {

/// One kind of exact problem: whether a problem is meant to be of it, why it cannot be solved as such, and the answer.
struct ExactKind {
    bool (*concerns)(const Problem&);
    std::string (*why_not)(const Problem&);
    ExactDesigns (*designs)(const Problem&, const RunOptions&, const RunEnd&);
};

bool has_poses_alone(const Problem& p) {
    return p.path && p.path->guides_body() && p.path->poses() == p.path->points.size();
}

bool has_ram_or_block(const Problem& p) {
    const auto second = second_dyad(p);
    return second && *second != homotopy::SecondDyad::rocker;
}

constexpr std::array<ExactKind, 10> kinds{{
    {[](const Problem& p) { return has_poses_alone(p) && has_ram_or_block(p); }, why_no_slider_crank_poses,
     slider_crank_pose_designs},
    {has_poses_alone, why_no_poses, pose_designs},
    {[](const Problem& p) { return is_slider_crank(*p.mechanism) && p.path && p.path->prescribed_timing; },
     why_no_slider_crank_timed_points, slider_crank_timed_designs},
    {[](const Problem& p) { return p.path && p.path->prescribed_timing && geared_five_bar(p); },
     why_no_geared_timed_points, geared_timed_designs},
    {[](const Problem& p) { return p.path && p.path->prescribed_timing; }, why_no_timed_points, timed_point_designs},
    {[](const Problem& p) { return p.path.has_value(); }, why_no_places, place_designs},
    {[](const Problem& p) { return p.function != nullptr && is_linkage(p); }, why_no_output_points,
     output_point_designs},
    {[](const Problem& p) { return p.function != nullptr; }, why_no_accuracy_points, accuracy_point_designs},
    {[](const Problem& p) { return p.has_instant; }, why_no_instant, instant_designs},
    {requires_extreme_velocity_ratio, why_no_extreme_velocity_ratio, extreme_velocity_ratio_designs},
}};

const ExactKind* kind_of(const Problem& problem) {
    const auto at = std::find_if(kinds.begin(), kinds.end(), [&](const ExactKind& k) { return k.concerns(problem); });
    return at == kinds.end() ? nullptr : &*at;
}

}  // namespace

std::string why_not_exact(const Problem& problem) {
    const ExactKind* kind = kind_of(problem);
    return kind ? kind->why_not(problem)
                : "it needs targets that are met exactly: a [path], [poses], a [function], an [instant], or an "
                  "extreme velocity ratio that equals a value";
}

ExactDesigns exact_designs(const Problem& problem, const RunOptions& options, const RunEnd& end) {
    return kind_of(problem)->designs(problem, options, end);
}

}  // namespace mechwright

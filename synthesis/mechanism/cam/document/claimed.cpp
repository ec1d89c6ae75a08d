#include <fmt/format.h>

#include <algorithm>
#include <numbers>

#include "synthesis/document/fields.h"
#include "synthesis/mechanism/cam/cam.h"
#include "synthesis/mechanism/cam/document/cam.h"
#include "synthesis/mechanism/cam/motion_program.h"
#include "synthesis/problem/text.h"

namespace mechwright::claims {

namespace {

using cam::SegmentKind;
using namespace names;

constexpr std::size_t most_table_points = 10000;

/// The index of a word among some; fails where it is none of them.
template <std::size_t N>
std::size_t word(Reader& in, const Json* json, const std::string& place, const std::array<std::string_view, N>& words) {
    const std::string text = in.text(json, place);
    const auto at = std::find(words.begin(), words.end(), text);
    if (at != words.end()) return static_cast<std::size_t>(at - words.begin());
    in.fail(fmt::format("{} is {}, which it cannot be", place, reading::quoted(text)));
    return 0;
}

std::size_t law_named(Reader& in, const Json* json, const std::string& place) {
    const std::string text = in.text(json, place);
    const auto laws = cam_laws();
    const auto at = std::find_if(laws.begin(), laws.end(), [&](const NamedLaw& law) { return law.name == text; });
    if (at != laws.end()) return static_cast<std::size_t>(at - laws.begin());
    in.fail(fmt::format("{} names the law {}, which there is not", place, reading::quoted(text)));
    return 0;
}

std::size_t count(Reader& in, const Json* json, const std::string& place, std::size_t most) {
    const double number = in.optional_number(json, place).value_or(0);
    if (number >= 0 && number <= static_cast<double>(most) && number == static_cast<double>(static_cast<int>(number)))
        return static_cast<std::size_t>(number);
    in.fail(fmt::format("{} is not a whole number up to {}", place, most));
    return 0;
}

std::shared_ptr<const LiftTable> table_of(Reader& in, const Json& segment, const std::string& place, const Claim& claim,
                                          bool angular) {
    const auto points = in.points(member(segment, of_segment("points")), place + ".points", most_table_points);
    const double unit = claim.units.degrees ? std::numbers::pi / 180 : 1;
    std::vector<double> angle, lift;
    for (const auto& p : points) {
        angle.push_back(p.x * unit);
        lift.push_back(angular ? p.y * unit : p.y);
    }
    const bool rises = std::adjacent_find(angle.begin(), angle.end(), std::greater_equal<>()) == angle.end();
    if (points.size() < 3 || !rises || angle.front() < 0 || !(angle.back() < 2 * std::numbers::pi)) {
        in.fail(place + ".points are not at least three cam angles that rise within a turn");
        return nullptr;
    }
    const auto [least, greatest] = std::minmax_element(lift.begin(), lift.end());
    if (!(*greatest > *least) || !(*greatest < 1e150) || !(*least > -1e150)) {
        in.fail(place + ".points have no lift");
        return nullptr;
    }
    return lift_table(std::move(angle), std::move(lift));
}

SegmentPlan segment_of(Reader& in, const Json& json, const Json* law, const std::string& place, const Claim& claim,
                       bool angular, std::size_t& coefficients) {
    SegmentPlan plan;
    plan.kind =
        static_cast<SegmentKind>(word(in, member(json, of_segment("kind")), place + ".kind", segment_kind_names));
    if (plan.kind == SegmentKind::cycle) plan.table = table_of(in, json, place, claim, angular);
    if (plan.kind != SegmentKind::rise && plan.kind != SegmentKind::fall) {
        if (law && *law != "") in.fail(fmt::format("{} has no law, stated is {}", place, law->dump()));
        return plan;
    }
    plan.laws = {law_named(in, law, "the law of " + place)};
    if (const Json* allowed = member(json, of_segment("laws"));
        allowed && law && allowed->is_array() && std::find(allowed->begin(), allowed->end(), *law) == allowed->end())
        in.fail(fmt::format("the law of {} is {}, which it does not list", place, law->dump()));
    plan.first_coefficient = coefficients;
    plan.start_count = count(in, member(json, of_segment("start")), place + ".start", MotionProgram::most_ends);
    plan.end_count = count(in, member(json, of_segment("end")), place + ".end", MotionProgram::most_ends);
    plan.shape_count = count(in, member(json, of_segment("shape")), place + ".shape", MotionProgram::most_shape);
    coefficients += plan.start_count + plan.end_count + plan.shape_count;
    if (coefficients > MotionProgram::most_coefficients) in.fail("cam.segments have too many coefficients");
    return plan;
}

}  // namespace

void read_cam(Reader& in, const Json& document, Claim& claim) {
    const Json* json = in.object(member(document, of_document("cam")), "cam");
    const Json* design = in.object(member(document, of_document("design")), "design");
    if (!json || !design) return;
    const auto follower = word(in, member(*json, of_cam("follower")), "cam.follower", cam_follower_names);
    const bool angular = word(in, member(*json, of_cam("motion")), "cam.motion", cam_motion_names) == 1;
    claim.mechanism = cam_mechanism(static_cast<CamFollower>(follower), angular);
    if (const Json* contour = member(*json, of_cam("contour"))) {
        const auto kind = static_cast<cam::ContourKind>(word(in, contour, "cam.contour", cam_contour_names) + 1);
        const auto mechanism = contour_cam_mechanism(static_cast<CamFollower>(follower), kind);
        if (angular || mechanism == nullptr) return in.fail("cam.contour does not go with the follower");
        claim.mechanism = with_program(*mechanism, contour_program(kind));
        claim.assembly = word(in, member(*design, of_design("rotation")), "design.rotation", cam_rotation_names);
        return;
    }
    const Json* segments = member(*json, of_cam("segments"));
    const Json* laws = member(*design, of_design("laws"));
    if (!in.array(segments, "cam.segments", MotionProgram::most_segments) ||
        !in.array(laws, "design.laws", MotionProgram::most_segments))
        return;
    if (segments->empty() || laws->size() != segments->size())
        return in.fail("design.laws has not one law for each of cam.segments");
    auto program = std::make_shared<MotionProgram>();
    std::size_t coefficients = 0;
    for (std::size_t i = 0; i < segments->size() && in.understood(); ++i) {
        const std::string place = fmt::format("cam.segments[{}]", i);
        if (!in.object(&(*segments)[i], place)) return;
        program->segments.push_back(segment_of(in, (*segments)[i], &(*laws)[i], place, claim, angular, coefficients));
    }
    claim.mechanism = with_program(*claim.mechanism, program);
    claim.assembly = word(in, member(*design, of_design("rotation")), "design.rotation", cam_rotation_names);
}

}  // namespace mechwright::claims

#include "synthesis/document/cam_document.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "synthesis/document/fields.h"
#include "synthesis/mechanism/cam/cam.h"
#include "synthesis/mechanism/cam/motion_program.h"
#include "synthesis/problem/units.h"

namespace mechwright {

namespace {

using Json = nlohmann::ordered_json;

using namespace names;

std::string_view name_of(cam::SegmentKind kind) { return segment_kind_names[static_cast<std::size_t>(kind)]; }

Json segment_document(const Problem& problem, const SegmentPlan& segment, bool angular) {
    Json json{{of_segment("kind"), name_of(segment.kind)}};
    if (!segment.laws.empty()) {
        Json laws = Json::array();
        for (const std::size_t law : segment.laws)
            laws.push_back(cam_laws()[law].name);
        json[of_segment("laws")] = std::move(laws);
        if (segment.start_count + segment.end_count + segment.shape_count > 0) {
            json[of_segment("start")] = segment.start_count;
            json[of_segment("end")] = segment.end_count;
            json[of_segment("shape")] = segment.shape_count;
        }
    }
    if (segment.table) {
        Json points = Json::array();
        for (std::size_t i = 0; i < segment.table->angle.size(); ++i)
            points.push_back(
                {in_file_unit(segment.table->angle[i], Unit::angle, problem.units),
                 in_file_unit(segment.table->lift[i], angular ? Unit::angle : Unit::length, problem.units)});
        json[of_segment("points")] = std::move(points);
    }
    return json;
}

std::vector<std::string> law_names(const Problem& problem, std::size_t assembly) {
    std::vector<std::string> names;
    for (std::size_t i = 0; i < program_of(*problem.mechanism)->segments.size(); ++i)
        names.emplace_back(program_of(*problem.mechanism)->segments[i].laws.empty()
                               ? std::string_view()
                               : cam_laws()[law_of(*program_of(*problem.mechanism), assembly, i)].name);
    return names;
}

}  // namespace

nlohmann::ordered_json cam_document(const Problem& problem) {
    const CamKind kind = cam_kind(*problem.mechanism);
    Json segments = Json::array();
    for (const SegmentPlan& segment : program_of(*problem.mechanism)->segments)
        segments.push_back(segment_document(problem, segment, kind.oscillating));
    Json json{{of_cam("follower"), cam_follower_names[static_cast<std::size_t>(kind.follower)]},
              {of_cam("motion"), cam_motion_names[kind.oscillating ? 1 : 0]}};
    if (kind.contour != cam::ContourKind::none)
        json[of_cam("contour")] = cam_contour_names[static_cast<std::size_t>(kind.contour) - 1];
    json[of_cam("segments")] = std::move(segments);
    return json;
}

void put_cam_choice(nlohmann::ordered_json& design, const Problem& problem, std::size_t assembly) {
    design[of_design("rotation")] = cam_rotation_names[assembly % 2];
    design[of_design("laws")] = law_names(problem, assembly);
}

std::string cam_choice_text(const Problem& problem, std::size_t assembly) {
    std::string text = assembly % 2 == 0 ? "turning counter-clockwise" : "turning clockwise";
    std::vector<std::string> segments;
    const auto names = law_names(problem, assembly);
    for (std::size_t i = 0; i < names.size(); ++i) {
        const auto kind = name_of(program_of(*problem.mechanism)->segments[i].kind);
        segments.push_back(names[i].empty() ? std::string(kind) : fmt::format("{} {}", names[i], kind));
    }
    return text + "; " + fmt::format("{}", fmt::join(segments, ", "));
}

}  // namespace mechwright

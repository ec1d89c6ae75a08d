#include "synthesis/mechanism/cam/document/cam.h"

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

Json cam_document(const Problem& problem) {
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

void put_cam_choice(Json& design, const Problem& problem, std::size_t assembly) {
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

/// Why the rotation of a cam is none of those that the problem allows, or what is proven of it leaves one of its
/// rotations or choices of laws out.
std::string cam_defect(const Json& document, const Problem& problem) {
    const auto rotation = [&](std::size_t assembly) { return cam_rotation_names[assembly % 2]; };
    const Json::json_pointer of_design("/design/rotation");
    if (document.contains(of_design) && std::none_of(problem.assemblies.begin(), problem.assemblies.end(),
                                                     [&](std::size_t i) { return document[of_design] == rotation(i); }))
        return fmt::format("design.rotation is {}, which was not asked for", claims::shown(&document[of_design]));
    const Json::json_pointer of_proof("/search/certificate/parts");
    if (!document.contains(of_proof) || !document[of_proof].is_array()) return {};
    const Json& parts = document[of_proof];
    for (const std::size_t asked : problem.assemblies)
        if (std::none_of(parts.begin(), parts.end(),
                         [&](const Json& part) { return part.is_object() && part.value("assembly", Json()) == asked; }))
            return fmt::format("search.certificate has no part for cams {}", cam_choice_text(problem, asked));
    return {};
}

}  // namespace

KindInDocuments cam_in_documents() {
    static constexpr std::array<std::string_view, 2> choices{"rotation", "laws"};
    return {"cam", "cam", choices, cam_document, put_cam_choice, cam_choice_text, claims::read_cam, cam_defect};
}

}  // namespace mechwright

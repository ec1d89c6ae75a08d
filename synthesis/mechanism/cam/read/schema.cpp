#include "synthesis/mechanism/cam/read/schema.h"

#include "synthesis/mechanism/cam/cam.h"
#include "synthesis/mechanism/cam/motion_program.h"
#include "synthesis/mechanism/cam/read/keys.h"
#include "synthesis/problem/schema/json_schema.h"

namespace mechwright {

using namespace schema;

std::vector<std::string_view> cam_law_names() {
    std::vector<std::string_view> names;
    for (const NamedLaw& law : cam_laws())
        names.push_back(law.name);
    for (const NamedLaw& law : cam_law_aliases())
        names.push_back(law.name);
    return names;
}

void complete_cam_schema(Json& properties) {
    const auto laws = cam_law_names();
    Json& segments = properties["segment"];
    Json& one = segments["items"]["properties"];
    one["law"].update(any_of({one_of(laws), list_of(one_of(laws))}));
    for (const char* end : {"start", "end"})
        one[end].update(
            any_of({list_of(range_of()), one_of(keys::ends_of_polynomials), table_of(keys::end_of_polynomial)}));
    segments["minItems"] = 1;
    segments["maxItems"] = MotionProgram::most_segments;
}

Json is_cam_of(const Mechanism& mechanism) {
    const CamKind kind = cam_kind(mechanism);
    const std::string_view follower = cam_follower_names[static_cast<std::size_t>(kind.follower)];
    const std::string_view motion = cam_motion_names[kind.oscillating ? 1 : 0];
    Json properties{{"follower", {{"const", follower}}}, {"motion", {{"const", motion}}}};
    Json required = Json::array({"follower"});
    if (kind.oscillating) required.push_back("motion");
    if (kind.contour == cam::ContourKind::none)
        properties["contour"] = false;
    else {
        // Of a specified contour a knife edge has the entry of a roller.
        if (kind.follower == CamFollower::roller) properties["follower"] = one_of(std::array{"knife", "roller"});
        properties["contour"] = {{"const", cam_contour_names[static_cast<std::size_t>(kind.contour) - 1]}};
        required.push_back("contour");
    }
    Json cam{{"properties", std::move(properties)}, {"required", std::move(required)}};
    return {{"properties", {{"mechanism", {{"const", mechanism.name}}}, {"cam", std::move(cam)}}},
            {"required", {"mechanism", "cam"}}};
}

void limit_cam_files(const Mechanism& mechanism, Json& schema) {
    schema["properties"]["motion"]["properties"]["crank_range"] = false;
    if (cam_kind(mechanism).contour != cam::ContourKind::none)
        schema["properties"]["segment"] = false;
    else
        schema["required"].push_back("segment");
}

}  // namespace mechwright

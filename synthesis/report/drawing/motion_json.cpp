#include "synthesis/report/drawing/motion_json.h"

#include <cmath>

#include "synthesis/mechanism/drawing/motion_row.h"
#include "synthesis/problem/units.h"

namespace mechwright {

namespace {

using Json = nlohmann::ordered_json;

Json point(const Vector<double>& p) { return {p.x, p.y}; }

Json points(const std::vector<Vector<double>>& all) {
    Json list = Json::array();
    for (const Vector<double>& p : all)
        list.push_back(point(p));
    return list;
}

Json outline_list(const std::vector<Outline>& all) {
    Json list = Json::array();
    for (const Outline& outline : all) {
        Json vertices = Json::array();
        for (const ArcVertex& v : outline.vertices)
            vertices.push_back({v.at.x, v.at.y, v.bulge});
        list.push_back({{"layer", name_of(outline.layer)}, {"closed", outline.closed}, {"vertices", vertices}});
    }
    return list;
}

Json targets(const FinishedDesign& design) {
    Json list = Json::array();
    for (const TargetPlace& target : design.targets) {
        Json one{{"at", point(target.at)}};
        if (target.direction) one["direction"] = in_file_unit(*target.direction, Unit::angle, design.units);
        if (target.reached) one["reached"] = point(*target.reached);
        list.push_back(std::move(one));
    }
    return list;
}

}  // namespace

Json motion_json(const FinishedDesign& design, const Scene& scene, int steps) {
    Json json{{"mechanism", design.mechanism->name},
              {"units", {{"angle", design.units.degrees ? "deg" : "rad"}, {"length", design.units.length}}}};
    json["bodies"] = Json::array();
    for (const Body& body : scene.bodies)
        json["bodies"].push_back({{"name", body.name},
                                  {"pins", points(body.pins)},
                                  {"points", points(body.points)},
                                  {"outlines", outline_list(body.outlines)}});
    json["pivots"] = points(scene.pivots);
    json["fixed"] = outline_list(scene.fixed);
    json["targets"] = targets(design);
    Json angles = Json::array(), frames = Json::array();
    std::vector<BodyPlace> places(scene.bodies.size());
    for (const double angle : even_angles(design, steps)) {
        angles.push_back(in_file_unit(angle, input_unit(design), design.units));
        if (!place_bodies(design, angle, design.motion.assembly, places)) {
            frames.push_back(nullptr);
            continue;
        }
        Json frame = Json::array();
        for (const BodyPlace& place : places)
            frame.push_back({place.at.x, place.at.y,
                             in_file_unit(std::atan2(place.turn.y, place.turn.x), Unit::angle, design.units)});
        frames.push_back(std::move(frame));
    }
    json["motion"] = {{"angles", std::move(angles)}, {"places", std::move(frames)}};
    return json;
}

}  // namespace mechwright

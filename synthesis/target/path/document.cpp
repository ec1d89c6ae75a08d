#include "synthesis/target/path/document.h"

#include <fmt/format.h>

#include <algorithm>

#include "synthesis/document/fields.h"
#include "synthesis/document/lists.h"
#include "synthesis/program/quantity_value.h"

namespace mechwright {

using Json = nlohmann::ordered_json;

using namespace names;

Json path_document(const Problem& problem, const Solution* best) {
    const PathTarget& target = *problem.path;
    Json json{{of_path("points"), pairs(target.points)},
              {of_path("timing"), target.prescribed_timing ? "prescribed"
                                  : target.any_order       ? "none"
                                                           : "free"},
              {of_path("closed"), target.closed}};
    if (target.guides_body()) {
        json[of_poses("directions")] = angles(target.directions, problem.units);
        json[of_poses("body_length")] = target.body_length;
    }
    if (std::any_of(target.weights.begin(), target.weights.end(), [](double w) { return w != 1; }))
        json[of_path("weights")] = target.weights;
    if (target.prescribed_timing) json[of_path("prescribed_angles")] = angles(target.crank_angles, problem.units);
    if (!best) return json;
    if (const std::optional<PathValues> values = path_values(problem, best->design)) {
        json[of_path("reached")] = pairs(values->reached);
        if (target.guides_body()) json[of_poses("reached_directions")] = angles(values->directions, problem.units);
        json[of_path("crank_angles")] = angles(best->design.path_angles, problem.units);
        json[of_path("distances")] = values->distances;
    }
    return json;
}

namespace claims {

namespace {

/// Numbers, or null where any direction will do.
std::vector<std::optional<double>> read_directions(Reader& in, const Json* json) {
    std::vector<std::optional<double>> directions;
    if (!in.array(json, "poses.directions", most_points)) return directions;
    for (std::size_t i = 0; i < json->size(); ++i) {
        const Json& one = (*json)[i];
        const std::string place = fmt::format("poses.directions[{}]", i);
        directions.push_back(one.is_null() ? std::nullopt : std::optional(in.number(&one, place)));
    }
    return directions;
}

}  // namespace

void read_path(Reader& in, const Json& document, Claim& claim) {
    const Json* poses = member(document, of_document("poses"));
    const Json* json = poses ? poses : member(document, of_document("path"));
    if (!json || !in.object(json, poses ? "poses" : "path")) return;
    if (!claim.mechanism->point)
        return in.fail(fmt::format("a {} guides no point along a path", claim.mechanism->name));
    if (poses && !claim.mechanism->body) return in.fail(fmt::format("a {} guides no body", claim.mechanism->name));
    ClaimedPath path;
    path.points = in.points(member(*json, of_path("points")), "path.points", most_points);
    if (path.points.empty()) in.fail("path.points is empty");
    const std::size_t count = path.points.size();
    if (const Json* timing = member(*json, of_path("timing"))) {
        const std::string name = in.text(timing, "path.timing");
        path.prescribed_timing = name == "prescribed";
        path.any_order = name == "none";
        if (name != "prescribed" && name != "free" && name != "none")
            in.fail("path.timing is not one of free, prescribed and none");
    }
    if (poses) {
        path.directions = read_directions(in, member(*json, of_poses("directions")));
        path.body_length = in.number(member(*json, of_poses("body_length")), "poses.body_length");
        if (const Json* reached = member(*json, of_poses("reached_directions")))
            path.reached_directions = in.numbers(reached, "poses.reached_directions", most_points, true);
        if (path.directions.size() != count) in.fail("poses.directions has not one angle for each point");
        if (!(path.body_length > 0)) in.fail("poses.body_length is not greater than 0");
    }
    if (const Json* closed = member(*json, of_path("closed"))) path.closed = in.flag(closed, "path.closed");
    path.weights.assign(count, 1.0);
    if (const Json* weights = member(*json, of_path("weights")))
        path.weights = in.numbers(weights, "path.weights", most_points, false);
    for (const double w : path.weights)
        if (w < 0) in.fail("path.weights has a negative weight");
    if (path.weights.size() != count) in.fail("path.weights has not one weight for each point");
    if (path.prescribed_timing) {
        path.prescribed_angles =
            in.numbers(member(*json, of_path("prescribed_angles")), "path.prescribed_angles", most_points, true);
        if (path.prescribed_angles.size() != count) in.fail("path.prescribed_angles has not one angle for each point");
    }
    if (const Json* reached = member(*json, of_path("reached")))
        path.reached = in.points(reached, "path.reached", most_points);
    if (const Json* angles = member(*json, of_path("crank_angles")))
        path.crank_angles = in.numbers(angles, "path.crank_angles", most_points, true);
    if (const Json* distances = member(*json, of_path("distances")))
        path.distances = in.numbers(distances, "path.distances", most_points, false);
    claim.path = std::move(path);
}

}  // namespace claims

}  // namespace mechwright

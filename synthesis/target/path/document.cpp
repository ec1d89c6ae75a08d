#include "synthesis/target/path/document.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "synthesis/document/fields.h"
#include "synthesis/document/lists.h"
#include "synthesis/mechanism/input.h"
#include "synthesis/problem/text.h"
#include "synthesis/program/quantity_value.h"
#include "synthesis/target/path/read_parts.h"

namespace mechwright {

using Json = nlohmann::ordered_json;

using namespace names;

namespace {

template <class T>
std::vector<T> at(const std::vector<T>& all, const PointRange& points) {
    const auto from = all.begin() + static_cast<std::ptrdiff_t>(points.first);
    return {from, from + static_cast<std::ptrdiff_t>(points.count)};
}

/// One target of a path: the whole of it where that has no parts.
Json target_document(const Problem& problem, const Design* design, const std::optional<PathValues>& values,
                     const PathPart& part) {
    const PathTarget& target = *problem.path;
    const Unit input = input_unit(*problem.mechanism);
    Json json = Json::object();
    if (!part.name.empty()) json = {{of_path("name"), part.name}, {of_path("weight"), part.weight}};
    json[of_path("points")] = pairs(at(target.points, part.points));
    json[of_path("timing")] = timing_word(target);
    json[of_path("closed")] = part.closed;
    if (part.guides_body) {
        json[of_poses("directions")] = angles(at(target.directions, part.points), problem.units);
        json[of_poses("body_length")] = part.body_length;
    }
    if (std::any_of(part.weights.begin(), part.weights.end(), [](double w) { return w != 1; }))
        json[of_path("weights")] = part.weights;
    if (target.prescribed_timing)
        json[of_path("prescribed_angles")] = in_file_units(at(target.crank_angles, part.points), input, problem.units);
    if (!values) return json;
    json[of_path("reached")] = pairs(at(values->reached, part.points));
    if (part.guides_body)
        json[of_poses("reached_directions")] = angles(at(values->directions, part.points), problem.units);
    json[of_path("crank_angles")] = in_file_units(at(design->path_angles, part.points), input, problem.units);
    json[of_path("distances")] = at(values->distances, part.points);
    return json;
}

}  // namespace

void put_path(Json& json, const Problem& problem, const Solution* best) {
    const PathTarget& path = *problem.path;
    const Design* design = best ? &best->design : nullptr;
    const std::optional<PathValues> values = design ? path_values(problem, *design) : std::nullopt;
    const auto member_of = [](bool body) { return body ? of_finding("poses") : of_finding("path"); };
    if (path.parts.empty()) {
        const PathPart whole{
            {}, 1, {0, path.points.size()}, path.weights, path.closed, path.guides_body(), path.body_length};
        json[member_of(path.guides_body())] = target_document(problem, design, values, whole);
        return;
    }
    for (const PathPart& part : path.parts) {
        Json& list = json[member_of(part.guides_body)];
        if (list.is_null()) list = Json::array();
        list.push_back(target_document(problem, design, values, part));
    }
}

namespace {

/// The entries of a list that belong to some points, where it is one that has them.
Json entries_at(const Json& list, std::size_t first, std::size_t count) {
    if (!list.is_array() || list.size() < first + count) return {};
    Json some = Json::array();
    for (std::size_t i = first; i < first + count; ++i)
        some.push_back(list[i]);
    return some;
}

}  // namespace

void put_reached(Json& document, const Json* crank_angles, const Json* distances) {
    std::size_t first = 0;
    for (const char* kind : {of_finding("path"), of_finding("poses")}) {
        if (!document.contains(kind)) continue;
        Json& targets = document[kind];
        const auto put = [&](Json& target, std::size_t count, bool alone) {
            for (const char* reached :
                 {of_poses("reached"), of_poses("reached_directions"), of_poses("crank_angles"), of_poses("distances")})
                target.erase(reached);
            for (const auto& [name, list] :
                 {std::pair(of_path("crank_angles"), crank_angles), {of_path("distances"), distances}})
                if (list != nullptr) target[name] = alone ? *list : entries_at(*list, first, count);
            first += count;
        };
        if (targets.is_object()) put(targets, 0, true);
        for (std::size_t i = 0; targets.is_array() && i < targets.size(); ++i) {
            if (!targets[i].is_object()) continue;
            const Json points = targets[i].value(of_path("points"), Json());
            put(targets[i], points.is_array() ? points.size() : 0, false);
        }
    }
}

namespace claims {

namespace {

/// Numbers, or null where any direction will do.
std::vector<std::optional<double>> read_directions(Reader& in, const Json* json, const std::string& place) {
    std::vector<std::optional<double>> directions;
    if (!in.array(json, place, most_points)) return directions;
    for (std::size_t i = 0; i < json->size(); ++i) {
        const Json& one = (*json)[i];
        directions.push_back(one.is_null() ? std::nullopt
                                           : std::optional(in.number(&one, fmt::format("{}[{}]", place, i))));
    }
    return directions;
}

/// One target, as it would stand alone. `path` and `poses` are the places that messages name.
ClaimedPath read_target(Reader& in, const Json& json, const Mechanism& mechanism, bool is_body, const std::string& path,
                        const std::string& poses) {
    const bool by_angles = input_unit(mechanism) == Unit::angle;
    ClaimedPath target;
    target.points = in.points(member(json, of_path("points")), path + ".points", most_points);
    if (target.points.empty()) in.fail(path + ".points is empty");
    const std::size_t count = target.points.size();
    if (const Json* timing = member(json, of_path("timing"))) {
        const std::string name = in.text(timing, path + ".timing");
        target.prescribed_timing = name == "prescribed";
        target.any_order = name == "none";
        if (name != "prescribed" && name != "free" && name != "none")
            in.fail(path + ".timing is not one of free, prescribed and none");
    }
    if (is_body) {
        target.directions = read_directions(in, member(json, of_poses("directions")), poses + ".directions");
        target.body_length = in.number(member(json, of_poses("body_length")), poses + ".body_length");
        if (const Json* reached = member(json, of_poses("reached_directions")))
            target.reached_directions = in.numbers(reached, poses + ".reached_directions", most_points, true);
        if (target.directions.size() != count) in.fail(poses + ".directions has not one angle for each point");
        if (!(target.body_length > 0)) in.fail(poses + ".body_length is not greater than 0");
    }
    if (const Json* closed = member(json, of_path("closed"))) target.closed = in.flag(closed, path + ".closed");
    target.weights.assign(count, 1.0);
    if (const Json* weights = member(json, of_path("weights")))
        target.weights = in.numbers(weights, path + ".weights", most_points, false);
    for (const double w : target.weights)
        if (w < 0) in.fail(path + ".weights has a negative weight");
    if (target.weights.size() != count) in.fail(path + ".weights has not one weight for each point");
    if (target.prescribed_timing) {
        target.prescribed_angles =
            in.numbers(member(json, of_path("prescribed_angles")), path + ".prescribed_angles", most_points, by_angles);
        if (target.prescribed_angles.size() != count)
            in.fail(path + ".prescribed_angles has not one angle for each point");
    }
    if (const Json* reached = member(json, of_path("reached")))
        target.reached = in.points(reached, path + ".reached", most_points);
    if (const Json* angles = member(json, of_path("crank_angles")))
        target.crank_angles = in.numbers(angles, path + ".crank_angles", most_points, by_angles);
    if (const Json* distances = member(json, of_path("distances")))
        target.distances = in.numbers(distances, path + ".distances", most_points, false);
    return target;
}

/// What is stated of the points of one of several targets is stated of all of its points, or of none.
template <class Member>
void check_length(Reader& in, const Json& json, const char* name, const std::vector<Member>& list, std::size_t count,
                  const std::string& place) {
    if (member(json, name) && list.size() != count)
        in.fail(fmt::format("{}.{} has not one entry for each point", place, name));
}

/// Adds one of several targets.
void add_target(Reader& in, const Json& json, bool is_body, const std::string& place, Claim& claim, PathTarget& whole,
                ClaimedPath& all) {
    if (!in.object(&json, place)) return;
    ClaimedPath one = read_target(in, json, *claim.mechanism, is_body, place, place);
    const std::string name = in.text(member(json, of_path("name")), place + ".name");
    const double weight = in.number(member(json, of_path("weight")), place + ".weight");
    const std::size_t count = one.points.size(), number = whole.parts.size();
    const auto& guided = claim.mechanism->guided;
    if (!(weight > 0)) in.fail(place + ".weight is not greater than 0");
    if (std::none_of(one.weights.begin(), one.weights.end(), [](double w) { return w > 0; }))
        in.fail(place + ".weights are all 0");
    if (number >= guided.size() || guided[number].name != name || guided[number].body.has_value() != is_body)
        return in.fail(fmt::format("{}: the linkage has no such target {} there", place, reading::quoted(name)));
    if (number > 0 && (one.prescribed_timing != all.prescribed_timing || one.any_order != all.any_order))
        in.fail(place + ".timing is not that of the others");
    check_length(in, json, of_path("reached"), one.reached, count, place);
    check_length(in, json, of_path("crank_angles"), one.crank_angles, count, place);
    check_length(in, json, of_path("distances"), one.distances, count, place);
    if (is_body) check_length(in, json, of_poses("reached_directions"), one.reached_directions, count, place);
    if (!in.understood()) return;
    PathTarget alone{one.points, one.prescribed_timing, one.any_order, {}, one.closed, one.weights, {}, 0};
    if (is_body) {
        alone.directions.assign(count, 0);
        alone.body_length = one.body_length;
    }
    add_part(whole, std::move(alone), name, weight);
    all.prescribed_timing = one.prescribed_timing;
    all.any_order = one.any_order;
    // At points of a path there are no directions.
    one.directions.resize(count);
    one.reached_directions.resize(is_body ? one.reached_directions.size() : count);
    const auto append = [](auto& list, const auto& some) { list.insert(list.end(), some.begin(), some.end()); };
    append(all.prescribed_angles, one.prescribed_angles);
    append(all.directions, one.directions);
    append(all.reached, one.reached);
    append(all.reached_directions, one.reached_directions);
    append(all.crank_angles, one.crank_angles);
    append(all.distances, one.distances);
}

/// Targets that have names.
void read_targets(Reader& in, const Json& document, Claim& claim) {
    PathTarget whole;
    ClaimedPath all;
    for (const bool is_body : {false, true}) {
        const std::string kind = is_body ? of_document("poses") : of_document("path");
        const Json* list = member(document, kind);
        if (list == nullptr || !in.array(list, kind, claim.mechanism->guided.size())) continue;
        for (std::size_t i = 0; i < list->size() && in.understood(); ++i)
            add_target(in, (*list)[i], is_body, fmt::format("{}[{}]", kind, i), claim, whole, all);
    }
    if (whole.parts.size() != claim.mechanism->guided.size())
        in.fail("path and poses do not have all targets that the linkage has");
    if (!in.understood()) return;
    if (!whole.guides_body()) {
        all.directions.clear();
        all.reached_directions.clear();
    }
    all.points = std::move(whole.points);
    all.closed = whole.closed;
    all.weights = std::move(whole.weights);
    all.body_length = whole.body_length;
    all.parts = std::move(whole.parts);
    all.part_of = std::move(whole.part_of);
    claim.path = std::move(all);
}

}  // namespace

void read_path(Reader& in, const Json& document, Claim& claim) {
    if (!claim.mechanism->guided.empty()) return read_targets(in, document, claim);
    const Json* poses = member(document, of_document("poses"));
    const Json* json = poses ? poses : member(document, of_document("path"));
    if (!json || !in.object(json, poses ? "poses" : "path")) return;
    if (!claim.mechanism->point)
        return in.fail(fmt::format("a {} guides no point along a path", claim.mechanism->name));
    if (poses && !claim.mechanism->body) return in.fail(fmt::format("a {} guides no body", claim.mechanism->name));
    claim.path = read_target(in, *json, *claim.mechanism, poses != nullptr, "path", "poses");
}

}  // namespace claims

}  // namespace mechwright

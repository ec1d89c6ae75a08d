#include "synthesis/document/followed_document.h"

#include "synthesis/problem/units.h"
#include "synthesis/program/error_extremes.h"

namespace mechwright {

namespace {

using Json = nlohmann::ordered_json;

}  // namespace

Json followed_document(const Problem& problem, const Design* design) {
    Json json = Json::object();
    json["full_turn"] = problem.followed->full_turn;
    if (!design) return json;
    const ErrorExtremes extremes = error_extremes_of(problem, *design);
    json["extremes"] = Json::array();
    for (const auto& e : extremes.all)
        json["extremes"].push_back({{"crank_angle", place_of(problem, *design, e.share)}, {"distance", e.error}});
    json["alternating"] = extremes.alternating;
    json["free"] = extremes.free;
    return json;
}

}  // namespace mechwright

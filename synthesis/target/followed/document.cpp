#include "synthesis/target/followed/document.h"

#include "synthesis/document/fields.h"
#include "synthesis/program/alternation/error_extremes.h"
#include "synthesis/target/over_input/document.h"

namespace mechwright {

namespace {

using Json = nlohmann::ordered_json;

using namespace names;

}  // namespace

Json followed_document(const Problem& problem, const InputTask& task, const Design* design) {
    Json json = named(task);
    json[of_followed("full_turn")] = task.asked.full_turn;
    if (!design) return json;
    const ErrorExtremes extremes = error_extremes_of(problem, task, *design);
    json[of_followed("extremes")] = Json::array();
    for (const auto& e : extremes.all)
        json[of_followed("extremes")].push_back(
            {{of_distance("crank_angle"), place_of(problem, task, *design, e.share)},
             {of_distance("distance"), e.error}});
    json[of_followed("alternating")] = extremes.alternating;
    json[of_followed("free")] = extremes.free;
    return json;
}

}  // namespace mechwright

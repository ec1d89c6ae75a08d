#include "synthesis/target/followed/document.h"

#include <fmt/format.h>

#include "synthesis/document/fields.h"
#include "synthesis/problem/units.h"
#include "synthesis/program/error_extremes.h"

namespace mechwright {

namespace {

using Json = nlohmann::ordered_json;

using namespace names;

}  // namespace

Json followed_document(const Problem& problem, const Design* design) {
    Json json = Json::object();
    json[of_followed("full_turn")] = problem.followed->full_turn;
    if (!design) return json;
    const ErrorExtremes extremes = error_extremes_of(problem, *design);
    json[of_followed("extremes")] = Json::array();
    for (const auto& e : extremes.all)
        json[of_followed("extremes")].push_back(
            {{of_distance("crank_angle"), place_of(problem, *design, e.share)}, {of_distance("distance"), e.error}});
    json[of_followed("alternating")] = extremes.alternating;
    json[of_followed("free")] = extremes.free;
    return json;
}

namespace claims {

void read_followed(Reader& in, const Json& document, Claim& claim) {
    for (const auto& [name, shape] :
         {std::pair{of_document("line"), Followed::line}, std::pair{of_document("arc"), Followed::arc}}) {
        const Json* json = member(document, name);
        if (!json || !in.object(json, name)) continue;
        claim.followed = FollowedTarget{shape};
        if (!followed_shape_of(*claim.mechanism, *claim.followed))
            return in.fail(fmt::format("a {} follows no {}", claim.mechanism->name, name));
        if (const Json* turns = member(*json, of_followed("full_turn")))
            claim.followed->full_turn = in.flag(turns, std::string(name) + ".full_turn");
    }
}

}  // namespace claims

}  // namespace mechwright

#include "synthesis/target/over_input/document.h"

#include <fmt/format.h>

#include <array>
#include <memory>
#include <utility>

#include "synthesis/document/fields.h"
#include "synthesis/problem/text.h"
#include "synthesis/target/followed/document.h"
#include "synthesis/target/function/document.h"

namespace mechwright {

using Json = nlohmann::ordered_json;

using namespace names;

Json named(const InputTask& task) {
    if (task.asked.name.empty()) return Json::object();
    return {{of_function("name"), task.asked.name}, {of_function("weight"), task.asked.weight}};
}

void put_over_input(Json& json, const Problem& problem, const Design* design) {
    for (const InputTask& task : input_tasks(problem)) {
        Json one =
            task.is_function() ? function_document(problem, task, design) : followed_document(problem, task, design);
        Json& member = json[task.section()];
        if (task.asked.name.empty()) {
            member = std::move(one);
            continue;
        }
        if (member.is_null()) member = Json::array();
        member.push_back(std::move(one));
    }
}

namespace claims {

namespace {

constexpr std::array<std::pair<const char*, Followed>, 3> sections{{{of_document("function"), Followed::nothing},
                                                                    {of_document("line"), Followed::line},
                                                                    {of_document("arc"), Followed::arc}}};

/// What a document says of one of them, without its name and weight.
AskedOverInput read_one(Reader& in, const Json& json, Followed followed, const std::string& place) {
    AskedOverInput asked;
    asked.followed = followed;
    if (followed == Followed::nothing)
        asked.function = read_function(in, json, place);
    else if (const Json* turns = member(json, of_followed("full_turn")))
        asked.full_turn = in.flag(turns, place + ".full_turn");
    return asked;
}

/// One that stands alone.
void read_alone(Reader& in, const Json& document, Claim& claim) {
    const Mechanism& mechanism = *claim.mechanism;
    for (const auto& [name, followed] : sections) {
        const Json* json = member(document, name);
        if (!json || !in.object(json, name)) continue;
        if (followed == Followed::nothing) {
            if (!mechanism.function) return in.fail(fmt::format("a {} generates no functions", mechanism.name));
            claim.function = read_one(in, *json, followed, name).function;
        } else {
            const FollowedTarget target{followed, read_one(in, *json, followed, name).full_turn};
            if (!followed_shape_of(mechanism, target))
                return in.fail(fmt::format("a {} follows no {}", mechanism.name, name));
            claim.followed = target;
        }
        if (!in.understood()) return;
    }
}

/// Those that have names, all of which the linkage has.
void read_named(Reader& in, const Json& document, Claim& claim) {
    const std::vector<InputTarget>& targets = claim.mechanism->over_input;
    auto all = std::make_shared<std::vector<AskedOverInput>>();
    for (const auto& [section, followed] : sections) {
        const Json* list = member(document, section);
        if (list == nullptr || !in.array(list, section, targets.size())) continue;
        for (std::size_t i = 0; i < list->size() && in.understood(); ++i) {
            const Json& json = (*list)[i];
            const std::string place = fmt::format("{}[{}]", section, i);
            if (!in.object(&json, place)) return;
            AskedOverInput asked = read_one(in, json, followed, place);
            asked.name = in.text(member(json, of_function("name")), place + ".name");
            asked.weight = in.number(member(json, of_function("weight")), place + ".weight");
            if (!(asked.weight > 0)) in.fail(place + ".weight is not greater than 0");
            const bool known = all->size() < targets.size() && targets[all->size()].name == asked.name &&
                               (targets[all->size()].shape ? targets[all->size()].shape->name : "function") == section;
            if (!known)
                return in.fail(
                    fmt::format("{}: the linkage has no such target {} there", place, reading::quoted(asked.name)));
            all->push_back(std::move(asked));
        }
    }
    if (all->size() != targets.size()) in.fail("function, line and arc do not have all targets that the linkage has");
    if (in.understood()) claim.over_input = std::move(all);
}

}  // namespace

void read_over_input(Reader& in, const Json& document, Claim& claim) {
    claim.mechanism->over_input.empty() ? read_alone(in, document, claim) : read_named(in, document, claim);
}

}  // namespace claims

}  // namespace mechwright

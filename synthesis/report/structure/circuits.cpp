#include "synthesis/report/structure/circuits.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>

#include "synthesis/mechanism/linkage/branches.h"
#include "synthesis/mechanism/linkage/limit_text.h"
#include "synthesis/problem/linkage/closing.h"
#include "synthesis/problem/linkage/sides.h"
#include "synthesis/report/structure/assemblies.h"
#include "synthesis/report/text/table.h"

namespace mechwright {

namespace {

using Json = nlohmann::ordered_json;

/// All branches, with the unit of inputs as the file has them.
struct FileBranches {
    AllBranches all{};
    double unit = 1;
};

std::optional<FileBranches> branches_of(const Linkage& l) {
    const std::vector<double> numbers = numbers_of(l, usual_dimensions(l));
    const double size = linkage::farthest_point(l.structure, numbers);
    const bool slide = l.structure.drives.front().of_slide;
    linkage::Driven<double> moving = driven(l, numbers);
    moving.sides.assign(l.order.choices, 1);
    const std::optional<int> turns = slide ? std::optional(1) : turns_of_cycle(l.structure, moving);
    if (!turns && !l.structure.drives.front().stops.any()) return {};
    linkage::Inputs inputs = linkage::inputs_of(l.structure, numbers, size, turns.value_or(1));
    // Inputs of order one, as radians are.
    constexpr double sizes = 4;  // where nothing stops it
    const double far = std::max({size, std::abs(inputs.from) / sizes, std::abs(inputs.to) / sizes});
    if (!slide && inputs.to - inputs.from > 4 * std::numbers::pi * linkage::most_turns) return {};
    const double length = slide && far > 0 ? std::exp2(std::round(std::log2(far))) : 1;
    for (linkage::DriveLaw& law : moving.laws)
        law.ratio *= length;
    inputs.from /= length;
    inputs.to /= length;
    auto all = all_branches(moving, l.structure, l.redundant, numbers, inputs);
    if (!all) return {};
    return FileBranches{std::move(*all), slide ? length : l.units.degrees ? 180 / std::numbers::pi : 1};
}

}  // namespace

Json circuits_of(const Linkage& l) {
    const auto all = branches_of(l);
    if (!all) return nullptr;
    Json circuits = Json::array();
    for (const linkage::Branch& branch : all->all.branches) {
        if (static_cast<std::size_t>(branch.circuit) > circuits.size())
            circuits.push_back({{"circuit", branch.circuit}, {"branches", Json::array()}});
        const linkage::Travel& travel = branch.travel;
        Json one{{"branch", branch.branch}, {"sides", Json::object()}};
        for (const linkage::Group* group : chosen_dyads(l))
            one["sides"][l.pins[group->pin]] = word_of(*group, all->all.assemblies[branch.assembly][group->choice]);
        one["from"] = travel.from * all->unit;
        one["to"] = travel.to * all->unit;
        one["whole"] = travel.whole;
        for (const auto& [key, limit] : {std::pair("from-end", &travel.first), {"to-end", &travel.last}})
            if (limit->exists()) one[key] = limit_text(l.order, *limit, l.links, l.pins, l.slides);
        circuits.back()["branches"].push_back(std::move(one));
    }
    return circuits;
}

std::string circuits_text(const Linkage& l, const Json& circuits) {
    const bool slide = l.structure.drives.front().of_slide;
    std::string text = fmt::format("\nCircuits: {}\n", circuits.size());
    std::size_t shown = 0;
    for (const Json& circuit : circuits)
        for (const Json& branch : circuit["branches"]) {
            constexpr std::size_t most = 64;
            if (++shown > most) return text + "  ...\n";
            std::string sides;
            for (const auto& [pin, side] : branch["sides"].items())
                sides += fmt::format("{}{}{}{}", sides.empty() ? "" : ", ", pin, tied_space, side.get<std::string>());
            std::string motion = "the drive turns fully";
            if (!branch["whole"].get<bool>()) {
                motion = fmt::format("{} {} to {}", slide ? "displacement" : "crank angle",
                                     number_text(branch["from"].get<double>(), 6),
                                     number_text(branch["to"].get<double>(), 6));
                const auto end = [&](const char* key) {
                    return branch.value(key, std::string("where nothing does it"));
                };
                motion += fmt::format(": ends {} and {}", end("from-end"), end("to-end"));
            }
            text += folded(fmt::format("  {}.{}  ", circuit["circuit"].get<int>(), branch["branch"].get<int>()),
                           (sides.empty() ? "" : sides + "; ") + motion);
        }
    return text;
}

}  // namespace mechwright

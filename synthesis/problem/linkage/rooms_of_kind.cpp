#include "synthesis/problem/linkage/rooms_of_kind.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cassert>
#include <nlohmann/json.hpp>
#include <utility>
#include <vector>

#include "synthesis/mechanism/linkage/rooms/with_rooms.h"
#include "synthesis/problem/linkage/expand.h"
#include "synthesis/problem/linkage/reading.h"
#include "synthesis/problem/schema/keys.h"
#include "synthesis/problem/toml/made_table.h"

namespace mechwright {

namespace {

using Json = nlohmann::ordered_json;

/// What the file of a kind can have, and its document repeats.
constexpr std::array<std::string_view, 2> of_rooms{"room", "region"};

/// Sums of a linkage's dimensions as sums of the kind's, by their names. What the kind has not is a number that is
/// given in the placement.
class ByName {
public:
    ByName(const Mechanism& kind, const Linkage& linkage)
        : kind_(kind), linkage_(linkage), dimensions_(dimensions_of(linkage)) {}

    void operator()(Affine& sum) const {
        std::erase_if(sum.terms, [&](auto& term) {
            auto& [dimension, factor] = term;
            const std::string& name = dimensions_[dimension].name;
            const int index = find_dimension(kind_, name);
            dimension = static_cast<std::size_t>(index);
            if (index < 0) sum.constant += factor * given(name);
            return index < 0;
        });
        std::sort(sum.terms.begin(), sum.terms.end());
    }

private:
    double given(std::string_view name) const {
        const auto& all = linkage_.placement;
        const auto at =
            std::find_if(all.begin(), all.end(), [&](const LinkageAnchor& one) { return one.range.name == name; });
        return at == all.end() ? 0 : at->range.min;
    }

    const Mechanism& kind_;
    const Linkage& linkage_;
    std::vector<Dimension> dimensions_;
};

/// A kind as the linkage that it is.
struct KindAsLinkage {
    Linkage linkage;  ///< in the first of its assemblies
    LinkageModel model;

    explicit KindAsLinkage(const Mechanism& kind) : linkage(linkage_in(kind, 0)), model(model_of(linkage)) {
        const ByName by_name(kind, linkage);
        for (Affine& number : model.numbers)
            by_name(number);
        for (Affine& number : model.placement)
            by_name(number);
        model.sides.push_back(linkage.sides);
        for (std::size_t assembly = 1; assembly < kind.assemblies.size(); ++assembly)
            model.sides.push_back(linkage_in(kind, assembly).sides);
    }

private:
    static Linkage linkage_in(const Mechanism& kind, std::size_t assembly) {
        ReadLinkage read = parse_linkage(linkage_of_kind(kind, assembly), "");
        assert(read.ok());
        return std::move(read.linkage);
    }
};

/// The mechanism with the rooms and regions of a file; itself where it has none that could be read.
std::shared_ptr<const Mechanism> with_rooms_of_file(reading::Section& file,
                                                    const std::shared_ptr<const Mechanism>& mechanism,
                                                    const Units& units, reading::Messages& messages) {
    KindAsLinkage kind(*mechanism);
    kind.linkage.units = units;
    reading::LinkageReading reading{file, kind.linkage, messages};
    reading::read_rooms(reading);
    kind.model.rooms = std::move(kind.linkage.rooms);
    kind.model.regions = std::move(kind.linkage.regions);
    if (kind.model.rooms.empty() && kind.model.regions.empty()) return mechanism;
    return with_rooms(mechanism, std::move(kind.model), reading::sections_named(*file.table, of_rooms).dump());
}

}  // namespace

MadeAgain with_rooms_of(const std::shared_ptr<const Mechanism>& kind, const Json& document, const Units& units) {
    Json sections = Json::object();
    for (const std::string_view name : of_rooms)
        if (const auto at = document.find(name); at != document.end()) sections[std::string(name)] = *at;
    if (sections.empty()) return {kind, {}};
    if (!kind->as_linkage) return {{}, "are of links and joints, and this mechanism has none"};
    if (!is_plain(sections)) return {{}, "are no sections of a file"};
    const reading::MadeTable made = reading::made_table(sections);
    reading::Messages messages{.file = {}, .nodes = &made.nodes};
    reading::Section file{&made.table, "", {1, 1}, keys::of_file()};
    const auto mechanism = with_rooms_of_file(file, kind, units, messages);
    if (!messages.failed) return {mechanism, {}};
    return {{}, "are wrong: " + to_string(reading::sorted(std::move(messages)).front())};
}

namespace reading {

void read_rooms_of_kind(Section& file, Problem& problem, Messages& messages) {
    bool any = false;
    for (const std::string_view name : of_rooms) {
        const toml::node* node = find(file, name);
        any = any || node != nullptr;
        if (node == nullptr || problem.mechanism == nullptr || problem.mechanism->as_linkage) continue;
        add_error(messages, place_of(*node),
                  fmt::format("[[{}]] is of links and joints, and a {} has none: leave it out", name,
                              problem.mechanism->name));
    }
    if (any && problem.mechanism != nullptr && problem.mechanism->as_linkage)
        problem.mechanism = with_rooms_of_file(file, problem.mechanism, problem.units, messages);
}

}  // namespace reading

}  // namespace mechwright

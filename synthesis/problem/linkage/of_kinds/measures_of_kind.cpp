#include "synthesis/problem/linkage/of_kinds/measures_of_kind.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cassert>
#include <nlohmann/json.hpp>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "synthesis/mechanism/linkage/with_measures.h"
#include "synthesis/mechanism/whole_quantities.h"
#include "synthesis/problem/linkage/model.h"
#include "synthesis/problem/linkage/of_kinds/expand.h"
#include "synthesis/problem/linkage/reading.h"
#include "synthesis/problem/schema/keys.h"
#include "synthesis/problem/sections/sections.h"
#include "synthesis/problem/toml/made_table.h"

namespace mechwright {

namespace {

using Json = nlohmann::ordered_json;

/// What the file of a kind can have, and its document repeats.
constexpr std::array<std::string_view, 3> of_linkages{"signals", "room", "region"};

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

/// Signals have no names of quantities that the kind has.
void check_names(const Mechanism& mechanism, reading::LinkageReading& reading, std::size_t own) {
    for (const LinkageSignal& signal : std::span(reading.made.signals).subspan(own))
        if (find_quantity(whole_of(mechanism), signal.name) >= 0)
            add_error(reading.messages,
                      key_place(*read_section(reading.file, "signals", reading.messages), signal.name),
                      fmt::format("'{}' cannot be the name of a signal: it is a quantity already", signal.name));
}

bool has_signal(const Linkage& linkage, std::string_view name) {
    return std::any_of(linkage.signals.begin(), linkage.signals.end(),
                       [&](const LinkageSignal& one) { return one.name == name; });
}

/// Where a file says a text, or the place given.
reading::FilePlace place_of_text(const toml::node& node, std::string_view text, reading::FilePlace otherwise) {
    if (node.value_exact<std::string>() == text) return reading::place_of(node);
    reading::FilePlace found = otherwise;
    const auto look = [&](const toml::node& below) { found = place_of_text(below, text, found); };
    if (const toml::table* table = node.as_table())
        for (const auto& [key, below] : *table)
            look(below);
    if (const toml::array* list = node.as_array())
        for (const toml::node& below : *list)
            look(below);
    return found;
}

/// The quantities of signals among these names, without what is said of the whole motion; reports those that are none
/// though they begin with the name of a signal.
std::vector<NamedMeasure> asked_of(reading::LinkageReading& reading, std::span<const std::string> names) {
    std::vector<NamedMeasure> asked;
    std::string fault;
    for (const std::string& name : names) {
        const std::string plain(without_whole(name));
        if (plain.find('.') == std::string::npos) continue;
        if (const auto quantity = to_linkage_quantity(reading.made, plain, fault))
            asked.push_back({plain, *quantity});
        else if (has_signal(reading.made, plain.substr(0, plain.find('.'))))
            add_error(reading.messages, place_of_text(*reading.file.table, name, reading.file.place), fault);
    }
    return asked;
}

/// The mechanism with the signals, rooms and regions of a file, and the quantities of these names; itself where it has
/// none that could be read.
std::shared_ptr<const Mechanism> with_those_of_file(reading::Section& file,
                                                    const std::shared_ptr<const Mechanism>& mechanism,
                                                    const Units& units, std::span<const std::string> names,
                                                    reading::Messages& messages) {
    KindAsLinkage kind(*mechanism);
    kind.linkage.units = units;
    reading::LinkageReading reading{file, kind.linkage, messages};
    reading::read_rooms(reading);
    const std::size_t own = kind.linkage.signals.size();
    reading::read_signal_section(reading);
    check_names(*mechanism, reading, own);
    if (const std::string why = messages.failed ? "" : why_no_mechanism(kind.linkage); !why.empty())
        add_error(messages, place_of(file, "signals"), why);
    // Where something is wrong its quantities are known all the same, so that they are not called unknown, too.
    LinkageModel read = model_of(kind.linkage);
    kind.model.signals = std::move(read.signals);
    kind.model.signal_names = std::move(read.signal_names);
    kind.model.rooms = std::move(kind.linkage.rooms);
    kind.model.regions = std::move(kind.linkage.regions);
    const std::vector<NamedMeasure> asked = asked_of(reading, names);
    const bool any = kind.linkage.signals.size() > own || !kind.model.rooms.empty() || !kind.model.regions.empty();
    if (!any && asked.empty()) return mechanism;
    return with_measures(mechanism, std::move(kind.model), own, asked,
                         reading::sections_named(*file.table, of_linkages).dump());
}

/// Whether one of these names can be that of a quantity of a signal.
bool can_be_of_signals(std::span<const std::string> names) {
    return std::any_of(names.begin(), names.end(),
                       [](const std::string& name) { return without_whole(name).find('.') != std::string::npos; });
}

}  // namespace

MadeAgain with_measures_of(const std::shared_ptr<const Mechanism>& kind, const Json& document,
                           std::span<const std::string> quantities, const Units& units) {
    Json sections = Json::object();
    for (const std::string_view name : of_linkages)
        if (const auto at = document.find(name); at != document.end()) sections[std::string(name)] = *at;
    if (sections.empty() && !(kind->as_linkage && can_be_of_signals(quantities))) return {kind, {}};
    if (!kind->as_linkage) return {{}, "are of links and joints, and this mechanism has none"};
    if (!is_plain(sections)) return {{}, "are no sections of a file"};
    const reading::MadeTable made = reading::made_table(sections);
    reading::Messages messages{.file = {}, .nodes = &made.nodes};
    reading::Section file{&made.table, "", {1, 1}, keys::of_file()};
    const auto mechanism = with_those_of_file(file, kind, units, quantities, messages);
    if (!messages.failed) return {mechanism, {}};
    return {{}, "are wrong: " + to_string(reading::sorted(std::move(messages)).front())};
}

namespace reading {

void read_measures_of_kind(Section& file, Problem& problem, Messages& messages) {
    const std::vector<std::string> names = quantities_in(*file.table);
    bool any = can_be_of_signals(names);
    for (const std::string_view name : of_linkages) {
        const toml::node* node = find(file, name);
        any = any || node != nullptr;
        if (node == nullptr || problem.mechanism == nullptr || problem.mechanism->as_linkage) continue;
        add_error(messages, place_of(*node),
                  fmt::format("{} is of links and joints, and a {} has none: leave it out",
                              name == "signals" ? "[signals]" : fmt::format("[[{}]]", name), problem.mechanism->name));
    }
    if (any && problem.mechanism != nullptr && problem.mechanism->as_linkage)
        problem.mechanism = with_those_of_file(file, problem.mechanism, problem.units, names, messages);
}

}  // namespace reading

}  // namespace mechwright

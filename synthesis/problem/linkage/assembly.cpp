// [assembly]: on which side each dyad is closed, and whether what is given closes so.

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <numbers>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "synthesis/mechanism/linkage/limit_text.h"
#include "synthesis/problem/linkage/closing.h"
#include "synthesis/problem/linkage/reading.h"
#include "synthesis/problem/linkage/sides.h"
#include "synthesis/problem/text.h"

namespace mechwright::reading {

namespace {

using Kind = linkage::Group::Kind;

/// The dyad of two assemblies that a key names: by its inner pin or its slide.
const linkage::Group* find_group(const Linkage& made, std::string_view key) {
    for (const linkage::Group& group : made.order.groups) {
        if (group.choice == linkage::none || made.links.empty()) continue;
        if (made.pins[group.pin] == key) return &group;
        if (group.by_slide && group.joint < made.slides.size() && made.slides[group.joint] == key) return &group;
    }
    return nullptr;
}

constexpr std::array<std::string_view, 5> any_side{"left", "right", "either", "ahead", "behind"};

/// Whether nothing is to be said of a side: of a redundant link, or of a dyad that redundant links keep a
/// parallelogram.
bool is_decided(const Linkage& made, std::string_view key, const linkage::Group* group) {
    return (group != nullptr && is_redundant(made, group->links[0])) ||
           std::any_of(made.kept_by_redundant.begin(), made.kept_by_redundant.end(),
                       [&](std::size_t pin) { return made.pins[pin] == key; });
}

std::vector<std::string_view> keys_of_dyads(const Linkage& made) {
    std::vector<std::string_view> keys;
    for (const linkage::Group& group : made.order.groups)
        if (group.choice != linkage::none && !is_redundant(made, group.links[0])) keys.push_back(made.pins[group.pin]);
    return keys;
}

/// 1, -1 or 0 for the word of a side; absent if it is none of them.
std::optional<std::int8_t> side_of(LinkageReading& reading, const toml::node& node, const linkage::Group& group,
                                   const std::string& what) {
    const auto word = to_choice(node, what, "side", side_words(group), reading.messages);
    if (!word) return {};
    return static_cast<std::int8_t>(*word == 0 ? 1 : *word == 1 ? -1 : 0);
}

/// { side = "left", from = "B", to = "D" }
std::optional<std::int8_t> side_between(LinkageReading& reading, const toml::table& table, const linkage::Group& group,
                                        const std::string& what) {
    const Linkage& made = reading.made;
    Section section{&table, what, place_of(table)};
    if (has(section, "group") || has(section, "index")) {
        add_error(
            reading.messages, section.place,
            fmt::format("{}: a dyad is told by its side; {{ group, index }} is of groups that are no dyads", what));
        return {};
    }
    const toml::node* node = find(section, "side");
    if (node == nullptr) add_error(reading.messages, section.place, fmt::format("'side' in {} is missing", what));
    const auto side = node == nullptr ? std::nullopt : side_of(reading, *node, group, what);
    const auto from = read_string(section, "from", reading.messages), to = read_string(section, "to", reading.messages);
    report_unknown_keys(section, reading.messages);
    if (!side || (!from && !to)) return side;
    if (group.kind != Kind::rrr || !from || !to) {
        add_error(reading.messages, section.place,
                  fmt::format("{}: 'from' and 'to' are the two outer pins of a dyad of two links", what));
        return {};
    }
    const std::string &first = made.pins[group.outer[0]], &second = made.pins[group.outer[1]];
    if (*from == first && *to == second) return side;
    if (*from == second && *to == first) return static_cast<std::int8_t>(-*side);
    add_error(reading.messages, section.place,
              fmt::format("{}: the outer pins of this dyad are '{}' and '{}'", what, first, second));
    return {};
}

/// Lengths that a dyad is made of and that are 0.
bool report_no_length(LinkageReading& reading, const std::vector<double>& numbers) {
    const Linkage& made = reading.made;
    const auto sizes = linkage::sizes_of(made.structure, made.order, std::span<const double>(numbers));
    for (std::size_t i = 0; i < sizes.size(); ++i) {
        const linkage::Step& step = made.order.steps[i];
        if (step.kind != linkage::Step::Kind::dyad) continue;
        for (const auto& [locus, part] :
             {std::pair(&step.first, &sizes[i].first), std::pair(&step.second, &sizes[i].second)})
            if (locus->kind == linkage::Locus::Kind::circle && locus->extended == linkage::none &&
                !(part->length > 0)) {
                add_error(reading.messages, reading.link_places[locus->link],
                          fmt::format("the points '{}' and '{}' of the link '{}' coincide: give it a length",
                                      made.pins[locus->centre], made.pins[step.pin], made.links[locus->link]));
                return true;
            }
    }
    return false;
}

void check_closing(LinkageReading& reading) {
    Linkage& made = reading.made;
    const std::vector<double> numbers = numbers_of(made, usual_dimensions(made));
    if (report_no_length(reading, numbers)) return;
    const Gap gap = least_gap(made, numbers);
    if (gap.missing == 0) return;
    std::string where;
    for (const linkage::Step& step : made.order.steps)
        if (step.margin == gap.margin && step.margin != linkage::none)
            where = step.kind == linkage::Step::Kind::stopped ? stop_text(step, made.pins, made.slides)
                    : step.kind == linkage::Step::Kind::tied
                        ? fmt::format("the lines that hold '{}'", made.links[step.link])
                        : fmt::format("the dyad closed at '{}'",
                                      made.pins[step.kind == linkage::Step::Kind::dyad ? step.pin : step.far_pin]);
    if (made.order.is_stop(gap.margin))
        return add_error(
            reading.messages, place_of(reading.file, "links"),
            fmt::format("with these dimensions {} lets it move nowhere: it is beyond it by {:.6g} where it "
                        "comes nearest. Change the stop, a length or a side",
                        where, gap.missing));
    const bool slide = made.structure.drives.front().of_slide;
    const double at = slide || !made.units.degrees ? gap.at : gap.at * 180 / std::numbers::pi;
    add_error(
        reading.messages, place_of(reading.file, "links"),
        std::isfinite(gap.missing)
            ? fmt::format("with these dimensions {} never closes: {:.6g} {} are missing where it comes nearest, at "
                          "the {} {:.6g}. Change a length or a side",
                          where, gap.missing, made.units.length, slide ? "displacement" : "crank angle", at)
            : std::string("with these dimensions the linkage never closes: two of its places coincide"));
}

}  // namespace

void read_assembly(LinkageReading& reading) {
    Linkage& made = reading.made;
    made.sides.assign(made.order.choices, 1);
    made.larger.assign(made.order.larger.size(), std::nullopt);
    reading.larger_places.assign(made.order.larger.size(), place_of(reading.file, "links"));
    std::optional<Section> section = read_section(reading.file, "assembly", reading.messages);
    if (reading.messages.failed) return;
    if (section)
        for (const auto& [key, node] : in_order(*section->table)) {
            const linkage::Group* group = find_group(made, key);
            const std::string what = fmt::format("'{}' in [assembly]", key);
            if (is_decided(made, key, group)) {
                if (node->is_string()) to_choice(*node, what, "side", any_side, reading.messages);
                continue;
            }
            if (group == nullptr && read_larger_assembly(reading, key, *node)) continue;
            if (group == nullptr) {
                const auto known = keys_of_dyads(made);
                add_error(reading.messages, key_place(*section, key),
                          fmt::format("{} is no dyad with two assemblies; {}", what,
                                      known.empty() ? "there is none: leave it out" : remedy(key, known)));
                continue;
            }
            const auto side = node->is_table() ? side_between(reading, *node->as_table(), *group, what)
                                               : side_of(reading, *node, *group, what);
            if (side) made.sides[group->choice] = *side;
        }
    if (!reading.messages.failed && made.given() && made.order.closed() && !made.structure.drives.empty())
        check_closing(reading);
}

}  // namespace mechwright::reading

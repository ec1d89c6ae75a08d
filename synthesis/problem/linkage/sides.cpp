#include "synthesis/problem/linkage/sides.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

namespace mechwright {

namespace {

bool is_turned(const linkage::Group& group) { return group.kind == linkage::Group::Kind::rrr; }

}  // namespace

const std::array<std::string_view, 3>& side_words(const linkage::Group& group) {
    static constexpr std::array<std::string_view, 3> turned{"left", "right", "either"};
    static constexpr std::array<std::string_view, 3> along{"ahead", "behind", "either"};
    return is_turned(group) ? turned : along;
}

std::string_view word_of(const linkage::Group& group, int side) {
    return side_words(group)[side > 0 ? 0 : side < 0 ? 1 : 2];
}

nlohmann::ordered_json side_document(const Linkage& linkage, const linkage::Group& group, int side) {
    nlohmann::ordered_json document{{"side", word_of(group, side)}};
    if (is_turned(group)) {
        document["from"] = linkage.pins[group.outer[0]];
        document["to"] = linkage.pins[group.outer[1]];
    }
    return document;
}

std::string assembly_line(const Linkage& linkage, const linkage::Group& group, int side) {
    const std::string& pin = linkage.pins[group.pin];
    const std::string key = pin.find(' ') == std::string::npos ? pin : '"' + pin + '"';
    if (!is_turned(group)) return fmt::format("{} = \"{}\"", key, word_of(group, side));
    return fmt::format("{} = {{ side = \"{}\", from = \"{}\", to = \"{}\" }}", key, word_of(group, side),
                       linkage.pins[group.outer[0]], linkage.pins[group.outer[1]]);
}

}  // namespace mechwright

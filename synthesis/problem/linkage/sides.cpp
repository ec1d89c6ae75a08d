#include "synthesis/problem/linkage/sides.h"

#include <fmt/format.h>

#include <algorithm>
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

void for_each_assembly(const std::vector<std::int8_t>& sides, std::size_t most,
                       const std::function<void(const std::vector<std::int8_t>&)>& use) {
    std::vector<std::size_t> open;
    for (std::size_t i = 0; i < sides.size() && open.size() < most; ++i)
        if (sides[i] == 0) open.push_back(i);
    std::vector<std::int8_t> all = sides;
    std::replace(all.begin(), all.end(), std::int8_t{0}, std::int8_t{1});
    for (std::size_t k = 0; k < std::size_t{1} << open.size(); ++k) {
        for (std::size_t i = 0; i < open.size(); ++i)
            all[open[i]] = (k >> (open.size() - 1 - i) & 1) == 0 ? 1 : -1;
        use(all);
    }
}

}  // namespace mechwright

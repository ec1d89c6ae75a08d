#include "synthesis/report/structure/assemblies.h"

#include <fmt/format.h>

#include <algorithm>

#include "synthesis/problem/linkage/closing.h"

namespace mechwright {

bool is_redundant(const Linkage& linkage, std::size_t link) {
    return std::find(linkage.redundant.begin(), linkage.redundant.end(), link) != linkage.redundant.end();
}

std::vector<const linkage::Group*> chosen_dyads(const Linkage& linkage) {
    std::vector<const linkage::Group*> dyads;
    for (const linkage::Group& group : linkage.order.groups)
        if (group.choice != linkage::none && !is_redundant(linkage, group.links[0])) dyads.push_back(&group);
    return dyads;
}

std::vector<LinkageAssembly> assemblies_at(const Linkage& linkage, double master) {
    LinkagePoses poses(linkage, numbers_of(linkage, usual_dimensions(linkage)));
    const std::vector<const linkage::Group*> dyads = chosen_dyads(linkage);
    std::vector<std::int8_t> open(linkage.order.choices, 1);
    for (const linkage::Group* group : dyads)
        open[group->choice] = 0;
    std::vector<LinkageAssembly> all;
    for_each_assembly(open, 10, [&](const std::vector<std::int8_t>& sides) {
        if (!poses.place(master, sides) || poses.misfit() > 1e-9 * poses.size()) return;
        const bool asked = std::all_of(dyads.begin(), dyads.end(), [&](const linkage::Group* group) {
            return linkage.sides[group->choice] * sides[group->choice] >= 0;
        });
        all.push_back({sides, poses.pose, asked});
    });
    return all;
}

std::string_view word_of(const linkage::Group& group, int side) {
    if (group.kind == linkage::Group::Kind::rrr) return side > 0 ? "left" : side < 0 ? "right" : "either";
    return side > 0 ? "ahead" : side < 0 ? "behind" : "either";
}

std::string assembly_line(const Linkage& linkage, const linkage::Group& group, int side) {
    const std::string& pin = linkage.pins[group.pin];
    const std::string key = pin.find(' ') == std::string::npos ? pin : '"' + pin + '"';
    if (group.kind != linkage::Group::Kind::rrr) return fmt::format("{} = \"{}\"", key, word_of(group, side));
    return fmt::format("{} = {{ side = \"{}\", from = \"{}\", to = \"{}\" }}", key, word_of(group, side),
                       linkage.pins[group.outer[0]], linkage.pins[group.outer[1]]);
}

}  // namespace mechwright

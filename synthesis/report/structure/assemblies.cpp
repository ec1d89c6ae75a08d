#include "synthesis/report/structure/assemblies.h"

#include <algorithm>

#include "synthesis/problem/linkage/closing.h"
#include "synthesis/problem/linkage/sides.h"

namespace mechwright {

std::vector<const linkage::Group*> chosen_dyads(const Linkage& linkage) {
    std::vector<const linkage::Group*> dyads;
    for (const linkage::Group& group : linkage.order.groups)
        if (group.choice != linkage::none && !is_redundant(linkage, group.links[0])) dyads.push_back(&group);
    return dyads;
}

std::vector<LinkageAssembly> assemblies_at(const Linkage& linkage, double master) {
    const std::vector<double> numbers = numbers_of(linkage, usual_dimensions(linkage));
    const double size = linkage::farthest_point(linkage.structure, numbers);
    linkage::Driven<double> moving = driven(linkage, numbers);
    const std::vector<const linkage::Group*> dyads = chosen_dyads(linkage);
    std::vector<std::int8_t> open(linkage.order.choices, 1);
    for (const linkage::Group* group : dyads)
        open[group->choice] = 0;
    std::vector<LinkageAssembly> all;
    for_each_assembly(open, 10, [&](const std::vector<std::int8_t>& sides) {
        moving.sides = sides;
        if (!moving.place(master) || misfit(linkage, numbers, moving.pose) > 1e-9 * size) return;
        const bool asked = std::all_of(dyads.begin(), dyads.end(), [&](const linkage::Group* group) {
            return linkage.sides[group->choice] * sides[group->choice] >= 0;
        });
        all.push_back({sides, moving.pose, asked});
    });
    return all;
}

}  // namespace mechwright

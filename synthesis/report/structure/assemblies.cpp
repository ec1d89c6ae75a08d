#include "synthesis/report/structure/assemblies.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "synthesis/mechanism/linkage/branches.h"
#include "synthesis/problem/linkage/closing.h"
#include "synthesis/problem/linkage/larger_groups.h"
#include "synthesis/problem/linkage/sides.h"

namespace mechwright {

std::vector<const linkage::Group*> chosen_dyads(const Linkage& linkage) {
    std::vector<const linkage::Group*> dyads;
    for (const linkage::Group& group : linkage.order.groups)
        if (group.choice != linkage::none && !is_redundant(linkage, group.links[0])) dyads.push_back(&group);
    return dyads;
}

double usual_input(const Linkage& linkage) {
    return linkage.assembled.empty() ? linkage.at.value_or(0) : linkage.assembled.front().assembled.input;
}

namespace {

/// The poses at an input to which the assemblies of a file lead from where it says them.
std::vector<linkage::Pose<double>> poses_of_file(const Linkage& linkage, const std::vector<double>& numbers,
                                                 double master) {
    std::vector<linkage::Pose<double>> poses;
    if (!linkage.unassembled.empty()) return poses;
    linkage::Driven<double> moving = driven(linkage, numbers);
    const bool slide = linkage.structure.drives.front().of_slide;
    const double size = linkage::farthest_point(linkage.structure, numbers);
    const linkage::Reach reach =
        slide ? linkage::Reach{-4 * size, 4 * size, 0, size} : linkage::Reach{0, 0, 2 * std::numbers::pi, 1};
    for (const LargerAssembly& one : linkage.assembled) {
        moving.sides = one.sides;
        moving.set_ways(linkage::follow_ways(linkage.structure, linkage.order, numbers, one.sides, moving.laws,
                                             one.assembled, reach));
        if (moving.place(master)) poses.push_back(moving.pose);
    }
    return poses;
}

bool is_posed_alike(const linkage::Pose<double>& a, const linkage::Pose<double>& b) {
    constexpr double within = 1e-6;
    for (std::size_t i = 0; i < a.links.size(); ++i)
        if (std::hypot(a.links[i].along.x - b.links[i].along.x, a.links[i].along.y - b.links[i].along.y) > within)
            return false;
    return true;
}

}  // namespace

std::vector<LinkageAssembly> assemblies_at(const Linkage& linkage, double master) {
    const std::vector<double> numbers = numbers_of(linkage, usual_dimensions(linkage));
    const double size = linkage::farthest_point(linkage.structure, numbers);
    linkage::Driven<double> moving = driven(linkage, numbers);
    const std::vector<const linkage::Group*> dyads = chosen_dyads(linkage);
    std::vector<LinkageAssembly> all;
    const auto of_file = poses_of_file(linkage, numbers, master);
    for_each_assembly(open_sides(linkage.order, linkage.redundant), 10, [&](const std::vector<std::int8_t>& sides) {
        if (!linkage.order.closed()) {
            for (LargerAssembly& one : larger_assemblies(linkage, numbers, sides, master, true)) {
                const bool asked = std::any_of(of_file.begin(), of_file.end(),
                                               [&](const auto& pose) { return is_posed_alike(pose, one.pose); });
                all.push_back({sides, std::move(one.pose), asked, std::move(one.indices)});
            }
            return;
        }
        moving.sides = sides;
        if (!moving.place(master) || misfit(linkage.structure, linkage.redundant, numbers, moving.pose) > 1e-9 * size)
            return;
        const bool asked = std::all_of(dyads.begin(), dyads.end(), [&](const linkage::Group* group) {
            return linkage.sides[group->choice] * sides[group->choice] >= 0;
        });
        all.push_back({sides, moving.pose, asked, {}});
    });
    return all;
}

AssembledAt assembled_at(const Linkage& linkage, std::optional<double> at) {
    const double named = at.value_or(usual_input(linkage));
    AssembledAt best{named, assemblies_at(linkage, named)};
    constexpr int inputs = 72;
    if (at || !best.assemblies.empty() || linkage.structure.drives.front().of_slide) return best;
    for (int i = 1; i < inputs; ++i) {
        const double master = 2 * std::numbers::pi * i / inputs;
        std::vector<LinkageAssembly> there = assemblies_at(linkage, master);
        if (there.size() > best.assemblies.size()) best = {master, std::move(there)};
    }
    return best;
}

}  // namespace mechwright

#include "synthesis/mechanism/linkage/branches.h"

#include <algorithm>
#include <cmath>

namespace mechwright {

namespace {

constexpr std::size_t most_open = 6;

bool is_one_of(std::span<const std::size_t> redundant, std::size_t link) {
    return std::find(redundant.begin(), redundant.end(), link) != redundant.end();
}

/// Whether two assemblies have the same sides where these can be chosen.
bool is_assembled_alike(const std::vector<std::int8_t>& a, const std::vector<std::int8_t>& b,
                        const std::vector<std::int8_t>& open) {
    for (std::size_t i = 0; i < open.size(); ++i)
        if (open[i] == 0 && a[i] != b[i]) return false;
    return true;
}

}  // namespace

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

double misfit(const linkage::Structure& structure, std::span<const std::size_t> redundant,
              std::span<const double> numbers, const linkage::Pose<double>& pose) {
    double greatest = 0;
    for (const linkage::Slot& slot : structure.slots) {
        const std::size_t link = slot.line.on;
        if (!is_one_of(redundant, link)) continue;
        const Vector<double> off =
            pose.pins[slot.pin] - pose.links[link].at(linkage::place_of(slot.line.towards, numbers));
        greatest = std::max(greatest, std::hypot(off.x, off.y));
    }
    return greatest;
}

std::vector<std::int8_t> open_sides(const linkage::Order& order, std::span<const std::size_t> redundant) {
    std::vector<std::int8_t> open(order.choices, 1);
    for (const linkage::Group& group : order.groups)
        if (group.choice != linkage::none && !is_one_of(redundant, group.links[0])) open[group.choice] = 0;
    return open;
}

std::optional<AllBranches> all_branches(const linkage::Driven<double>& moving, const linkage::Structure& structure,
                                        std::span<const std::size_t> redundant, std::span<const double> numbers,
                                        const linkage::Inputs& inputs) {
    constexpr double fits_within = 1e-9;  // of the size
    const std::vector<std::int8_t> open = open_sides(moving.order, redundant);
    if (static_cast<std::size_t>(std::count(open.begin(), open.end(), 0)) > most_open) return {};
    AllBranches all;
    for_each_assembly(open, most_open, [&](const auto& sides) { all.assemblies.push_back(sides); });
    const double size = size_of(moving);
    all.branches = linkage::branches_of(
        moving, all.assemblies, inputs, [&](linkage::Driven<double>& one, const linkage::Travel& travel) {
            return one.place(travel.from + 0.5 * (travel.to - travel.from)) &&
                   misfit(structure, redundant, numbers, one.pose) <= fits_within * size;
        });
    return all;
}

std::optional<CircuitAndBranch> circuit_of_linkage(const Motion& motion, std::span<const double> dimensions) {
    const LinkageModel& model = linkage_of(motion.model);
    const bool goes_on = model.turns == 0 && !model.has_stops();
    if (!model.order.closed() || goes_on || !(motion.from <= motion.to)) return {};
    const linkage::Driven<double> moving = driven(model, dimensions, motion.assembly);
    const linkage::Inputs inputs = inputs_of(model, dimensions, moving);
    const auto all = all_branches(moving, model.structure, model.redundant, numbers_of(model, dimensions), inputs);
    if (!all) return {};
    const std::vector<std::int8_t> open = open_sides(model.order, model.redundant);
    const double middle = model.input_of(motion.from + 0.5 * (motion.to - motion.from));
    const auto found = std::find_if(all->branches.begin(), all->branches.end(), [&](const linkage::Branch& branch) {
        const linkage::Travel& travel = branch.travel;
        const double period = inputs.to - inputs.from;
        const double at = inputs.cyclic ? middle + period * std::ceil((travel.from - middle) / period) : middle;
        return at <= travel.to && travel.from <= at &&
               is_assembled_alike(all->assemblies[branch.assembly], moving.sides, open);
    });
    if (found == all->branches.end()) return {};
    return CircuitAndBranch{found->circuit, found->branch};
}

}  // namespace mechwright

#include "synthesis/problem/linkage/closing.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>
#include <utility>

#include "analysis/linkage/structure/inputs.h"
#include "analysis/numbers/golden_section.h"
#include "synthesis/mechanism/linkage/branches.h"

namespace mechwright {

namespace {

constexpr int samples = 360;
constexpr std::size_t most_open = 8;

/// Inputs of the master over its motion: a turn, or a slide's displacements.
std::vector<double> inputs_over_motion(const Linkage& linkage, std::span<const double> numbers, int count) {
    const double size = linkage::farthest_point(linkage.structure, numbers);
    const linkage::Inputs over =
        linkage.structure.drives.empty() ? linkage::Inputs{} : inputs_of(linkage.structure, numbers, size, 1);
    std::vector<double> inputs;
    for (int i = 0; i < count; ++i)
        inputs.push_back(over.from + (over.to - over.from) * i / count);
    return inputs;
}

}  // namespace

linkage::Driven<double> driven(const Linkage& linkage, std::span<const double> numbers) {
    return {linkage.structure, linkage.order, numbers, {}, laws_in<double>(linkage.drives)};
}

namespace {

Gap gap_at(linkage::Driven<double>& moving, double input) {
    if (moving.place(input)) return {0, input, 0};
    for (std::size_t i = 0; i < moving.pose.margins.size(); ++i) {
        const double least = std::min(moving.pose.margins[i].outer, moving.pose.margins[i].inner);
        if (least < 0) return {-least, input, i};
    }
    return {std::numeric_limits<double>::infinity(), input, 0};
}

/// Greater is nearer to closing: what comes later in the order can close only where all before it does.
std::pair<double, double> nearness(const Gap& gap) {
    if (gap.missing == 0) return {std::numeric_limits<double>::infinity(), 0};
    return {static_cast<double>(gap.margin), -gap.missing};
}

/// The least gap of one assembly: at the inputs, and between the neighbours of each that is nearer than they are.
Gap least_gap_of(linkage::Driven<double>& moving, const std::vector<double>& inputs) {
    std::vector<Gap> gaps;
    for (const double input : inputs)
        gaps.push_back(gap_at(moving, input));
    const auto is_less = [](const Gap& a, const Gap& b) { return a.missing < b.missing; };
    Gap best = *std::min_element(gaps.begin(), gaps.end(), is_less);
    const double step = inputs[1] - inputs[0];
    for (std::size_t i = 0; i < gaps.size() && best.missing > 0; ++i) {
        const auto &before = gaps[(i + gaps.size() - 1) % gaps.size()], &after = gaps[(i + 1) % gaps.size()];
        if (nearness(gaps[i]) < nearness(before) || nearness(gaps[i]) < nearness(after)) continue;
        const double nearest = greatest_between([&](double input) { return nearness(gap_at(moving, input)); },
                                                inputs[i] - step, inputs[i] + step);
        best = std::min(best, gap_at(moving, nearest), is_less);
    }
    return best;
}

}  // namespace

Gap least_gap(const Linkage& linkage, std::span<const double> numbers) {
    linkage::Driven<double> moving = driven(linkage, numbers);
    std::vector<std::int8_t> sides = linkage.sides;
    sides.resize(linkage.order.choices, 0);
    if (static_cast<std::size_t>(std::count(sides.begin(), sides.end(), 0)) > most_open) return {};
    const std::vector<double> inputs = inputs_over_motion(linkage, numbers, samples);
    Gap best{std::numeric_limits<double>::infinity()};
    for_each_assembly(sides, most_open, [&](const std::vector<std::int8_t>& one) {
        if (best.missing == 0) return;
        moving.sides = one;
        const Gap gap = least_gap_of(moving, inputs);
        if (gap.missing < best.missing) best = gap;
    });
    return best;
}

double redundant_misfit(const Linkage& linkage, std::span<const double> numbers) {
    linkage::Driven<double> moving = driven(linkage, numbers);
    const double size = linkage::farthest_point(linkage.structure, numbers);
    double worst = 0;
    int closed = 0;
    for (const double input : inputs_over_motion(linkage, numbers, samples / 5)) {
        double best = std::numeric_limits<double>::infinity();
        for_each_assembly(
            std::vector<std::int8_t>(linkage.order.choices, 0), most_open, [&](const std::vector<std::int8_t>& sides) {
                moving.sides = sides;
                if (moving.place(input))
                    best = std::min(best, misfit(linkage.structure, linkage.redundant, numbers, moving.pose) / size);
            });
        if (!std::isfinite(best)) continue;
        ++closed;
        worst = std::max(worst, best);
    }
    return closed < 2 ? -1 : worst;
}

}  // namespace mechwright

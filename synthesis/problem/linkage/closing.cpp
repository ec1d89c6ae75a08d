#include "synthesis/problem/linkage/closing.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include "analysis/numbers/golden_section.h"

namespace mechwright {

namespace {

constexpr int samples = 360;
constexpr std::size_t most_open = 8;

/// Inputs of the master over its motion: a turn, or a slide's displacement between its stops or over the linkage's
/// size.
std::vector<double> inputs_over_motion(const Linkage& linkage, double size, int count) {
    double from = 0, to = 2 * std::numbers::pi;
    if (!linkage.structure.drives.empty() && linkage.structure.drives.front().of_slide) {
        from = -4 * size;
        to = 4 * size;
    }
    std::vector<double> inputs;
    for (int i = 0; i < count; ++i)
        inputs.push_back(from + (to - from) * i / count);
    return inputs;
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

LinkagePoses::LinkagePoses(const Linkage& of, std::vector<double> numbers_of_it)
    : linkage(of),
      numbers(std::move(numbers_of_it)),
      sizes(linkage::sizes_of(of.structure, of.order, std::span<const double>(numbers))),
      pose(linkage::empty_pose<double>(of.structure, of.order)) {}

bool LinkagePoses::place(double master, const std::vector<std::int8_t>& sides) {
    const std::vector<double> inputs = inputs_of(linkage, master);
    return linkage::place<double>(linkage.order, sizes, {inputs, sides}, pose);
}

double LinkagePoses::size() const {
    double greatest = 0;
    for (const linkage::Pin& pin : linkage.structure.pins)
        for (const linkage::Point& point : pin.points) {
            const Vector<double> at = linkage::place_of<double>(point.at, numbers);
            greatest = std::max(greatest, std::hypot(at.x, at.y));
        }
    return greatest;
}

namespace {

Gap gap_at(LinkagePoses& poses, double input, const std::vector<std::int8_t>& sides) {
    if (poses.place(input, sides)) return {0, input, 0};
    for (std::size_t i = 0; i < poses.pose.margins.size(); ++i) {
        const double least = std::min(poses.pose.margins[i].outer, poses.pose.margins[i].inner);
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
Gap least_gap_of(LinkagePoses& poses, const std::vector<double>& inputs, const std::vector<std::int8_t>& sides) {
    std::vector<Gap> gaps;
    for (const double input : inputs)
        gaps.push_back(gap_at(poses, input, sides));
    const auto is_less = [](const Gap& a, const Gap& b) { return a.missing < b.missing; };
    Gap best = *std::min_element(gaps.begin(), gaps.end(), is_less);
    const double step = inputs[1] - inputs[0];
    for (std::size_t i = 0; i < gaps.size() && best.missing > 0; ++i) {
        const auto &before = gaps[(i + gaps.size() - 1) % gaps.size()], &after = gaps[(i + 1) % gaps.size()];
        if (nearness(gaps[i]) < nearness(before) || nearness(gaps[i]) < nearness(after)) continue;
        const double nearest = greatest_between([&](double input) { return nearness(gap_at(poses, input, sides)); },
                                                inputs[i] - step, inputs[i] + step);
        best = std::min(best, gap_at(poses, nearest, sides), is_less);
    }
    return best;
}

}  // namespace

Gap least_gap(const Linkage& linkage, const std::vector<double>& numbers) {
    LinkagePoses poses(linkage, numbers);
    std::vector<std::int8_t> sides = linkage.sides;
    sides.resize(linkage.order.choices, 0);
    if (static_cast<std::size_t>(std::count(sides.begin(), sides.end(), 0)) > most_open) return {};
    const std::vector<double> inputs = inputs_over_motion(linkage, poses.size(), samples);
    Gap best{std::numeric_limits<double>::infinity()};
    for_each_assembly(sides, most_open, [&](const std::vector<std::int8_t>& one) {
        if (best.missing == 0) return;
        const Gap gap = least_gap_of(poses, inputs, one);
        if (gap.missing < best.missing) best = gap;
    });
    return best;
}

double LinkagePoses::misfit() const {
    double greatest = 0;
    for (const linkage::Slot& slot : linkage.structure.slots) {
        const std::size_t link = slot.line.on;
        if (std::find(linkage.redundant.begin(), linkage.redundant.end(), link) == linkage.redundant.end()) continue;
        const Vector<double> off =
            pose.pins[slot.pin] - pose.links[link].at(linkage::place_of<double>(slot.line.towards, numbers));
        greatest = std::max(greatest, std::hypot(off.x, off.y));
    }
    return greatest;
}

double redundant_misfit(const Linkage& linkage, const std::vector<double>& numbers) {
    LinkagePoses poses(linkage, numbers);
    const double size = poses.size();
    double worst = 0;
    int closed = 0;
    for (const double input : inputs_over_motion(linkage, size, samples / 5)) {
        double best = std::numeric_limits<double>::infinity();
        for_each_assembly(std::vector<std::int8_t>(linkage.order.choices, 0), most_open,
                          [&](const std::vector<std::int8_t>& sides) {
                              if (poses.place(input, sides)) best = std::min(best, poses.misfit() / size);
                          });
        if (!std::isfinite(best)) continue;
        ++closed;
        worst = std::max(worst, best);
    }
    return closed < 2 ? -1 : worst;
}

}  // namespace mechwright

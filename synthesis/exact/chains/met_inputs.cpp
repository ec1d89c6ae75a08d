#include "synthesis/exact/chains/met_inputs.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "analysis/numbers/extremes.h"
#include "synthesis/program/quantity_value.h"

namespace mechwright {

namespace {

constexpr int samples = 720;
/// Of distances, over the size of the design, and of the difference of directions.
constexpr double met_within = 1e-7;

struct Guided {
    const Problem& problem;
    const Design& design;

    struct At {
        Vector<double> point;
        Vector<double> slope;  ///< by the input
        bool assembles;
    };
    At at(double input) const {
        std::array<double, PointGuidance::most_reads + 1> x{}, y{};
        PathMiss miss{};
        miss.gradient_x = x;
        miss.gradient_y = y;
        miss_of_point(*problem.mechanism, problem.mechanism->form(design.assembly), design.dimensions, input, {0, 0},
                      miss);
        const std::size_t last = problem.mechanism->point->reads.size();
        return {-miss.miss, {-x[last], -y[last]}, miss.margin >= 0};
    }
    /// How fast half the square of the distance from a target grows.
    double growth(const At& here, std::size_t target) const {
        return dot(here.point - problem.path->points[target], here.slope);
    }
    bool is_met(std::size_t target, double input, double size) const {
        const At here = at(input);
        const Vector<double> off = here.point - problem.path->points[target];
        if (!here.assembles || !(std::hypot(off.x, off.y) <= met_within * size)) return false;
        if (!problem.path->faces(target)) return true;
        const double facing = problem.path->directions[target];
        PoseMiss pose{};
        miss_of_body(*problem.mechanism, problem.mechanism->form(design.assembly), design.dimensions, input,
                     problem.path->points[target], {std::cos(facing), std::sin(facing)}, pose);
        return std::hypot(pose.turn.miss.x, pose.turn.miss.y) <= met_within;
    }
};

/// The greatest of what the design and its targets are measured in.
double size_of(const Problem& problem, const Design& design) {
    double size = longest_length(*problem.mechanism, design.dimensions);
    for (const Vector<double>& point : problem.path->points)
        size = std::max({size, std::abs(point.x), std::abs(point.y)});
    return size;
}

/// All inputs of the motion at which each target is met.
std::vector<std::vector<double>> met_at(const Guided& guided, const Motion& motion) {
    const std::size_t targets = guided.problem.path->points.size();
    const double size = size_of(guided.problem, guided.design);
    std::vector<std::vector<double>> met(targets);
    double before = motion.from;
    Guided::At last = guided.at(before);
    for (int i = 1; i <= samples; ++i) {
        const double after = i == samples ? motion.to : motion.from + i * (motion.to - motion.from) / samples;
        const Guided::At here = guided.at(after);
        for (std::size_t k = 0; k < targets && last.assembles && here.assembles; ++k) {
            const double from = guided.growth(last, k), to = guided.growth(here, k);
            if (!(from <= 0 && to > 0)) continue;
            const auto growth = [&](double input) { return guided.growth(guided.at(input), k); };
            const double input = from == 0 ? before : zero_between(growth, before, after, from, to);
            if (guided.is_met(k, input, size)) met[k].push_back(input);
        }
        before = after;
        last = here;
    }
    return met;
}

/// The next input after another one in a direction, of those given and the same a cycle later or before.
std::optional<double> next_after(const std::vector<double>& all, double from, double direction, double cycle) {
    std::optional<double> nearest;
    for (double input : all) {
        if (cycle > 0)
            while (direction * (input - from) <= 0)
                input += direction * cycle;
        const double way = direction * (input - from);
        if (way > 0 && (!nearest || way < direction * (*nearest - from))) nearest = input;
    }
    return nearest;
}

}  // namespace

std::vector<std::vector<double>> inputs_in_order(const Problem& problem, const Design& design) {
    const Motion motion = motion_of(*problem.mechanism, design.dimensions, design.assembly, nullptr);
    if (!(motion.from < motion.to)) return {};
    const auto met = met_at({problem, design}, motion);
    const double cycle = motion.full_turn ? motion.to - motion.from : 0;
    std::vector<std::vector<double>> ways;
    for (const double direction : {1.0, -1.0}) {
        std::optional<std::vector<double>> shortest;
        for (const double first : met.front()) {
            std::vector<double> way{first};
            for (std::size_t k = 1; k < met.size() && way.size() == k; ++k)
                if (const auto next = next_after(met[k], way.back(), direction, cycle)) way.push_back(*next);
            const double length = std::abs(way.back() - first);
            if (way.size() < met.size() || (cycle > 0 && length >= cycle)) continue;
            if (!shortest || length < std::abs(shortest->back() - shortest->front())) shortest = std::move(way);
        }
        if (shortest) ways.push_back(*std::move(shortest));
    }
    return ways;
}

}  // namespace mechwright

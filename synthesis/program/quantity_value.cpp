#include "synthesis/program/quantity_value.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "synthesis/target/path/rows/stretch.h"

namespace mechwright {

namespace {

std::optional<double> path_quantity(const Problem& problem, const Quantity& quantity, const Design& design) {
    const std::optional<PathValues> path = path_values(problem, design);
    if (!path) return std::nullopt;
    const PathMeans& means = quantity.of_target == every_target ? *path : path->of_targets[quantity.of_target];
    switch (quantity.path) {
        case PathMeasure::sum_of_squares: return means.sum_of_squares;
        case PathMeasure::root_mean_square: return means.root_mean_square;
        case PathMeasure::greatest: return means.greatest;
        case PathMeasure::none: break;
    }
    return std::nullopt;
}

std::optional<double> reduced(Reduce reduce, std::span<const double> components) {
    if (components.empty()) return std::nullopt;
    switch (reduce) {
        case Reduce::only: return components.front();
        case Reduce::least: return *std::min_element(components.begin(), components.end());
        case Reduce::greatest: return *std::max_element(components.begin(), components.end());
    }
    return std::nullopt;
}

}  // namespace

namespace {

/// The crank angles over which a design is judged where that is not its whole motion: those given, the range of use, or
/// those in which all targets are met where one of them is over an input range.
std::optional<std::array<double, 2>> crank_range_of(const Problem& problem, const Design& design) {
    if (problem.crank_range) return std::array{problem.crank_range->x, problem.crank_range->y};
    if (problem.use || covers_several(problem)) {
        const auto stretch = stretch_of(problem, design);
        return stretch ? std::array{stretch->first, stretch->last} : std::array{1.0, 0.0};
    }
    if (!moves_over_targets(problem)) return std::nullopt;
    const std::size_t input = problem.mechanism->input->start;
    const double start = design.dimensions[input], end = start + design.dimensions[input + 1];
    return std::array{std::min(start, end), std::max(start, end)};
}

Motion motion_over(const Problem& problem, const Design& design, const double* range) {
    Motion motion = motion_of(*problem.mechanism, design.dimensions, design.assembly, range);
    motion.settings = problem.settings;
    motion.function = problem.function.get();
    motion.followed = problem.followed ? problem.followed->shape : Followed::nothing;
    motion.asked = problem.over_input.get();
    motion.has_instant = problem.has_instant;
    motion.is_range_of_use = problem.use.has_value();
    return motion;
}

}  // namespace

Motion motion_of(const Problem& problem, const Design& design) {
    const auto range = crank_range_of(problem, design);
    return motion_over(problem, design, range ? range->data() : nullptr);
}

Motion motion_of(const Problem& problem, const Quantity& quantity, const Design& design) {
    return quantity.whole ? motion_over(problem, design, nullptr) : motion_of(problem, design);
}

std::optional<CircuitAndBranch> circuit_of(const Problem& problem, const Motion& motion, const Design& design) {
    const Mechanism& mechanism = *problem.mechanism;
    if (mechanism.circuit == nullptr) return std::nullopt;
    return mechanism.circuit(motion, design.dimensions);
}

namespace {

/// What keeps a design assembled over the range of crank angles over which it is judged, and the motion as this gets
/// it. None where it moves freely, or over the stretch of several targets.
std::optional<std::pair<const Quantity*, Motion>> margin_over(const Problem& problem, const Motion& motion) {
    if (moves_over_targets(problem) && !covers_several(problem) && !problem.crank_range)
        return std::pair(&problem.mechanism->input->margin, motion);
    if ((!problem.crank_range && !problem.use) || motion.full_turn) return std::nullopt;
    const auto& families = problem.mechanism->families;
    const auto limited = std::find_if(families.begin(), families.end(), [](const Family& f) { return !f.full_turn; });
    if (limited == families.end() || !limited->assembly_margin) return std::nullopt;
    Motion over = motion;
    over.family = static_cast<std::size_t>(limited - families.begin());
    return std::pair(&*limited->assembly_margin, over);
}

bool assembles_over(const Problem& problem, const Motion& motion, const Design& design) {
    constexpr double closed_within = 1e-12;  // of margins over the longest length
    const auto margin = margin_over(problem, motion);
    return !margin || least_component(*margin->first, margin->second, design.dimensions) >=
                          -closed_within * longest_length(*problem.mechanism, design.dimensions);
}

}  // namespace

double longest_length(const Mechanism& mechanism, std::span<const double> dimensions) {
    double longest = 0;
    for (std::size_t i = 0; i < dimensions.size(); ++i)
        if (mechanism.dimensions[i].kind == DimensionKind::length) longest = std::max(longest, std::abs(dimensions[i]));
    return mechanism.size ? mechanism.size(mechanism.form(0), dimensions) : longest;
}

double least_component(const Quantity& margin, const Motion& motion, std::span<const double> dimensions) {
    std::array<double, Quantity::most_components> components{};
    measure(margin, motion, dimensions, {components, {}, {}});
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < count_components(margin, motion); ++i) {
        if (std::isnan(components[i])) return components[i];
        least = std::min(least, components[i]);
    }
    return least;
}

bool assembles_over_range(const Problem& problem, const Design& design) {
    return assembles_over(problem, motion_of(problem, design), design);
}

namespace {

/// Over a motion over which the design assembles.
std::optional<double> value_over(const Problem& problem, const Quantity& q, const Motion& motion,
                                 const Design& design) {
    std::optional<double> value;
    if (q.path != PathMeasure::none) {
        const bool one_kind = problem.path && problem.path->parts.empty();
        if (one_kind && problem.path->guides_body() != (q.section == "poses")) return std::nullopt;
        value = path_quantity(problem, q, design);
    } else if (is_defined(q, motion)) {
        std::array<double, Quantity::most_components> components{};
        const std::size_t count = count_components(q, motion);
        measure(q, motion, design.dimensions, {components, {}, {}});
        const std::span<const double> all(components.data(), count);
        if (std::any_of(all.begin(), all.end(), [](double c) { return std::isnan(c); })) return std::nullopt;
        value = reduced(q.reduce, all);
    }
    return value && std::isfinite(*value) ? value : std::nullopt;
}

}  // namespace

std::optional<double> quantity_value(const Problem& problem, std::size_t quantity, const Design& design) {
    return QuantityValues(problem, design)[quantity];
}

std::optional<double> QuantityValues::operator[](std::size_t quantity) {
    const Quantity& q = problem_.mechanism->quantities[quantity];
    const Judged& judged = judged_over(q.whole);
    return judged.assembles ? value_over(problem_, q, judged.motion, design_) : std::nullopt;
}

const QuantityValues::Judged& QuantityValues::judged_over(bool whole) {
    std::optional<Judged>& judged = judged_[whole ? 1 : 0];
    if (!judged) {
        const Motion motion = whole ? motion_over(problem_, design_, nullptr) : motion_of(problem_, design_);
        judged = {motion, motion.from <= motion.to && (whole || assembles_over(problem_, motion, design_))};
    }
    return *judged;
}

namespace {

struct MissedPoint {
    Vector<double> place;  ///< target - reached
    double turn = 0;       ///< 2 sin(half the angle between the directions)
    double direction = 0;  ///< of a guided body
};

MissedPoint missed_point(const Problem& problem, const Design& design, std::size_t i) {
    const PathTarget& target = *problem.path;
    const Form form = problem.mechanism->form(design.assembly, target.target_of(i));
    if (!target.guides_body_at(i)) {
        PathMiss miss{};
        miss_of_point(*problem.mechanism, form, design.dimensions, design.path_angles[i], target.points[i], miss);
        return {miss.miss};
    }
    // Where any direction will do, the one that the body has is counted from 0.
    const double asked = target.faces(i) ? target.directions[i] : 0;
    const Vector<double> facing{std::cos(asked), std::sin(asked)};
    PoseMiss miss{};
    miss_of_body(*problem.mechanism, form, design.dimensions, design.path_angles[i], target.points[i], facing, miss);
    const Vector<double> faces = facing - miss.turn.miss;
    // The turn is added to the direction asked for, so that both are counted from the same whole turn.
    const double turned = std::atan2(cross(facing, faces), dot(facing, faces));
    const double turn = target.faces(i) ? std::hypot(miss.turn.miss.x, miss.turn.miss.y) : 0;
    return {miss.place.miss, turn, asked + turned};
}

template <class WeightAt>
PathMeans means_over(const std::vector<double>& distances, const PointRange& points, const WeightAt& weight_at) {
    PathMeans means;
    double weights = 0;
    for (std::size_t i = points.first; i < points.end(); ++i) {
        means.sum_of_squares += weight_at(i) * distances[i] * distances[i];
        weights += weight_at(i);
        means.greatest = std::max(means.greatest, distances[i]);
    }
    means.root_mean_square = weights > 0 ? std::sqrt(means.sum_of_squares / weights) : 0;
    return means;
}

}  // namespace

std::optional<double> value_named(const Problem& problem, const Design& design, std::string_view name) {
    if (const int i = find_dimension(*problem.mechanism, name); i >= 0)
        return design.dimensions[static_cast<std::size_t>(i)];
    const int i = find_quantity(*problem.mechanism, name);
    return i >= 0 ? quantity_value(problem, static_cast<std::size_t>(i), design) : std::nullopt;
}

std::optional<PathValues> path_values(const Problem& problem, const Design& design) {
    const std::optional<PathTarget>& target = problem.path;
    if (!target || target->points.empty() || design.path_angles.size() != target->points.size()) return std::nullopt;
    PathValues values;
    for (std::size_t i = 0; i < target->points.size(); ++i) {
        const MissedPoint miss = missed_point(problem, design, i);
        const double distance = std::hypot(miss.place.x, miss.place.y, target->body_length_at(i) * miss.turn);
        if (!std::isfinite(distance)) return std::nullopt;
        values.reached.push_back(target->points[i] - miss.place);
        if (target->guides_body()) values.directions.push_back(miss.direction);
        values.distances.push_back(distance);
    }
    const auto weight = [&](std::size_t i) { return i < target->weights.size() ? target->weights[i] : 1; };
    static_cast<PathMeans&>(values) = means_over(values.distances, {0, target->points.size()}, weight);
    for (const PathPart& part : target->parts)
        values.of_targets.push_back(means_over(values.distances, part.points,
                                               [&](std::size_t i) { return part.weights[i - part.points.first]; }));
    return values;
}

}  // namespace mechwright

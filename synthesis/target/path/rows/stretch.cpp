#include "synthesis/target/path/rows/stretch.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include "synthesis/mechanism/cycle.h"
#include "synthesis/target/path/rows/path_outputs.h"

namespace mechwright {

using Eigen::VectorXd;

bool needs_stretch(const Problem& problem, const Family& family) {
    if (family.full_turn || !problem.mechanism->input.has_value()) return false;
    if (covers_several(problem)) return true;
    return problem.path && (problem.path->points.size() > 1 || problem.use) && !problem.path->closed;
}

namespace {

/// A part of the stretch that cannot be parted: between the ends of a target.
struct Span {
    StretchEnd first{}, last{};
    double from = 0, to = 0;
    bool turns = true;  ///< it may as well be whole cycles later
};

/// Between the crank angles of a path or poses: of an ordered path the first and the last.
template <class AngleAt>
Span span_of_path(const PathTarget& path, std::size_t target, const AngleAt& angle_at) {
    const PointRange points = path.points_of(target);
    const bool ordered = !path.prescribed_timing && !path.any_order;
    std::size_t least = points.first, greatest = points.first;
    for (std::size_t i = points.first; i < points.end(); ++i) {
        if (ordered && i > points.first && i + 1 < points.end()) continue;
        if (angle_at(i) < angle_at(least)) least = i;
        if (angle_at(i) > angle_at(greatest)) greatest = i;
    }
    // Points that count by the nearest of the curve lie in one motion.
    return {{least}, {greatest}, angle_at(least), angle_at(greatest), !path.any_order};
}

struct Spans {
    std::array<Span, most_targets> all;
    std::size_t count = 0;

    void add(const Span& one) { all[count++] = one; }
    void add_input_range(std::span<const double> dimensions, std::size_t at) {
        const double start = dimensions[at], end = start + dimensions[at + 1];
        const StretchEnd at_start{{}, at, false}, at_end{{}, at, true};
        add(end < start ? Span{at_end, at_start, end, start} : Span{at_start, at_end, start, end});
    }
    std::span<const Span> those() const { return std::span(all).first(count); }
};

template <class AngleAt>
Spans spans_of(const Problem& problem, std::span<const double> dimensions, const AngleAt& angle_at) {
    Spans spans;
    for (std::size_t k = 0; problem.path && k < problem.path->targets(); ++k)
        spans.add(span_of_path(*problem.path, k, angle_at));
    for (const InputTarget& target : problem.mechanism->over_input)
        spans.add_input_range(dimensions, target.start);
    if (problem.function || problem.followed) spans.add_input_range(dimensions, problem.mechanism->input->start);
    return spans;
}

/// The shortest stretch that holds all, each turned on by whole cycles, where there are such: it begins where one of
/// them does.
StretchEnds shortest_stretch(const Spans& all, double cycle) {
    constexpr double as_short = 1e-9;
    const std::span<const Span> spans = all.those();
    // Where an angle is no number, which solvers try, the stretch has none either, whichever ends it has.
    StretchEnds best{spans.front().first, spans.front().last, 0};
    double shortest = std::numeric_limits<double>::infinity();
    for (const Span& begins : spans) {
        const double begin = begins.from;
        StretchEnds ends{begins.first, begins.first, 0};
        double least = begin, greatest = begin;
        for (const Span& span : spans) {
            const bool stays = &span == &begins || !span.turns || !std::isfinite(cycle);
            const double turns = stays ? 0 : cycle * std::ceil((begin - span.from) / cycle - as_short);
            if (span.from + turns < least) {
                least = span.from + turns;
                ends.first = span.first;
            }
            if (span.to + turns > greatest) {
                greatest = span.to + turns;
                ends.last = span.last;
                ends.turns = turns;
            }
        }
        if (!(greatest - least < shortest - as_short)) continue;
        shortest = greatest - least;
        best = ends;
    }
    return best;
}

/// Whether the crank turns clockwise from the first target to the last: they are met in order as `angle_at` falls.
template <class AngleAt>
bool turns_clockwise(const PathTarget& path, const AngleAt& angle_at) {
    for (std::size_t target = 0; target < path.targets() && !path.any_order; ++target)
        if (const PointRange points = path.points_of(target); points.count > 1)
            return angle_at(points.end() - 1) < angle_at(points.first);
    return false;
}

/// By how much the range of use goes beyond the ends of a stretch: beyond the end at the lesser crank angle, then
/// beyond the other.
template <class AngleAt>
std::array<double, 2> beyond_ends(const Problem& problem, const AngleAt& angle_at) {
    if (!problem.use) return {0, 0};
    const auto [before, after] = *problem.use;
    return turns_clockwise(*problem.path, angle_at) ? std::array{after, before} : std::array{before, after};
}

}  // namespace

std::optional<CrankStretch> stretch_of(const Problem& problem, const Design& design) {
    if (problem.path && design.path_angles.size() != problem.path->points.size()) return std::nullopt;
    const auto angle_at = [&](std::size_t i) { return design.path_angles[i]; };
    const StretchEnds ends =
        shortest_stretch(spans_of(problem, design.dimensions, angle_at), cycle_of(*problem.mechanism));
    const auto angle = [&](const StretchEnd& end) {
        if (end.point) return angle_at(*end.point);
        return design.dimensions[end.input_start] + (end.after_range ? design.dimensions[end.input_start + 1] : 0);
    };
    const auto [less, more] = beyond_ends(problem, angle_at);
    return CrankStretch{angle(ends.first) - less, angle(ends.last) + ends.turns + more};
}

double least_margin_along(const Problem& problem, const Design& design) {
    const InputRange& input = *problem.mechanism->input;
    const auto stretch = stretch_of(problem, design);
    if (!stretch) return std::numeric_limits<double>::quiet_NaN();
    std::vector<double> arguments;
    for (const std::size_t i : input.reads)
        arguments.push_back(design.dimensions[i]);
    arguments.push_back(stretch->first);
    arguments.push_back(stretch->last - stretch->first);
    std::array<double, InputRange::most_margins> value;
    Motion motion;
    motion.assembly = design.assembly;
    motion.model = problem.mechanism->model.data();
    motion.of = input.margin.of.data();
    input.margin.measure(motion, arguments, {value, {}, {}});
    return *std::min_element(value.begin(),
                             value.begin() + static_cast<std::ptrdiff_t>(input.margin.components(motion)));
}

namespace {

/// The crank angle of a point, as a path has it.
double angle_at_point(const Program& program, std::span<const double> dimensions, const VectorXd& x, std::size_t i) {
    const PathTarget& path = *program.problem->path;
    if (program.untimed_path()) return x[static_cast<Eigen::Index>(program.first_path_angle + i)];
    return path.crank_angles[i] / unit_of_input(program) +
           dimensions[program.problem->mechanism->roles_of(path.target_of(i)).start];
}

StretchEnds ends_at(const Program& program, std::span<const double> dimensions, const VectorXd& x) {
    const Problem& problem = *program.problem;
    // The crank may turn either way along an ordered path.
    if (!covers_several(problem) && problem.path->parts.empty() && !problem.path->prescribed_timing &&
        !problem.path->any_order)
        return {{0}, {problem.path->points.size() - 1}, 0};
    return shortest_stretch(
        spans_of(problem, dimensions, [&](std::size_t i) { return angle_at_point(program, dimensions, x, i); }),
        cycle_of(*problem.mechanism));
}

/// An argument of a measure as a sum of the crank angles of ends.
struct SumOfEnds {
    const Program& program;
    std::span<const double> dimensions;
    const VectorXd& x;
    BlockArguments& arguments;
    std::size_t& used;  ///< terms of the arguments that are taken
    const std::size_t from = used;
    std::size_t to = from;
    double value = 0;

    void add(const StretchEnd& end, double sign) {
        if (end.point) {
            const PathAngle met = path_angle(program, dimensions, x, *end.point);
            value += sign * met.angle;
            if (met.variable >= 0) arguments.ends[used++] = {static_cast<std::size_t>(met.variable), sign};
        }
        for (std::size_t k = 0; k < (end.point ? 0u : end.after_range ? 2u : 1u); ++k) {
            value += sign * dimensions[end.input_start + k];
            for (const LinearTerm& term : program.follows[end.input_start + k])
                arguments.ends[used++] = {term.index, sign * term.factor};
        }
        to = used;
    }
    void finish() {
        arguments.value[arguments.count] = value;
        arguments.source[arguments.count++] = std::span<const LinearTerm>(arguments.ends).subspan(from, to - from);
    }
};

}  // namespace

StretchEnds stretch_ends(const Program& program, const VectorXd& x) {
    return ends_at(program, dimensions_at(program, x), x);
}

const QuantityBlock* stretch_block(const Program& program) {
    const auto block = std::find_if(program.blocks.begin(), program.blocks.end(), [&](const QuantityBlock& b) {
        return b.along_stretch && b.quantity == &program.problem->mechanism->input->margin;
    });
    return block == program.blocks.end() ? nullptr : &*block;
}

bool depends_on_stretch(const Program& program) {
    return std::any_of(program.blocks.begin(), program.blocks.end(),
                       [](const QuantityBlock& b) { return b.along_stretch; });
}

void add_stretch(const Program& program, std::span<const double> dimensions, const VectorXd& x,
                 BlockArguments& arguments) {
    const Problem& problem = *program.problem;
    const StretchEnds ends = ends_at(program, dimensions, x);
    std::size_t used = 0;
    SumOfEnds start{program, dimensions, x, arguments, used};
    start.add(ends.first, 1);
    SumOfEnds range{program, dimensions, x, arguments, used};
    range.add(ends.last, 1);
    range.value += ends.turns;
    range.add(ends.first, -1);
    if (problem.use) {
        const auto [less, more] =
            beyond_ends(problem, [&](std::size_t i) { return angle_at_point(program, dimensions, x, i); });
        const double unit = unit_of_input(program);
        // The first of an ordered path is at the greater crank angle where the crank turns clockwise.
        start.value += (range.value < 0 ? more : -less) / unit;
        range.value += (range.value < 0 ? -(less + more) : less + more) / unit;
    }
    start.finish();
    range.finish();
}

}  // namespace mechwright

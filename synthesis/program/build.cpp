#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include "synthesis/mechanism/cycle.h"
#include "synthesis/problem/input_tasks.h"
#include "synthesis/program/condition_margin.h"
#include "synthesis/program/program.h"
#include "synthesis/target/path/rows/path_outputs.h"
#include "synthesis/target/path/rows/path_rows.h"
#include "synthesis/target/path/rows/stretch.h"

namespace mechwright {

namespace {

/// A length whose range starts at zero starts at this part of its greatest value.
constexpr double least_length = 1e-6;

/// Twice the root mean square distance of the points from their centre: it does not depend on how a path is turned.
double path_extent(const PathTarget& path) {
    const auto n = static_cast<double>(path.points.size());
    Vector<double> centre{0, 0};
    for (const Vector<double>& p : path.points)
        centre = centre + Vector<double>{p.x / n, p.y / n};
    double sum = 0;
    for (const Vector<double>& p : path.points)
        sum += dot(p - centre, p - centre) / n;
    return 2 * std::sqrt(sum);
}

/// The size that the problem speaks of: its longest fixed link, else its path, else its ranges, of coordinates at last.
double length_scale(const Problem& problem) {
    double fixed = 0, ranged = 0, coordinates = 0;
    for (std::size_t i = 0; i < problem.dimensions.size(); ++i) {
        const DimensionRange& d = problem.dimensions[i];
        if (problem.mechanism->dimensions[i].kind == DimensionKind::coordinate)
            coordinates = std::max({coordinates, std::abs(d.min), std::abs(d.max)});
        if (problem.mechanism->dimensions[i].kind != DimensionKind::length) continue;
        if (d.fixed()) fixed = std::max(fixed, d.max);
        ranged = std::max(ranged, std::sqrt(std::max(d.min, 0.01 * d.max) * d.max));
    }
    if (fixed > 0) return fixed;
    const double extent = problem.path ? path_extent(*problem.path) : 0;
    if (extent > 0) return extent;
    return ranged > 0 ? ranged : coordinates > 0 ? coordinates : 1;
}

/// What a value of this unit is divided by in the program.
double unit_scale(Unit unit, double length) {
    switch (unit) {
        case Unit::length:
        case Unit::force: return length;
        case Unit::area:
        case Unit::torque: return length * length;
        case Unit::curvature: return 1 / length;
        case Unit::none:
        case Unit::rate:
        case Unit::angle: return 1;
    }
    return 1;
}

/// Builds one program step by step; the parts below are in the order in which they are called.
struct Builder {
    const Problem& problem;
    Program program;
    Motion motion;
    std::size_t next_choice = 0;

    Builder(const Problem& p, const Variant& v) : problem(p), motion(motion_of(p, v.family, v.assembly)) {
        program.problem = &p;
        program.variant = v;
        program.length = length_scale(p);
        const Mechanism& mechanism = *p.mechanism;
        program.model = mechanism.model_over ? mechanism.model_over(mechanism.model, program.length) : mechanism.model;
        motion.model = program.model.data();
    }

    /// Whether prescribed crank angles of a target are counted from a dimension.
    bool is_start(std::size_t dimension) const {
        const Mechanism& mechanism = *problem.mechanism;
        if (!mechanism.point) return false;
        for (std::size_t k = 0; k < std::max<std::size_t>(mechanism.guided.size(), 1); ++k)
            if (mechanism.roles_of(k).start == dimension) return true;
        return false;
    }

    void add_dimensions() {
        const auto& kinds = problem.mechanism->dimensions;
        program.variable_of.assign(kinds.size(), -1);
        program.follows.resize(kinds.size());
        for (std::size_t i = 0; i < kinds.size(); ++i) {
            const DimensionRange& range = problem.dimensions[i];
            const double scale = scales(kinds[i].kind) ? program.length : 1;
            program.dimensions.push_back(range.min / scale);
            if (range.fixed() || range.tied()) continue;
            // A timed path and an instant need the start angle; an untimed path finds its own crank angles.
            const bool unused_start =
                is_start(i) && !problem.has_instant && !(problem.path && problem.path->prescribed_timing);
            if (unused_start) {
                program.dimensions.back() = range.start.value_or(range.min) / scale;
                continue;
            }
            const bool length = kinds[i].kind == DimensionKind::length;
            const double lower = length ? std::max(range.min, least_length * range.max) : range.min;
            program.dimensions.back() = 0;
            program.follows[i] = {{program.variables.size(), 1}};
            program.variable_of[i] = static_cast<std::ptrdiff_t>(program.variables.size());
            // An angle that may take any value has no ends that a search could run against.
            // After a turn of a cycle of several nothing is where it was.
            const bool comes_back = !is_start(i) || turns_of_cycle(*problem.mechanism) == 1;
            const double beyond = turns_freely(problem, i) && comes_back ? 2 * std::numbers::pi : 0;
            program.variables.push_back(
                {std::string(kinds[i].name), lower / scale - beyond, range.max / scale + beyond});
        }
        for (std::size_t i = 0; i < kinds.size(); ++i)
            if (problem.dimensions[i].tied()) add_tie(i);
    }

    void add_tie(std::size_t dimension) {
        const DimensionRange& range = problem.dimensions[dimension];
        const Dimension& kind = problem.mechanism->dimensions[dimension];
        program.dimensions[dimension] = range.tie.constant / (scales(kind.kind) ? program.length : 1);
        for (const auto& [other, times] : range.tie.terms)
            if (program.variable_of[other] >= 0)
                program.follows[dimension].push_back({static_cast<std::size_t>(program.variable_of[other]), times});
            else
                program.dimensions[dimension] += times * program.dimensions[other];
        if (kind.kind != DimensionKind::length || range.min > 0) return;
        LinearForm form{{}, program.follows[dimension], program.dimensions[dimension]};
        add_row(fmt::format("{} is greater than 0", kind.name), std::move(form),
                least_length * range.max / program.length, unlimited);
    }

    void add_path() {
        program.dimension_variables = program.variables.size();
        if (problem.path) add_path_rows(program);
    }

    void add_row(std::string name, LinearForm form, double lower, double upper) {
        program.rows.push_back({std::move(name), std::move(form), lower, upper});
    }

    void add_conditions_of_motion() {
        const Family& family = problem.mechanism->families[program.variant.family];
        for (const LinearCondition& condition : family.conditions) {
            LinearForm form;
            for (std::size_t i = 0; i < condition.coefficients.size(); ++i) {
                for (const LinearTerm& term : program.follows[i])
                    form.variables.push_back({term.index, condition.coefficients[i] * term.factor});
                form.constant += condition.coefficients[i] * program.dimensions[i];
            }
            add_row(std::string(condition.name), std::move(form), condition_margin, unlimited);
        }
        if (const auto stroke = stroke_of(program))
            for (const InputTask& task : input_tasks(problem))
                keep_on_stroke(task.start, *stroke);
        const bool one_range = moves_over_targets(problem) && !covers_several(problem);
        if (one_range) add_margins(block_of(problem.mechanism->input->margin));
        if (moves_over_targets(problem) && family.full_turn) {
            if (family.assembly_margin) add_full_turn(family);
        } else if (!one_range) {
            if (family.assembly_margin && is_defined(*family.assembly_margin, motion))
                add_margins(block_of(*family.assembly_margin));
            if (needs_stretch(problem, family)) {
                const Quantity& margin = problem.mechanism->input->margin;
                add_margins(add_block(margin, motion_for(margin, motion), true));
            }
        }
    }

    /// Keeps an input range, which starts with a dimension, on the stroke of the slide that drives.
    void keep_on_stroke(std::size_t start, const std::array<double, 2>& stroke) {
        LinearForm form;
        for (const std::size_t dimension : {start, start + 1}) {
            form.variables.insert(form.variables.end(), program.follows[dimension].begin(),
                                  program.follows[dimension].end());
            form.constant += program.dimensions[dimension];
            if (!form.variables.empty()) add_row("the input range is on the stroke", form, stroke[0], stroke[1]);
        }
    }

    /// What keeps the crank turning fully beyond the range of its input.
    void add_full_turn(const Family& family) {
        Motion whole = motion_for(*family.assembly_margin, motion);
        whole.full_turn = true;
        whole.from = 0;
        whole.to = 2 * std::numbers::pi * family.turns;
        if (!is_defined(*family.assembly_margin, whole)) return;
        add_margins(add_block(*family.assembly_margin, whole, false));
    }

    /// Rows that keep the design assembled.
    void add_margins(const QuantityBlock& block) {
        for (std::size_t k = 0; k < block.count; ++k)
            add_row(std::string(block.quantity->name), {{{block.first + k, 1}}, {}}, condition_margin, unlimited);
    }

    /// `over` is the motion as the functions of the quantity get it.
    QuantityBlock add_block(const Quantity& quantity, const Motion& over, bool along_stretch) {
        program.blocks.push_back({&quantity, over, program.outputs, quantity.components(over), along_stretch});
        program.outputs += program.blocks.back().count;
        return program.blocks.back();
    }

    QuantityBlock block_of(const Quantity& quantity) {
        for (const QuantityBlock& block : program.blocks)
            if (block.quantity == &quantity) return block;
        // What knows that the ends of the motion move gets those of the stretch in which all targets are met.
        return add_block(quantity, motion_of(problem, quantity, motion),
                         (problem.use || covers_several(problem)) && has_moving_ends(problem, quantity));
    }

    std::size_t place(std::optional<std::size_t>& output, std::size_t count) {
        if (!output) {
            output = program.outputs;
            program.outputs += count;
        }
        return *output;
    }

    double total_weight(const PointRange& points) const {
        const auto from = problem.path->weights.begin() + static_cast<std::ptrdiff_t>(points.first);
        return std::accumulate(from, from + static_cast<std::ptrdiff_t>(points.count), 0.0);
    }

    /// The sum and the mean over all points or those of one target.
    PathBlock::Mean& mean_of(std::size_t target) {
        std::vector<PathBlock::Mean>& means = program.path->means;
        const auto at = std::find_if(means.begin(), means.end(),
                                     [&](const PathBlock::Mean& mean) { return mean.of_target == target; });
        return at == means.end() ? means.emplace_back(PathBlock::Mean{target, {}, {}}) : *at;
    }

    /// What the sum is multiplied by to be that of the weights that the file gives: those of one of several targets
    /// stand for its share in all.
    double as_given(std::size_t target) const {
        const PathTarget& path = *problem.path;
        if (path.parts.empty() || target == every_target) return 1;
        const std::vector<double>& given = path.parts[target].weights;
        return std::accumulate(given.begin(), given.end(), 0.0) / path.parts[target].weight;
    }

    /// The component chosen by this variant for the next disjunction.
    std::size_t chosen() {
        return next_choice < program.variant.choices.size() ? program.variant.choices[next_choice++] : 0;
    }

    /// lower <= factor output <= upper, divided by the greater of the two limits.
    void add_limits(const std::string& name, std::size_t output, double factor, double lower, double upper) {
        const double size =
            std::max(std::isfinite(lower) ? std::abs(lower) : 0, std::isfinite(upper) ? std::abs(upper) : 0);
        const double scale = size > 0 ? 1 / size : 1;
        add_row(name, {{{output, factor * scale}}, {}}, lower * scale, upper * scale);
        program.rows.back().requirement = true;
    }

    /// |output| <= limit. Against a limit below the tolerance everything else that the program holds would be huge: of
    /// such a one half is aimed at, and the tolerance is the other half.
    void add_absolute_limit(const std::string& name, std::size_t output, double limit) {
        const double tolerance = problem.solver.tolerance;
        if (limit == 0 || limit > tolerance) return add_limits(name, output, 1, -limit, limit);
        add_row(name, {{{output, 2 * tolerance / limit}}, {}}, -tolerance, tolerance);
        program.rows.back().requirement = true;
    }

    /// The limits that a requirement sets, in the program's unit.
    struct Limits {
        double lower;
        double upper;
    };

    Limits limits_of(const Quantity& quantity, const Requirement& r) const {
        const double unit = unit_scale(quantity.unit, program.length);
        if (r.equal) return {*r.equal / unit, *r.equal / unit};
        return {r.min ? *r.min / unit : -unlimited, r.max ? *r.max / unit : unlimited};
    }

    /// A limit on a distance, less what the rounding of a design's dimensions can add to it; half of it at the least.
    static double within_rounding(double limit) {
        constexpr double kept_below_limit = 1.5e-14;  // some rounding units of positions, of a program's order one
        return std::max(limit - kept_below_limit, 0.5 * limit);
    }

    void add_path_requirement(const Quantity& quantity, const Requirement& r) {
        auto [lower, upper] = limits_of(quantity, r);
        const std::string name(quantity.name);
        if (quantity.path == PathMeasure::sum_of_squares)
            return add_limits(name, place(mean_of(quantity.of_target).sum, 1), as_given(quantity.of_target), lower,
                              upper);
        if (!r.equal) upper = within_rounding(upper);
        const PointRange points = problem.path->points_of(quantity.of_target);
        if (quantity.path == PathMeasure::root_mean_square)
            return add_limits(name, place(mean_of(quantity.of_target).sum, 1), 1 / total_weight(points),
                              lower * std::abs(lower), upper * std::abs(upper));
        const std::size_t first = place(program.path->squares, program.targets.size());
        for (std::size_t i = points.first; i < points.end(); ++i)
            add_limits(name, first + i, 1, -unlimited, upper * std::abs(upper));
    }

    void add_requirements() {
        for (const Requirement& r : problem.requirements) {
            const Quantity& quantity = programmed_quantity(problem, r.quantity);
            if (quantity.path != PathMeasure::none) {
                add_path_requirement(quantity, r);
                continue;
            }
            const auto [lower, upper] = limits_of(quantity, r);
            const QuantityBlock block = block_of(quantity);
            // The side on which every component must lie, then the side on which one must.
            const bool single = block.count == 1;
            const bool all_above = single || quantity.reduce == Reduce::least;
            const bool all_below = single || quantity.reduce == Reduce::greatest;
            const std::size_t one = !single && is_disjunctive(quantity, r) ? chosen() : 0;
            for (std::size_t k = 0; k < block.count; ++k) {
                const double low = all_above || k == one ? lower : -unlimited;
                const double high = all_below || k == one ? upper : unlimited;
                if (quantity.paired && low == -unlimited) {
                    const bool twin_follows = k % 2 == 0;
                    if (twin_follows && high < unlimited)
                        add_absolute_limit(std::string(quantity.name), block.first + k, high);
                    continue;
                }
                if (std::isfinite(low) || std::isfinite(high))
                    add_limits(std::string(quantity.name), block.first + k, 1, low, high);
            }
        }
    }

    /// The outputs whose worst is the value of a term, and whether that worst is the least.
    struct TermOutputs {
        std::vector<LinearTerm> outputs;
        bool least;
    };

    const Quantity& quantity_of(const ObjectiveTerm& term) const { return programmed_quantity(problem, term.quantity); }

    TermOutputs outputs_of(const ObjectiveTerm& term, bool alone) {
        const Quantity& quantity = quantity_of(term);
        PathBlock* path = program.path ? &*program.path : nullptr;
        switch (quantity.path) {
            case PathMeasure::sum_of_squares:
                return {{{place(mean_of(quantity.of_target).sum, 1), as_given(quantity.of_target)}}, false};
            case PathMeasure::root_mean_square:
                // Alone it is least where the sum is, and the sum is smooth.
                if (alone) return {{{place(mean_of(quantity.of_target).sum, 1), 1}}, false};
                return {{{place(mean_of(quantity.of_target).rms, 1), 1}}, false};
            case PathMeasure::greatest: {
                const std::size_t n = program.targets.size();
                const std::size_t first = alone ? place(path->squares, n) : place(path->distances, n);
                const PointRange points = problem.path->points_of(quantity.of_target);
                TermOutputs all{{}, false};
                for (std::size_t i = points.first; i < points.end(); ++i)
                    all.outputs.push_back({first + i, 1});
                return all;
            }
            case PathMeasure::none: break;
        }
        const QuantityBlock block = block_of(quantity);
        const bool least = quantity.reduce == Reduce::least;
        if (block.count == 1) return {{{block.first, 1}}, least};
        // Of a minimised least or maximised greatest value one component decides.
        if (least != term.maximize)
            return {{{block.first + (is_disjunctive(quantity, term) ? chosen() : 0), 1}}, least};
        TermOutputs all{{}, least};
        for (std::size_t k = 0; k < block.count; ++k)
            all.outputs.push_back({block.first + k, 1});
        return all;
    }

    /// What an output of this quantity is multiplied by to be in the file's unit, in which weights are meant.
    double in_file_unit(const Quantity& quantity) const {
        if (quantity.unit == Unit::angle) return problem.units.degrees ? 180 / std::numbers::pi : 1;
        return unit_scale(quantity.unit, program.length);
    }

    /// A variable that lies above (below) all outputs, with the rows that keep it there.
    std::size_t add_epigraph(const std::vector<LinearTerm>& outputs, bool above, const std::string& name) {
        const std::size_t t = program.variables.size();
        program.variables.push_back({"worst " + name, -unlimited, unlimited});
        for (const LinearTerm& output : outputs) {
            const double sign = above ? 1 : -1;
            add_row("worst " + name, {{{output.index, -sign * output.factor}}, {{t, sign}}}, 0, unlimited);
        }
        program.epigraphs.push_back({t, above, outputs});
        return t;
    }

    void add_objective() {
        if (!problem.objective) {
            program.closest_to_reference = true;
            return;
        }
        const Objective& objective = *problem.objective;
        const bool alone = objective.terms.size() == 1;
        if (objective.worst && !alone) {
            const bool maximize = objective.terms.front().maximize;
            std::vector<LinearTerm> outputs;
            for (const ObjectiveTerm& term : objective.terms)
                for (const LinearTerm& output : outputs_of(term, false).outputs)
                    outputs.push_back({output.index, output.factor * term.weight * in_file_unit(quantity_of(term))});
            program.objective.variables.push_back(
                {add_epigraph(outputs, !maximize, "objective"), maximize ? -1.0 : 1.0});
            return;
        }
        for (const ObjectiveTerm& term : objective.terms) {
            const TermOutputs value = outputs_of(term, alone);
            const double weight = alone ? 1 : term.weight * in_file_unit(quantity_of(term));
            const double factor = term.maximize ? -weight : weight;
            if (value.outputs.size() == 1)
                program.objective.outputs.push_back(
                    {value.outputs.front().index, factor * value.outputs.front().factor});
            else
                program.objective.variables.push_back(
                    {add_epigraph(value.outputs, !value.least, std::string(quantity_of(term).name)), factor});
        }
    }
};

}  // namespace

Program build_program(const Problem& problem, const Variant& variant) {
    Builder builder(problem, variant);
    builder.add_dimensions();
    builder.add_path();
    builder.add_conditions_of_motion();
    builder.add_requirements();
    builder.add_objective();
    Program program = std::move(builder.program);
    // Where nothing is to be optimised, designs close to the preferred or middle values are asked for.
    program.reference = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(program.size()));
    for (std::size_t i = 0; i < program.variable_of.size(); ++i) {
        const std::ptrdiff_t v = program.variable_of[i];
        if (v < 0) continue;
        const Variable& variable = program.variables[static_cast<std::size_t>(v)];
        const double scale = scales(problem.mechanism->dimensions[i].kind) ? program.length : 1;
        const auto& start = problem.dimensions[i].start;
        program.reference[v] = start ? *start / scale : 0.5 * (variable.lower + variable.upper);
    }
    return program;
}

}  // namespace mechwright

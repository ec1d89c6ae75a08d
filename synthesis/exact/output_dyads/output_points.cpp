#include "synthesis/exact/output_dyads/output_points.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "synthesis/exact/chains/link_numbers.h"
#include "synthesis/exact/output_dyads/dyad_conditions.h"
#include "synthesis/problem/judged_motion.h"
#include "synthesis/program/quantity_value.h"

namespace mechwright {

namespace {

using Point = std::complex<double>;

Point complex_of(const Vector<double>& v) { return {v.x, v.y}; }

/// Links of one size: what is known of the dyad for some of a linkage's assemblies.
struct OutputProblem {
    const Problem& problem;
    const LinkageModel& model;
    FunctionTarget points;  ///< as samples
    const Quantity& error;
    DyadPlan plan;

    explicit OutputProblem(const Problem& p)
        : problem(p),
          model(*p.mechanism->model.as<LinkageModel>()),
          points(at_accuracy_points(*p.function)),
          error(deviation_from(*p.mechanism, "function")),
          plan(dyad_plan(p)) {}

    std::size_t scales() const { return problem.mechanism->input->start; }
    std::size_t start() const { return scales() + 2; }
    const linkage::Coordinates& at(std::size_t pin, std::size_t link) const {
        return coordinates_on(model.structure.pins[pin], link);
    }
};

/// Ranges in which all that is searched has a value.
using Ranges = std::vector<DimensionRange>;

std::vector<double> least_of(const Ranges& ranges) {
    std::vector<double> dimensions;
    for (const DimensionRange& range : ranges)
        dimensions.push_back(range.min);
    return dimensions;
}

/// The assemblies of a problem, one of those that differ in the dyad alone.
std::vector<std::size_t> assemblies_before(const OutputProblem& o) {
    std::vector<std::size_t> different;
    const auto before = [&](std::size_t assembly) {
        auto sides = o.model.sides[assembly];
        sides[o.plan.dyad.choice] = 0;
        return sides;
    };
    for (const std::size_t assembly : o.problem.assemblies)
        if (std::none_of(different.begin(), different.end(),
                         [&](std::size_t other) { return before(other) == before(assembly); }))
            different.push_back(assembly);
    return different;
}

/// The same assembly with the dyad on a side; nothing where the mechanism has none.
std::optional<std::size_t> with_side(const OutputProblem& o, std::size_t assembly, int side) {
    auto sides = o.model.sides[assembly];
    sides[o.plan.dyad.choice] = static_cast<std::int8_t>(side);
    const auto same = std::find(o.model.sides.begin(), o.model.sides.end(), sides);
    if (same == o.model.sides.end()) return {};
    return static_cast<std::size_t>(same - o.model.sides.begin());
}

/// A power of two, so that scaling costs no digits.
double size_of(const KnownPlaces<double>& known) {
    double sum = 0;
    for (const Vector<double>& place : known.outer) {
        const Vector<double> way = place - known.outer.front();
        sum += dot(way, way);
    }
    return sum > 0 ? std::exp2(std::round(std::log2(std::sqrt(sum / static_cast<double>(known.outer.size()))))) : 1;
}

/// What is known before the dyad, and the dyad that was found: at the first accuracy point, in the frame of the link
/// that carries it.
struct FoundDyad {
    const Ranges& ranges;
    const KnownPlaces<double>& known;
    std::size_t assembly;
    Point inner_pin;
    Point pivot;  ///< of a lever; of a slide the direction of its line

    Point outer(std::size_t i) const { return complex_of(known.outer[i]); }
    Point turn(std::size_t i) const { return complex_of(known.turns[i]); }
    Point arm() const { return inner_pin - pivot; }
    Point inner(std::size_t i) const {
        if (known.turns.empty()) return inner_pin + (known.ways[i] - known.ways[0]) * pivot;
        return pivot + arm() * turn(i) / turn(0);
    }
};

/// On which side the dyad is closed, 1 or -1; 0 where that changes from point to point.
int side_of(const OutputProblem& o, const FoundDyad& found) {
    int side = 0;
    for (std::size_t i = 0; i < found.known.outer.size(); ++i) {
        const Point from = o.plan.dyad.counts_from_rod ? found.outer(i) : found.pivot;
        const Point to = o.plan.dyad.counts_from_rod ? found.pivot : found.outer(i);
        const bool positive = o.plan.dyad.slides()
                                  ? (std::conj(found.pivot) * (found.inner(i) - found.outer(i))).real() > 0
                                  : (std::conj(to - from) * (found.inner(i) - from)).imag() > 0;
        const int here = positive ? 1 : -1;
        if (side != 0 && here != side) return 0;
        side = here;
    }
    return side;
}

/// Whether the function is met at the accuracy points, by the linkage's own analysis.
bool meets_points(const OutputProblem& o, const Design& design) {
    constexpr double met_within = 1e-9;  // radians, or over the size of what a slide is moved by
    Motion motion = motion_of(o.problem, design);
    motion.function = &o.points;
    motion = motion_for(o.error, motion);
    std::array<double, Quantity::most_components> components{};
    measure(o.error, motion, design.dimensions, {components, {}, {}});
    const auto end = components.begin() + static_cast<std::ptrdiff_t>(o.error.components(motion));
    const double unit = o.plan.dyad.slides() ? longest_length(*o.problem.mechanism, design.dimensions) : 1;
    return std::all_of(components.begin(), end, [&](double error) { return std::abs(error) <= met_within * unit; });
}

/// What is known of the numbers of a lever, and the start of the output where it is found.
void say_lever(const OutputProblem& o, const FoundDyad& found, const LinkNumbers& numbers, std::vector<ChainRow>& rows,
               double& start) {
    const OutputDyad& dyad = o.plan.dyad;
    const Point pivot = *numbers.constant_place(o.at(dyad.pivot, dyad.lever));
    if (o.plan.start_is_found) {
        const Point arm =
            found.arm() / std::abs(found.arm()) / *numbers.direction_to(o.at(dyad.inner, dyad.lever), pivot);
        start = dyad.sense * std::arg(arm / found.turn(0));
    }
    const Point lever = found.turn(0) * std::polar(1.0, dyad.sense * start);
    numbers.add_place(rows, o.at(dyad.pivot, dyad.carrier), found.pivot);
    numbers.add_place(rows, o.at(dyad.inner, dyad.lever), pivot + found.arm() / lever);
}

/// The same of a slide.
void say_slide(const OutputProblem& o, const FoundDyad& found, const std::vector<double>& dimensions,
               std::vector<ChainRow>& rows, double& start) {
    const auto line = slide_line<double>(o.model, o.plan.dyad, dimensions);
    const Point along = complex_of(line.along), from = std::conj(along) * (found.inner_pin - complex_of(line.pin));
    if (o.plan.start_is_found) start = from.real() - found.known.ways.front();
    rows.push_back({o.model.numbers[o.model.structure.slides[o.plan.dyad.slide].offset], from.imag(), false});
}

ExactDesign design_of(const OutputProblem& o, const FoundDyad& found) {
    const OutputDyad& dyad = o.plan.dyad;
    const LinkNumbers numbers{found.ranges, o.model};
    const Point rod_end = *numbers.constant_place(o.at(dyad.outer, dyad.rod));
    Design design;
    design.dimensions = least_of(found.ranges);
    design.assembly = found.assembly;
    std::vector<ChainRow> rows;
    double& start = design.dimensions[o.start()];
    if (dyad.slides())
        say_slide(o, found, design.dimensions, rows, start);
    else
        say_lever(o, found, numbers, rows, start);
    numbers.add_place(rows, o.at(dyad.inner, dyad.rod),
                      rod_end + std::abs(found.outer(0) - found.inner(0)) *
                                    *numbers.direction_to(o.at(dyad.inner, dyad.rod), rod_end));
    const bool agree = solve_rows(*o.problem.mechanism, found.ranges, rows, design.dimensions);
    const int side = side_of(o, found);
    if (side == 0)
        return excluded_design(std::move(design), "branch: it has to be taken apart between the accuracy points");
    if (!agree) return excluded_design(std::move(design), "range: what is given of its links does not allow it");
    const auto assembly = with_side(o, found.assembly, side);
    if (!assembly) return excluded_design(std::move(design), "assembly: it is not the one that is asked for");
    design.assembly = *assembly;
    ExactDesign made = exact_design(o.problem, std::move(design));
    if (made.defect.empty() && !meets_points(o, made.solution.design))
        return excluded_design(std::move(made.solution.design), "accuracy: it does not meet the accuracy points");
    return made;
}

/// A lever without length on the pivot about which the outer pin goes round itself: every function is met by it.
bool is_no_lever(const Dyad& dyad) { return std::abs(dyad.fixed) < 1e-7 * (1 + std::abs(dyad.moving)); }

/// The dyads of one assembly: what they follow from, and those that are real.
struct Dyads {
    KnownPlaces<double> known;
    double size = 1;
    std::vector<Dyad> real;
};

/// Nothing where the linkage before the dyad does not close at an accuracy point.
std::optional<Dyads> dyads_of(const OutputProblem& o, const Ranges& ranges, std::size_t assembly,
                              SolutionCounts& counts) {
    const std::vector<double> dimensions = least_of(ranges);
    auto known = known_places(o.model, o.plan.dyad, dimensions, o.scales(), assembly, o.points.parts);
    if (!known) return {};
    Dyads all{*std::move(known), 1, {}};
    all.size = size_of(all.known);
    const auto conditions = output_conditions(o.model, o.plan, o.start(), all.known, dimensions, all.size);
    const DyadSolutions found = dyads_meeting(conditions);
    counts.tracked += conditions.moving_lines == 2 || conditions.fixed_lines == 2 ? 1 : 4;
    counts.at_infinity += found.at_infinity;
    counts.singular += found.singular;
    for (const ComplexDyad& dyad : found.dyads) {
        const auto real = real_dyad(dyad);
        if (real && !o.plan.dyad.slides() && is_no_lever(*real)) {
            --counts.tracked;
            continue;
        }
        ++counts.distinct;
        if (!real) continue;
        ++counts.real;
        all.real.push_back(*real);
    }
    return all;
}

ExactDesign design_of(const OutputProblem& o, const Ranges& ranges, std::size_t assembly, const Dyads& of,
                      const Dyad& dyad) {
    const Point outer = complex_of(of.known.outer.front()), pivot = outer - of.size * dyad.moving;
    if (o.plan.dyad.slides())
        return design_of(o, {ranges, of.known, assembly, outer + of.size * dyad.fixed, dyad.moving});
    return design_of(o, {ranges, of.known, assembly, pivot + of.size * dyad.fixed, pivot});
}

/// The dyads rounded from their certificates, as far as there are some.
void certify(const OutputProblem& o, const Ranges& ranges, std::size_t assembly, Dyads& all, SolutionCounts& counts) {
    std::vector<Digits50> dimensions;
    for (const DimensionRange& range : ranges)
        dimensions.emplace_back(range.min);
    const auto known = known_places_again(o.model, o.plan.dyad, dimensions, o.scales(), assembly, o.points.parts);
    if (!known) return;
    const auto conditions = output_conditions(o.model, o.plan, o.start(), *known, dimensions, all.size);
    for (Dyad& dyad : all.real)
        if (const auto proof = certified(dyad, conditions.rows)) {
            ++counts.certified;
            dyad = proof->dyad;
        }
}

/// What shows that all dyads are known.
std::string argument(const SolutionCounts& counts, std::size_t points) {
    if (counts.tracked == 1)
        return fmt::format("linear equations have one dyad that ends on the output and meets {} accuracy points",
                           points);
    return fmt::format(
        "Burmester: all {} dyads that end on the output and meet {} accuracy points are accounted for, {} of them real",
        counts.tracked, points, counts.real);
}

ExactDesigns isolated(const OutputProblem& o) {
    ExactDesigns out;
    SolutionCounts counts;
    bool closes = false;
    for (const std::size_t assembly : assemblies_before(o)) {
        auto all = dyads_of(o, o.problem.dimensions, assembly, counts);
        if (!all) continue;
        closes = true;
        certify(o, o.problem.dimensions, assembly, *all, counts);
        for (const Dyad& dyad : all->real)
            add_design(out, design_of(o, o.problem.dimensions, assembly, *all, dyad));
    }
    if (!closes) out.note = "what the dyad hangs on does not close at every accuracy point, in none of the assemblies";
    out.counts = counts;
    out.evaluations = static_cast<long>(counts.tracked);
    if (counts.distinct + counts.at_infinity == counts.tracked)
        out.proof = proof_by(argument(counts, o.points.parts.size()), CountCertificate{});
    else
        out.note = some_are_singular;
    rank(o.problem, out);
    return out;
}

Ranges ranges_for(const OutputProblem& o, std::span<const double> numbers) {
    Ranges ranges = o.problem.dimensions;
    for (std::size_t j = 0; j < o.plan.searched.size(); ++j) {
        DimensionRange& range = ranges[o.plan.searched[j]];
        range.min += numbers[j] * (range.max - range.min);
        range.max = range.min;
    }
    return ranges;
}

}  // namespace

std::string why_no_output_points(const Problem& problem) {
    if (has_ties(problem)) return "dimensions are tied to others";
    return dyad_plan(problem).why_not;
}

ExactDesigns output_point_designs(const Problem& problem, const RunOptions& options, const RunEnd& end) {
    const OutputProblem o(problem);
    if (o.plan.searched.empty()) return isolated(o);
    const std::vector<std::size_t> assemblies = assemblies_before(o);
    const auto member = [&](std::span<const double> numbers) {
        const Ranges ranges = ranges_for(o, numbers);
        SolutionCounts counts;
        std::optional<ExactDesign> best;
        for (const std::size_t assembly : assemblies)
            if (const auto all = dyads_of(o, ranges, assembly, counts))
                for (const Dyad& dyad : all->real)
                    keep_better(problem, best, design_of(o, ranges, assembly, *all, dyad));
        return best;
    };
    constexpr int examined = 1024;  // what a linkage does over a range takes a while
    return search_family(problem, {o.plan.searched.size(), member, {}, examined}, options, end);
}

}  // namespace mechwright

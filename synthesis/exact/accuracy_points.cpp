#include "synthesis/exact/accuracy_points.h"

#include <fmt/format.h>

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "synthesis/exact/poses/certified_dyad.h"
#include "synthesis/exact/sized_linkage.h"
#include "synthesis/mechanism/four_bar/four_bar.h"
#include "synthesis/problem/units.h"
#include "synthesis/target/function/function_target.h"

namespace mechwright {

namespace {

using Complex = std::complex<double>;

/// Errors at accuracy points that are met, radians.
constexpr double met_within = 1e-9;

/// start and range of input and output, in the order of the dimensions.
using Scales = std::array<double, 4>;

/// Crank and rocker pin at the first accuracy point, the crank's pivot in 0 and the rocker's in 1.
struct Pins {
    Complex crank;
    Complex rocker;
};

std::vector<Pins> without_ground_link(const DyadSolutions& found, SolutionCounts& counts) {
    counts.tracked += 4;
    counts.at_infinity += found.at_infinity;
    counts.singular += found.singular;
    std::vector<Pins> pins;
    for (const ComplexDyad& dyad : found.dyads) {
        const auto real = real_dyad(dyad);
        // The ground link itself joins its two pivots at all times.
        if (real && std::abs(real->moving) + std::abs(real->fixed - 1.0) < 1e-7) {
            --counts.tracked;
            continue;
        }
        ++counts.distinct;
        if (!real) continue;
        ++counts.real;
        pins.push_back({real->moving, real->fixed});
    }
    return pins;
}

struct AccuracyProblem {
    const Problem& problem;
    FunctionTarget points;  ///< as samples
    const Quantity& error;

    explicit AccuracyProblem(const Problem& p)
        : problem(p), points(at_accuracy_points(*p.function)), error(deviation_from(*p.mechanism, "function")) {}

    std::size_t count() const { return points.parts.size(); }
    const DimensionRange& scale(std::size_t k) const { return problem.dimensions[problem.mechanism->input->start + k]; }
    double input(const Scales& s, std::size_t i) const { return s[0] + s[1] * points.parts[i].x; }
    double output(const Scales& s, std::size_t i) const { return s[2] + s[3] * points.parts[i].y; }

    /// The crank as a body seen from the rocker: displacements from the first accuracy point of the crank's pivot, and
    /// turns of the crank against the rocker. A link that joins the two is the coupler.
    std::vector<Displacement> displacements(const Scales& s) const {
        std::vector<Displacement> all;
        for (std::size_t i = 1; i < count(); ++i) {
            const double crank = s[1] * (points.parts[i].x - points.parts[0].x);
            const double rocker = s[3] * (points.parts[i].y - points.parts[0].y);
            all.push_back({1.0 - std::polar(1.0, -rocker), std::polar(1.0, crank - rocker)});
        }
        return all;
    }
};

/// Freudenstein's equation k1 cos(output) - k2 cos(input) + k3 = cos(input - output) at three points: linear in the
/// ratios. Both starts are given.
std::optional<Pins> through_three(const AccuracyProblem& a, const Scales& s) {
    Eigen::Matrix3d rows;
    Eigen::Vector3d right;
    for (Eigen::Index i = 0; i < 3; ++i) {
        const double input = a.input(s, static_cast<std::size_t>(i)), output = a.output(s, static_cast<std::size_t>(i));
        rows.row(i) << std::cos(output), -std::cos(input), 1;
        right[i] = std::cos(input - output);
    }
    const Eigen::FullPivLU<Eigen::Matrix3d> lu(rows);
    if (!lu.isInvertible()) return {};
    Eigen::Vector3d k = lu.solve(right);
    k += lu.solve(right - rows * k);
    // k1 = ground / crank, k2 = ground / rocker; negative ones turn a link by half a turn.
    if (!(k[0] != 0 && k[1] != 0)) return {};
    return Pins{std::polar(1.0, a.input(s, 0)) / k[0], 1.0 + std::polar(1.0, a.output(s, 0)) / k[1]};
}

/// An angle that is found up to whole turns, as the file counts it.
double counted_as_asked(double angle, const DimensionRange& range) {
    constexpr double turn = 2 * std::numbers::pi;
    const double middle = 0.5 * (range.min + range.max);
    const double counted = angle + turn * std::round((middle - angle) / turn);
    return range.fixed() && std::abs(counted - range.min) < met_within ? range.min : counted;
}

ExactDesign design_of(const AccuracyProblem& a, const Scales& s, const Pins& pins) {
    const Problem& problem = a.problem;
    Design design = mechwright::design_of(
        problem,
        SizedLinkage{1, std::abs(pins.crank), std::abs(pins.rocker - pins.crank), std::abs(pins.rocker - 1.0)});
    auto& d = design.dimensions;
    const std::size_t scales = problem.mechanism->input->start;
    std::copy(s.begin(), s.end(), d.begin() + static_cast<std::ptrdiff_t>(scales));
    d[scales] = counted_as_asked(std::arg(pins.crank) - s[1] * a.points.parts[0].x, a.scale(0));
    d[scales + 2] = counted_as_asked(std::arg(pins.rocker - 1.0) - s[3] * a.points.parts[0].y, a.scale(2));
    const Complex to_pivot = 1.0 - pins.crank, to_pin = pins.rocker - pins.crank;
    design.assembly = (std::conj(to_pivot) * to_pin).imag() > 0 ? 0 : 1;
    Motion motion;
    motion.assembly = design.assembly;
    motion.function = &a.points;
    std::array<double, Quantity::most_components> components{};
    measure(a.error, motion, d, {components, {}, {}});
    const std::size_t count = a.error.components(motion);
    ExactDesign out = exact_design(problem, std::move(design));
    const bool met = std::all_of(components.begin(), components.begin() + static_cast<std::ptrdiff_t>(count),
                                 [](double error) { return std::abs(error) <= met_within; });
    if (!met) {
        out.defect = "branch: it has to be taken apart between the accuracy points";
        out.solution.violation = std::max(out.solution.violation, 1.0);
        out.solution.feasible = false;
    }
    return out;
}

/// Which starts are solved for, where there are more than three points: the output's first.
struct Solved {
    bool input = false;
    bool output = false;
};

Solved solved_starts(const AccuracyProblem& a) {
    if (a.count() == 5) return {true, true};
    if (a.count() == 4) return a.scale(2).fixed() ? Solved{true, false} : Solved{false, true};
    return {};
}

/// The conditions of the coupler as a dyad in fifty digits, the crank's pivot in 0 and the rocker's in 1: it joins
/// places of the crank seen from the rocker, and starts that are given put its pins on lines.
std::array<ExactCondition, 4> exact_conditions(const AccuracyProblem& a, const Scales& s) {
    const auto direction = [](const Digits50& angle) { return Vector<Digits50>{cos(angle), sin(angle)}; };
    const auto along = [](double start, double range, double part) { return Digits50(start) + Digits50(range) * part; };
    const auto& parts = a.points.parts;
    std::vector<ExactCondition> all;
    for (std::size_t i = 1; i < a.count(); ++i) {
        const Digits50 crank = Digits50(s[1]) * (Digits50(parts[i].x) - parts[0].x);
        const Digits50 rocker = Digits50(s[3]) * (Digits50(parts[i].y) - parts[0].y);
        all.push_back(exact_condition({{1 - cos(rocker), sin(rocker)}, direction(crank - rocker)}));
    }
    const Solved solved = solved_starts(a);
    if (!solved.input) all.push_back(exact_moving_pivot_on_line({0, 0}, direction(along(s[0], s[1], parts[0].x))));
    if (!solved.output) all.push_back(exact_fixed_pivot_on_line({1, 0}, direction(along(s[2], s[3], parts[0].y))));
    return {all[0], all[1], all[2], all[3]};
}

/// All four-bars for given scales, but for the starts that are solved for.
std::vector<Pins> pins_for(const AccuracyProblem& a, const Scales& s, SolutionCounts& counts) {
    const Solved solved = solved_starts(a);
    if (!solved.input && !solved.output) {
        ++counts.tracked;
        const auto pins = through_three(a, s);
        if (!pins) {
            ++counts.singular;
            return {};
        }
        ++counts.distinct;
        ++counts.real;
        return {*pins};
    }
    DyadConditions conditions;
    const std::vector<Displacement> displacements = a.displacements(s);
    for (std::size_t i = 0; i < displacements.size(); ++i)
        conditions.row(static_cast<Eigen::Index>(i)) = condition_of(displacements[i]);
    if (displacements.size() == 3)
        conditions.row(3) = solved.output ? moving_pivot_on_line(0, std::polar(1.0, a.input(s, 0)))
                                          : fixed_pivot_on_line(1, std::polar(1.0, a.output(s, 0)));
    return without_ground_link(dyads_meeting(conditions), counts);
}

/// The scales that are neither given nor solved for.
std::vector<std::size_t> searched_scales(const AccuracyProblem& a) {
    const Solved solved = solved_starts(a);
    std::vector<std::size_t> searched;
    for (std::size_t k = 0; k < 4; ++k)
        if (!a.scale(k).fixed() && !(k == 0 && solved.input) && !(k == 2 && solved.output)) searched.push_back(k);
    return searched;
}

Scales scales_for(const AccuracyProblem& a, const std::vector<std::size_t>& searched, std::span<const double> numbers) {
    Scales s;
    for (std::size_t k = 0; k < 4; ++k)
        s[k] = a.scale(k).min;
    for (std::size_t j = 0; j < searched.size(); ++j) {
        const DimensionRange& range = a.scale(searched[j]);
        s[searched[j]] = range.min + numbers[j] * (range.max - range.min);
    }
    return s;
}

ExactDesigns isolated(const AccuracyProblem& a) {
    ExactDesigns out;
    SolutionCounts counts;
    const Scales s = scales_for(a, {}, {});
    const auto conditions = exact_conditions(a, s);
    for (Pins pins : pins_for(a, s, counts)) {
        if (const auto proof = certified({pins.rocker, pins.crank}, conditions)) {
            ++counts.certified;
            pins = {proof->dyad.moving, proof->dyad.fixed};
        }
        add_design(out, design_of(a, s, pins));
    }
    out.counts = counts;
    out.evaluations = static_cast<long>(counts.tracked);
    if (counts.distinct + counts.at_infinity == counts.tracked)
        out.proof = proof_by(
            fmt::format(
                "Freudenstein: all {} four-bars that meet {} accuracy points are accounted for, {} of them real",
                counts.tracked, a.count(), counts.real),
            CountCertificate{});
    rank(a.problem, out);
    return out;
}

}  // namespace

std::string why_no_accuracy_points(const Problem& problem) {
    if (!is_four_bar(*problem.mechanism)) return "it generates functions by four-bars and linkages alone";
    if (!problem.function) return "it needs a [function]";
    if (has_ties(problem)) return "dimensions are tied to others";
    const FunctionTarget& f = *problem.function;
    const std::size_t points = f.expression.empty() ? f.samples.size() : f.accuracy_points.size();
    if (points == 0) return "it needs accuracy_points in [function]: 3, 4 or 5, or a list of x";
    if (points < 3 || points > 5)
        return fmt::format("it meets from 3 to 5 points of a function, and there are {}: {}", points,
                           points < 3 ? "give more" : "slsqp finds the least error");
    const std::size_t scales = problem.mechanism->input->start;
    const auto is_free = [&](std::size_t scale) { return problem.dimensions[scale].fixed() ? 0U : 1U; };
    const unsigned free_starts = is_free(scales) + is_free(scales + 2);
    if (points == 5 && free_starts < 2)
        return "five accuracy points need the starts of both scales: give input and output a range for 'start'";
    if (points == 4 && free_starts < 1)
        return "four accuracy points need the start of one scale: give input or output a range for 'start'";
    return {};
}

ExactDesigns accuracy_point_designs(const Problem& problem, const RunOptions& options, const RunEnd& end) {
    const AccuracyProblem a(problem);
    const std::vector<std::size_t> searched = searched_scales(a);
    if (searched.empty()) return isolated(a);
    const auto member = [&](std::span<const double> numbers) {
        const Scales s = scales_for(a, searched, numbers);
        SolutionCounts counts;
        std::optional<ExactDesign> best;
        for (const Pins& pins : pins_for(a, s, counts))
            keep_better(problem, best, design_of(a, s, pins));
        return best;
    };
    return search_family(problem, {searched.size(), member}, options, end);
}

}  // namespace mechwright

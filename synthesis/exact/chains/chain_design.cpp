#include "synthesis/exact/chains/chain_design.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "synthesis/exact/chains/chain_rows.h"
#include "synthesis/exact/chains/met_inputs.h"

namespace mechwright {

namespace {

using Point = std::complex<double>;
using homotopy::SecondDyad;

const LinkageModel& model_of(const Problem& problem) { return *problem.mechanism->model.as<LinkageModel>(); }

/// A linkage that stands in for any other: rows of its readings have what all have in common.
GuidedParts some_parts(SecondDyad kind) {
    return {{{0.31, 0.23}, {0.83, 1.07}},
            kind,
            {kind == SecondDyad::ram ? std::polar(1.0, 0.7) : Point(2.13, -0.41),
             kind == SecondDyad::block ? std::polar(1.0, 1.9) : Point(1.71, 1.39)}};
}

/// The crank's angle at each place, from the frame's x axis.
std::vector<double> crank_angles(const ChainReading& reading, const Dyad& crank,
                                 std::span<const Displacement> displacements) {
    std::vector<double> angles;
    const Point first = crank.moving - crank.fixed;
    for (const auto& [shift, turn] : displacements)
        angles.push_back(
            std::arg(reading.crank * ((shift + crank.moving * turn - crank.fixed) / first) / reading.frame));
    return angles;
}

/// On which side the second dyad is closed at a place: its sign.
double side_at(const GuidedParts& parts, const Point& along, const Displacement& at) {
    const auto& [shift, turn] = at;
    const Point pin = shift + parts.crank.moving * turn;
    if (parts.kind == SecondDyad::ram) return (std::conj(along) * (shift + parts.second.moving * turn - pin)).real();
    if (parts.kind == SecondDyad::block) return (std::conj(along * turn) * (parts.second.fixed - pin)).real();
    return (std::conj(parts.second.fixed - pin) * (shift + parts.second.moving * turn - pin)).imag();
}

bool changes_side(const GuidedParts& parts, const Point& along, std::span<const Displacement> displacements) {
    const bool first = side_at(parts, along, displacements.front()) > 0;
    return std::any_of(displacements.begin(), displacements.end(),
                       [&](const Displacement& at) { return (side_at(parts, along, at) > 0) != first; });
}

GuidedParts in_drawing(const GuidedParts& parts, const DrawingPlace& place) {
    GuidedParts drawn = parts;
    for (Point* pin : {&drawn.crank.fixed, &drawn.crank.moving})
        *pin = place.origin + place.size * *pin;
    if (parts.kind != SecondDyad::ram) drawn.second.fixed = place.origin + place.size * parts.second.fixed;
    if (parts.kind != SecondDyad::block) drawn.second.moving = place.origin + place.size * parts.second.moving;
    return drawn;
}

/// How far dimensions are outside of their ranges, relative to these.
double beyond_ranges(const Problem& problem, const std::vector<double>& dimensions) {
    double worst = 0;
    for (std::size_t i = 0; i < dimensions.size(); ++i) {
        const DimensionRange& range = problem.dimensions[i];
        const double size = std::max({std::abs(range.min), std::abs(range.max), 1e-300});
        worst = std::max({worst, (range.min - dimensions[i]) / size, (dimensions[i] - range.max) / size});
    }
    return worst;
}

/// A design whose drive is not its crank: its own motion says where it meets the places. What lies outside of its
/// ranges is not moved at all.
ExactDesign met_by_motion(const Problem& problem, Design design) {
    constexpr double rounding = 1e-9;
    move_angles_into_ranges(problem, design);
    if (const double beyond = beyond_ranges(problem, design.dimensions); beyond > rounding) {
        ExactDesign out = excluded_design(std::move(design), "range: a dimension is outside its range");
        out.solution.violation = beyond;
        return out;
    }
    std::optional<ExactDesign> best;
    for (const std::size_t assembly : problem.assemblies) {
        Design one = design;
        one.assembly = assembly;
        for (std::vector<double>& inputs : inputs_in_order(problem, one)) {
            one.path_angles = std::move(inputs);
            keep_better(problem, best, exact_design(problem, one));
        }
    }
    return best ? *std::move(best)
                : excluded_design(std::move(design),
                                  "order: in no assembly its drive takes it through the targets in their order");
}

/// The design of one reading, in the best assembly.
ExactDesign design_of(const Problem& problem, const GuidedChains& chains, const ChainReading& reading,
                      const GuidedParts& parts, std::span<const Displacement> displacements) {
    Design design;
    for (const DimensionRange& range : problem.dimensions)
        design.dimensions.push_back(range.min);
    const bool agree = solve_rows(*problem.mechanism, problem.dimensions, reading.rows, design.dimensions);
    const auto& directions = problem.path->directions;
    const auto first = std::find_if(directions.begin(), directions.end(), [](double a) { return !std::isnan(a); });
    if (first != directions.end())
        design.dimensions[problem.mechanism->point->roles.body] = *first - std::arg(reading.body);
    design.assembly = problem.assemblies.front();
    // Seen from another drive the body may pass a toggle of its rockers.
    if (chains.by_crank && changes_side(parts, reading.along, displacements))
        return excluded_design(std::move(design), "branch: it has to be taken apart between the targets");
    if (!agree) return excluded_design(std::move(design), "range: what is given of its links does not allow it");
    if (!chains.by_crank) return met_by_motion(problem, std::move(design));
    const std::vector<double> angles = crank_angles(reading, parts.crank, displacements);
    std::optional<ExactDesign> best;
    for (const std::size_t assembly : problem.assemblies) {
        Design one = design;
        one.assembly = assembly;
        keep_better(problem, best, exact_design(problem, std::move(one), angles));
    }
    return *std::move(best);
}

}  // namespace

std::string why_no_chain_design(const Problem& problem, const GuidedChains& chains) {
    const LinkageModel& model = model_of(problem);
    if (!model.scale.terms.empty()) return "the scale of the linkage is to be found: give it";
    const LinkageDrive& drive = model.drives.front();
    if (drive.ratio != 1 || drive.phase != 0 || drive.motion) return "its drive has a motion of its own";
    const auto readings = readings_of(problem, chains, some_parts(chains.second), {1.1, 2.3});
    if (readings.empty())
        return "it needs links whose frames show in their points: one pin at given coordinates, like [0, 0], and "
               "another beside or above it, like [\"length\", 0]; a slide or slot at a given angle";
    const std::vector<ChainRow>& rows = readings.front().rows;
    // What a drive beside the chains is made of can be searched where poses say all of these.
    const bool searched = !chains.by_crank && chains.second == SecondDyad::rocker && problem.path &&
                          problem.path->poses() == problem.path->points.size();
    const auto beside = dimensions_unsaid(*problem.mechanism, problem.dimensions, rows);
    if (!beside.empty() && !searched)
        return fmt::format(
            "'{}' does not say where the guided body hangs, on {} and one more link, slide or slot: give it",
            problem.mechanism->dimensions[beside.front()].name, chains.by_crank ? "the crank" : "a rocker");
    std::vector<DimensionRange> ranges = problem.dimensions;
    for (const std::size_t i : beside)
        ranges[i].max = ranges[i].min;
    if (undetermined_lengths(*problem.mechanism, ranges, rows) > 0)
        return "the places of the links' pins leave some of the dimensions open: give one of those that stand together";
    return {};
}

std::vector<std::size_t> dimensions_beside_chains(const Problem& problem, const GuidedChains& chains) {
    const auto readings = readings_of(problem, chains, some_parts(chains.second), {1.1, 2.3});
    if (readings.empty()) return {};
    return dimensions_unsaid(*problem.mechanism, problem.dimensions, readings.front().rows);
}

std::string why_no_chain_family(const Problem& problem, const GuidedChains& chains, std::size_t dimensions) {
    const std::size_t open = open_dimensions(*problem.mechanism, problem.dimensions).size() -
                             dimensions_beside_chains(problem, chains).size();
    if (open == dimensions) return {};
    return fmt::format(
        "a family of linkages passes so few places, and the file leaves {} of the {} numbers open that say where its "
        "guided link hangs and where its point is: give all of them ranges, those of the frame or its placement too, "
        "or "
        "use another method",
        open, dimensions);
}

ExactDesign chain_design(const Problem& problem, const GuidedChains& chains, const GuidedParts& parts,
                         std::span<const Displacement> displacements, const DrawingPlace& place) {
    std::optional<ExactDesign> best;
    for (const ChainReading& reading : readings_of(problem, chains, in_drawing(parts, place), place.origin))
        keep_better(problem, best, design_of(problem, chains, reading, parts, displacements));
    if (best) return *std::move(best);
    Design none;
    for (const DimensionRange& range : problem.dimensions)
        none.dimensions.push_back(range.min);
    return excluded_design(std::move(none), "degenerate: two of its pins coincide");
}

}  // namespace mechwright

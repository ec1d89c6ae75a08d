#include "synthesis/exact/chains/chain_design.h"

#include <fmt/format.h>

#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "synthesis/exact/chains/chain_rows.h"

namespace mechwright {

namespace {

using Point = std::complex<double>;
using homotopy::SecondDyad;

const LinkageModel& model_of(const Problem& problem) { return *problem.mechanism->model.as<LinkageModel>(); }

/// Dimensions that the rows are to say: what is to be found but for numbers of the target itself.
std::vector<std::size_t> open_dimensions(const Problem& problem) {
    const PathRoles& roles = problem.mechanism->point->roles;
    std::vector<std::size_t> open;
    for (std::size_t i = 0; i < problem.dimensions.size(); ++i)
        if (!problem.dimensions[i].fixed() && i != roles.start && i != roles.body) open.push_back(i);
    return open;
}

bool is_angle(const Problem& problem, std::size_t dimension) {
    return problem.mechanism->dimensions[dimension].kind == DimensionKind::angle;
}

/// The least difference of two angles.
double apart(double a, double b) { return std::abs(std::remainder(a - b, 2 * std::numbers::pi)); }

/// The dimensions that the rows of lengths are about, and these as equations.
struct LengthEquations {
    std::vector<std::size_t> dimensions;
    Eigen::MatrixXd factors;
    Eigen::VectorXd values;
};

LengthEquations length_equations(const Problem& problem, const std::vector<ChainRow>& rows) {
    LengthEquations e;
    for (const std::size_t i : open_dimensions(problem))
        if (!is_angle(problem, i)) e.dimensions.push_back(i);
    const auto count = std::count_if(rows.begin(), rows.end(), [](const ChainRow& row) { return !row.angle; });
    e.factors = Eigen::MatrixXd::Zero(count, static_cast<Eigen::Index>(e.dimensions.size()));
    e.values = Eigen::VectorXd::Zero(count);
    Eigen::Index k = 0;
    for (const ChainRow& row : rows) {
        if (row.angle) continue;
        e.values[k] = row.value - row.number.constant;
        for (const auto& [dimension, factor] : row.number.terms) {
            const auto at = std::find(e.dimensions.begin(), e.dimensions.end(), dimension);
            if (at == e.dimensions.end())
                e.values[k] -= factor * problem.dimensions[dimension].min;
            else
                e.factors(k, at - e.dimensions.begin()) = factor;
        }
        ++k;
    }
    return e;
}

/// Whether a number is one dimension, or less one, and a constant.
bool is_turn_of_one(const Affine& number) {
    return number.terms.size() == 1 && std::abs(number.terms.front().second) == 1;
}

/// The dimensions that the rows say, into those of a design; whether given ones agree.
bool solve_rows(const Problem& problem, const std::vector<ChainRow>& rows, std::vector<double>& dimensions) {
    constexpr double agree_within = 1e-9;
    const LengthEquations e = length_equations(problem, rows);
    bool agree = true;
    double size = 0;
    for (const ChainRow& row : rows)
        if (!row.angle) size = std::max(size, std::abs(row.value));
    if (!e.dimensions.empty()) {
        const Eigen::VectorXd found = e.factors.colPivHouseholderQr().solve(e.values);
        for (std::size_t i = 0; i < e.dimensions.size(); ++i)
            dimensions[e.dimensions[i]] = found[static_cast<Eigen::Index>(i)];
        agree = (e.factors * found - e.values).cwiseAbs().maxCoeff() <= agree_within * size;
    } else {
        agree = e.values.size() == 0 || e.values.cwiseAbs().maxCoeff() <= agree_within * size;
    }
    for (const ChainRow& row : rows)
        if (row.angle && is_turn_of_one(row.number) && !problem.dimensions[row.number.terms.front().first].fixed())
            dimensions[row.number.terms.front().first] =
                (row.value - row.number.constant) * row.number.terms.front().second;
    for (const ChainRow& row : rows)
        if (row.angle && apart(row.number.at(std::span<const double>(dimensions)), row.value) > agree_within)
            agree = false;
    return agree;
}

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

/// The design of one reading, in the best assembly.
ExactDesign design_of(const Problem& problem, const ChainReading& reading, const GuidedParts& parts,
                      std::span<const Displacement> displacements) {
    Design design;
    for (const DimensionRange& range : problem.dimensions)
        design.dimensions.push_back(range.min);
    const bool agree = solve_rows(problem, reading.rows, design.dimensions);
    const auto& directions = problem.path->directions;
    const auto first = std::find_if(directions.begin(), directions.end(), [](double a) { return !std::isnan(a); });
    if (first != directions.end())
        design.dimensions[problem.mechanism->point->roles.body] = *first - std::arg(reading.body);
    design.assembly = problem.assemblies.front();
    if (changes_side(parts, reading.along, displacements))
        return excluded_design(std::move(design), "branch: it has to be taken apart between the targets");
    if (!agree) return excluded_design(std::move(design), "range: what is given of its links does not allow it");
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
    const auto is_said = [&](std::size_t dimension, bool angle) {
        return std::any_of(rows.begin(), rows.end(), [&](const ChainRow& row) {
            return row.angle == angle && (!angle || is_turn_of_one(row.number)) &&
                   std::any_of(row.number.terms.begin(), row.number.terms.end(),
                               [&](const auto& term) { return term.first == dimension; });
        });
    };
    for (const std::size_t i : open_dimensions(problem))
        if (!is_said(i, is_angle(problem, i)))
            return fmt::format(
                "'{}' does not say where the guided body hangs, on the crank and one more link, slide or slot: give it",
                problem.mechanism->dimensions[i].name);
    const LengthEquations e = length_equations(problem, rows);
    if (!e.dimensions.empty() && e.factors.colPivHouseholderQr().rank() < e.factors.cols())
        return "the places of the links' pins leave some of the dimensions open: give one of those that stand together";
    return {};
}

std::string why_no_chain_family(const Problem& problem, std::size_t dimensions) {
    const std::size_t open = open_dimensions(problem).size();
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
        keep_better(problem, best, design_of(problem, reading, parts, displacements));
    if (best) return *std::move(best);
    Design none;
    for (const DimensionRange& range : problem.dimensions)
        none.dimensions.push_back(range.min);
    return excluded_design(std::move(none), "degenerate: two of its pins coincide");
}

}  // namespace mechwright

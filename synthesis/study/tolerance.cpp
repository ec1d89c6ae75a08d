#include "synthesis/study/tolerance.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <boost/math/special_functions/erf.hpp>
#include <cmath>
#include <memory>
#include <numbers>

#include "analysis/numbers/low_discrepancy.h"
#include "synthesis/mechanism/cycle.h"
#include "synthesis/problem/allowed_values.h"
#include "synthesis/problem/schema/keys.h"
#include "synthesis/problem/units.h"
#include "synthesis/program/assess.h"
#include "synthesis/program/quantity_value.h"
#include "synthesis/report/csv/csv_text.h"
#include "synthesis/solve/solve.h"
#include "synthesis/study/allocation.h"
#include "synthesis/study/iso_tolerances.h"
#include "synthesis/target/path/rows/nearest_point.h"

namespace mechwright {

namespace {

/// A zone of tolerance is so many standard deviations wide.
constexpr double deviations_in_zone = 6;

/// The width of the zone in which a dimension lies, or the pin of a hole.
double zone_of(const Deviation& deviation, double size) {
    return size * (deviation.uniform || deviation.joint ? 2 : deviations_in_zone);
}

/// The deviations of pieces, one for each of the study: from the numbers of sample and dimension, or joint, alone.
Off random_deviation(const Deviation& deviation, double size, std::uint64_t seed, std::uint64_t number) {
    const std::uint64_t which = deviation.joint ? ~static_cast<std::uint64_t>(*deviation.joint) : deviation.dimension;
    const std::uint64_t bits = mixed(mixed(mixed(seed) ^ which) ^ number);
    const double part = std::ldexp(static_cast<double>(bits >> 11) + 0.5, -53);
    if (deviation.joint) {
        const double direction = 2 * std::numbers::pi * part;
        return {size * std::cos(direction), size * std::sin(direction)};
    }
    if (deviation.uniform) return {size * (2 * part - 1), 0};
    return {-size * std::numbers::sqrt2 * boost::math::erfc_inv(2 * part), 0};
}

/// The mechanism of a piece whose holes are off, each by so much.
std::shared_ptr<const Mechanism> with_holes_off(const TolerancedDesign& design, const Study& study,
                                                const std::vector<Off>& offs) {
    const std::shared_ptr<const Mechanism>& nominal = design.problem.mechanism;
    if (!nominal->pin_joints) return nominal;
    std::vector<Vector<double>> by(nominal->pin_joints->names.size(), {0, 0});
    bool any = false;
    for (std::size_t i = 0; i < offs.size(); ++i)
        if (const auto& joint = study.deviations[i].joint) {
            by[*joint] = offs[i];
            any = any || offs[i].x != 0 || offs[i].y != 0;
        }
    if (!any) return nominal;
    auto made = std::make_shared<Mechanism>(*nominal);
    made->model = nominal->pin_joints->moved(nominal->model, design.nominal.design.dimensions, by);
    return made;
}

/// The value of a quantity for a piece that is off by one deviation alone.
std::optional<double> value_off(const TolerancedDesign& design, const Study& study, std::size_t quantity,
                                std::size_t deviation, const Off& off) {
    std::vector<Off> offs(study.deviations.size(), Off{0, 0});
    offs[deviation] = off;
    const Piece piece = piece_of(design, study, offs);
    return quantity_value(piece.problem, quantity, piece.solution.design);
}

/// By how much a quantity changes with a small part of a deviation, in each of the two directions of a pin; nothing
/// where a piece beside the design has no such value.
std::optional<double> change_by_difference(const TolerancedDesign& design, const Study& study, std::size_t quantity,
                                           std::size_t deviation) {
    constexpr double part = 1e-3;
    const double step = part * design.sizes[deviation];
    Vector<double> slope{0, 0};
    const std::array<Vector<double>, 2> directions{{{1, 0}, {0, 1}}};
    for (std::size_t k = 0; k < (study.deviations[deviation].joint ? 2u : 1u); ++k) {
        const auto more = value_off(design, study, quantity, deviation, step * directions[k]);
        const auto less = value_off(design, study, quantity, deviation, -step * directions[k]);
        if (!more || !less) return {};
        slope = slope + ((*more - *less) / (2 * step)) * directions[k];
    }
    return study.deviations[deviation].joint ? std::hypot(slope.x, slope.y) : slope.x;
}

/// The derivatives of the distances from a path's points: at a fixed crank angle, or at the nearest point, which comes
/// to the same; where the angle is prescribed, it moves with that of the start.
std::optional<std::vector<double>> path_sensitivities(const Problem& problem, const Quantity& quantity,
                                                      const Design& design) {
    const Mechanism& mechanism = *problem.mechanism;
    const std::optional<PathValues> values = path_values(problem, design);
    if (!values || problem.path->guides_body()) return {};
    const Reads& reads = mechanism.point->reads;
    const std::size_t n = reads.size();
    std::vector<double> x(n + 1), y(n + 1), total(mechanism.dimensions.size(), 0.0);
    const PathTarget& path = *problem.path;
    const bool all = quantity.of_target == every_target;
    const PathMeans& means = all ? *values : values->of_targets[quantity.of_target];
    const PointRange points = path.points_of(quantity.of_target);
    const auto weight_at = [&](std::size_t i) {
        return all ? path.weights[i] : path.parts[quantity.of_target].weights[i - points.first];
    };
    double weights = 0;
    for (std::size_t i = points.first; i < points.end(); ++i)
        weights += weight_at(i);
    for (std::size_t i = points.first; i < points.end(); ++i) {
        const double distance = values->distances[i];
        double factor = 2 * weight_at(i);
        if (quantity.path == PathMeasure::root_mean_square) factor /= 2 * weights * means.root_mean_square;
        if (quantity.path == PathMeasure::greatest) factor = distance == means.greatest ? 1 / distance : 0;
        if (factor == 0) continue;
        PathMiss miss{{}, 0, x, y, {}, {}};
        miss_of_point(mechanism, mechanism.form(design.assembly, path.target_of(i)), design.dimensions,
                      design.path_angles[i], path.points[i], miss);
        for (std::size_t k = 0; k < n; ++k)
            total[reads[k]] += factor * (miss.miss.x * x[k] + miss.miss.y * y[k]);
        if (path.prescribed_timing)
            total[mechanism.roles_of(path.target_of(i)).start] += factor * (miss.miss.x * x[n] + miss.miss.y * y[n]);
    }
    return total;
}

/// Crank angles less or more whole cycles, where there are such, each within half a cycle of the one beside it: a range
/// of use is between them.
void count_on(const std::vector<double>& beside, double cycle, std::vector<double>& angles) {
    for (std::size_t i = 0; i < angles.size() && std::isfinite(cycle); ++i)
        angles[i] -= cycle * std::round((angles[i] - beside[i]) / cycle);
}

}  // namespace

std::optional<TolerancedDesign> toleranced_design(const PreparedStudy& prepared, const StudyRunOptions& options,
                                                  std::string& why) {
    TolerancedDesign design{prepared.base, {}, {}};
    RunOptions run;
    run.jobs = options.jobs;
    run.stop = options.stop;
    const Result result = solve(design.problem, run);
    const bool given = result.search.method == "given";
    if (!result.best || (!given && result.status != Status::solved)) {
        why = "the design whose tolerances are asked for was not found; 'mechwright solve' says more";
        return {};
    }
    design.nominal = *result.best;
    for (const Deviation& deviation : prepared.study->deviations) {
        if (deviation.grade == 0 && deviation.general == 0) {
            design.sizes.push_back(deviation.size);
            continue;
        }
        const Dimension& dimension = design.problem.mechanism->dimensions[deviation.dimension];
        const double size = design.nominal.design.dimensions[deviation.dimension];
        const auto zone =
            deviation.grade > 0 ? iso_tolerance(deviation.grade, size) : general_tolerance(deviation.general, size);
        if (!zone) {
            why = fmt::format(
                "'{}' is {} mm, for which {} has no tolerance: write {{ normal = ... }} or {{ uniform = "
                "... }} for it",
                dimension.name, size,
                deviation.grade > 0 ? "ISO 286 (up to 3150 mm)" : "this class of ISO 2768 (0.5 to 4000 mm)");
            return {};
        }
        design.sizes.push_back(*zone / (deviation.uniform ? 2 : deviations_in_zone));
    }
    if (prepared.study->allocation && !allocate_tolerances(*prepared.study, options, design, why)) return {};
    return design;
}

double standard_deviation(const Deviation& deviation, double size) {
    if (deviation.joint) return size / std::numbers::sqrt2;
    return deviation.uniform ? size / std::numbers::sqrt3 : size;
}

Piece sample(const TolerancedDesign& design, const Study& study, std::uint64_t number) {
    std::vector<Off> offs;
    offs.reserve(study.deviations.size());
    for (std::size_t i = 0; i < study.deviations.size(); ++i)
        offs.push_back(random_deviation(study.deviations[i], design.sizes[i], study.seed, number));
    return piece_of(design, study, offs);
}

Piece piece_of(const TolerancedDesign& design, const Study& study, const std::vector<Off>& offs) {
    Design piece = design.nominal.design;
    for (std::size_t i = 0; i < study.deviations.size(); ++i)
        if (!study.deviations[i].joint) piece.dimensions[study.deviations[i].dimension] += offs[i].x;
    Problem as_made = design.problem;
    as_made.text.clear();  // it asks for other dimensions
    as_made.mechanism = with_holes_off(design, study, offs);
    const std::optional<PathTarget>& path = as_made.path;
    if (path && path->prescribed_timing)
        set_prescribed_angles(as_made, piece);
    else if (path)
        meet_nearest_points(as_made, piece);
    if (as_made.use) count_on(design.nominal.design.path_angles, cycle_of(*as_made.mechanism), piece.path_angles);
    // The ranges of the dimensions are for design, not for pieces.
    for (std::size_t i = 0; i < piece.dimensions.size(); ++i)
        as_made.dimensions[i] = allowed_between(as_made.dimensions[i], piece.dimensions[i], piece.dimensions[i]);
    Solution solution = assess(as_made, std::move(piece));
    return {std::move(as_made), std::move(solution)};
}

std::optional<std::vector<double>> sensitivities(const Problem& problem, std::size_t quantity, const Design& design) {
    const Quantity& q = problem.mechanism->quantities[quantity];
    if (!quantity_value(problem, quantity, design)) return {};
    if (q.path != PathMeasure::none) return path_sensitivities(problem, q, design);
    // How the ends of a range of use move with the dimensions is not known here.
    if (problem.use && q.of_motion && !q.whole) return {};
    const Motion motion = motion_of(problem, q, design);
    const std::size_t count = count_components(q, motion);
    std::vector<double> values(count), gradient(count * q.reads.size());
    measure(q, motion, design.dimensions, {values, gradient, {}});
    std::size_t at = 0;
    if (q.reduce == Reduce::least)
        at = static_cast<std::size_t>(std::min_element(values.begin(), values.end()) - values.begin());
    if (q.reduce == Reduce::greatest)
        at = static_cast<std::size_t>(std::max_element(values.begin(), values.end()) - values.begin());
    std::vector<double> all(problem.mechanism->dimensions.size(), 0.0);
    for (std::size_t i = 0; i < q.reads.size(); ++i)
        all[q.reads[i]] = gradient[at * q.reads.size() + i];
    const bool finite = std::all_of(all.begin(), all.end(), [](double d) { return std::isfinite(d); });
    return finite ? std::optional(all) : std::nullopt;
}

std::optional<std::vector<double>> changes_of(const TolerancedDesign& design, const Study& study,
                                              std::size_t quantity) {
    const auto gradient = sensitivities(design.problem, quantity, design.nominal.design);
    std::vector<double> changes;
    for (std::size_t i = 0; i < study.deviations.size(); ++i) {
        const Deviation& deviation = study.deviations[i];
        const auto change = gradient && !deviation.joint ? std::optional((*gradient)[deviation.dimension])
                                                         : change_by_difference(design, study, quantity, i);
        if (!change) return {};
        changes.push_back(*change);
    }
    return changes;
}

namespace {

/// The unit in which a deviation is given.
Unit unit_of_size(const Deviation& deviation, const Mechanism& mechanism) {
    return deviation.joint ? Unit::length : unit_of(mechanism.dimensions[deviation.dimension].kind);
}

void predict(const TolerancedDesign& design, const Study& study, std::size_t quantity, QuantitySpread& spread) {
    const auto changes = changes_of(design, study, quantity);
    if (!changes) return;
    const Mechanism& mechanism = *design.problem.mechanism;
    const double factor = file_units_per_inner(mechanism.quantities[quantity].unit, design.problem.units);
    double variance = 0;
    for (std::size_t i = 0; i < study.deviations.size(); ++i) {
        const Deviation& deviation = study.deviations[i];
        const double derivative = (*changes)[i] * factor;
        const double effect = derivative * standard_deviation(deviation, design.sizes[i]);
        const Unit unit = unit_of_size(deviation, mechanism);
        spread.derivatives.push_back(derivative / file_units_per_inner(unit, design.problem.units));
        spread.parts.push_back(effect * effect);
        variance += effect * effect;
        spread.worst += std::abs(derivative) * zone_of(deviation, design.sizes[i]) / 2;
    }
    for (double& part : spread.parts)
        part = variance > 0 ? part / variance : 0;
    spread.first_order = std::sqrt(variance);
}

/// The number of the sorted values of a column below which a part of them lies.
double quantile(SQLite::Database& data, const std::string& column, std::int64_t count, double part) {
    const auto skipped = static_cast<std::int64_t>(std::llround(part * static_cast<double>(count - 1)));
    return data
        .execAndGet("SELECT " + column + " FROM points WHERE " + column + " IS NOT NULL ORDER BY " + column +
                    " LIMIT 1 OFFSET " + std::to_string(skipped))
        .getDouble();
}

void measure_samples(SQLite::Database& data, QuantitySpread& spread) {
    const std::string column = sql_name(spread.quantity);
    const std::string from = " FROM points WHERE " + column + " IS NOT NULL";
    const std::int64_t count = data.execAndGet("SELECT count(*)" + from).getInt64();
    if (count == 0) return;
    spread.mean = data.execAndGet("SELECT avg(" + column + ")" + from).getDouble();
    SQLite::Statement squares(data, "SELECT total((" + column + " - ?1) * (" + column + " - ?1))" + from);
    squares.bind(1, spread.mean);
    squares.executeStep();
    const double sum = squares.getColumn(0).getDouble();
    spread.deviation = count > 1 ? std::sqrt(sum / static_cast<double>(count - 1)) : 0;
    spread.least = quantile(data, column, count, 0);
    spread.low = quantile(data, column, count, 0.025);
    spread.high = quantile(data, column, count, 0.975);
    spread.greatest = quantile(data, column, count, 1);
}

/// SQL that is true for samples that meet every limit; empty without limits. Equalities no piece ever meets.
std::string limits_of(const Problem& problem) {
    std::string condition;
    for (const Requirement& requirement : problem.requirements) {
        const Quantity& quantity = problem.mechanism->quantities[requirement.quantity];
        const auto add = [&](const std::optional<double>& limit, const char* relation) {
            if (!limit) return;
            if (!condition.empty()) condition += " AND ";
            condition +=
                sql_name(quantity.name) + relation + csv_number(in_file_unit(*limit, quantity.unit, problem.units));
        };
        add(requirement.min, " >= ");
        add(requirement.max, " <= ");
    }
    return condition;
}

/// The coarsest grade of ISO 286 whose zone is no wider than that of a deviation; 0 where there is none.
int grade_of(const TolerancedDesign& design, const Deviation& deviation, double size) {
    const Problem& problem = design.problem;
    if (deviation.joint || problem.units.length != "mm" ||
        problem.mechanism->dimensions[deviation.dimension].kind != DimensionKind::length)
        return 0;
    const double zone = zone_of(deviation, size);
    const double length = std::abs(design.nominal.design.dimensions[deviation.dimension]);
    constexpr double same = 1e-9;  // a zone that is a grade's is that grade's
    int coarsest = 0;
    for (int grade = keys::least_grade; grade <= keys::greatest_grade; ++grade)
        if (const auto width = iso_tolerance(grade, length); width && *width <= zone * (1 + same)) coarsest = grade;
    return coarsest;
}

}  // namespace

ToleranceReport tolerance_report(const PreparedStudy& prepared, const TolerancedDesign& design,
                                 const std::filesystem::path& data) {
    const Problem& problem = design.problem;
    const Study& study = *prepared.study;
    ToleranceReport report;
    for (std::size_t i = 0; i < study.deviations.size(); ++i) {
        const Deviation& deviation = study.deviations[i];
        const double factor = file_units_per_inner(unit_of_size(deviation, *problem.mechanism), problem.units);
        report.dimensions.push_back(name_of_deviation(deviation, *problem.mechanism));
        report.standard_deviations.push_back(standard_deviation(deviation, design.sizes[i]) * factor);
        report.sizes.push_back(design.sizes[i] * factor);
        report.uniform.push_back(deviation.uniform);
        report.clearances.push_back(deviation.joint.has_value());
        report.grades.push_back(grade_of(design, deviation, design.sizes[i]));
    }
    report.allocated = design.allocated;
    if (study.allocation) report.wanted_share = study.allocation->share;
    SQLite::Database database(data.string(), SQLite::OPEN_READONLY);
    const auto counted = [&database](const std::string& where) {
        return static_cast<std::uint64_t>(database.execAndGet("SELECT count(*) FROM points" + where).getInt64());
    };
    report.samples = counted("");
    report.assembled = counted(" WHERE status = 'evaluated'");
    const std::string limits = limits_of(problem);
    report.has_limits = !limits.empty();
    if (report.has_limits) report.within_limits = counted(" WHERE " + limits);
    for (const std::string& name : prepared.columns.quantities) {
        const auto index = static_cast<std::size_t>(find_quantity(*problem.mechanism, name));
        const std::optional<double> nominal = quantity_value(problem, index, design.nominal.design);
        if (!nominal) continue;
        const Unit unit = problem.mechanism->quantities[index].unit;
        QuantitySpread spread;
        spread.quantity = name;
        spread.unit = unit_label(unit, problem.units);
        spread.nominal = in_file_unit(*nominal, unit, problem.units);
        predict(design, study, index, spread);
        measure_samples(database, spread);
        report.quantities.push_back(std::move(spread));
    }
    return report;
}

}  // namespace mechwright

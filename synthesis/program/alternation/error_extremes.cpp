#include "synthesis/program/alternation/error_extremes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "synthesis/mechanism/input.h"
#include "synthesis/problem/units.h"
#include "synthesis/program/alternation/free_columns.h"
#include "synthesis/program/quantity_value.h"

namespace mechwright {

namespace {

constexpr std::size_t most_extremes = 40;
/// Extremes this close to the greatest are as great as it.
constexpr double as_great_within = 1e-6;

/// What an error is off by rounding: a few units of the last place of what it is the difference of.
double rounding_of_error(const Problem& problem, const InputTask& task, const Design& design) {
    constexpr double units = 8;
    double size = 1;
    if (task.unit() == Unit::length) {
        size = 0;
        for (std::size_t i = 0; i < design.dimensions.size(); ++i)
            if (problem.mechanism->dimensions[i].kind == DimensionKind::length)
                size = std::max(size, std::abs(design.dimensions[i]));
    }
    return units * std::numeric_limits<double>::epsilon() * size;
}

/// How many of the dimensions left open the error depends on independently: the size of a linkage does not count where
/// only angles matter.
int free_dimensions(const Problem& problem, const InputTask& task, const Design& design) {
    const Quantity& q = *task.deviation;
    const Motion motion = motion_of(problem, design);
    const std::size_t count = count_components(q, motion);
    std::vector<double> value(count), gradient(count * q.reads.size());
    measure(q, motion, design.dimensions, {value, gradient, {}});
    const auto slopes = Eigen::Map<const Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>>(
        gradient.data(), static_cast<Eigen::Index>(count), static_cast<Eigen::Index>(q.reads.size()));
    return slopes.allFinite() ? independent_columns(by_free_dimensions(problem, q.reads, slopes)) : 0;
}

}  // namespace

bool asks_for_least_error(const Problem& problem, const InputTask& task) {
    if (!problem.objective || problem.objective->terms.size() != 1 || !problem.requirements.empty()) return false;
    const ObjectiveTerm& term = problem.objective->terms.front();
    return !term.maximize && &problem.mechanism->quantities[term.quantity] == task.deviation;
}

std::vector<ErrorExtreme> every_extreme(const Problem& problem, const InputTask& task, const Design& design) {
    const Form form = task.form(*problem.mechanism, design.assembly);
    std::array<double, Reads::most> room;
    const auto arguments = task.deviation->reads.of(design.dimensions, room);
    return task.is_function() ? task.generation->extremes(*task.asked.function, form, arguments)
                              : task.shape->extremes(form, arguments);
}

ErrorExtremes error_extremes_of(const Problem& problem, const InputTask& task, const Design& design) {
    ErrorExtremes e;
    e.all = every_extreme(problem, task, design);
    double greatest = 0;
    for (const auto& extreme : e.all)
        greatest = std::max(greatest, std::abs(extreme.error));
    const double as_great_from = (1 - as_great_within) * greatest - rounding_of_error(problem, task, design);
    double last = 0;
    for (const auto& extreme : e.all) {
        if (std::abs(extreme.error) < as_great_from || last * extreme.error > 0) continue;
        last = extreme.error;
        ++e.alternating;
    }
    e.free = free_dimensions(problem, task, design);
    if (e.all.size() > most_extremes) e.all.resize(most_extremes);
    return e;
}

double place_of(const Problem& problem, const InputTask& task, const Design& design, double share) {
    if (const FunctionTarget* f = task.asked.function.get()) return f->from + share * (f->to - f->from);
    return in_file_unit(design.dimensions[task.start] + share * design.dimensions[task.start + 1],
                        input_unit(*problem.mechanism), problem.units);
}

}  // namespace mechwright

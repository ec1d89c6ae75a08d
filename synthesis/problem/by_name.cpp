#include "synthesis/problem/by_name.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "synthesis/problem/allowed_values.h"
#include "synthesis/problem/text.h"

namespace mechwright {

namespace {

template <class... Parts>
[[noreturn]] void refuse_with(fmt::format_string<Parts...> text, Parts&&... parts) {
    throw std::invalid_argument(fmt::format(text, std::forward<Parts>(parts)...));
}

/// The index of a name among named things; refused where there is none.
template <class Named>
std::size_t named_index(const Problem& problem, std::string_view kind, std::string_view name,
                        const std::vector<Named>& all) {
    std::vector<std::string_view> names;
    for (std::size_t i = 0; i < all.size(); ++i) {
        if (all[i].name == name) return i;
        names.push_back(all[i].name);
    }
    refuse_with("a {} has no {} '{}'; {}", problem.mechanism->name, kind, name, reading::remedy(name, names));
}

DimensionRange& named_range(Problem& problem, std::string_view dimension) {
    return problem.dimensions[named_index(problem, "dimension", dimension, problem.mechanism->dimensions)];
}

std::size_t named_quantity(const Problem& problem, std::string_view quantity) {
    return named_index(problem, "quantity", quantity, problem.mechanism->quantities);
}

void refuse_infinite(std::string_view name, double number) {
    if (!std::isfinite(number)) refuse_with("{} is {}: give a finite number", name, number);
}

void add_term(Problem& problem, std::string_view quantity, bool maximized, double weight) {
    if (!(weight > 0) || !std::isfinite(weight))
        refuse_with("the weight of {} is {}: it must be > 0", quantity, weight);
    if (!problem.objective) problem.objective.emplace();
    problem.objective->terms.push_back({named_quantity(problem, quantity), maximized, weight});
}

void add_wish(Problem& problem, std::string_view quantity, bool maximized, double within) {
    if (!(within >= 0) || !std::isfinite(within))
        refuse_with("{} is wished for within {}: it must be 0 or greater", quantity, within);
    problem.wishes.push_back({{named_quantity(problem, quantity), maximized, 1}, within});
}

}  // namespace

Problem problem_of(std::string_view mechanism) {
    Problem problem;
    problem.mechanism = find_mechanism(mechanism);
    if (!problem.mechanism) {
        std::vector<std::string_view> names;
        const auto all = mechanisms();
        for (const auto& known : all)
            if (names.empty() || names.back() != known->name) names.push_back(known->name);
        refuse_with("there is no mechanism '{}'; {}", mechanism, reading::remedy(mechanism, names));
    }
    problem.dimensions.resize(problem.mechanism->dimensions.size());
    problem.assemblies = {0};
    for (std::size_t i = 0; i < problem.mechanism->settings.size(); ++i)
        problem.settings[i] = problem.mechanism->settings[i].preset;
    return problem;
}

void fix(Problem& problem, std::string_view dimension, double value) {
    refuse_infinite(dimension, value);
    named_range(problem, dimension) = {value, value, {}, true};
}

void design_within(Problem& problem, std::string_view dimension, double min, double max, std::optional<double> start) {
    refuse_infinite(dimension, min);
    refuse_infinite(dimension, max);
    if (!(min < max)) refuse_with("{} is to lie between {} and {}: the first must be less", dimension, min, max);
    if (start && !(*start >= min && *start <= max))
        refuse_with("{} is to start at {}, outside its range from {} to {}", dimension, *start, min, max);
    named_range(problem, dimension) = {min, max, start, true};
}

void choose_among(Problem& problem, std::string_view dimension, std::vector<double> choices) {
    if (choices.empty()) refuse_with("{} has no choices", dimension);
    if (choices.size() > most_choices) refuse_with("{} has more than {} choices", dimension, most_choices);
    for (const double choice : choices)
        refuse_infinite(dimension, choice);
    std::sort(choices.begin(), choices.end());
    if (std::adjacent_find(choices.begin(), choices.end()) != choices.end())
        refuse_with("{} has the same choice twice", dimension);
    if (choices.size() == 1) return fix(problem, dimension, choices.front());
    DimensionRange& range = named_range(problem, dimension) = {choices.front(), choices.back(), {}, true};
    range.choices = std::move(choices);
}

void design_in_steps(Problem& problem, std::string_view dimension, double min, double max, double step) {
    refuse_infinite(dimension, step);
    design_within(problem, dimension, min, max);
    DimensionRange& range = named_range(problem, dimension);
    if (!end_with_step(range, step))
        refuse_with("the steps of {} are {}: they must be > 0, and one at least but not more than {} in its range",
                    dimension, step, most_steps);
}

void assemble(Problem& problem, std::string_view assembly) {
    const auto& known = problem.mechanism->assemblies;
    problem.assemblies.clear();
    for (std::size_t i = 0; i < known.size(); ++i)
        if (assembly == "either" || assembly == known[i]) problem.assemblies.push_back(i);
    if (problem.assemblies.empty()) refuse_with("a {} has no assembly '{}'", problem.mechanism->name, assembly);
}

void require_equal(Problem& problem, std::string_view quantity, double value) {
    refuse_infinite(quantity, value);
    problem.requirements.push_back({named_quantity(problem, quantity), value, {}, {}});
}

void require_within(Problem& problem, std::string_view quantity, std::optional<double> min, std::optional<double> max) {
    for (const auto& limit : {min, max})
        if (limit) refuse_infinite(quantity, *limit);
    if (!min && !max)
        refuse_with("{} is required to be anything: give a least value, a greatest one or both", quantity);
    if (min && max && !(*min <= *max)) refuse_with("{} cannot be at least {} and at most {}", quantity, *min, *max);
    problem.requirements.push_back({named_quantity(problem, quantity), {}, min, max});
}

void minimize(Problem& problem, std::string_view quantity, double weight) {
    add_term(problem, quantity, false, weight);
}
void maximize(Problem& problem, std::string_view quantity, double weight) { add_term(problem, quantity, true, weight); }

void wish_least(Problem& problem, std::string_view quantity, double within) {
    add_wish(problem, quantity, false, within);
}
void wish_greatest(Problem& problem, std::string_view quantity, double within) {
    add_wish(problem, quantity, true, within);
}

void follow_path(Problem& problem, std::vector<Vector<double>> points) {
    if (!problem.mechanism->point) refuse_with("a {} guides no point along a path", problem.mechanism->name);
    if (points.size() < 2) refuse_with("a path has two points or more, not {}", points.size());
    for (const Vector<double>& p : points)
        for (const double coordinate : {p.x, p.y})
            refuse_infinite("a coordinate of the path", coordinate);
    PathTarget path;
    path.weights.assign(points.size(), 1);
    path.points = std::move(points);
    problem.path = std::move(path);
}

std::string why_not_whole(const Problem& problem) {
    if (!problem.mechanism) return "it names no mechanism";
    const Mechanism& mechanism = *problem.mechanism;
    if (problem.dimensions.size() != mechanism.dimensions.size()) return "it has not all dimensions";
    if (!problem.wishes.empty() && !problem.objective) return "it has wishes, and no objective that comes after them";
    std::vector<double> least, greatest;
    for (std::size_t i = 0; i < mechanism.dimensions.size(); ++i) {
        const Dimension& dimension = mechanism.dimensions[i];
        const DimensionRange& range = problem.dimensions[i];
        if (dimension.required && !range.named)
            return fmt::format("'{}' is missing: a number or a range", dimension.name);
        if (dimension.kind == DimensionKind::length && range.named && !(range.min > 0))
            return fmt::format("'{}' must be greater than 0, not {}", dimension.name, range.min);
        least.push_back(range.min);
        greatest.push_back(range.max);
    }
    if (mechanism.objection)
        if (const auto objection = mechanism.objection(least, greatest)) return objection->why;
    return {};
}

}  // namespace mechwright

#include "synthesis/target/over_input/read.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "synthesis/mechanism/input.h"
#include "synthesis/problem/sections/sections.h"
#include "synthesis/target/function/function_target.h"

namespace mechwright::reading {

namespace {

constexpr std::size_t most_samples = 10000;

/// [from, to] of x.
void read_x(Section& function, FunctionTarget& target, Messages& messages) {
    if (!has(function, "x"))
        return add_error(messages, function.place, "an expression needs its range: write x = [from, to]");
    const auto range = read_numbers(function, "x", messages);
    if (!range) return;
    const FilePlace place = place_of(function, "x");
    if (range->size() != 2)
        return add_error(
            messages, place,
            fmt::format("{} must be two numbers, [from, to], not {}", name_of(function, "x"), range->size()));
    if (!((*range)[0] < (*range)[1]))
        return add_error(messages, place,
                         fmt::format("{} must run from a smaller to a greater number, not from {} to {}",
                                     name_of(function, "x"), (*range)[0], (*range)[1]));
    target.from = (*range)[0];
    target.to = (*range)[1];
}

void read_samples(Section& function, FunctionTarget& target, Messages& messages) {
    const toml::node* node = find(function, "samples");
    if (!node->is_array()) return report_kind(*node, name_of(function, "samples"), "a list of [x, y]", messages);
    for (const toml::node& entry : *node->as_array()) {
        const toml::array* pair = entry.as_array();
        if (pair == nullptr || pair->size() != 2)
            return add_error(messages, place_of(entry),
                             fmt::format("each of {} must be a pair [x, y]", name_of(function, "samples")));
        const auto x = to_number((*pair)[0], "the x of a sample", messages);
        const auto y = to_number((*pair)[1], "the y of a sample", messages);
        if (!x || !y) return;
        if (!target.samples.empty() && !(*x > target.samples.back().x))
            return add_error(
                messages, place_of(entry),
                fmt::format("x must rise from sample to sample, not go from {} to {}", target.samples.back().x, *x));
        target.samples.push_back({*x, *y});
    }
    if (target.samples.size() < 2 || target.samples.size() > most_samples)
        add_error(messages, place_of(*node),
                  fmt::format("{} must have from 2 to {} pairs, not {}", name_of(function, "samples"), most_samples,
                              target.samples.size()));
}

/// What is generated: an expression with its range, or samples.
void read_target(Section& function, FunctionTarget& target, Messages& messages) {
    const bool expression = has(function, "expression");
    const bool samples = has(function, "samples");
    if (expression == samples)
        return add_error(
            messages, function.place,
            expression
                ? function.title + " has both 'expression' and 'samples': give one of them"
                : function.title + " needs expression = \"...\" with x = [from, to], or samples = [[x, y], ...]");
    const std::size_t before = messages.entries.size();
    if (expression) {
        if (const auto text = read_string(function, "expression", messages)) target.expression = *text;
        read_x(function, target, messages);
    } else {
        read_samples(function, target, messages);
    }
    if (messages.entries.size() != before && !expression) return;
    const std::string why =
        messages.entries.size() != before ? why_not_understood(target.expression) : complete(target);
    if (!why.empty()) add_error(messages, place_of(function, expression ? "expression" : "samples"), why);
}

/// How many, spread as Chebyshev's polynomials have their zeros; or a list of x.
void read_accuracy_points(Section& function, FunctionTarget& target, Messages& messages) {
    constexpr std::string_view key = "accuracy_points";
    const toml::node* node = find(function, key);
    if (node == nullptr) return;
    const FilePlace place = place_of(*node);
    if (target.expression.empty())
        return add_error(
            messages, place,
            fmt::format("{} go with an expression; of samples an exact method meets all", name_of(function, key)));
    if (const auto count = node->value_exact<std::int64_t>()) {
        if (*count < 3 || *count > 5)
            return add_error(
                messages, place,
                fmt::format("{} must be 3, 4 or 5, or a list of x, not {}", name_of(function, key), *count));
        const double middle = 0.5 * (target.from + target.to), half = 0.5 * (target.to - target.from);
        for (std::int64_t k = 1; k <= *count; ++k)
            target.accuracy_points.push_back(
                middle -
                half * std::cos(std::numbers::pi * static_cast<double>(2 * k - 1) / static_cast<double>(2 * *count)));
        return;
    }
    const auto points = read_numbers(function, key, messages);
    if (!points) return;
    if (points->size() < 3 || points->size() > 5)
        return add_error(
            messages, place,
            fmt::format("{} must be from 3 to 5 values of x, not {}", name_of(function, key), points->size()));
    for (std::size_t i = 0; i < points->size(); ++i) {
        const double x = (*points)[i];
        if (x < target.from || x > target.to)
            return add_error(
                messages, place_of((*node->as_array())[i]),
                fmt::format("accuracy point {} is outside the range of x, {} to {}", x, target.from, target.to));
        if (i > 0 && !(x > (*points)[i - 1]))
            return add_error(messages, place_of((*node->as_array())[i]),
                             fmt::format("accuracy points must rise, not go from {} to {}", (*points)[i - 1], x));
    }
    target.accuracy_points = *points;
}

/// { start, range } of the input or the output.
void read_scale_of(Section& function, std::string_view key, std::size_t first, Problem& problem, Messages& messages) {
    if (!has(function, key))
        return add_error(messages, function.place,
                         fmt::format("{1} needs '{0}': {0} = {{ start = ..., range = ... }}", key, function.title));
    auto scale = read_section(function, key, messages);
    if (!scale) return;
    scale->title = key;
    read_scale(*scale, first, problem, messages);
    report_unknown_keys(*scale, messages);
}

/// An input range that is given lies on the stroke of the slide that drives, where one does.
void check_stroke(const Section& scale, std::size_t first, const Problem& problem, Messages& messages) {
    const auto reach = reach_of_input(*problem.mechanism);
    const DimensionRange &start = problem.dimensions[first], &range = problem.dimensions[first + 1];
    const bool is_input = problem.mechanism->dimensions[first].name.ends_with("input-start");
    const bool is_given = start.fixed() && range.fixed() && range.min != 0;  // what is missing has been told
    if (!reach || !is_input || !is_given) return;
    const double end = start.min + range.min;
    if (std::min(start.min, end) >= (*reach)[0] && std::max(start.min, end) <= (*reach)[1]) return;
    add_error(
        messages, scale.place,
        fmt::format("the range from {} to {} is not on the stroke of the slide that drives, which goes from {} to "
                    "{}: keep it between the stops, or give other stops",
                    start.min, end, (*reach)[0], (*reach)[1]));
}

}  // namespace

void read_scale(Section& scale, std::size_t first, Problem& problem, Messages& messages) {
    constexpr std::array<std::string_view, 2> parts{"start", "range"};
    for (std::size_t k = 0; k < parts.size(); ++k) {
        const Dimension& dimension = problem.mechanism->dimensions[first + k];
        const toml::node* node = find(scale, parts[k]);
        if (node == nullptr) {
            add_error(messages, scale.place,
                      fmt::format("'{}' of '{}' is missing: give {}, or {{ min = ..., max = ... }}", parts[k],
                                  scale.title, dimension.kind == DimensionKind::angle ? "an angle" : "a length"));
            continue;
        }
        const auto read = to_dimension_or_tie(*node, first + k, *problem.mechanism, problem.units, messages);
        if (!read) continue;
        problem.dimensions[first + k] = *read;
        if (k == 1 && !read->tied() && read->min <= 0 && read->max >= 0)
            add_error(messages, place_of(*node),
                      fmt::format("the range of the {} must not be 0{}", scale.title,
                                  read->fixed() ? "" : ": let min and max have the same sign"));
    }
    check_stroke(scale, first, problem, messages);
}

void set_crank_range(Problem& problem) {
    if (problem.mechanism == nullptr || !has_input_range(problem)) return;
    if (problem.path || problem.over_input) return;  // other targets may need more of it
    const DimensionRange& start = problem.dimensions[problem.mechanism->input->start];
    const DimensionRange& range = problem.dimensions[problem.mechanism->input->start + 1];
    if (!problem.crank_range && start.fixed() && range.fixed() && range.min != 0)
        problem.crank_range = {std::min(start.min, start.min + range.min), std::max(start.min, start.min + range.min)};
}

namespace {

void read_one_function(OverInputSection& of, Problem& problem, Messages& messages) {
    Section& function = of.section;
    const Mechanism& mechanism = *problem.mechanism;
    auto target = std::make_shared<FunctionTarget>();
    read_target(function, *target, messages);
    for (const char* key : {"expression", "samples", "x"})
        find(function, key);
    read_accuracy_points(function, *target, messages);
    const std::size_t scales =
        of.number == every_target ? mechanism.input->start : mechanism.over_input[of.number].start;
    read_scale_of(function, "input", scales, problem, messages);
    read_scale_of(function, "output", scales + 2, problem, messages);
    report_unknown_keys(function, messages);
    AskedOverInput asked;
    asked.function = std::move(target);
    add_over_input(of, std::move(asked), problem);
}

}  // namespace

void read_function(Section& file, Problem& problem, Messages& messages) {
    for (OverInputSection& of : read_over_input_sections(file, "function", problem, messages))
        read_one_function(of, problem, messages);
}

}  // namespace mechwright::reading

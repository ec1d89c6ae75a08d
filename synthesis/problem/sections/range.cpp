#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "synthesis/problem/allowed_values.h"
#include "synthesis/problem/schema/keys.h"
#include "synthesis/problem/sections/sections.h"
#include "synthesis/problem/text.h"

namespace mechwright::reading {

namespace {

void check_start(const Section& range, const DimensionRange& read, Messages& messages) {
    if (read.start && (*read.start < read.min || *read.start > read.max))
        add_error(messages, place_of(range, "start"),
                  fmt::format("'start' {} in {} must lie between {}{} and {}{}", *read.start, range.title,
                              read.choices.empty() ? "'min' " : "the least choice ", read.min,
                              read.choices.empty() ? "'max' " : "the greatest ", read.max));
}

std::optional<DimensionRange> read_choices(Section& range, Messages& messages) {
    range.known = keys::dimension_choices;
    DimensionRange read;
    read.named = true;
    read.start = read_number(range, "start", messages);
    auto choices = read_numbers(range, "choices", messages);
    for (const char* key : {"min", "max", "step", "round"})
        if (has(range, key)) {
            add_error(messages, key_place(range, key),
                      fmt::format("'{}' does not go with 'choices' in {}: leave out one of them", key, range.title));
            range.reported.push_back(key);
        }
    report_unknown_keys(range, messages);
    if (!choices) return {};
    const FilePlace place = place_of(range, "choices");
    if (choices->empty()) add_error(messages, place, fmt::format("'choices' in {} is empty", range.title));
    if (choices->size() > most_choices)
        add_error(messages, place,
                  fmt::format("'choices' in {} has {} values: give {} at most, or min, max and step", range.title,
                              choices->size(), most_choices));
    std::sort(choices->begin(), choices->end());
    if (const auto twice = std::adjacent_find(choices->begin(), choices->end()); twice != choices->end())
        add_error(messages, place, fmt::format("'choices' in {} has {} twice", range.title, *twice));
    if (choices->empty()) return {};
    read.min = choices->front();
    read.max = choices->back();
    if (choices->size() > 1) read.choices = std::move(*choices);
    check_start(range, read, messages);
    return read;
}

void read_step(Section& range, DimensionRange& read, Messages& messages) {
    const auto step = read_number(range, "step", messages);
    if (!step || (*step > 0 && read.fixed()) || end_with_step(read, *step)) return;
    add_error(messages, place_of(range, "step"),
              fmt::format("'step' {} in {} {}", *step, range.title,
                          !(*step > 0) ? "must be greater than 0"
                          : *step > read.max - read.min
                              ? fmt::format("is greater than the range from {} to {}", read.min, read.max)
                              : fmt::format("makes more than {} values: take a greater one", most_steps)));
}

void read_round(Section& range, DimensionRange& read, Messages& messages) {
    const auto multiple = read_number(range, "round", messages);
    if (!multiple) return;
    if (has(range, "step"))
        return add_error(messages, key_place(range, "round"),
                         fmt::format("'round' does not go with 'step' in {}: leave out one of them", range.title));
    if (const std::string fault = round_fault(read, *multiple); !fault.empty())
        return add_error(messages, place_of(range, "round"), fmt::format("{} in {}", fault, range.title));
    round_to(read, *multiple);
}

}  // namespace

std::string round_fault(DimensionRange range, double multiple) {
    if (!(multiple > 0)) return fmt::format("'round' {} must be greater than 0", multiple);
    if (round_to(range, multiple)) return {};
    return range.max - range.min < most_steps * multiple
               ? fmt::format("no multiple of 'round' {} lies between {} and {}", multiple, range.min, range.max)
               : fmt::format("'round' {} makes more than {} values: take a greater one", multiple, most_steps);
}

void round_lengths(const Section& file, Problem& problem, Messages& messages) {
    const toml::node* node = file.table->at_path("solver.round").node();
    const double multiple = node != nullptr ? node->value<double>().value_or(0) : 0;
    if (problem.mechanism == nullptr || !(multiple > 0)) return;
    for (std::size_t i = 0; i < problem.dimensions.size(); ++i) {
        DimensionRange& range = problem.dimensions[i];
        const Dimension& dimension = problem.mechanism->dimensions[i];
        const bool is_free = !range.fixed() && !range.tied() && !range.discrete();
        if (!is_free || dimension.kind != DimensionKind::length) continue;
        if (const std::string fault = round_fault(range, multiple); !fault.empty())
            add_error(messages, place_of(*node), fmt::format("{}, the range of '{}'", fault, dimension.name));
        round_to(range, multiple);
    }
}

std::optional<DimensionRange> to_range(const toml::table& table, std::string_view name, Messages& messages) {
    Section range{&table, fmt::format("the range of '{}'", name), place_of(table), keys::dimension_range};
    if (has(range, "choices")) return read_choices(range, messages);
    for (const char* key : {"min", "max"})
        if (!has(range, key))
            add_error(messages, range.place,
                      fmt::format("{} is missing: write {{ min = ..., max = ... }}, or {{ choices = [...] }}",
                                  name_of(range, key)));
    const auto min = read_number(range, "min", messages), max = read_number(range, "max", messages);
    DimensionRange read{min.value_or(0), max.value_or(0), read_number(range, "start", messages), true};
    if (min && max && *min > *max)
        add_error(messages, place_of(range, "min"),
                  fmt::format("'min' {} is greater than 'max' {} in {}", read.min, read.max, range.title));
    else if (min && max) {
        check_start(range, read, messages);
        read_step(range, read, messages);
        read_round(range, read, messages);
    } else {
        find(range, "step");
        find(range, "round");
    }
    report_unknown_keys(range, messages);
    if (!min || !max || *min > *max) return {};
    return read;
}

}  // namespace mechwright::reading

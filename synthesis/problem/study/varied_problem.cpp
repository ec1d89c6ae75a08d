#include "synthesis/problem/study/varied_problem.h"

#include <fmt/format.h>
#include <muParser.h>

#include <algorithm>
#include <cmath>

#include "synthesis/problem/sections/sections.h"
#include "synthesis/problem/study/value_path.h"
#include "synthesis/problem/toml/toml_text.h"

namespace mechwright {

namespace {

constexpr double greatest_whole = 9e15;

/// A number as a TOML value: whole where it stands for one.
template <class Use>
std::string with_number(double number, bool whole, const Use& use) {
    if (whole && number == std::round(number) && std::abs(number) < greatest_whole)
        return use(toml::value<std::int64_t>(static_cast<std::int64_t>(number)));
    return use(toml::value<double>(number));
}

toml::table without_study(toml::table table) {
    table.erase("study");
    return table;
}

toml::table parsed(std::string_view text, const std::string& file) {
    reading::Messages messages{.file = file};
    return without_study(reading::parse_toml(text, messages).value_or(toml::table()));
}

}  // namespace

VariedProblem::VariedProblem(std::string_view text, std::string file)
    : file_(std::move(file)), original_(parsed(text, file_)), changed_(parsed(text, file_)) {}

VariedProblem::VariedProblem(const toml::table& table, std::string file)
    : file_(std::move(file)), original_(without_study(table)), changed_(original_) {}

std::string VariedProblem::put(std::string_view path, const toml::node& value) {
    return reading::put_value(changed_, path, &value);
}

std::string VariedProblem::put_original(std::string_view path) {
    return reading::put_value(changed_, path, reading::value_at(original_, path));
}

std::string VariedProblem::put(const StudyAxis& axis, const AxisValue& value) {
    if (axis.cases()) {
        // What another case has changed and this one says nothing of is as the file says.
        for (const std::string& path : paths_of_cases_)
            put_original(path);
        paths_of_cases_.clear();
        if (value.as_in_file) return {};
        for (const auto& [path, node] : *axis.values[value.index].as_table()) {
            if (std::string fault = reading::put_value(changed_, path.str(), &node); !fault.empty()) return fault;
            paths_of_cases_.emplace_back(path.str());
        }
        return {};
    }
    if (value.as_in_file) return put_original(axis.name);
    if (!axis.range) return put(axis.name, axis.values[value.index]);
    return with_number(value.number, axis.range->whole, [&](const toml::node& node) { return put(axis.name, node); });
}

std::string VariedProblem::put(const Study& study, std::span<const AxisValue> values) {
    for (std::size_t i = 0; i < study.axes.size(); ++i)
        if (std::string fault = put(study.axes[i], values[i]); !fault.empty()) return fault;
    for (const FollowingValue& following : study.following) {
        const double number = number_of(following, study, values);
        if (!std::isfinite(number)) {
            put_original(following.path);
            continue;
        }
        std::string fault =
            with_number(number, false, [&](const toml::node& node) { return put(following.path, node); });
        if (!fault.empty()) return fault;
    }
    return {};
}

ReadProblem VariedProblem::read() const {
    ReadProblem read;
    read.problem.file = file_;
    reading::Messages messages{.file = file_};
    reading::read_problem_table(changed_, read.problem, messages);
    reading::conclude(read, std::move(messages));
    return read;
}

std::string label_of(const StudyAxis& axis, const AxisValue& value) {
    if (value.as_in_file) return "as in the file";
    return axis.range ? fmt::format("{}", value.number) : axis.labels[value.index];
}

double number_of(const FollowingValue& following, const Study& study, std::span<const AxisValue> values) {
    mu::Parser parser;
    std::vector<double> numbers(following.variables.size());
    for (std::size_t i = 0; i < numbers.size(); ++i) {
        const auto& [name, axis] = following.variables[i];
        if (values[axis].as_in_file) return std::nan("");
        numbers[i] = study.axes[axis].range ? values[axis].number
                                            : study.axes[axis].values[values[axis].index].value<double>().value_or(0);
        parser.DefineVar(name, &numbers[i]);
    }
    try {
        parser.SetExpr(following.expression);
        return parser.Eval();
    } catch (const mu::Parser::exception_type&) {
        return std::nan("");
    }
}

namespace reading {

namespace {

/// "with dimensions.ground = 0 and segment.1.law = 'wrong'"
std::string said(const Study& study, std::span<const AxisValue> values) {
    std::string text;
    for (std::size_t i = 0; i < study.axes.size(); ++i)
        text +=
            fmt::format("{}{} = {}", i == 0 ? "with " : ", ", study.axes[i].name, label_of(study.axes[i], values[i]));
    return text;
}

/// Whether the first messages say it already of the file as it is: the same, or something else of the place.
bool is_said(const Messages& messages, std::size_t first, const Message& message) {
    const auto end = messages.entries.begin() + static_cast<std::ptrdiff_t>(std::min(first, messages.entries.size()));
    return std::any_of(messages.entries.begin(), end, [&](const Entry& entry) {
        const bool at =
            message.line > 0 && entry.message.line == message.line && entry.message.column == message.column;
        return !entry.message.warning && (at || entry.message.text == message.text);
    });
}

}  // namespace

void check_ends(VariedProblem&& varied, FilePlace study_place, const Study& study, Messages& messages) {
    for (const bool last : {false, true}) {
        std::vector<AxisValue> values;
        for (const StudyAxis& axis : study.axes)
            values.push_back(axis.range ? AxisValue{.number = last ? axis.range->to : axis.range->from}
                                        : AxisValue{.index = last ? axis.values.size() - 1 : 0});
        if (const std::string fault = varied.put(study, values); !fault.empty()) {
            add_error(messages, study_place, "[study] " + fault);
            return;
        }
        ReadProblem read = varied.read();
        messages.unreadable |= read.unreadable;
        const std::size_t before = messages.entries.size();
        for (const Message& message : read.messages)
            if (!message.warning && !is_said(messages, before, message))
                add_error(messages,
                          message.line > 0 && messages.nodes == nullptr ? FilePlace{message.line, message.column}
                                                                        : study_place,
                          fmt::format("[study] {}: {}", said(study, values), message.text));
        if (messages.entries.size() != before) return;
    }
}

}  // namespace reading

}  // namespace mechwright

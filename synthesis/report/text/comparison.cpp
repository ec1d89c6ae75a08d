#include "synthesis/report/text/comparison.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <functional>

#include "synthesis/document/document.h"
#include "synthesis/problem/units.h"
#include "synthesis/program/assess.h"
#include "synthesis/program/quantity_value.h"
#include "synthesis/report/csv/csv_text.h"
#include "synthesis/report/text/table.h"

namespace mechwright {

namespace {

/// A quantity that designs are compared by, and its heading in two short lines.
struct Column {
    std::string_view quantity;
    std::string_view heading;
    std::string_view more;
};

constexpr std::array<Column, 7> compared_columns{{{"total-length", "size", ""},
                                                  {"transmission-angle-worst", "worst", "angle"},
                                                  {"time-ratio", "time", "ratio"},
                                                  {"stroke", "stroke", ""},
                                                  {"speed-variation", "speed", "variation"},
                                                  {"cam-size", "cam", "size"},
                                                  {"pressure-angle-max", "pressure", "angle"}}};

/// Rows above the designs in the table.
constexpr std::size_t heading_rows = 3;

/// Whether a search was stopped before it ended.
bool is_stopped(const Compared& c) {
    return c.result.status == Status::limit || c.result.status == Status::interrupted;
}

/// A design that meets all requirements and passed verification, be it the best until the search was stopped.
bool has_design(const Compared& c) {
    return c.result.best && c.result.best->feasible && c.result.verified() &&
           (c.result.status == Status::solved || is_stopped(c));
}

/// The value of a quantity by its name, in the file's unit.
std::optional<double> value_of(const Compared& c, std::string_view quantity) {
    const int index = find_quantity(*c.problem.mechanism, quantity);
    if (index < 0 || !has_design(c)) return std::nullopt;
    const auto value = quantity_value(c.problem, static_cast<std::size_t>(index), c.result.best->design);
    if (!value) return std::nullopt;
    return in_file_unit(*value, c.problem.mechanism->quantities[static_cast<std::size_t>(index)].unit, c.problem.units);
}

std::string unit_of_quantity(const Compared& c, std::string_view quantity) {
    const int index = find_quantity(*c.problem.mechanism, quantity);
    return index < 0
               ? ""
               : unit_label(c.problem.mechanism->quantities[static_cast<std::size_t>(index)].unit, c.problem.units);
}

/// "minimize speed-variation"; several terms with their weights.
std::string objective_text(const Compared& c) {
    if (!c.problem.objective) return {};
    std::string text;
    for (const ObjectiveTerm& term : c.problem.objective->terms) {
        text += text.empty() ? "" : c.problem.objective->worst ? ", " : " + ";
        if (term.weight != 1) text += fmt::format("{} x ", term.weight);
        text += fmt::format("{} {}", term.maximize ? "maximize" : "minimize",
                            c.problem.mechanism->quantities[term.quantity].name);
    }
    return text;
}

std::string requirement_text(const Compared& c, const Requirement& r) {
    const Quantity& quantity = c.problem.mechanism->quantities[r.quantity];
    const std::string unit = unit_label(quantity.unit, c.problem.units);
    std::string text(quantity.name);
    const auto add = [&](std::string_view relation, const std::optional<double>& limit) {
        if (limit)
            text += fmt::format(" {} {}{}{}", relation, in_file_unit(*limit, quantity.unit, c.problem.units),
                                unit.empty() ? "" : " ", unit);
    };
    add("=", r.equal);
    add(">=", r.min);
    add("<=", r.max);
    return text;
}

/// Everything that a file asks for, as lines that can be compared.
std::vector<std::string> asked(const Compared& c) {
    std::vector<std::string> lines;
    for (const Requirement& r : c.problem.requirements)
        lines.push_back(requirement_text(c, r));
    if (c.problem.objective) lines.push_back(objective_text(c));
    for (std::size_t i = 0; i < c.problem.mechanism->settings.size(); ++i)
        if (c.problem.settings[i] != c.problem.mechanism->settings[i].preset)
            lines.push_back(fmt::format(
                "{} = {}", c.problem.mechanism->settings[i].name,
                c.problem.settings[i] / inner_per_file_unit(c.problem.mechanism->settings[i], c.problem.units)));
    std::sort(lines.begin(), lines.end());
    return lines;
}

/// The unit of the objective: of its only term, or none.
std::string objective_unit(const Compared& c) {
    if (!c.problem.objective || c.problem.objective->terms.size() != 1) return {};
    return unit_of_quantity(c, c.problem.mechanism->quantities[c.problem.objective->terms.front().quantity].name);
}

bool same_objective(const std::vector<Compared>& all) {
    return !all.empty() && all.front().problem.objective && std::all_of(all.begin(), all.end(), [&](const Compared& c) {
        return objective_text(c) == objective_text(all.front()) && objective_unit(c) == objective_unit(all.front());
    });
}

std::string short_name(const Compared& c) { return std::filesystem::path(c.problem.file).stem().string(); }

/// A unit that all designs with a value share, else nothing.
std::string common_unit(const std::vector<Compared>& all, const std::function<std::string(const Compared&)>& unit) {
    std::string common;
    for (const Compared& c : all)
        if (std::string one = unit(c); !one.empty()) {
            if (!common.empty() && common != one) return {};
            common = std::move(one);
        }
    return common;
}

/// "power stopped at a limit", for each search that did not end; of a design that it came to before, that it did.
std::string stopped_searches(const std::vector<Compared>& all) {
    std::string text;
    for (const Compared& c : all) {
        if (!is_stopped(c)) continue;
        text += folded("", fmt::format("{} was stopped {}{}.", short_name(c),
                                       c.result.status == Status::limit ? "at a limit" : "on request",
                                       has_design(c) ? ": its design is the best so far" : " without a design"));
    }
    return text;
}

std::string missing(const std::string& list, const std::vector<std::string>& those,
                    const std::vector<std::string>& in) {
    std::string text;
    for (const std::string& line : those)
        if (std::find(in.begin(), in.end(), line) == in.end()) text += (text.empty() ? list : std::string(", ")) + line;
    return text;
}

}  // namespace

std::vector<Compared> ranked(std::vector<Compared> all) {
    const bool by_objective = same_objective(all);
    std::stable_sort(all.begin(), all.end(), [&](const Compared& a, const Compared& b) {
        if (has_design(a) != has_design(b)) return has_design(a);
        if (!by_objective || !has_design(a)) return false;
        const double x = a.result.best->objective, y = b.result.best->objective;
        return maximizes(a.problem) ? x > y : x < y;
    });
    return all;
}

std::string comparison_table(const std::vector<Compared>& all, const TextStyle& style) {
    Table table{{Align::left, Align::left, Align::point}, {{"", "mechanism", "objective"}, {"", "", ""}, {"", "", ""}}};
    if (same_objective(all)) table.rows[2][2] = objective_unit(all.front());
    for (const Compared& c : all) {
        std::string objective = "-";
        if (!has_design(c))
            objective = name_of(c.result.status);
        else if (c.problem.objective)
            objective = objective_text(c.problem, *c.result.best, style.digits);
        table.rows.push_back({short_name(c), std::string(c.problem.mechanism->name), std::move(objective)});
    }
    for (const Column& column : compared_columns) {
        if (std::none_of(all.begin(), all.end(), [&](const Compared& c) { return value_of(c, column.quantity); }))
            continue;
        table.columns.push_back(Align::point);
        table.rows[0].emplace_back(column.heading);
        table.rows[1].emplace_back(column.more);
        table.rows[2].push_back(
            common_unit(all, [&](const Compared& c) { return unit_of_quantity(c, column.quantity); }));
        for (std::size_t i = 0; i < all.size(); ++i) {
            const auto value = value_of(all[i], column.quantity);
            table.rows[i + heading_rows].push_back(value ? rounded_text(*value, style.digits) : "-");
        }
    }
    std::string text = to_text(table, 0);
    if (const std::string stopped = stopped_searches(all); !stopped.empty()) text += '\n' + stopped;
    if (!same_objective(all) || !has_design(all.front())) return text;
    text += '\n' + folded(emphasised("Best: ", Emphasis::good, style.colour),
                          fmt::format("{}, {} = {}{}{}", short_name(all.front()), objective_text(all.front()),
                                      objective_text(all.front().problem, *all.front().result.best, style.digits),
                                      objective_unit(all.front()).empty() ? "" : std::string(1, tied_space),
                                      objective_unit(all.front())));
    return text;
}

std::string comparison_csv(const std::vector<Compared>& all) {
    std::string text = "file,mechanism,status,objective";
    for (const Column& column : compared_columns)
        text += "," + std::string(column.quantity);
    text += '\n';
    for (const Compared& c : all) {
        text += csv_field(c.problem.file) + "," + std::string(c.problem.mechanism->name) + "," +
                std::string(name_of(c.result.status)) + ",";
        if (has_design(c) && c.problem.objective) text += csv_number(c.result.best->objective);
        for (const Column& column : compared_columns) {
            const auto value = value_of(c, column.quantity);
            text += "," + (value ? csv_number(*value) : std::string());
        }
        text += '\n';
    }
    return text;
}

nlohmann::ordered_json comparison_json(const std::vector<Compared>& all) {
    nlohmann::ordered_json list = nlohmann::ordered_json::array();
    for (const Compared& c : all) {
        nlohmann::ordered_json one{
            {"file", c.problem.file}, {"mechanism", c.problem.mechanism->name}, {"status", name_of(c.result.status)}};
        if (has_design(c) && c.problem.objective) one["objective"] = c.result.best->objective;
        for (const Column& column : compared_columns)
            if (const auto value = value_of(c, column.quantity)) one[std::string(column.quantity)] = *value;
        one["result"] = document(c.problem, c.result);
        list.push_back(std::move(one));
    }
    return list;
}

std::string differences_of_tasks(const std::vector<Compared>& all) {
    std::string text;
    for (std::size_t i = 1; i < all.size(); ++i) {
        const auto first = asked(all.front()), other = asked(all[i]);
        const std::string more = missing(" asks for ", other, first), less = missing(" not for ", first, other);
        if (more.empty() && less.empty()) continue;
        text += all[i].problem.file + (more.empty() ? " asks" : more) + (less.empty() || more.empty() ? "" : ",") +
                less + " (compared with " + all.front().problem.file + ")\n";
    }
    return text;
}

}  // namespace mechwright

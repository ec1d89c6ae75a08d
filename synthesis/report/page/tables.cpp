#include "synthesis/report/page/tables.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "synthesis/mechanism/input.h"
#include "synthesis/mechanism/whole_quantities.h"
#include "synthesis/problem/units.h"
#include "synthesis/report/drawing/svg.h"
#include "synthesis/report/names.h"
#include "synthesis/report/text/table.h"

namespace mechwright {

namespace {

using Json = nlohmann::ordered_json;

/// The member if it is there and an object or an array, as asked for; else an empty one.
const Json& part(const Json& json, const char* name, Json::value_t type) {
    static const Json nothing;
    return json.is_object() && json.contains(name) && json[name].type() == type ? json[name] : nothing;
}
const Json& object_in(const Json& json, const char* name) { return part(json, name, Json::value_t::object); }
const Json& list_in(const Json& json, const char* name) { return part(json, name, Json::value_t::array); }

std::string text_in(const Json& json, const char* name) {
    return json.is_object() && json.contains(name) ? cell_text(json[name]) : "";
}

std::optional<double> number_in(const Json& json, const char* name) {
    if (!json.is_object() || !json.contains(name) || !json[name].is_number()) return std::nullopt;
    return json[name].get<double>();
}

/// The mechanism of a document: the one of its name that has every number of its dimensions. Cams of several kinds have
/// one name, and the same word means a length of one and an angle of another. Null where there is none.
std::shared_ptr<const Mechanism> mechanism_of(const Json& document) {
    const std::string name = text_in(object_in(document, "problem"), "mechanism");
    const auto has_all = [&](const Mechanism& m, const Json& numbers) {
        for (const auto& [key, value] : numbers.items())
            if (value.is_number() && find_dimension(m, key) < 0) return false;
        return true;
    };
    for (const auto& m : mechanisms_named(name))
        if (has_all(*m, object_in(document, "design")) && has_all(*m, object_in(document, "dimensions"))) return m;
    return nullptr;
}

/// Units of quantities and dimensions by their names.
struct UnitsOf {
    std::shared_ptr<const Mechanism> mechanism;
    Units units;

    explicit UnitsOf(const Json& document) : mechanism(mechanism_of(document)) {
        units.degrees = text_in(object_in(document, "units"), "angle") != "rad";
        units.length = text_in(object_in(document, "units"), "length");
        units.force = text_in(object_in(document, "units"), "force");
    }
    std::string of_quantity(std::string_view name) const {
        const int i = mechanism ? find_quantity(*mechanism, without_whole(name)) : -1;
        return i < 0 ? "" : unit_label(mechanism->quantities[static_cast<std::size_t>(i)].unit, units);
    }
    std::string of_dimension(std::string_view name) const {
        const int i = mechanism ? find_dimension(*mechanism, name) : -1;
        return i < 0 ? "" : unit_label(unit_of(mechanism->dimensions[static_cast<std::size_t>(i)].kind), units);
    }
    std::string of_input() const { return unit_label(mechanism ? input_unit(*mechanism) : Unit::angle, units); }
    /// "crank angle" or "displacement".
    std::string input_name() const { return mechanism ? std::string(input_word(*mechanism)) : "crank angle"; }
};

/// "given", "least", "greatest" or empty: where a dimension lies in what the file allows.
std::string place_in_range(const Json& given, double value) {
    if (given.is_number()) return "given";
    const std::optional<double> min = number_in(given, "min"), max = number_in(given, "max");
    const auto at = [&](const std::optional<double>& limit) {
        return limit && std::abs(value - *limit) <= 1e-9 * std::max(1.0, std::abs(*limit));
    };
    return at(min) ? "at its least" : at(max) ? "at its greatest" : "";
}

std::string dimensions_table(const Json& document, const UnitsOf& units) {
    const Json& design = object_in(document, "design");
    const Json& given = object_in(document, "dimensions");
    std::string rows;
    for (const auto& [name, value] : design.items()) {
        if (!value.is_number()) {
            if (value.is_string()) rows += table_row({name, value.get<std::string>(), "", ""});
            continue;
        }
        const std::string place =
            given.contains(name) ? place_in_range(given[name], value.get<double>()) : std::string();
        rows += table_row({name, cell_text(value), units.of_dimension(name), place});
    }
    return table_of("Dimensions", {"dimension", "value", "unit", ""}, rows);
}

/// One limit of a requirement: how far the value is inside it.
std::string limit_row(const Json& requirement, const char* limit, const char* sign, const UnitsOf& units,
                      double tolerance) {
    const std::optional<double> required = number_in(requirement, limit), value = number_in(requirement, "value");
    if (!required) return {};
    const std::string name = text_in(requirement, "quantity"), unit = units.of_quantity(name);
    if (!value)
        return table_row({name, fmt::format("{} {}", sign, number_text(*required)), "no value", unit, "", "not met"},
                         true);
    const bool equal = std::string_view(limit) == "equal";
    const double margin = equal                              ? -std::abs(*value - *required)
                          : std::string_view(limit) == "min" ? *value - *required
                                                             : *required - *value;
    const bool met = margin >= -tolerance * std::max(1.0, std::abs(*required));
    const bool active = met && margin <= 1e-6 * std::max(1.0, std::abs(*required));
    return table_row({name, fmt::format("{} {}", sign, number_text(*required)), number_text(*value), unit,
                      equal || active ? fmt::format("{:.1e}", std::abs(margin)) : number_text(margin, 5),
                      !met               ? "not met"
                      : active && !equal ? "met, at the limit"
                                         : "met"},
                     !met);
}

std::string requirements_table(const Json& document, const UnitsOf& units) {
    const double tolerance = number_in(document, "tolerance").value_or(1e-9);
    std::string rows;
    for (const Json& requirement : list_in(document, "requirements"))
        rows += limit_row(requirement, "equal", "=", units, tolerance) +
                limit_row(requirement, "min", "\u2265", units, tolerance) +
                limit_row(requirement, "max", "\u2264", units, tolerance);
    return table_of("Requirements", {"quantity", "required", "reached", "unit", "margin", ""}, rows);
}

std::string objective_rows(const Json& objective, const UnitsOf& units) {
    if (!objective.is_object()) return {};
    std::string rows;
    if (objective.contains("quantity"))
        rows += table_row({text_in(objective, "sense") + " " + text_in(objective, "quantity"),
                           text_in(objective, "value"), units.of_quantity(text_in(objective, "quantity"))});
    for (const Json& term : list_in(objective, "terms"))
        rows += table_row({text_in(term, "sense") + " " + text_in(term, "quantity"), text_in(term, "value"),
                           units.of_quantity(text_in(term, "quantity"))});
    return rows;
}

std::string wish_rows(const Json& document, const UnitsOf& units) {
    std::string rows;
    for (const Json& wish : list_in(document, "wishes"))
        rows +=
            table_row({text_in(wish, "sense") + " " + text_in(wish, "quantity"), text_in(wish, "value"),
                       units.of_quantity(text_in(wish, "quantity")), text_in(wish, "best"), text_in(wish, "limit")});
    return rows;
}

std::string quantities_table(const Json& document, const UnitsOf& units) {
    std::string rows;
    for (const auto& [name, value] : object_in(document, "quantities").items())
        rows += table_row({name, cell_text(value), units.of_quantity(name)});
    return table_of("Quantities", {"quantity", "value", "unit"}, rows);
}

std::string in_details(std::string_view summary, const std::string& content) {
    if (content.empty()) return {};
    return fmt::format("<details><summary>{}</summary>{}</details>", summary, content);
}

std::string pair_text(const Json& pair) {
    if (!pair.is_array() || pair.size() < 2) return "";
    return cell_text(pair[0]) + ", " + cell_text(pair[1]);
}

/// The points of one path, or its poses.
std::string points_table(const Json& path, const UnitsOf& units) {
    const Json &points = list_in(path, "points"), &reached = list_in(path, "reached"),
               &distances = list_in(path, "distances"), &angles = list_in(path, "crank_angles");
    const std::string name = text_in(path, "name");
    std::string rows;
    for (std::size_t i = 0; i < points.size(); ++i)
        rows += table_row({std::to_string(i + 1), pair_text(points[i]), i < reached.size() ? pair_text(reached[i]) : "",
                           i < angles.size() ? cell_text(angles[i]) : "",
                           i < distances.size() ? cell_text(distances[i]) : ""});
    const std::string title = name.empty() ? "Targets" : fmt::format("Targets of '{}'", name);
    return rows.empty()
               ? ""
               : in_details(title, table_of(title, {"", "target", "reached", units.input_name(), "distance"}, rows));
}

std::string targets_table(const Json& document, const UnitsOf& units) {
    std::string text;
    for (const char* kind : {"path", "poses"}) {
        if (const Json& list = list_in(document, kind); !list.empty())
            for (const Json& path : list)
                text += points_table(path, units);
        else
            text += points_table(object_in(document, kind), units);
    }
    return text;
}

std::string verification_table(const Json& document) {
    std::string rows;
    std::size_t passed = 0, all = 0;
    for (const Json& check : list_in(object_in(document, "verification"), "checks")) {
        const bool good = check.is_object() && check.contains("passed") && check["passed"] == true;
        ++all;
        passed += good ? 1 : 0;
        rows += table_row({good ? "passed" : "FAILED", text_in(check, "name"), text_in(check, "detail")}, !good);
    }
    return in_details(fmt::format("Verification: {} of {} checks passed, recomputed in fifty digits", passed, all),
                      table_of("Verification", {"", "check", "found"}, rows));
}

std::string search_table(const Json& document) {
    const Json& search = object_in(document, "search");
    std::string rows;
    for (const auto& [name, value] : search.items())
        if (!value.is_structured()) rows += table_row({name, cell_text(value)});
    return in_details("How it was found", table_of("Search", {"", ""}, rows));
}

}  // namespace

std::string cell_text(const Json& value) {
    if (value.is_string()) return value.get<std::string>();
    if (value.is_boolean()) return value.get<bool>() ? "yes" : "no";
    if (value.is_number()) return number_text(value.get<double>());
    return "";
}

std::string table_row(const std::vector<std::string>& cells, bool bad) {
    std::string row = bad ? "<tr class=\"bad\">" : "<tr>";
    for (std::size_t i = 0; i < cells.size(); ++i)
        row += i == 0 ? "<th scope=\"row\">" + escaped(cells[i]) + "</th>" : "<td>" + escaped(cells[i]) + "</td>";
    return row + "</tr>";
}

std::string table_of(std::string_view caption, const std::vector<std::string>& heads, const std::string& rows) {
    if (rows.empty()) return {};
    std::string text = fmt::format("<table><caption>{}</caption><thead><tr>", escaped(caption));
    for (const std::string& head : heads)
        text += head.empty() ? "<td></td>" : "<th scope=\"col\">" + escaped(head) + "</th>";
    return text + "</tr></thead><tbody>" + rows + "</tbody></table>";
}

std::string standing_sentence(const Json& document) {
    const std::string status = text_in(document, "status");
    if (status.empty()) return "A given mechanism, evaluated.";
    if (status == "solved") return "Solved: all requirements are met, and the design passed verification.";
    const std::string note = text_in(document, "note");
    return "Status: " + status + (note.empty() ? "." : ". " + note);
}

namespace {

/// Which crank angles the design is judged over, where that is a range of use.
std::string range_of_use_text(const Json& document, const UnitsOf& units) {
    const Json& used = list_in(document, "used_crank_angles");
    if (used.size() != 2) return {};
    const std::string unit = units.of_input();
    return fmt::format(
        "<p>Range of use: {}s from {} {} to {} {}. Quantities, plots and motion are over it; NAME{} is the "
        "quantity NAME over the whole motion.</p>",
        units.input_name(), cell_text(used[0]), unit, cell_text(used[1]), unit, whole_suffix);
}

/// Where the design stands close to a singular position, or why there is none like it.
std::string warnings_of(const Json& document) {
    std::string text;
    for (const Json& one : list_in(document, "warnings")) {
        const bool impossible = one.is_object() && one.value("impossible", Json(false)) == true;
        text += std::string("<p class=\"bad\">") + (impossible ? "Warning: " : "Close to a singular position. ") +
                escaped(impossible ? text_in(one, "name") + "."
                                   : fmt::format("{}: by {}, {} of the longest length.", text_in(one, "name"),
                                                 text_in(one, "margin"), text_in(one, "relative"))) +
                "</p>";
    }
    return text;
}

}  // namespace

std::string tables_of(const Json& document) {
    const UnitsOf units(document);
    const std::string defect = text_in(document, "defect");
    const std::string warning =
        defect.empty() ? "" : "<p class=\"bad\">Excluded by a defect: " + escaped(defect) + "</p>";
    return warning + warnings_of(document) + dimensions_table(document, units) + range_of_use_text(document, units) +
           table_of("First, in this order", {"", "value", "unit", "best", "allowed"}, wish_rows(document, units)) +
           table_of("Objective", {"", "value", "unit"}, objective_rows(object_in(document, "objective"), units)) +
           requirements_table(document, units) + in_details("Quantities", quantities_table(document, units)) +
           targets_table(document, units) + verification_table(document) + search_table(document);
}

}  // namespace mechwright

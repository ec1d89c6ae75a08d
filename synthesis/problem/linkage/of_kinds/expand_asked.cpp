// What is asked of a built-in kind, by quantities of the linkage that it is.

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <numbers>
#include <vector>

#include "synthesis/mechanism/linkage/quantities.h"
#include "synthesis/mechanism/whole_quantities.h"
#include "synthesis/problem/linkage/of_kinds/expanding.h"
#include "synthesis/problem/text.h"
#include "synthesis/problem/toml/made_table.h"
#include "synthesis/problem/units.h"
#include "synthesis/target/names.h"

namespace mechwright::reading {

namespace {

struct Asking {
    Expanding& e;
    bool full_turn;                    ///< of all designs
    std::vector<Assurance> assured{};  ///< by the quantities that are asked for

    void assure(const Counterpart& counterpart) {
        for (const Assurance& more : counterpart.assured)
            if (std::none_of(assured.begin(), assured.end(),
                             [&](const Assurance& one) { return one.quantity == more.quantity; }))
                assured.push_back(more);
    }
};

const Counterpart* find_counterpart(const Expanding& e, std::string_view quantity) {
    const auto at = std::find_if(e.as.quantities.begin(), e.as.quantities.end(),
                                 [&](const Counterpart& one) { return one.quantity == without_whole(quantity); });
    return at == e.as.quantities.end() ? nullptr : &*at;
}

void refuse_quantity(Asking& asking, const toml::node& node, std::string_view quantity, std::string_view why) {
    add_error(asking.e.messages, place_of(node), fmt::format("a linkage has no '{}': {}", quantity, why));
}

/// The names that stand for a quantity, and how it follows from them; empty where there are none, which is reported.
struct NamedCounterparts {
    std::vector<std::string> names{};
    Counterpart::By by = Counterpart::By::same;
};

/// Whether a quantity of the kind that is measured over its whole motion would be one over the input range of a target,
/// or over a range of use: signals and transmission angles of a linkage are.
bool loses_its_motion(const Expanding& e, const Counterpart& counterpart) {
    if (!has_moving_ends(e.problem) || counterpart.is.front().find('.') == std::string_view::npos) return false;
    const auto& over_input = e.problem.mechanism->input->quantities;
    return std::none_of(over_input.begin(), over_input.end(),
                        [&](const Quantity& quantity) { return quantity.name == counterpart.quantity; });
}

/// Whether a quantity is one that a target brings: these come after the mechanism's own.
bool is_of_target(const Mechanism& mechanism, int quantity) {
    return mechanism.plain && static_cast<std::size_t>(quantity) >= mechanism.plain->quantities.size();
}

bool is_of_room(const Mechanism& mechanism, int quantity) {
    return mechanism.quantities[static_cast<std::size_t>(quantity)].of.as<LinkageMeasure>() != nullptr;
}

NamedCounterparts counterpart_names(Asking& asking, const toml::node& node) {
    const std::string quantity = node.value_or(std::string());
    const Mechanism& mechanism = *asking.e.problem.mechanism;
    const int index = find_quantity(mechanism, quantity);
    const Counterpart* counterpart = find_counterpart(asking.e, quantity);
    if (counterpart == nullptr && index >= 0 && (is_of_target(mechanism, index) || is_of_room(mechanism, index)))
        return {{quantity}};
    if (counterpart == nullptr || counterpart->is.front().empty())
        return refuse_quantity(asking, node, quantity, counterpart ? counterpart->why_not : "leave it out"),
               NamedCounterparts{};
    if (counterpart->of_full_turn && !asking.full_turn)
        return refuse_quantity(
                   asking, node, quantity,
                   fmt::format("{} is the same where the crank turns fully, and this problem has designs whose crank "
                               "does not: require that in its place",
                               counterpart->is.front())),
               NamedCounterparts{};
    const bool loses = loses_its_motion(asking.e, *counterpart);
    if (loses && !asking.e.problem.use)
        return refuse_quantity(
                   asking, node, quantity,
                   "beside [line], [arc] or [function] its signals are measured over the input range alone"),
               NamedCounterparts{};
    asking.assure(*counterpart);
    const bool whole = loses || without_whole(quantity) != quantity;
    NamedCounterparts named{{}, counterpart->by};
    for (const std::string_view name : counterpart->is)
        if (!name.empty()) named.names.push_back(std::string(name) + std::string(whole ? whole_suffix : ""));
    return named;
}

std::string requirement_text(std::string_view quantity, const toml::table& limits) {
    std::string text = fmt::format("\n[[require]]\nquantity = \"{}\"\n", quantity);
    for (const char* key : {"equal", "min", "max"})
        if (const toml::node* node = limits.get(key)) text += fmt::format("{} = {}\n", key, value_text(*node));
    return text;
}

void write_requirement(Asking& asking, const toml::table& table) {
    const toml::node& node = *table.get("quantity");
    const NamedCounterparts named = counterpart_names(asking, node);
    if (named.names.empty()) return;
    const std::string quantity = node.value_or(std::string());
    const bool least = named.by == Counterpart::By::least;
    if (named.by != Counterpart::By::same && (table.contains("equal") || table.contains(least ? "max" : "min")))
        return refuse_quantity(asking, node, quantity,
                               fmt::format("it is the {} of several, which can only be limited by '{}'",
                                           least ? "least" : "greatest", least ? "min" : "max"));
    const Counterpart* counterpart = find_counterpart(asking.e, quantity);
    if (counterpart != nullptr && counterpart->least_limit)
        for (const auto& [key, limit] : table)
            if (limit.is_number() &&
                from_file_unit(limit.value_or(0.0), Unit::angle, asking.e.problem.units) < *counterpart->least_limit)
                return refuse_quantity(asking, limit, quantity,
                                       fmt::format("only limits of {} deg or more on it can be said by signals",
                                                   *counterpart->least_limit * 180 / std::numbers::pi));
    for (const std::string& name : named.names)
        asking.e.text += requirement_text(name, table);
}

/// A term whose quantity is the least or greatest of several: a list of which the worst counts.
void write_objective(Asking& asking, const toml::table& table, bool alone) {
    const bool maximize = table.contains("maximize");
    const char* sense = maximize ? "maximize" : "minimize";
    const toml::node& asked = *table.get(sense);
    std::vector<std::string> names;
    bool several = false;
    const auto take = [&](const toml::node& node) {
        NamedCounterparts named = counterpart_names(asking, node);
        const bool worst = named.by == (maximize ? Counterpart::By::least : Counterpart::By::greatest);
        if (named.by != Counterpart::By::same && (!worst || !alone))
            refuse_quantity(asking, node, node.value_or(std::string()),
                            fmt::format("it is the {} of several, which can only be {} alone",
                                        named.by == Counterpart::By::least ? "least" : "greatest",
                                        named.by == Counterpart::By::least ? "maximized" : "minimized"));
        several = several || worst;
        std::move(named.names.begin(), named.names.end(), std::back_inserter(names));
    };
    if (const toml::array* list = asked.as_array())
        for (const toml::node& one : *list)
            take(one);
    else
        take(asked);
    std::string quoted_names;
    for (const std::string& name : names)
        quoted_names += fmt::format("{}\"{}\"", quoted_names.empty() ? "" : ", ", name);
    const bool as_list = asked.is_array() || several;
    asking.e.text += alone ? "\n[objective]\n" : "\n[[objective]]\n";
    asking.e.text += fmt::format("{} = {}\n", sense, as_list ? fmt::format("[{}]", quoted_names) : quoted_names);
    if (several && !table.contains("reduce")) asking.e.text += "reduce = \"max\"\n";
    for (const char* key : {"reduce", "weight", "rank", "within"})
        if (const toml::node* node = table.get(key)) asking.e.text += fmt::format("{} = {}\n", key, value_text(*node));
}

bool flag_of_target(const Expanding& e, std::string_view section, std::string_view key) {
    const toml::table* table = only_table(e.table, section);
    return table != nullptr && (*table)[key].value_or(false);
}

/// Whether each design that the problem can have turns its crank fully.
bool turns_fully(const Expanding& e) {
    if (flag_of_target(e, "path", "closed") ||
        std::ranges::any_of(sections_of_shapes, [&](auto shape) { return flag_of_target(e, shape, "full_turn"); }))
        return true;
    std::vector<double> dimensions;
    for (std::size_t i = 0; i < e.problem.dimensions.size(); ++i) {
        const Dimension& d = e.problem.mechanism->dimensions[i];
        const auto design = e.put_in.as_starts ? std::nullopt : e.number_of_design(d.name);
        if (!design && !e.problem.dimensions[i].fixed() && !e.is_of_target(i)) return false;
        dimensions.push_back(design ? from_file_unit(*design, unit_of(d.kind), e.problem.units)
                                    : e.problem.dimensions[i].min);
    }
    const std::size_t assembly = e.assembly_of_design().value_or(e.problem.assemblies.front());
    return motion_of(*e.problem.mechanism, dimensions, assembly, nullptr).full_turn;
}

void write_assurance(Expanding& e, const Assurance& one) {
    const auto number = [&](double value) { return in_file_unit(value, one.unit, e.problem.units); };
    e.text += fmt::format("\n[[require]]                       # {}\nquantity = \"{}\"\n", one.why, one.quantity);
    if (one.min) e.text += fmt::format("min = {}\n", number(*one.min));
    if (one.max) e.text += fmt::format("max = {}\n", number(*one.max));
}

template <class Use>
void for_each_table(const toml::node* node, const Use& use) {
    if (node == nullptr) return;
    if (const toml::table* one = node->as_table()) use(*one, true);
    if (const toml::array* list = node->as_array())
        for (const toml::node& entry : *list)
            use(*entry.as_table(), list->size() == 1);
}

}  // namespace

void write_asked(Expanding& e) {
    Asking asking{e, turns_fully(e)};
    // What time ratios, swings and strokes are of makes the crank turn, too.
    for_each_table(e.table.get("require"), [&](const toml::table& table, bool) {
        const Counterpart* counterpart = find_counterpart(e, table["quantity"].value_or(std::string()));
        asking.full_turn = asking.full_turn || (counterpart != nullptr && !counterpart->assured.empty());
    });
    for_each_table(e.table.get("require"), [&](const toml::table& table, bool) { write_requirement(asking, table); });
    for_each_table(e.table.get("objective"),
                   [&](const toml::table& table, bool alone) { write_objective(asking, table, alone); });
    for (const Assurance& one : asking.assured)
        write_assurance(e, one);
}

}  // namespace mechwright::reading

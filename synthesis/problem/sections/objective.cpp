#include <fmt/format.h>

#include "synthesis/problem/schema/keys.h"
#include "synthesis/problem/sections/sections.h"
#include "synthesis/problem/text.h"

namespace mechwright::reading {

namespace {

/// The one of 'minimize' and 'maximize' that an objective has; null, and reported, if it has none or both.
const toml::node* find_sense(Section& section, Messages& messages) {
    const toml::node* minimize = find(section, "minimize");
    const toml::node* maximize = find(section, "maximize");
    if (minimize != nullptr && maximize != nullptr)
        add_error(messages, place_of(section, "maximize"),
                  "one objective cannot have both 'minimize' and 'maximize': write one [[objective]] for each");
    else if (minimize == nullptr && maximize == nullptr)
        add_error(messages, section.place, "an objective needs 'minimize' or 'maximize' with the name of a quantity");
    else
        return minimize != nullptr ? minimize : maximize;
    return nullptr;
}

struct Context {
    const Section& file;
    const Problem& problem;
    Messages& messages;
};

void add_term(const toml::node& node, const Section& section, double weight, Objective& objective,
              const Context& context) {
    const bool maximize = has(section, "maximize");
    const auto quantity =
        to_quantity(node, maximize ? "'maximize'" : "'minimize'", context.file, context.problem, context.messages);
    if (quantity) objective.terms.push_back({*quantity, maximize, weight});
}

void read_worst(const toml::array& list, Section& section, Objective& objective, const Context& context) {
    objective.worst = true;
    if (!has(section, "reduce"))
        add_error(context.messages, place_of(list),
                  "a list of quantities needs reduce = \"max\" (its worst counts); for a sum write one [[objective]] "
                  "for each");
    read_choice(section, "reduce", "reduction", context.messages);
    if (list.empty())
        add_error(context.messages, place_of(list), "this list of quantities is empty: name at least one");
    for (const toml::node& node : list)
        add_term(node, section, 1, objective, context);
}

Objective read_single(Section& section, const Context& context) {
    Objective objective;
    const toml::node* sense = find_sense(section, context.messages);
    if (sense != nullptr && sense->is_array()) {
        read_worst(*sense->as_array(), section, objective, context);
    } else {
        if (find(section, "reduce") != nullptr && sense != nullptr)
            add_error(context.messages, place_of(section, "reduce"),
                      R"('reduce' needs a list of quantities: ["first", "second"])");
        if (sense != nullptr) add_term(*sense, section, 1, objective, context);
    }
    if (const toml::node* weight = find(section, "weight"); weight != nullptr)
        add_error(context.messages, place_of(*weight),
                  "'weight' has no effect on a single objective: leave it out, or write [[objective]] for a sum");
    report_unknown_keys(section, context.messages);
    return objective;
}

void read_weighted(const toml::node& node, Objective& objective, const Context& context) {
    if (!node.is_table())
        return report_kind(node, "an entry of 'objective'", "a section, headed [[objective]]", context.messages);
    Section section{node.as_table(), "[[objective]]", place_of(node), keys::objective};
    const toml::node* sense = find_sense(section, context.messages);
    const double weight = read_number(section, "weight", context.messages).value_or(1);
    report_unknown_keys(section, context.messages);
    if (weight <= 0)
        add_error(context.messages, place_of(section, "weight"),
                  fmt::format("'weight' must be greater than 0, not {}", weight));
    if (sense != nullptr) add_term(*sense, section, weight, objective, context);
}

Objective read_sum(const toml::array& list, const Context& context) {
    Objective objective;
    if (list.empty())
        add_error(context.messages, place_of(list),
                  "'objective' is empty: leave it out to ask for any feasible design");
    for (const toml::node& node : list)
        read_weighted(node, objective, context);
    return objective;
}

}  // namespace

void read_objective(Section& file, Problem& problem, Messages& messages) {
    const toml::node* node = find(file, "objective");
    if (node == nullptr) return;
    const Context context{file, problem, messages};
    if (node->is_array()) {
        problem.objective = read_sum(*node->as_array(), context);
    } else if (node->is_table()) {
        Section section{node->as_table(), "[objective]", place_of(*node), keys::objective};
        problem.objective = read_single(section, context);
    } else {
        report_kind(*node, "'objective'", "a section, headed [objective], or several headed [[objective]]", messages);
    }
}

}  // namespace mechwright::reading

#include <fmt/format.h>

#include <algorithm>

#include "synthesis/problem/schema/keys.h"
#include "synthesis/problem/sections/sections.h"
#include "synthesis/problem/text.h"
#include "synthesis/problem/units.h"

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
    for (const char* key : {"weight", "rank", "within"})
        if (const toml::node* node = find(section, key))
            add_error(context.messages, place_of(*node),
                      fmt::format("'{}' has no effect on a single objective: leave it out, or write [[objective]] for "
                                  "each of several",
                                  key));
    report_unknown_keys(section, context.messages);
    return objective;
}

/// One of several objectives.
struct Entry {
    FilePlace place{};
    FilePlace within_place{};
    std::int64_t rank = 1;
    std::optional<double> within{};  ///< in the file's unit
    Objective objective{};           ///< of one term, or of none where it could not be read
};

std::optional<Entry> read_entry(const toml::node& node, const Context& context) {
    if (!node.is_table()) {
        report_kind(node, "an entry of 'objective'", "a section, headed [[objective]]", context.messages);
        return {};
    }
    Section section{node.as_table(), "[[objective]]", place_of(node), keys::objective};
    const toml::node* sense = find_sense(section, context.messages);
    const double weight = read_number(section, "weight", context.messages).value_or(1);
    Entry entry;
    entry.rank = read_whole_number(section, "rank", context.messages).value_or(1);
    entry.within = read_number(section, "within", context.messages);
    entry.place = place_of(section, "rank");
    entry.within_place = place_of(section, "within");
    report_unknown_keys(section, context.messages);
    if (weight <= 0)
        add_error(context.messages, place_of(section, "weight"),
                  fmt::format("'weight' must be greater than 0, not {}", weight));
    if (entry.rank < 1)
        add_error(context.messages, entry.place, fmt::format("'rank' must be 1 or greater, not {}", entry.rank));
    if (entry.within && *entry.within < 0)
        add_error(context.messages, entry.within_place,
                  fmt::format("'within' must be 0 or greater, not {}", *entry.within));
    if (sense != nullptr) add_term(*sense, section, weight, entry.objective, context);
    return entry;
}

/// Entries of the last rank are summed; of each rank before that there is one, which is a wish.
void read_several(const toml::array& list, Problem& problem, const Context& context) {
    if (list.empty())
        add_error(context.messages, place_of(list),
                  "'objective' is empty: leave it out to ask for any feasible design");
    std::vector<Entry> entries;
    for (const toml::node& node : list)
        if (auto entry = read_entry(node, context)) entries.push_back(std::move(*entry));
    std::stable_sort(entries.begin(), entries.end(), [](const Entry& a, const Entry& b) { return a.rank < b.rank; });
    Objective last;
    for (std::size_t i = 0; i < entries.size(); ++i) {
        const Entry& entry = entries[i];
        if (entry.rank == entries.back().rank) {
            if (entry.within)
                add_error(context.messages, entry.within_place,
                          "'within' has no effect on an objective that none comes after: give one of a higher 'rank'");
            last.terms.insert(last.terms.end(), entry.objective.terms.begin(), entry.objective.terms.end());
        } else if (i > 0 && entries[i - 1].rank == entry.rank) {
            add_error(context.messages, entry.place,
                      fmt::format("two objectives have rank {}: only those of the last rank are summed, give this one "
                                  "a rank of its own",
                                  entry.rank));
        } else if (!entry.objective.terms.empty()) {
            const ObjectiveTerm& term = entry.objective.terms.front();
            const Unit unit = problem.mechanism->quantities[term.quantity].unit;
            problem.wishes.push_back({term, from_file_unit(entry.within.value_or(0), unit, problem.units)});
        }
    }
    problem.objective = std::move(last);
}

}  // namespace

void read_objective(Section& file, Problem& problem, Messages& messages) {
    const toml::node* node = find(file, "objective");
    if (node == nullptr) return;
    const Context context{file, problem, messages};
    if (node->is_array()) {
        read_several(*node->as_array(), problem, context);
    } else if (node->is_table()) {
        Section section{node->as_table(), "[objective]", place_of(*node), keys::objective};
        problem.objective = read_single(section, context);
    } else {
        report_kind(*node, "'objective'", "a section, headed [objective], or several headed [[objective]]", messages);
    }
}

}  // namespace mechwright::reading

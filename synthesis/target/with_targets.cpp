#include "synthesis/target/with_targets.h"

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

#include "synthesis/target/followed/numbers.h"
#include "synthesis/target/function/numbers.h"
#include "synthesis/target/over_input/numbers.h"
#include "synthesis/target/path/numbers.h"

namespace mechwright {

namespace {

bool is_among(std::string_view name, std::span<const std::string_view> names) {
    return std::find(names.begin(), names.end(), name) != names.end();
}

/// Numbers that stand together, the targets that have them, and the name of the one that [dimensions] can give.
struct Numbers {
    std::array<std::string_view, 3> of;
    std::string_view given;
    void (*add)(Mechanism&);
};

constexpr std::array<Numbers, 6> all_numbers{{
    {{"path", "poses", "instant"}, "crank-start", add_crank_start},
    {{"poses"}, "body-angle", add_body_angle},
    {{"function", "line", "arc"},
     "",
     [](Mechanism& m) { m.over_input.empty() ? add_input_range(m) : add_numbers_over_input(m); }},
    {{"function"},
     "",
     [](Mechanism& m) {
         if (m.function) add_output_range(m);
     }},
    {{"line"},
     "",
     [](Mechanism& m) {
         if (m.line) add_shape(m, *m.line);
     }},
    {{"arc"},
     "",
     [](Mechanism& m) {
         if (m.arc) add_shape(m, *m.arc);
     }},
}};

void add_numbers(Mechanism& m, std::span<const std::string_view> names) {
    std::array<bool, 6> there{};
    for (const std::string& target : m.targets)
        for (std::size_t i = 0; i < there.size(); ++i) {
            const Numbers& numbers = all_numbers[i];
            const bool asked = (!numbers.given.empty() && is_among(numbers.given, names)) ||
                               std::any_of(numbers.of.begin(), numbers.of.end(),
                                           [&](std::string_view section) { return is_among(section, names); });
            if (!asked || there[i] || !is_among(target, numbers.of)) continue;
            numbers.add(m);
            there[i] = true;
        }
}

/// What it cannot be asked for here is left out, so that nothing measures it with numbers that it has not.
void leave_out_unasked(Mechanism& m, std::span<const std::string_view> names) {
    if (m.body && m.point->roles.body == no_dimension) m.body.reset();
    if (!is_among("function", names)) m.function.reset();
    if (!is_among("line", names)) m.line.reset();
    if (!is_among("arc", names)) m.arc.reset();
    if (!is_among("instant", names)) m.at_instant.clear();
}

void add_quantities(Mechanism& m, std::span<const std::string_view> names) {
    const auto add = [&](const std::vector<Quantity>& some) {
        m.quantities.insert(m.quantities.end(), some.begin(), some.end());
    };
    if (!m.guided.empty()) {
        add(quantities_of_targets(m));
    } else {
        if (m.point && is_among("path", names)) add(path_quantities());
        if (m.body && is_among("poses", names)) add(pose_quantities());
    }
    if (m.function) add(m.function->quantities);
    if (m.line) add(m.line->quantities);
    if (m.arc) add(m.arc->quantities);
    add(quantities_over_input(m));
    for (Quantity& q : m.at_instant)
        q.reads = q.reads.and_then(m.point->roles.start, 1);
    add(m.at_instant);
}

Mechanism made_for(const std::shared_ptr<const Mechanism>& kind, std::span<const std::string_view> names) {
    Mechanism made = *kind;
    made.plain = kind;
    add_numbers(made, names);
    leave_out_unasked(made, names);
    add_quantities(made, names);
    return made;
}

}  // namespace

std::shared_ptr<const Mechanism> with_targets(const std::shared_ptr<const Mechanism>& mechanism,
                                              std::span<const std::string_view> names) {
    if (!mechanism->plain) return mechanism;
    Mechanism made = made_for(mechanism->plain, names);
    made.whole = mechanism;
    return std::make_shared<const Mechanism>(std::move(made));
}

std::shared_ptr<const Mechanism> with_all_targets(std::shared_ptr<const Mechanism> kind) {
    if (kind->targets.empty()) return kind;
    const std::vector<std::string_view> all(kind->targets.begin(), kind->targets.end());
    return std::make_shared<const Mechanism>(made_for(kind, all));
}

}  // namespace mechwright

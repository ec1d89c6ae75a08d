#include "synthesis/mechanism/explanations/explanations.h"

#include <algorithm>
#include <map>
#include <mutex>
#include <vector>

namespace mechwright {

namespace {

std::vector<Explanation> all_explanations() {
    std::vector<Explanation> all;
    const auto add = [&](const Explanation& one) {
        const auto is_same = [&](const Explanation& e) { return e.name == one.name; };
        if (std::none_of(all.begin(), all.end(), is_same)) all.push_back(one);
    };
    for (const auto& part : {linkage_explanations(), ram_explanations(), target_explanations()})
        std::for_each(part.begin(), part.end(), add);
    for (const auto& mechanism : mechanisms()) {
        const auto own = mechanism->explanations ? mechanism->explanations() : std::vector<Explanation>{};
        std::for_each(own.begin(), own.end(), add);
    }
    return all;
}

}  // namespace

std::span<const Explanation> explanations() {
    // Mechanisms are added, never taken away: what is said of fewer stays as it is for whoever reads it.
    static std::mutex guard;
    static std::map<std::size_t, const std::vector<Explanation>> by_number;
    const std::lock_guard lock(guard);
    const std::size_t number = mechanisms().size();
    const auto at = by_number.find(number);
    return at != by_number.end() ? at->second : by_number.emplace(number, all_explanations()).first->second;
}

const Explanation* find_explanation(std::string_view quantity) {
    const auto all = explanations();
    const auto found = std::find_if(all.begin(), all.end(), [&](const Explanation& e) { return e.name == quantity; });
    return found == all.end() ? nullptr : &*found;
}

std::optional<FormulaText> formula_for(const Explanation& explanation, const Mechanism& mechanism) {
    for (const QuantityFormula& own : mechanism.formulas)
        if (own.quantity == explanation.name) return FormulaText{own.text, own.source};
    for (const Formula& formula : explanation.formulas)
        if (mechanism.meaning.find(formula.of) != std::string::npos) return FormulaText{formula.text, formula.source};
    return std::nullopt;
}

}  // namespace mechwright

#include "synthesis/mechanism/explanations/explanations.h"

#include <algorithm>

namespace mechwright {

std::span<const Explanation> explanations() {
    static const std::vector<Explanation> all = [] {
        std::vector<Explanation> joined;
        for (const auto& part : {linkage_explanations(), ram_explanations(), target_explanations(), cam_explanations()})
            joined.insert(joined.end(), part.begin(), part.end());
        return joined;
    }();
    return all;
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

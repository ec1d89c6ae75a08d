#include "synthesis/mechanism/explanations/explanations.h"

#include <algorithm>

namespace mechwright {

namespace {

bool applies(const Formula& formula, const Mechanism& mechanism) {
    return formula.of.empty() || formula.of == mechanism.name ||
           (mechanism.name == "cam" && mechanism.meaning.find(formula.of) != std::string_view::npos);
}

}  // namespace

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

const Formula* formula_for(const Explanation& explanation, const Mechanism& mechanism) {
    const auto found = std::find_if(explanation.formulas.begin(), explanation.formulas.end(),
                                    [&](const Formula& formula) { return applies(formula, mechanism); });
    return found == explanation.formulas.end() ? nullptr : &*found;
}

}  // namespace mechwright

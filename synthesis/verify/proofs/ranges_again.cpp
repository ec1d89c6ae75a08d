#include "synthesis/verify/proofs/ranges_again.h"

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <string_view>
#include <vector>

#include "synthesis/problem/input_tasks.h"

namespace mechwright {

namespace {

/// Whether only a crank that turns fully can be the answer: the path closes, a line or an arc is followed by one that
/// turns, or a quantity is named that nothing else has.
bool has_to_turn(const ProofContext& c) {
    const Claim& claim = *c.design.claim;
    if (claim.path && claim.path->closed) return true;
    if (must_turn_fully(claim)) return true;
    if (claim.crank_range || claim.path || !input_tasks(claim).empty()) return false;
    const auto& families = claim.mechanism->families;
    const auto limited = std::find_if(families.begin(), families.end(), [](const Family& f) { return !f.full_turn; });
    if (limited == families.end()) return true;
    Motion motion = c.design.motion;
    motion.family = static_cast<std::size_t>(limited - families.begin());
    motion.full_turn = false;
    motion.from = 0;
    motion.to = 1;
    const auto lacks = [&](std::size_t quantity) {
        const Quantity& q = claim.mechanism->quantities[quantity];
        return q.path == PathMeasure::none && !q.defined(motion);
    };
    return std::any_of(claim.requirements.begin(), claim.requirements.end(),
                       [&](const ClaimedRequirement& r) { return lacks(r.quantity); }) ||
           (claim.objective && std::any_of(claim.objective->terms.begin(), claim.objective->terms.end(),
                                           [&](const ClaimedTerm& t) { return lacks(t.quantity); }));
}

/// The greatest value of what a condition needs to be at least 0, over the ranges; tied dimensions move together.
Digits50 greatest(const ProofContext& c, const AtLeast& condition) {
    const Claim& claim = *c.design.claim;
    std::vector<Digits50> coefficient(claim.design.size(), Digits50(0));
    Digits50 sum = 0;
    const auto add = [&](std::string_view name, int sign) {
        const auto i = static_cast<std::size_t>(find_dimension(*claim.mechanism, name));
        const auto& given = claim.given[i];
        if (!given || !given->tied()) {
            coefficient[i] += sign;
            return;
        }
        for (const auto& [other, times] : given->tie.terms)
            coefficient[other] += sign * Digits50(times);
        sum += sign * from_document(given->tie.constant, unit_of(claim.mechanism->dimensions[i].kind), claim.units);
    };
    for (const std::string_view name : condition.plus)
        add(name, 1);
    for (const std::string_view name : condition.minus)
        add(name, -1);
    for (std::size_t i = 0; i < coefficient.size(); ++i) {
        if (coefficient[i] == 0) continue;
        const DigitsRange range = range_again(c, i, Strictness::loosened);
        sum += coefficient[i] * (coefficient[i] > 0 ? range.greatest : range.least);
    }
    return sum;
}

}  // namespace

Finding check_ranges_again(const ProofContext& c) {
    if (!c.infeasible) return fails("it says nothing of the best design");
    const auto ways_again = c.problem.mechanism->ways_again;
    if (!ways_again) return fails("ranges exclude no mechanism of this kind");
    const std::vector<Way> ways = ways_again(has_to_turn(c));
    std::string why;
    for (const Way& way : ways) {
        const auto missed =
            std::find_if(way.begin(), way.end(), [&](const AtLeast& condition) { return greatest(c, condition) < 0; });
        if (missed == way.end())
            return fails("there are dimensions in the ranges that meet the conditions of a motion");
        if (why.find(missed->why) == std::string::npos) why += (why.empty() ? "" : "; ") + std::string(missed->why);
    }
    return holds("within the ranges it cannot be that " + why);
}

}  // namespace mechwright

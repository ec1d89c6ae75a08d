#include "synthesis/verify/proofs/proof_context.h"

#include <algorithm>
#include <limits>

#include "synthesis/problem/units.h"

namespace mechwright {

namespace {

/// What a limit on lengths may be missed by where all limits are 0: the longest length that any design has.
Digits50 longest_of_all(const ProofContext& c) {
    Digits50 longest = 0;
    for (std::size_t i = 0; i < c.problem.dimensions.size(); ++i)
        if (c.problem.mechanism->dimensions[i].kind == DimensionKind::length)
            longest = std::max(longest, range_again(c, i, Strictness::exact).greatest);
    return longest;
}

Digits50 room_of(const ProofContext& c, Unit unit, const ClaimedRequirement& r) {
    Digits50 scale = unit == Unit::none || unit == Unit::angle ? 1 : 0;
    for (const auto& limit : {r.equal, r.min, r.max})
        if (limit) scale = std::max<Digits50>(scale, abs(from_document(*limit, unit, c.problem.units)));
    if (scale == 0) {
        const Digits50 longest = longest_of_all(c);
        scale = unit == Unit::area ? Digits50(longest * longest) : unit == Unit::curvature ? 1 / longest : longest;
    }
    return c.design.claim->tolerance * scale;
}

}  // namespace

const Quantity* single_objective(const ProofContext& c, bool maximize) {
    const auto& objective = c.problem.objective;
    if (!objective || objective->terms.size() != 1 || objective->terms.front().maximize != maximize) return nullptr;
    return &c.problem.mechanism->quantities[objective->terms.front().quantity];
}

DigitsRange asked_again(const ProofContext& c, std::string_view quantity, Strictness limits) {
    const Digits50 any = std::numeric_limits<Digits50>::infinity();
    DigitsRange asked{-any, any};
    for (const ClaimedRequirement& r : c.design.claim->requirements) {
        const Quantity& q = c.problem.mechanism->quantities[r.quantity];
        if (q.name != quantity) continue;
        const Digits50 room = limits == Strictness::loosened ? room_of(c, q.unit, r) : Digits50(0);
        for (const auto& least : {r.equal, r.min})
            if (least)
                asked.least = std::max<Digits50>(asked.least, from_document(*least, q.unit, c.problem.units) - room);
        for (const auto& greatest : {r.equal, r.max})
            if (greatest)
                asked.greatest =
                    std::min<Digits50>(asked.greatest, from_document(*greatest, q.unit, c.problem.units) + room);
    }
    return asked;
}

DigitsRange range_again(const ProofContext& c, std::size_t dimension, Strictness limits) {
    const Claim& claim = *c.design.claim;
    const auto& given = claim.given[dimension];
    if (!given) return {0, 0};
    const Unit unit = unit_of(claim.mechanism->dimensions[dimension].kind);
    if (given->tied()) {
        const auto unbounded = std::numeric_limits<Digits50>::infinity();
        const Digits50 constant = from_document(given->tie.constant, unit, claim.units);
        DigitsRange sum{constant, constant};
        for (const auto& [other, times] : given->tie.terms) {
            const auto& parent = claim.given[other];
            if (!parent || parent->tied()) return {-unbounded, unbounded};
            const DigitsRange of = range_again(c, other, limits);
            sum.least += times * (times > 0 ? of.least : of.greatest);
            sum.greatest += times * (times > 0 ? of.greatest : of.least);
        }
        return sum;
    }
    const Digits50 least = from_document(given->min, unit, claim.units);
    const Digits50 greatest = from_document(given->max, unit, claim.units);
    if (limits == Strictness::exact || least == greatest) return {least, greatest};
    const Digits50 room = claim.tolerance * std::max<Digits50>(abs(least), abs(greatest));
    return {least - room, greatest + room};
}

}  // namespace mechwright

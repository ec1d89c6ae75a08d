#include "synthesis/exact/poses/counted_dyads.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "synthesis/exact/guided_parts.h"

namespace mechwright {

namespace {

constexpr std::string_view not_independent =
    "the targets are special, like poses without a turn: their conditions on dyads depend on each other, so that whole "
    "families meet them or none, and none are listed; one target less leaves a family that is searched";

}  // namespace

std::vector<RealDyad> counted_dyads(const std::vector<Displacement>& displacements,
                                    const std::vector<ExactDisplacement>& exact, SolutionCounts& counts,
                                    bool& complete) {
    const DyadSolutions found = dyads_through(std::span<const Displacement, 4>(displacements));
    std::array<ExactCondition, 4> conditions;
    if (exact.size() == 4) std::transform(exact.begin(), exact.end(), conditions.begin(), exact_condition);
    std::size_t distinct = found.dyads.size(), singular = found.singular;
    std::vector<RealDyad> dyads;
    const PartedDyads fine = exact.size() == 4 && singular > 0 ? parted(found, conditions) : PartedDyads{};
    if (fine.real.size() + fine.others > distinct) {
        distinct = fine.real.size() + fine.others;
        singular -= std::min(singular, distinct - found.dyads.size());
        for (const CertifiedDyad& dyad : fine.real)
            dyads.push_back({dyad.dyad, dyad});
    } else {
        for (const ComplexDyad& dyad : found.dyads) {
            const auto real = real_dyad(dyad);
            if (!real) continue;
            RealDyad one{*real, {}};
            if (exact.size() == 4) one.proof = certified(*real, conditions);
            if (one.proof) one.dyad = one.proof->dyad;
            dyads.push_back(std::move(one));
        }
    }
    counts.tracked += 4;
    counts.distinct += distinct;
    counts.at_infinity += found.at_infinity;
    counts.singular += singular;
    complete = complete && found.isolated && distinct + found.at_infinity == 4;
    return dyads;
}

std::size_t certified_of(const std::vector<RealDyad>& dyads) {
    return static_cast<std::size_t>(
        std::count_if(dyads.begin(), dyads.end(), [](const RealDyad& one) { return one.proof.has_value(); }));
}

std::string why_not_so_many_targets(std::string_view linkages, std::size_t count, std::string_view targets) {
    if (count < 2) return fmt::format("it needs from two to five {}, and there is one", targets);
    if (count <= 5) return {};
    return fmt::format(
        "it finds {} through up to five {}, and there are {}: through more no linkage passes in "
        "general; least-squares finds the closest",
        linkages, targets, count);
}

ExactDesigns with_count_noted(const Problem& problem, ExactDesigns out) {
    if (out.counts && out.counts->distinct + out.counts->at_infinity + out.counts->singular < out.counts->tracked)
        out.note = not_independent;
    else if (out.counts && out.counts->singular > 0)
        out.note = some_are_singular;
    claim_no_more_than_seen(problem, out);
    rank(problem, out);
    return out;
}

}  // namespace mechwright

#include "synthesis/solve/why_infeasible.h"

#include <algorithm>
#include <string_view>

#include "synthesis/exact/closed_form/closed_form.h"
#include "synthesis/proof/empty_ranges.h"
#include "synthesis/proof/known_limits.h"

namespace mechwright {

namespace {

/// What a closed form proves of a problem that asks for less.
std::shared_ptr<const Proof> proof_of(const Problem& relaxed) {
    if (!why_no_closed_form(relaxed).empty()) return nullptr;
    const auto outcome = solve_in_closed_form(relaxed);
    return outcome && outcome->infeasible ? outcome->proof : nullptr;
}

/// Of the strokes and transmission angle of a drive, whatever else is asked for.
std::shared_ptr<const Proof> proof_by_strokes(const Problem& problem) {
    Problem relaxed = problem;
    relaxed.objective.reset();
    std::erase_if(relaxed.requirements, [&](const Requirement& r) {
        const std::string_view name = problem.mechanism->quantities[r.quantity].name;
        const bool transmission = name == "transmission-angle-worst" || name == "transmission-angle-min";
        return !((name == "time-ratio" || name == "stroke") && r.equal) && !(transmission && r.min && !r.max);
    });
    return proof_of(relaxed);
}

/// Of the smallest cam under limits on pressure angle or curvature, whatever is to be least or greatest.
std::shared_ptr<const Proof> proof_by_size(const Problem& problem) {
    for (const char* size : {"prime-radius", "base-radius", "pivot-distance"}) {
        const int quantity = find_quantity(*problem.mechanism, size),
                  dimension = find_dimension(*problem.mechanism, size);
        if (quantity < 0 || dimension < 0) continue;
        Problem relaxed = problem;
        relaxed.objective = Objective{{{static_cast<std::size_t>(quantity), false, 1}}};
        DimensionRange& range = relaxed.dimensions[static_cast<std::size_t>(dimension)];
        range.max = std::max(range.min, std::min(range.max, asked_of(problem, size).greatest));
        if (auto proof = proof_of(relaxed)) return proof;
    }
    return nullptr;
}

}  // namespace

std::shared_ptr<const Proof> why_infeasible(const Problem& problem) {
    if (auto proof = proof_by_limits(problem)) return proof;
    if (auto proof = proof_by_ranges(problem)) return proof;
    if (auto proof = proof_by_size(problem)) return proof;
    return proof_by_strokes(problem);
}

}  // namespace mechwright

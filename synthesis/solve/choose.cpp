#include "synthesis/solve/choose.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "synthesis/document/document.h"
#include "synthesis/search/optima.h"
#include "synthesis/verify/verify.h"

namespace mechwright {

namespace {

/// By name, the first check that a design does not pass.
std::string defect_of(const std::vector<Check>& checks) {
    const auto failed = std::find_if(checks.begin(), checks.end(), [](const Check& c) { return !c.passed; });
    if (failed == checks.end()) return checks.empty() ? "it was not verified" : "";
    return failed->name + (failed->detail.empty() ? "" : ": " + failed->detail);
}

/// Which of the designs already taken (0: the best one) draws the curve of another.
std::optional<std::size_t> cognate_of(const Problem& problem, const Result& result, const Solution& other) {
    if (!problem.path || has_input_range(problem) || !problem.mechanism->point->draws_same_curve) return std::nullopt;
    const auto draws_same_curve = problem.mechanism->point->draws_same_curve;
    const auto is_cognate = [&](const Solution& known) {
        return draws_same_curve(known.design.dimensions, other.design.dimensions);
    };
    if (is_cognate(*result.best)) return 0;
    for (std::size_t i = 0; i < result.alternatives.size(); ++i)
        if (is_cognate(result.alternatives[i].solution)) return i + 1;
    return std::nullopt;
}

/// Whether a design is of no interest beside those already taken: in a flat valley searches end at many places.
bool is_known(const Problem& problem, const Result& result, const Solution& other) {
    constexpr double alike_within = 1e-2;
    const auto is_like = [&](const Solution& known) {
        return same_design(problem, known.design, other.design, alike_within);
    };
    return (result.best && is_like(*result.best)) ||
           std::any_of(result.alternatives.begin(), result.alternatives.end(),
                       [&](const VerifiedDesign& d) { return is_like(d.solution); });
}

}  // namespace

std::vector<Check> checks_of(const Problem& problem, const Solution& solution) {
    Result alone;
    alone.status = Status::solved;
    alone.best = solution;
    return verify_design(document(problem, alone), Stated::everything);
}

void choose_verified(const Problem& problem, Found& found, const RunEnd& end, Result& result) {
    const std::vector<Solution>& candidates = found.candidates;
    constexpr std::size_t most_alternatives = 10;
    auto proof = std::exchange(result.search.proof, nullptr);
    bool is_first = false;
    result.status = Status::solved;
    for (std::size_t i = 0; i < candidates.size() && candidates[i].feasible; ++i) {
        if ((!result.best && i >= found.most_tried) || (i > 0 && end.reached())) break;
        if (result.alternatives.size() + result.excluded.size() >= most_alternatives) break;
        if (is_known(problem, result, candidates[i])) continue;
        std::vector<Check> checks = i == 0 && !found.checks_of_first.empty() ? std::move(found.checks_of_first)
                                                                             : checks_of(problem, candidates[i]);
        if (!all_passed(checks)) {
            result.excluded.push_back({candidates[i], defect_of(checks)});
        } else if (result.best) {
            result.alternatives.push_back(
                {candidates[i], std::move(checks), cognate_of(problem, result, candidates[i])});
        } else {
            is_first = i == 0;
            result.best = candidates[i];
            result.verification = std::move(checks);
        }
    }
    if (!result.best) {
        result.best = candidates.front();
        result.verification = checks_of(problem, candidates.front());
        result.excluded.erase(result.excluded.begin());
    }
    // What a method proved of its best design does not hold for the next.
    if (is_first) result.search.proof = std::move(proof);
}

void choose_all_verified(const Problem& problem, Found& found, const RunEnd& end, Result& result) {
    for (Solution& candidate : found.candidates) {
        if (&candidate != &found.candidates.front() && end.reached()) {
            found.stopped = true;
            found.report.proof = result.search.proof = nullptr;
            break;
        }
        std::vector<Check> checks = checks_of(problem, candidate);
        if (!all_passed(checks)) {
            found.excluded.push_back({std::move(candidate), defect_of(checks)});
            continue;
        }
        ++result.search.solutions->defect_free;
        if (result.best) {
            const auto cognate = cognate_of(problem, result, candidate);
            result.alternatives.push_back({std::move(candidate), std::move(checks), cognate});
        } else {
            result.best = std::move(candidate);
            result.verification = std::move(checks);
        }
    }
    result.search.local_optima = static_cast<int>(result.search.solutions->defect_free);
}

}  // namespace mechwright

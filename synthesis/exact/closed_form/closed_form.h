#pragma once
/// \file
/// Closed forms as methods: which problems they cover, and what they say of them.

#include <limits>
#include <optional>
#include <string>

#include "synthesis/program/proof.h"
#include "synthesis/program/result.h"

namespace mechwright {

struct ClosedFormOutcome {
    std::optional<Solution> best;  ///< the optimum, or where the problem is infeasible the best that can be had
    bool infeasible = false;       ///< proved
    /// Of an infeasible problem the least that would do of what is to be least; infinite where nothing would.
    double least = std::numeric_limits<double>::infinity();
    std::shared_ptr<const Proof> proof{};  ///< that this is the whole answer
};

/// Why no closed form covers a problem; empty if one does. One that covers a problem may still not conclude it, where
/// ranges of dimensions cut its optimum off.
std::string why_no_closed_form(const Problem& problem);

/// The answer in closed form, if there is one. Precondition: why_no_closed_form is empty.
std::optional<ClosedFormOutcome> solve_in_closed_form(const Problem& problem);

/// Keeps the better of two answers to one problem: one that is feasible, then the smaller objective. Where neither is,
/// all designs that are shown are as large as is allowed, and the answer that would do with less counts; where none
/// would do with anything, the one that misses less.
void keep_smaller(std::optional<ClosedFormOutcome>& best, ClosedFormOutcome outcome);

/// The smallest of all assemblies, each of which is answered by `of_assembly`; its proof has the parts of all. Nothing
/// where one of them has no answer.
template <class CertificateKind, class OfAssembly>
std::optional<ClosedFormOutcome> best_of_assemblies(const Problem& problem, const OfAssembly& of_assembly) {
    std::optional<ClosedFormOutcome> best;
    CertificateKind all;
    for (const std::size_t assembly : problem.assemblies) {
        std::optional<ClosedFormOutcome> outcome = of_assembly(assembly);
        if (!outcome) return std::nullopt;
        const auto& one = std::get<CertificateKind>(outcome->proof->certificate);
        all.parts.insert(all.parts.end(), one.parts.begin(), one.parts.end());
        keep_smaller(best, *std::move(outcome));
    }
    if (!best) return best;
    all.dimension = std::get<CertificateKind>(best->proof->certificate).dimension;
    best->proof = proof_by(best->proof->argument, std::move(all));
    return best;
}

/// One closed form: whether it covers a problem, its answer if so, and what it is good for in half a sentence.
struct ClosedForm {
    bool (*covers)(const Problem&);
    std::optional<ClosedFormOutcome> (*solve)(const Problem&);
    std::string_view good_for;
};

/// Crank-rockers of given swing and time ratio; ram-driving mechanisms of given time ratio and perhaps stroke.
ClosedForm crank_rocker_closed_form();
ClosedForm slider_crank_closed_form();
ClosedForm crank_shaper_closed_form();
ClosedForm whitworth_closed_form();

/// The smallest cams under limits on pressure angle or curvature.
ClosedForm translating_cam_closed_form();
ClosedForm oscillating_cam_closed_form();
ClosedForm flat_cam_closed_form();
ClosedForm swinging_flat_cam_closed_form();

}  // namespace mechwright

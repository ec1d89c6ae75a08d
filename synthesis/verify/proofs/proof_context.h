#pragma once
/// \file
/// What the checks of certificates have in common: the document, what it asks for in fifty digits, and what was found.

#include <string>
#include <string_view>

#include "synthesis/document/claim_json.h"
#include "synthesis/problem/problem.h"
#include "synthesis/verify/rebuilt.h"

namespace mechwright {

/// What a certificate was found to show: nothing wrong, or why it does not hold.
struct Finding {
    std::string defect;
    std::string shown;
};

inline Finding holds(std::string shown) { return {{}, std::move(shown)}; }
inline Finding fails(std::string why) { return {std::move(why), {}}; }

struct ProofContext {
    const claims::Json& document;
    const claims::Json& search;
    const claims::Json& certificate;
    const Rebuilt& design;
    const Problem& problem;  ///< as the document has it
    bool infeasible;         ///< is what is said to be proven, else the best
};

/// The one quantity that is to be greatest or least; null where there are none or several.
const Quantity* single_objective(const ProofContext& c, bool maximize);

/// Two numbers, angles in radians.
struct DigitsRange {
    Digits50 least;
    Digits50 greatest;
};

/// Whether limits count as they stand, or with what the tolerance of the document lets pass.
enum class Strictness { exact, loosened };

/// What all requirements together ask of a quantity; infinite where they ask nothing.
DigitsRange asked_again(const ProofContext& c, std::string_view quantity, Strictness limits);

/// Where a dimension may lie, ties resolved; of one that was not given 0.
DigitsRange range_again(const ProofContext& c, std::size_t dimension, Strictness limits);

}  // namespace mechwright

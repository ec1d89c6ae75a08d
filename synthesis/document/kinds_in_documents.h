#pragma once
/// \file
/// Kinds of mechanism of which documents say more than dimensions and an assembly: what was given of them, and what
/// their designs choose. A kind's folder in `synthesis/mechanism` writes and reads it.

#include <nlohmann/json.hpp>
#include <span>
#include <string>
#include <string_view>

#include "synthesis/document/claim.h"
#include "synthesis/document/claim_json.h"
#include "synthesis/problem/problem.h"

namespace mechwright {

struct KindInDocuments {
    std::string_view mechanism;                 ///< its name, which several mechanisms can share
    const char* given;                          ///< the member for what was given
    std::span<const std::string_view> choices;  ///< members of a design
    nlohmann::ordered_json (*given_of)(const Problem& problem);
    void (*put_choices)(nlohmann::ordered_json& design, const Problem& problem, std::size_t assembly);
    /// The choices in words: "turning counter-clockwise; cycloidal rise, dwell".
    std::string (*choices_text)(const Problem& problem, std::size_t assembly);
    /// Makes the claim one of the mechanism that is meant, with the assembly of its design.
    void (*read)(claims::Reader& in, const nlohmann::ordered_json& document, Claim& claim);
    /// Why the choices of a design are none of those that the problem allows, or what is proven leaves some of these
    /// out; empty where neither is so.
    std::string (*choices_defect)(const nlohmann::ordered_json& document, const Problem& problem);
};

std::span<const KindInDocuments> kinds_in_documents();

/// That of a mechanism, or null.
const KindInDocuments* kind_in_documents(const Mechanism& mechanism);

}  // namespace mechwright

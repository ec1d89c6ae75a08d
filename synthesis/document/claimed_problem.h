#pragma once
/// \file
/// The design of a result document as the problem that it answers, for whoever wants to evaluate it further.

#include "synthesis/document/claim.h"
#include "synthesis/program/result.h"

namespace mechwright {

struct ClaimedDesign {
    Problem problem;
    Design design;
};

/// Numbers are taken as the reader of problem files takes them. File and title, which a claim does not have, are left
/// empty.
ClaimedDesign claimed_design(const Claim& claim);

/// Why the claimed design cannot be evaluated; empty if it can.
std::string why_not_evaluable(const Claim& claim);

}  // namespace mechwright

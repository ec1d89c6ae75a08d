#pragma once
/// \file
/// What guides a body, before it is a design: the crank and the second dyad.

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "synthesis/exact/exact_designs.h"
#include "synthesis/exact/homotopy/guidance_system.h"
#include "synthesis/exact/poses/dyads.h"

namespace mechwright {

struct GuidedParts {
    Dyad crank;
    homotopy::SecondDyad kind = homotopy::SecondDyad::rocker;
    /// Of a ram `fixed` is the direction square to its line, of a block `moving` that square to the body's line, in the
    /// first place.
    Dyad second;
};

/// What the second dyad of a problem's mechanism is; nothing where it guides in another way.
std::optional<homotopy::SecondDyad> second_dyad(const Problem& problem);

/// Whether a problem's mechanism is described by its links.
bool is_linkage(const Problem& problem);

/// Why the parts of a problem's mechanism do not say its design; empty if they do.
std::string why_no_parts(const Problem& problem);

/// As many dimensions as places can say of a linkage that guides a body: a pose says two, a point one. 10 of a
/// four-bar, 9 of the others.
std::size_t conditions_of(const Problem& problem);

/// Why a family that passes few places cannot be searched, since some of what may be chosen is given; empty if it can.
/// Of linkages alone: ranges of other mechanisms show that themselves.
std::string why_no_family(const Problem& problem);

/// Of a linkage whose guided body is not driven by its crank, but by something else: those dimensions of that with
/// ranges. Precondition: why_no_parts is empty.
std::optional<std::vector<std::size_t>> dimensions_of_drive(const Problem& problem);

/// Claims no proof that there is no design where what drives the body was looked at in samples of its motion.
void claim_no_more_than_seen(const Problem& problem, ExactDesigns& out);

/// The design of these parts, with the displacements of all places in their order from that in which the parts are
/// given; nothing where a link has no length.
std::optional<ExactDesign> exact_design(const Problem& problem, const GuidedParts& parts,
                                        std::span<const Displacement> displacements, const DrawingPlace& place);

}  // namespace mechwright

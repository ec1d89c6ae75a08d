#pragma once
/// \file
/// Whether every linkage errs by so much somewhere, for verification: in fifty digits, by convex hulls.
///
/// The loop equation of a four-bar and of a slider-crank is linear in three constants: at an input and an output a row
/// of four numbers is orthogonal to (k1, k2, k3, 1), and the determinant of four rows vanishes. The rows of the outputs
/// within e of one that is asked for lie on an arc of a circle or a parabola, and so in the triangle of its ends and
/// the point where its tangents there meet. The determinant is linear in every row: where it has one sign at all
/// corners, no linkage errs by less than e at all four places.

#include <array>
#include <span>
#include <vector>

#include "synthesis/mechanism/mechanism.h"

namespace mechwright {

/// An input, and the output asked for there; radians, or lengths.
struct AskedPlace {
    Digits50 input;
    Digits50 output;
};

enum class LoopKind { four_bar, slider_crank };

/// Whether four of the places exclude that any linkage errs by at most `error` at all of them. Sets of four are tried
/// in the order of how much they promise, and errors divided where the corners leave it open, up to a limit.
bool every_linkage_errs(LoopKind kind, const std::vector<AskedPlace>& places, const Digits50& error);

}  // namespace mechwright

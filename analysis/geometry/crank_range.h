#pragma once
/// \file
/// The crank angles that a motion covers.

namespace mechwright {

/// Where the crank can be: a full turn, or from `from` to `to` (radians, counter-clockwise).
template <class T>
struct CrankRange {
    bool full_turn;
    T from;
    T to;
    /// The linkage assembles in a second range too, the mirror image of this one about the ground line.
    bool mirrored = false;
};

}  // namespace mechwright

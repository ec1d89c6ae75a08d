#pragma once
/// \file
/// A program without what keeps a linkage closed over its motion: for the first steps of searches, which that would
/// take the most of the time of.

#include "synthesis/program/program.h"

namespace mechwright {

/// Whether a program has rows that keep its design closed over a motion and are dear: margins whose least values are
/// looked for at every evaluation, as those of linkages are.
bool has_margins_of_motion(const Program& program);

/// The same program without these rows, nor what is computed for them alone. Variables are the same; what is feasible
/// for the program is feasible for this one.
Program without_margins(Program program);

}  // namespace mechwright

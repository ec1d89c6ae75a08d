#pragma once
/// \file
/// Sketches for SolveSpace (https://solvespace.com), a free parametric CAD program: the mechanism with its constraints,
/// so that it can be moved there by dragging.

#include <string>

#include "synthesis/report/drawing/scene.h"

namespace mechwright {

/// A .slvs file with one sketch in the xy plane. Links are lines of fixed length between pins that are joined where
/// the mechanism joins them; pivots are held; a ram stays on its slide and a block on its arm. Paths are construction
/// lines. A cam is its profile as lines and arcs. Precondition: the mechanism assembles at the crank angle.
std::string sketch_of(const FinishedDesign& design, const Scene& scene, double crank_angle);

}  // namespace mechwright

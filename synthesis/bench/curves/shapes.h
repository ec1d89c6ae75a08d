#pragma once
/// \file
/// Shapes that no linkage draws: letters, hearts, feet, airfoils, loops, noisy ovals, all about 20 mm in size; what a
/// path in any order is tried on.

#include <string>
#include <vector>

#include "analysis/geometry/vector.h"

namespace mechwright::bench {

struct Shape {
    std::string name;
    std::vector<Vector<double>> points;
    bool closed;
    double longest = 200;       ///< limit of every length and coordinate, mm
    std::string requirement{};  ///< of the problem file, as a section
};

std::vector<Shape> shapes();

/// The problem file of a shape: a four-bar of least path-rms with every dimension to be found.
std::string problem_text(const Shape& shape, int seed);

}  // namespace mechwright::bench

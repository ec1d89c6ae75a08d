#pragma once
/// \file
/// Published answers to the path problems of the literature, and their sum of squared distances from the targets.

#include <cstddef>
#include <vector>

#include "analysis/four_bar.h"

namespace mechwright::test {

struct PublishedPath {
    const char* source;
    FourBar<double> links;
    CouplerPoint<double> point;
    Placement<double> placement;
    std::vector<double> crank_angles;  ///< from the ground link; radians
    double sse;                        ///< sum of squared distances
    double last_digit;                 ///< half a unit in the last digit given of it
    Assembly assembly = Assembly::open;
};

inline double sum_of_squares(const PublishedPath& path, const std::vector<Vector<double>>& targets, Assembly assembly) {
    double sum = 0;
    for (std::size_t i = 0; i < targets.size(); ++i) {
        const auto p = pose(path.links, path.crank_angles[i], assembly);
        const auto off = miss(position(path.links, path.point, p), path.placement, targets[i]);
        sum += dot(off, off);
    }
    return sum;
}

inline double sum_of_squares(const PublishedPath& path, const std::vector<Vector<double>>& targets) {
    return sum_of_squares(path, targets, path.assembly);
}

}  // namespace mechwright::test

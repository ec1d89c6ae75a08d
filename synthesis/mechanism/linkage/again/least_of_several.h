#pragma once
/// \file
/// What is least of several functions of the poses of a linkage, as it is sampled along its motion.

#include <algorithm>
#include <cstddef>
#include <limits>
#include <vector>

#include "synthesis/mechanism/linkage/again/measured.h"

namespace mechwright::again {

/// The least over the motion of several functions of a pose, of(k, pose) for k < count: of those that come near to the
/// least at the samples.
template <class Of>
Digits50 least_of_several(const Scan& scan, std::size_t count, const Of& of) {
    constexpr double near_best = 2e-2, infinity = std::numeric_limits<double>::infinity();
    std::vector<double> seen(count, infinity);
    double best = infinity, worst = -infinity;
    for (const double input : scan.at) {
        const SeriesSignals* sample = scan.look(input);
        for (std::size_t k = 0; sample && k < count; ++k) {
            const double one = of(k, sample->in_pose()).c[0];
            seen[k] = std::min(seen[k], one);
            best = std::min(best, one);
            worst = std::max(worst, one);
        }
    }
    Digits50 least = infinity;
    for (std::size_t k = 0; k < count; ++k)
        if (seen[k] <= best + near_best * (worst - best))
            least = std::min<Digits50>(
                least, least_of_poses(scan, [&of, k]<class T>(const PoseSignals<T>& pose) { return of(k, pose); }));
    return isfinite(least) ? least : Digits50(missing);
}

}  // namespace mechwright::again

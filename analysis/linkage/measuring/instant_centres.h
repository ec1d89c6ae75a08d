#pragma once
/// \file
/// Instant centres: for each pair of links the place at which both have the same velocity, where the one turns against
/// the other. Of n links there are n (n - 1) / 2; of three links the three centres lie in one line (Aronhold and
/// Kennedy).

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "analysis/linkage/placing/place.h"
#include "analysis/numbers/series.h"

namespace mechwright::linkage {

/// How a link moves: the velocity of a place on it, and its angular velocity.
struct LinkMotion {
    Vector<double> at{};
    Vector<double> velocity{};
    double turning = 0;

    Vector<double> velocity_at(const Vector<double>& place) const { return velocity + turning * left_of(place - at); }
};

struct InstantCentre {
    enum class Kind : std::uint8_t {
        place,        ///< `at`
        at_infinity,  ///< the links do not turn against each other: in the direction `at`, a unit vector of either
                      ///< sense
        everywhere    ///< they do not move against each other
    };
    std::size_t first = 0;
    std::size_t second = 0;
    Kind kind = Kind::everywhere;
    Vector<double> at{};
};

/// How all links move, from a pose in a series of the time, in which they close.
inline std::vector<LinkMotion> motions_of(const Pose<Series<double, 1>>& pose) {
    std::vector<LinkMotion> motions;
    for (const auto& link : pose.links) {
        const Vector<double> along{link.along.x.c[0], link.along.y.c[0]}, slope{link.along.x.c[1], link.along.y.c[1]};
        motions.push_back(
            {{link.origin.x.c[0], link.origin.y.c[0]}, {link.origin.x.c[1], link.origin.y.c[1]}, cross(along, slope)});
    }
    return motions;
}

/// The centres of all pairs, in the order (0, 1), (0, 2), (1, 2), (0, 3), ... The velocities of both links at a place x
/// are the same where w + (turning of the first - that of the second) J (x - o) = 0: o is the place by which the motion
/// of the first is given, w its velocity there less that of the second, J a right angle to the left. What is 1e-12 of
/// the greatest angular velocity, or velocity, is 0.
inline std::vector<InstantCentre> instant_centres(const std::vector<LinkMotion>& motions) {
    constexpr double rounding = 1e-12;
    double fastest = 0, greatest_turning = 0;
    for (const LinkMotion& motion : motions) {
        greatest_turning = std::max(greatest_turning, std::abs(motion.turning));
        for (const LinkMotion& other : motions) {
            const Vector<double> there = motion.velocity_at(other.at);
            fastest = std::max(fastest, std::hypot(there.x, there.y));
        }
    }
    std::vector<InstantCentre> centres;
    for (std::size_t second = 1; second < motions.size(); ++second)
        for (std::size_t first = 0; first < second; ++first) {
            const LinkMotion &a = motions[first], &b = motions[second];
            const Vector<double> w = a.velocity - b.velocity_at(a.at);
            const double turning = a.turning - b.turning, slip = std::hypot(w.x, w.y);
            InstantCentre centre{first, second};
            if (std::abs(turning) > rounding * greatest_turning) {
                centre.kind = InstantCentre::Kind::place;
                centre.at = a.at + (1 / turning) * left_of(w);
            } else if (slip > rounding * fastest) {
                centre.kind = InstantCentre::Kind::at_infinity;
                centre.at = (1 / slip) * left_of(w);
            }
            centres.push_back(centre);
        }
    return centres;
}

}  // namespace mechwright::linkage

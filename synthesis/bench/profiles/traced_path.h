#pragma once
/// \file
/// Points of random linkages' own paths, and the problems of finding these again.

#include <cstdint>
#include <string>

namespace mechwright::bench {

/// Points of one turn of a linkage, and the problem of finding it again.
struct TracedPath {
    double size = 0;  ///< the farthest of the points from the first
    std::string text;
};

/// So many points of the k-th random six-bar, of Watt's first kind or Stephenson's third, in which no dyad comes nearer
/// to its limits than 20 deg. Its sides are given; every length, the placement and the crank angle of the first point
/// are to be found, with the crank angles from point to point or without.
TracedPath traced_six_bar(std::uint64_t k, bool watt, int count, bool timed);

/// So many timed points of the k-th random linkage of 4, 6, ... 12 links: a four-bar, and dyads that hang one on the
/// other. Sides are given, and the pivots of the third and fourth dyad; all else is to be found, in wide ranges or in
/// narrow ones about what is known.
TracedPath traced_chain(std::uint64_t k, int links, int count, bool about_known = false);

}  // namespace mechwright::bench

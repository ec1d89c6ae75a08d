#pragma once
/// \file
/// The start system of the nine-point problem: parameters at which all its solutions are known, one of each orbit of
/// six (three cognates, whose dyads can be exchanged). It is made once, by monodromy, and kept with the program.

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>

#include "synthesis/exact/homotopy/nine_point_paths.h"

namespace mechwright::homotopy {

/// Cognate triplets of nine generic points (Wampler, Morgan and Sommese 1992).
inline constexpr std::size_t nine_point_triplets = 1442;

struct NinePointStart {
    NinePointParameters parameters;
    std::vector<NinePointValues> solutions;
};

/// What all members of an orbit have in common: the sum of the three fixed pivots, and of their conjugates.
struct OrbitKey {
    Complex<double> pivots;
    Complex<double> conjugates;
    double rounding = 0;  ///< of both, where the moving pivots lie close together
};

OrbitKey orbit_of(const NinePointValues& solution);

/// Whether two keys agree but for rounding.
bool is_same(const OrbitKey& a, const OrbitKey& b);

/// Orbits that have been seen, found again quickly.
class SeenOrbits {
public:
    /// The number that was given with an orbit, or nothing if it is new; then it is kept with this one.
    std::optional<std::size_t> find_or_keep(const OrbitKey& key, std::size_t number);
    std::size_t size() const { return keys_.size(); }

private:
    struct Entry {
        OrbitKey key;
        std::size_t number;
    };
    std::vector<Entry> keys_;  ///< by the real part of the pivots
    double most_rounding_ = 0;
};

/// From one random linkage and the points that it meets: loops in the space of parameters, along which its solutions
/// exchange places, until all triplets are known or `most_loops` have been gone round. `progress` is told how many
/// there are.
NinePointStart make_nine_point_start(std::uint64_t seed, int jobs, int most_loops,
                                     const std::function<void(std::size_t known, int loops)>& progress);

/// A text that parse_nine_point_start reads; numbers to nine digits, which refinement completes.
std::string to_text(const NinePointStart& start, std::uint64_t seed);

struct ReadStart {
    std::optional<NinePointStart> start;
    std::string fault;  ///< what is wrong with the text, where there is none
};

/// Reads, refines and checks a start system: all solutions must solve it, and no two may be of one orbit.
ReadStart parse_nine_point_start(std::string_view text);

/// The one that comes with the program.
const NinePointStart& nine_point_start();

}  // namespace mechwright::homotopy

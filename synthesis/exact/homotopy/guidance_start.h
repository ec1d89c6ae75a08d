#pragma once
/// \file
/// Start systems: parameters at which all solutions of a guidance system are known, one of each orbit. They are made
/// once, by monodromy, and kept with the program.
///
/// Two solutions are of one orbit if they differ in which dyad is called the crank's. With one pose alone nothing but
/// points is asked for, and Roberts' cognates are of one orbit too: six solutions in each. A slider-crank has one
/// cognate, with the same crank pivot.

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>

#include "synthesis/exact/homotopy/guidance_paths.h"

namespace mechwright::homotopy {

/// How many orbits generic parameters have, by the number of poses: cognate triplets of nine points (Wampler, Morgan
/// and Sommese 1992), pairs of dyads of poses and points (as monodromy finds them from three seeds); cognate pairs of
/// slider-cranks through eight points, slider-cranks and inverted slider-cranks through poses and points (as monodromy
/// finds them; tests/exact/slider_crank_count.cpp has the trace test).
constexpr std::size_t orbits_of(const GuidanceSystem& system) {
    constexpr std::array<std::size_t, GuidanceSystem::most_poses> four_bars{1442, 1112, 201, 30};
    constexpr std::array<std::size_t, GuidanceSystem::most_poses> slider_cranks{279, 202, 42, 6};
    constexpr std::array<std::size_t, GuidanceSystem::most_poses> inverted{2220, 448, 56, 6};
    if (system.second == SecondDyad::block) return inverted[system.poses - 1];
    return (system.second == SecondDyad::ram ? slider_cranks : four_bars)[system.poses - 1];
}

/// How that is known: "the literature", "monodromy", "monodromy and a trace test". Both of the latter are done in
/// doubles.
std::string_view evidence_of(const GuidanceSystem& system);

/// All systems that there are start systems of.
std::vector<GuidanceSystem> every_system();

/// "nine-point", "2-poses-6-points", "slider-crank-eight-point", "inverted-slider-crank-2-poses-5-points", ...
std::string name_of(const GuidanceSystem& system);

/// The system of this name.
std::optional<GuidanceSystem> find_system(std::string_view name);

struct StartSystem {
    GuidanceSystem system;
    GuidanceParameters parameters{};
    std::vector<GuidanceValues> solutions;
};

/// What all members of an orbit have in common: the sum of the fixed pivots, of all three with one pose alone, and of
/// their conjugates.
struct OrbitKey {
    Complex<double> pivots;
    Complex<double> conjugates;
    double rounding = 0;  ///< of both, where the moving pivots lie close together
};

OrbitKey orbit_of(const GuidanceSystem& system, const GuidanceValues& solution);

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

/// From one random linkage and the places that it passes: loops in the space of parameters, along which its solutions
/// exchange places, until as many orbits as expected are known or `most_loops` have been gone round. `progress` is told
/// how many there are.
StartSystem make_start_system(const GuidanceSystem& system, std::uint64_t seed, int jobs, int most_loops,
                              std::size_t expected, const std::function<void(std::size_t known, int loops)>& progress);

/// A text that parse_start_system reads; numbers to nine digits, which refinement completes.
std::string to_text(const StartSystem& start, std::uint64_t seed);

struct ReadStart {
    std::optional<StartSystem> start;
    std::string fault;  ///< what is wrong with the text, where there is none
};

/// Reads, refines and checks a start system: all solutions must solve it, and no two may be of one orbit.
ReadStart parse_start_system(std::string_view text);

/// The one that comes with the program.
const StartSystem& start_system(const GuidanceSystem& system);

}  // namespace mechwright::homotopy

#pragma once
/// \file
/// How the geometry of each follower stands in the registry.

#include <array>
#include <cstddef>

#include "analysis/cam/flat_follower.h"
#include "analysis/cam/roller_follower.h"
#include "synthesis/mechanism/cam/motion_program.h"

namespace mechwright::cam {

/// Of every follower; those with fewer geometric dimensions leave the last ones alone.
inline constexpr std::size_t most_geometry = 4;

/// `geometry`: how many of the first dimensions the follower is made of; `make`: the follower.
template <template <class> class Follower>
struct Layout;

template <>
struct Layout<TranslatingRoller> {
    static constexpr std::size_t geometry = 3;
    static constexpr bool roller = true;
    static constexpr bool oscillating = false;
    template <class T>
    static TranslatingRoller<T> make(const std::array<T, most_geometry>& g, int sense) {
        return {g[0], g[1], g[2], sense};
    }
};

template <>
struct Layout<OscillatingRoller> {
    static constexpr std::size_t geometry = 4;
    static constexpr bool roller = true;
    static constexpr bool oscillating = true;
    template <class T>
    static OscillatingRoller<T> make(const std::array<T, most_geometry>& g, int sense) {
        return {g[0], g[1], g[2], g[3], sense};
    }
};

template <>
struct Layout<TranslatingFlat> {
    static constexpr std::size_t geometry = 1;
    static constexpr bool roller = false;
    static constexpr bool oscillating = false;
    template <class T>
    static TranslatingFlat<T> make(const std::array<T, most_geometry>& g, int sense) {
        return {g[0], sense};
    }
};

template <>
struct Layout<OscillatingFlat> {
    static constexpr std::size_t geometry = 3;
    static constexpr bool roller = false;
    static constexpr bool oscillating = true;
    template <class T>
    static OscillatingFlat<T> make(const std::array<T, most_geometry>& g, int sense) {
        return {g[0], g[1], g[2], sense};
    }
};

template <template <class> class Follower>
constexpr ProgramSlots slots{Layout<Follower>::geometry};

/// How many dimensions a cam with this follower has.
template <template <class> class Follower>
constexpr std::size_t dimension_count = slots<Follower>.end();

/// The follower of these dimensions, in numbers that are made of theirs.
template <template <class> class Follower, class T, class Number>
Follower<T> follower_of(std::span<const Number> dimensions, std::size_t assembly) {
    std::array<T, most_geometry> g{};
    for (std::size_t i = 0; i < Layout<Follower>::geometry; ++i)
        g[i] = T(dimensions[i]);
    return Layout<Follower>::make(g, sense_of(assembly));
}

}  // namespace mechwright::cam

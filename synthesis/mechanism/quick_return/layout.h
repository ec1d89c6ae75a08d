#pragma once
/// \file
/// How the dimensions of a ram-driving mechanism stand in the registry, and which of them are its links.

#include <array>
#include <cstddef>

#include "analysis/quick_return.h"

namespace mechwright::quick_return {

/// `reads`: how many of the first dimensions the motion of the ram depends on; `links`: the indices of the link
/// lengths; `make`: the mechanism of these dimensions.
template <template <class> class Drive>
struct Layout;

template <>
struct Layout<SliderCrank> {
    static constexpr std::size_t reads = 3;
    static constexpr std::array<std::size_t, 2> links{0, 1};
    template <class T>
    static SliderCrank<T> make(const std::array<T, reads>& x, std::size_t) {
        return {x[0], x[1], x[2]};
    }
};

template <>
struct Layout<CrankShaper> {
    static constexpr std::size_t reads = 5;
    static constexpr std::array<std::size_t, 4> links{0, 1, 2, 3};
    template <class T>
    static CrankShaper<T> make(const std::array<T, reads>& x, std::size_t) {
        return {x[0], x[1], x[2], x[3], x[4]};
    }
};

template <>
struct Layout<Whitworth> {
    static constexpr std::size_t reads = 5;
    static constexpr std::array<std::size_t, 4> links{0, 1, 2, 3};
    template <class T>
    static Whitworth<T> make(const std::array<T, reads>& x, std::size_t) {
        return {x[0], x[1], x[2], x[3], x[4]};
    }
};

template <>
struct Layout<DragLink> {
    static constexpr std::size_t reads = 9;
    static constexpr std::array<std::size_t, 6> links{0, 1, 2, 3, 4, 6};
    template <class T>
    static DragLink<T> make(const std::array<T, reads>& x, std::size_t assembly) {
        return {
            {x[0], x[1], x[2], x[3]}, x[4], x[5], x[6], x[7], x[8], assembly == 0 ? Assembly::open : Assembly::crossed};
    }
};

/// Families of every ram-driving mechanism: two strokes in each full turn, or any other motion.
enum FamilyIndex : std::size_t { full_turn, limited_range };

/// Index into Motion::settings.
inline constexpr std::size_t working_share = 0;

}  // namespace mechwright::quick_return

#pragma once
/// \file
/// Derivatives of what has many arguments by dual numbers that carry a few at a time.

#include <algorithm>
#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "analysis/numbers/dual.h"
#include "analysis/numbers/second_dual.h"

namespace mechwright {

inline constexpr std::size_t seeded_at_once = 8;

/// Calls use(seeded, from, count) for each few arguments in turn: `seeded` are all of them, and those from `from` on
/// carry the partial derivatives 0, 1, ...
template <class Use>
void by_few(std::span<const double> arguments, const Use& use) {
    using First = Dual<double, seeded_at_once>;
    const std::size_t n = arguments.size();
    for (std::size_t from = 0; from < n; from += seeded_at_once) {
        const std::size_t count = std::min(seeded_at_once, n - from);
        std::vector<First> seeded(arguments.begin(), arguments.end());
        for (std::size_t i = 0; i < count; ++i)
            seeded[from + i] = First::variable(arguments[from + i], i);
        use(std::span<const First>(seeded), from, count);
    }
}

/// The arguments whose derivatives a second dual carries; as many as there are arguments where it carries none.
using SeededPair = std::array<std::size_t, seeded_at_once>;

/// Calls use(seeded, carried) so often that every pair of arguments is carried together once at least.
template <class Use>
void by_pairs(std::span<const double> arguments, const Use& use) {
    constexpr std::size_t half = seeded_at_once / 2;
    using Second = SecondDual<double, seeded_at_once>;
    const std::size_t n = arguments.size(), blocks = (n + half - 1) / half;
    for (std::size_t b = 0; b < blocks; ++b)
        for (std::size_t a = 0; a <= b; ++a) {
            if (a == b && blocks > 1) continue;
            std::vector<Second> seeded(arguments.begin(), arguments.end());
            SeededPair carried{};
            for (std::size_t v = 0; v < seeded_at_once; ++v) {
                const std::size_t i = v < half ? a * half + v : b * half + v - half;
                const bool again = a == b && v >= half;
                carried[v] = i < n && !again ? i : n;
                if (carried[v] < n) seeded[i] = Second::variable(arguments[i], v);
            }
            use(std::span<const Second>(seeded), carried);
        }
}

/// Calls use(v, w, entry) for the carried pairs v >= w of a call, with the place of each in a lower triangle by rows.
template <class Use>
void for_each_pair(const SeededPair& carried, std::size_t arguments, const Use& use) {
    for (std::size_t v = 0; v < seeded_at_once; ++v)
        for (std::size_t w = 0; w <= v; ++w)
            if (carried[v] < arguments && carried[w] < arguments) {
                const auto [less, more] = std::minmax(carried[v], carried[w]);
                use(v, w, more * (more + 1) / 2 + less);
            }
}

}  // namespace mechwright

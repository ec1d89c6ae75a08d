#pragma once
/// \file
/// The quantities of the four-bar as smooth components (measured.h), each from the analysis of the mechanism.

#include <algorithm>
#include <array>
#include <cstddef>
#include <type_traits>

#include "analysis/four_bar.h"
#include "synthesis/mechanism/measured.h"

namespace mechwright::four_bar {

/// Indices into the families of the registry entry.
enum FamilyIndex : std::size_t { crank_rocker, double_crank, limited_range };

/// How many of the first dimensions are link lengths.
inline constexpr std::size_t links = 4;

template <class T>
FourBar<T> linkage(const std::array<T, links>& x) {
    return {x[0], x[1], x[2], x[3]};
}

inline Assembly assembly_of(const Motion& motion) { return motion.assembly == 0 ? Assembly::open : Assembly::crossed; }

inline TransmissionExtremes transmission_extremes_of(const Motion& motion) {
    return motion.full_turn ? transmission_extremes_of_full_turn() : transmission_extremes(motion.from, motion.to);
}

template <class T>
HalfTurn<T> constant(const HalfTurn<double>& half) {
    return {T(half.cosine), T(half.sine)};
}

/// The angle at extreme k of the motion; of a limited range the first two are its ends.
template <class T>
T transmission_angle_at(const Motion& motion, const TransmissionExtremes& extremes, std::size_t k,
                        const std::array<T, links>& x) {
    const HalfTurn<T> half = constant<T>(extremes.at[k]);
    return motion.full_turn || k > 1 ? transmission_angle(linkage(x), half)
                                     : transmission_angle_at_end(linkage(x), half);
}

struct Swing {
    static constexpr std::size_t reads = links;
    static constexpr std::size_t most = 1;
    template <class T>
    static std::size_t components(const Motion&, const std::array<T, links>& x, Components<T> out) {
        out[0] = swing(linkage(x));
        return 1;
    }
};

/// Slow over fast stroke: the greater of a ratio and its reciprocal, the two directions of the crank.
struct TimeRatio {
    static constexpr std::size_t reads = links;
    static constexpr std::size_t most = 2;
    template <class T>
    static std::size_t components(const Motion&, const std::array<T, links>& x, Components<T> out) {
        const T excess = stroke_excess(linkage(x));
        out[0] = (pi<double>() + excess) / (pi<double>() - excess);
        out[1] = (pi<double>() - excess) / (pi<double>() + excess);
        return 2;
    }
};

struct TransmissionAngleMin {
    static constexpr std::size_t reads = links;
    static constexpr std::size_t most = 4;
    template <class T>
    static std::size_t components(const Motion& motion, const std::array<T, links>& x, Components<T> out) {
        const auto extremes = transmission_extremes_of(motion);
        const std::size_t count = motion.full_turn ? 1 : extremes.count;  // over a full turn the least is at 0
        for (std::size_t k = 0; k < count; ++k)
            out[k] = transmission_angle_at(motion, extremes, k, x);
        return count;
    }
};

struct TransmissionAngleMax {
    static constexpr std::size_t reads = links;
    static constexpr std::size_t most = 4;
    template <class T>
    static std::size_t components(const Motion& motion, const std::array<T, links>& x, Components<T> out) {
        const auto extremes = transmission_extremes_of(motion);
        const std::size_t first = motion.full_turn ? 1 : 0;  // over a full turn the greatest is at pi
        for (std::size_t k = first; k < extremes.count; ++k)
            out[k - first] = transmission_angle_at(motion, extremes, k, x);
        return extremes.count - first;
    }
};

/// The least of the angle and its supplement.
struct TransmissionAngleWorst {
    static constexpr std::size_t reads = links;
    static constexpr std::size_t most = 8;
    template <class T>
    static std::size_t components(const Motion& motion, const std::array<T, links>& x, Components<T> out) {
        const std::size_t least = TransmissionAngleMin::components(motion, x, out);
        std::array<T, most> greatest{};
        const std::size_t count = TransmissionAngleMax::components<T>(motion, x, greatest);
        for (std::size_t k = 0; k < count; ++k)
            out[least + k] = pi<double>() - greatest[k];
        return least + count;
    }
};

/// The longest link over the shortest: every ratio that can be the greatest in the family.
struct LinkRatio {
    static constexpr std::size_t reads = links;
    static constexpr std::size_t most = 12;
    template <class T>
    static std::size_t components(const Motion& motion, const std::array<T, links>& x, Components<T> out) {
        std::size_t count = 0;
        for (std::size_t shortest = 0; shortest < links; ++shortest) {
            if (motion.family == crank_rocker && shortest != 1) continue;
            if (motion.family == double_crank && shortest != 0) continue;
            for (std::size_t longest = 0; longest < links; ++longest)
                if (longest != shortest) out[count++] = x[longest] / x[shortest];
        }
        return count;
    }
};

struct TotalLength {
    static constexpr std::size_t reads = links;
    static constexpr std::size_t most = 1;
    template <class T>
    static std::size_t components(const Motion&, const std::array<T, links>& x, Components<T> out) {
        out[0] = (x[0] + x[1]) + (x[2] + x[3]);
        return 1;
    }
};

struct GrashofMargin {
    static constexpr std::size_t reads = links;
    static constexpr std::size_t most = 3;
    template <class T>
    static std::size_t components(const Motion& motion, const std::array<T, links>& x, Components<T> out) {
        if (motion.family == limited_range) {
            out[0] = grashof_margin(linkage(x));
            return 1;
        }
        const auto m =
            motion.family == crank_rocker ? crank_rocker_margins(linkage(x)) : double_crank_margins(linkage(x));
        out[0] = m.ground_longest;
        out[1] = m.coupler_longest;
        out[2] = m.rocker_longest;
        return 3;
    }
};

/// Whether a motion goes through a crank angle and not only up to it.
inline bool goes_through(const Motion& motion, double crank_angle) {
    const double turn = 2 * pi<double>();
    const double next = crank_angle + turn * (std::floor((motion.from - crank_angle) / turn) + 1);
    return motion.full_turn || next < motion.to;
}

/// The greatest (sense = +1) or least (-1) stationary values of the velocity ratio, the worst first; where there are
/// fewer than there are places, the last is repeated. At change points it has the values from either side.
template <int sense>
struct VelocityRatioExtreme {
    static constexpr std::size_t reads = links;
    static constexpr std::size_t most = 5;
    static std::size_t places(const Motion& motion) { return motion.full_turn ? 3 : 5; }

    template <class T>
    static std::size_t components(const Motion& motion, const std::array<T, links>& x, Components<T> out) {
        return components(motion, x, out, fixed_ends<T>(motion));
    }

    template <class T>
    static std::size_t components(const Motion& motion, const std::array<T, links>& x, Components<T> out,
                                  const Ends<T>& ends) {
        const FourBar<T> m = linkage(x);
        const FourBar<double> plain = converted<double>(m);
        const Assembly assembly = assembly_of(motion);
        const CrankRange<double> range{motion.full_turn, motion.from, motion.to};
        const auto extremes = velocity_ratio_extremes(plain, assembly, range);
        struct Found {
            double angle;
            double value;
            const T* end;                      ///< null where the ratio is stationary
            const T* beside_change = nullptr;  ///< the ratio on one side of a change point
        };
        const auto ratio = [&]<class U>(const std::array<U, links>& lengths, const U& angle) {
            return velocity_ratio(linkage(lengths), angle, assembly);
        };
        std::array<std::array<T, 2>, 2> beside_changes{};
        std::array<Found, VelocityRatioExtremes::capacity + 4> found{};
        for (std::size_t i = 0; i < extremes.count; ++i) {
            const bool first = !motion.full_turn && i == 0, last = !motion.full_turn && i + 1 == extremes.count;
            found[i] = {extremes.at[i], velocity_ratio(plain, extremes.at[i], assembly),
                        first  ? &ends.from
                        : last ? &ends.to
                               : nullptr};
            if (found[i].end != nullptr && is_toggle(plain, half_turn(extremes.at[i])))
                found[i].value = velocity_ratio_at_toggle(plain, extremes.at[i], assembly);
        }
        std::size_t known = extremes.count;
        for (const bool away : {false, true}) {
            const HalfTurn<double> half = away ? HalfTurn<double>{0, 1} : HalfTurn<double>{1, 0};
            const double angle = away ? pi<double>() : 0;
            if (!is_toggle(plain, half) || !goes_through(motion, angle)) continue;
            beside_changes[away] = velocity_ratios_at_change_point(m, away);
            for (const T& beside : beside_changes[away])
                if (const double value = value_of(beside); std::isfinite(value))
                    found[known++] = {angle, value, nullptr, &beside};
        }
        // The worst first, of equals the one that comes first. A stable sort of the library would allocate.
        std::sort(found.begin(), found.begin() + static_cast<std::ptrdiff_t>(known),
                  [](const Found& a, const Found& b) {
                      return a.value != b.value ? sense * a.value > sense * b.value : a.angle < b.angle;
                  });
        const std::size_t count = places(motion);
        for (std::size_t k = 0; k < count; ++k) {
            if (known == 0) {  // no stationary point: the ratio is constant
                out[k] = velocity_ratio(m, T(1), assembly);
                continue;
            }
            const Found& f = found[std::min(k, known - 1)];
            if (f.beside_change != nullptr)
                out[k] = *f.beside_change;
            else if (std::isinf(f.value))  // at a toggle
                out[k] = T(f.value);
            else
                out[k] = f.end == nullptr ? at_stationary(x, f.angle, ratio) : ratio(x, *f.end);
        }
        return count;
    }
};

/// What must be >= 0 for a design to assemble over a limited range: both margins wherever they can be least.
struct AssemblyMargin {
    static constexpr std::size_t reads = links;
    static constexpr std::size_t most = 8;
    template <class T>
    static std::size_t components(const Motion& motion, const std::array<T, links>& x, Components<T> out) {
        const auto extremes = transmission_extremes_of(motion);
        for (std::size_t k = 0; k < extremes.count; ++k) {
            const auto margins = assembly_margins(linkage(x), constant<T>(extremes.at[k]));
            out[2 * k] = margins.stretch;
            out[2 * k + 1] = margins.fold;
        }
        return 2 * extremes.count;
    }
};

}  // namespace mechwright::four_bar

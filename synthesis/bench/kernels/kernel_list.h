#pragma once
/// \file
/// The kernels that are timed: for each a mechanism's dimensions, what follows from them at one position in orders 0
/// (where it is), 1 (how fast) and 2 (how its speed changes), by our formulas in any number type and by the textbook's
/// in double, and positions that are usual and hard.

#include <array>
#include <cmath>
#include <numbers>
#include <string_view>
#include <vector>

#include "analysis/cam/roller_follower.h"
#include "analysis/cam/segment.h"
#include "analysis/four_bar.h"
#include "analysis/numbers/low_discrepancy.h"
#include "analysis/quick_return.h"
#include "analysis/slider_crank.h"
#include "synthesis/bench/kernels/textbook.h"

namespace mechwright::bench {

/// Dimensions and a position: a crank angle, or the part of a cam's rise.
template <std::size_t N>
struct KernelInput {
    std::array<double, N> x;
    double at;
};

inline constexpr std::size_t usual_count = 256;

/// Numbers of (0, 1), spread evenly.
inline double spread(std::uint64_t k, std::size_t dimension) {
    static const LowDiscrepancy sequence(8, 1, 1);
    return sequence(k, dimension);
}

/// Crank angle that lies 2^-k beside another, and that next to it.
inline double beside(double angle, int k) { return angle * (1 - std::ldexp(1.0, -k)); }

struct CouplerPointKernel {
    static constexpr std::string_view name = "four-bar, coupler point";
    static constexpr std::string_view hard = "2^-k from a change point, crank 2^-k of the frame";
    static constexpr std::array<std::string_view, 3> orders{"position", "velocity", "acceleration"};
    static constexpr std::size_t size = 6;  ///< ground, crank, coupler, rocker, along, across
    using Input = KernelInput<size>;

    template <int order, class T>
    static Vector<T> ours(const std::array<T, size>& x, const HalfTurn<T>& half) {
        const FourBar<T> m{x[0], x[1], x[2], x[3]};
        const CouplerPoint<T> point{x[4], x[5]};
        const auto p = pose(m, half, Assembly::open);
        if constexpr (order == 0) {
            return position(m, point, p);
        } else {
            const auto v = velocity(m, p);
            if constexpr (order == 1)
                return velocity(m, point, p, v);
            else
                return acceleration(m, point, p, v, acceleration(m, p, v));
        }
    }
    template <int order, class T>
    static Vector<T> ours(const std::array<T, size>& x, const T& at) {
        return ours<order>(x, half_turn(at));
    }
    template <int order>
    static Vector<double> textbook(const std::array<double, size>& x, double at) {
        const auto a = textbook::four_bar_angles(x[0], x[1], x[2], x[3], at);
        const textbook::CouplerMotion point{x[4], x[5], x[1]};
        if constexpr (order == 0) return point.position(a);
        const auto w = textbook::four_bar_spins(x[1], x[2], x[3], a);
        if constexpr (order == 1) return point.velocity(a, w.coupler);
        return point.acceleration(a, w.coupler, textbook::coupler_turn(x[1], x[2], x[3], a, w));
    }
    /// Crank-rockers: the shortest link and three margins.
    static std::vector<Input> usual() {
        std::vector<Input> all;
        for (std::uint64_t k = 0; k < usual_count; ++k) {
            const double crank = 0.2 + spread(k, 0), p = 0.1 + spread(k, 1), q = 0.1 + spread(k, 2),
                         s = 0.1 + spread(k, 3);
            all.push_back(
                {{crank + (q + s) / 2, crank, crank + (p + s) / 2, crank + (p + q) / 2, spread(k, 4), spread(k, 5)},
                 2 * std::numbers::pi * spread(k, 6)});
        }
        return all;
    }
    static std::vector<Input> hard_ones() {
        std::vector<Input> all;
        for (int k = 10; k <= 40; k += 2) {
            const double hair = std::ldexp(1.0, -k);
            all.push_back({{4.5 - hair, 1, 3, 2.5, 0.5, 0.25}, beside(std::numbers::pi, k)});
            all.push_back({{3, hair, 2, 2.5, 0.5, 0.25}, 1.0 + 0.1 * k});
        }
        return all;
    }
};

struct SliderCrankKernel {
    static constexpr std::string_view name = "slider-crank, ram";
    static constexpr std::string_view hard = "rod 2^-k longer than crank and offset, crank 2^-k of the rod";
    static constexpr std::array<std::string_view, 3> orders{"position", "velocity", "acceleration"};
    static constexpr std::size_t size = 3;  ///< crank, rod, offset
    using Input = KernelInput<size>;

    template <int order, class T>
    static Vector<T> ours(const std::array<T, size>& x, const T& at) {
        const SliderCrank<T> m{x[0], x[1], x[2]};
        if constexpr (order == 0) return {ram_position(m, at), T(0)};
        if constexpr (order == 1) return {ram_velocity(m, at), T(0)};
        return {ram_acceleration(m, at), T(0)};
    }
    template <int order>
    static Vector<double> textbook(const std::array<double, size>& x, double at) {
        if constexpr (order == 0) return {textbook::ram_position(x[0], x[1], x[2], at), 0};
        if constexpr (order == 1) return {textbook::ram_velocity(x[0], x[1], x[2], at), 0};
        return {textbook::ram_acceleration(x[0], x[1], x[2], at), 0};
    }
    static std::vector<Input> usual() {
        std::vector<Input> all;
        for (std::uint64_t k = 0; k < usual_count; ++k) {
            const double crank = 0.2 + spread(k, 0), offset = spread(k, 1);
            all.push_back({{crank, crank + offset + 0.2 + spread(k, 2), offset}, 2 * std::numbers::pi * spread(k, 3)});
        }
        return all;
    }
    static std::vector<Input> hard_ones() {
        std::vector<Input> all;
        for (int k = 10; k <= 40; k += 2) {
            const double hair = std::ldexp(1.0, -k);
            all.push_back({{1, 1.5 + hair, 0.5}, beside(1.5 * std::numbers::pi, k)});
            all.push_back({{hair, 1.5, 1.5 - 4 * hair}, 3.0 + 0.1 * k});
        }
        return all;
    }
};

struct CrankShaperKernel {
    static constexpr std::string_view name = "crank shaper, ram";
    static constexpr std::string_view hard = "crank 2^-k shorter than the centre distance";
    static constexpr std::array<std::string_view, 3> orders{"position", "velocity", "acceleration"};
    static constexpr std::size_t size = 5;  ///< centre distance, crank, lever, rod, ram distance
    using Input = KernelInput<size>;

    template <int order, class T>
    static Vector<T> ours(const std::array<T, size>& x, const T& at) {
        const CrankShaper<T> m{x[0], x[1], x[2], x[3], x[4]};
        if constexpr (order == 0) return {ram_position(m, at), T(0)};
        if constexpr (order == 1) return {ram_velocity(m, at), T(0)};
        return {ram_acceleration(m, at), T(0)};
    }
    /// The lever is the crank of a slider-crank; its angle to the ram line is a right angle less than to the centres.
    template <int order>
    static Vector<double> textbook(const std::array<double, size>& x, double at) {
        const double lever = textbook::arm_angle(x[0], x[1], at) - std::numbers::pi / 2;
        if constexpr (order == 0) return {textbook::ram_position(x[2], x[3], -x[4], lever), 0};
        const double ratio = textbook::arm_ratio(x[0], x[1], at);
        const double velocity = textbook::ram_velocity(x[2], x[3], -x[4], lever);
        if constexpr (order == 1) return {velocity * ratio, 0};
        return {textbook::ram_acceleration(x[2], x[3], -x[4], lever) * ratio * ratio +
                    velocity * textbook::arm_ratio_rate(x[0], x[1], at),
                0};
    }
    static std::vector<Input> usual() {
        std::vector<Input> all;
        for (std::uint64_t k = 0; k < usual_count; ++k) {
            const double crank = 0.2 + 0.6 * spread(k, 0), lever = 1 + spread(k, 1);
            all.push_back({{1, crank, lever, 1 + spread(k, 2), lever}, 2 * std::numbers::pi * spread(k, 3)});
        }
        return all;
    }
    static std::vector<Input> hard_ones() {
        std::vector<Input> all;
        for (int k = 10; k <= 40; k += 2) {
            const double hair = std::ldexp(1.0, -k);
            all.push_back({{1, 1 - hair, 2, 1.5, 1.9}, beside(std::numbers::pi, k)});
        }
        return all;
    }
};

struct RollerKernel {
    static constexpr std::string_view name = "cam with roller";
    static constexpr std::string_view hard = "offset 2^-k less than the prime radius, lift 2^-k of it";
    static constexpr std::array<std::string_view, 3> orders{"lift", "pressure angle", "curvature"};
    static constexpr std::size_t size = 4;  ///< prime radius, offset, lift, angle of the rise
    using Input = KernelInput<size>;

    template <class T>
    static cam::Lift<T> lift(const std::array<T, size>& x, const T& at) {
        cam::Segment<T> rise;
        rise.kind = cam::SegmentKind::rise;
        rise.lift = x[2];
        rise.angle = x[3];
        return cam::lift_at(rise, 0, at, T(0));
    }
    template <int order, class T>
    static Vector<T> ours(const std::array<T, size>& x, const T& at) {
        const auto f = lift(x, at);
        if constexpr (order == 0) return {f.s, T(0)};
        const auto p = cam::pitch_point(cam::TranslatingRoller<T>{x[0], x[1], T(0), 1}, f);
        if constexpr (order == 1) return {cam::pressure_angle(p), T(0)};
        return {cam::curvature(p), T(0)};
    }
    template <int order>
    static Vector<double> textbook(const std::array<double, size>& x, double at) {
        const double turns = 2 * std::numbers::pi * at;
        const cam::Lift<double> f{x[2] * (at - std::sin(turns) / (2 * std::numbers::pi)),
                                  x[2] / x[3] * (1 - std::cos(turns)),
                                  2 * std::numbers::pi * x[2] / (x[3] * x[3]) * std::sin(turns), 0};
        if constexpr (order == 0) return {f.s, 0};
        if constexpr (order == 1) return {textbook::pressure_angle(x[0], x[1], f), 0};
        return {textbook::pitch_curvature(x[0], x[1], f), 0};
    }
    static std::vector<Input> usual() {
        std::vector<Input> all;
        for (std::uint64_t k = 0; k < usual_count; ++k)
            all.push_back({{1 + spread(k, 0), spread(k, 1), 0.1 + 0.5 * spread(k, 2), 1 + spread(k, 3)}, spread(k, 4)});
        return all;
    }
    static std::vector<Input> hard_ones() {
        std::vector<Input> all;
        for (int k = 10; k <= 40; k += 2) {
            const double hair = std::ldexp(1.0, -k);
            all.push_back({{1, 1 - hair, 0.25, 1}, 0.01 + 0.02 * k});
            all.push_back({{1, 0.5, hair, 1}, hair});
        }
        return all;
    }
};

}  // namespace mechwright::bench

#pragma once
/// \file
/// The coupler point of the four-bar as a path-guiding point (guided_point.h).

#include <cmath>

#include "analysis/four_bar.h"
#include "synthesis/mechanism/guided_point.h"

namespace mechwright::four_bar {

struct CouplerPath {
    static constexpr std::size_t reads = 9;

    /// x: ground, crank, coupler, rocker, point-along, point-across, origin-x, origin-y, tilt, crank angle.
    template <class T>
    static MissAndMargin<T> miss(std::size_t assembly, const std::array<T, reads + 1>& x,
                                 const Vector<double>& target) {
        const FourBar<T> links{x[0], x[1], x[2], x[3]};
        const auto p = pose(links, x[9], assembly == 0 ? Assembly::open : Assembly::crossed);
        const Vector<T> local = position(links, CouplerPoint<T>{x[4], x[5]}, p);
        const Placement<T> placement{{x[6], x[7]}, x[8]};
        return {mechwright::miss(local, placement, Vector<T>{T(target.x), T(target.y)}),
                std::min(value_of(p.margins.stretch), value_of(p.margins.fold))};
    }

    /// The same with first derivatives by the implicit function theorem, at a tenth of the price of dual numbers; not
    /// at a toggle, where it returns false.
    static bool miss_and_gradient(std::size_t assembly, const std::array<double, reads + 1>& x,
                                  const Vector<double>& target, PathMiss& out) {
        const FourBar<double> links{x[0], x[1], x[2], x[3]};
        const CouplerPoint<double> point{x[4], x[5]};
        const auto p = pose(links, x[9], assembly == 0 ? Assembly::open : Assembly::crossed);
        if (p.transmission_sine == 0) return false;
        const Vector<double> local = position(links, point, p);
        const Vector<double> axis{std::cos(x[8]), std::sin(x[8])};
        const Vector<double> reached = turned(local, axis);
        out.miss = (target - Vector<double>{x[6], x[7]}) - reached;
        out.margin = std::min(p.margins.stretch, p.margins.fold);
        const auto gradient = position_gradient(links, point, p);
        const auto set = [&](std::size_t argument, const Vector<double>& of_point) {
            out.gradient_x[argument] = -of_point.x;
            out.gradient_y[argument] = -of_point.y;
        };
        for (std::size_t i = 0; i < 6; ++i)
            set(i, turned(gradient[i], axis));
        set(6, {1, 0});
        set(7, {0, 1});
        set(8, left_of(reached));
        set(9, turned(gradient[6], axis));
        return true;
    }
};

/// A body on the coupler as a guided body.
struct CouplerPose {
    static constexpr std::size_t reads = 15;

    /// x: the dimensions of the four-bar in their order, then the crank angle.
    template <class T>
    static PoseMissAndMargin<T> miss(std::size_t assembly, const std::array<T, reads + 1>& x,
                                     const Vector<double>& target, const Vector<double>& facing) {
        using std::cos, std::sin;
        const FourBar<T> links{x[0], x[1], x[2], x[3]};
        const auto p = pose(links, x[15], assembly == 0 ? Assembly::open : Assembly::crossed);
        const Vector<T> local = position(links, CouplerPoint<T>{x[4], x[5]}, p);
        const Placement<T> placement{{x[6], x[7]}, x[8]};
        const T turn = x[8] + x[14];
        const Vector<T> faces = turned(p.coupler, Vector<T>{cos(turn), sin(turn)});
        return {{mechwright::miss(local, placement, Vector<T>{T(target.x), T(target.y)}),
                 std::min(value_of(p.margins.stretch), value_of(p.margins.fold))},
                Vector<T>{T(facing.x), T(facing.y)} - faces};
    }
};

}  // namespace mechwright::four_bar

#pragma once
/// \file
/// A point on the rod of a slider-crank as a path-guiding point (guided_point.h).

#include "analysis/slider_crank.h"
#include "synthesis/mechanism/guided_point.h"

namespace mechwright::quick_return {

struct RodPath {
    static constexpr std::size_t reads = 8;

    /// x: crank, rod, offset, point-along, point-across, origin-x, origin-y, tilt, crank angle.
    template <class T>
    static MissAndMargin<T> miss(std::size_t, const std::array<T, reads + 1>& x, const Vector<double>& target) {
        const SliderCrank<T> m{x[0], x[1], x[2]};
        const auto p = pose(m, x[8]);
        const Placement<T> placement{{x[5], x[6]}, x[7]};
        return {mechwright::miss(position(m, CouplerPoint<T>{x[3], x[4]}, p), placement,
                                 Vector<T>{T(target.x), T(target.y)}),
                std::min(value_of(p.left), value_of(p.right))};
    }
};

/// A body on the rod as a guided body.
struct RodPose {
    static constexpr std::size_t reads = 10;

    /// x: as above, crank-start, body-angle, crank angle.
    template <class T>
    static PoseMissAndMargin<T> miss(std::size_t, const std::array<T, reads + 1>& x, const Vector<double>& target,
                                     const Vector<double>& facing) {
        using std::cos, std::sin;
        const SliderCrank<T> m{x[0], x[1], x[2]};
        const auto p = pose(m, x[10]);
        const Placement<T> placement{{x[5], x[6]}, x[7]};
        const T turn = x[7] + x[9];
        const Vector<T> faces = turned(p.rod, Vector<T>{cos(turn), sin(turn)});
        return {{mechwright::miss(position(m, CouplerPoint<T>{x[3], x[4]}, p), placement,
                                  Vector<T>{T(target.x), T(target.y)}),
                 std::min(value_of(p.left), value_of(p.right))},
                Vector<T>{T(facing.x), T(facing.y)} - faces};
    }
};

}  // namespace mechwright::quick_return

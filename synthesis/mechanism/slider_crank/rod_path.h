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

    /// The same with first derivatives by the implicit function theorem; not where the rod stands square to the slide,
    /// where it returns false.
    static bool miss_and_gradient(std::size_t, const std::array<double, reads + 1>& x, const Vector<double>& target,
                                  PathMiss& out) {
        const SliderCrank<double> m{x[0], x[1], x[2]};
        const CouplerPoint<double> point{x[3], x[4]};
        const auto p = pose(m, x[8]);
        if (p.rod.x == 0) return false;
        out.margin = std::min(p.left, p.right);
        place_with_gradient(position(m, point, p), position_gradient(m, point, p), x, 8, target, out);
        return true;
    }
};

/// A body on the rod as a guided body.
struct RodPose {
    static constexpr std::size_t reads = RodPath::reads + 1;

    /// x: as above, the angle of the body before the crank angle.
    template <class T>
    static PoseMissAndMargin<T> miss(std::size_t, const std::array<T, reads + 1>& x, const Vector<double>& target,
                                     const Vector<double>& facing) {
        using std::cos, std::sin;
        const SliderCrank<T> m{x[0], x[1], x[2]};
        const auto p = pose(m, x[9]);
        const Placement<T> placement{{x[5], x[6]}, x[7]};
        const T turn = x[7] + x[8];
        const Vector<T> faces = turned(p.rod, Vector<T>{cos(turn), sin(turn)});
        return {{mechwright::miss(position(m, CouplerPoint<T>{x[3], x[4]}, p), placement,
                                  Vector<T>{T(target.x), T(target.y)}),
                 std::min(value_of(p.left), value_of(p.right))},
                Vector<T>{T(facing.x), T(facing.y)} - faces};
    }

    /// The same with first derivatives, as above.
    static bool miss_and_gradient(std::size_t, const std::array<double, reads + 1>& x, const Vector<double>& target,
                                  const Vector<double>& facing, PoseMiss& out) {
        const SliderCrank<double> m{x[0], x[1], x[2]};
        const CouplerPoint<double> point{x[3], x[4]};
        const auto p = pose(m, x[9]);
        if (p.rod.x == 0) return false;
        out.place.margin = out.turn.margin = std::min(p.left, p.right);
        out.place.gradient_x[8] = out.place.gradient_y[8] = 0;
        place_with_gradient(position(m, point, p), position_gradient(m, point, p), x, 9, target, out.place);
        const double turn = x[7] + x[8];
        const Vector<double> faces = turned(p.rod, Vector<double>{std::cos(turn), std::sin(turn)});
        const RodTurn<double> rod = rod_turn(m, p);
        face_with_gradient(faces, rod.dimensions, rod.crank_angle, {7, 8}, 9, facing, out.turn);
        return true;
    }
};

}  // namespace mechwright::quick_return

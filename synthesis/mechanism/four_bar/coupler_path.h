#pragma once
/// \file
/// The coupler point of the four-bar as a path-guiding point (guided_point.h).

#include <algorithm>
#include <cmath>

#include "analysis/four_bar.h"
#include "analysis/numbers/unit_vector.h"
#include "synthesis/mechanism/guided_point.h"

namespace mechwright::four_bar {

inline Assembly assembly_of(std::size_t assembly) { return assembly == 0 ? Assembly::open : Assembly::crossed; }

struct CouplerPath {
    static constexpr std::size_t reads = 9;

    /// x: ground, crank, coupler, rocker, point-along, point-across, origin-x, origin-y, tilt, crank angle.
    template <class T>
    static MissAndMargin<T> miss(std::size_t assembly, const std::array<T, reads + 1>& x,
                                 const Vector<double>& target) {
        const FourBar<T> links{x[0], x[1], x[2], x[3]};
        const auto p = pose(links, x[9], assembly_of(assembly));
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
        const auto p = pose(links, x[9], assembly_of(assembly));
        if (p.transmission_sine == 0) return false;
        out.margin = std::min(p.margins.stretch, p.margins.fold);
        place_with_gradient(position(links, point, p), position_gradient(links, point, p), x, 9, target, out);
        return true;
    }
};

/// A body on the coupler as a guided body.
struct CouplerPose {
    static constexpr std::size_t reads = CouplerPath::reads + 1;

    /// x: as above, the angle of the body before the crank angle.
    template <class T>
    static PoseMissAndMargin<T> miss(std::size_t assembly, const std::array<T, reads + 1>& x,
                                     const Vector<double>& target, const Vector<double>& facing) {
        const FourBar<T> links{x[0], x[1], x[2], x[3]};
        const auto p = pose(links, x[10], assembly_of(assembly));
        const Vector<T> local = position(links, CouplerPoint<T>{x[4], x[5]}, p);
        const Placement<T> placement{{x[6], x[7]}, x[8]};
        const Vector<T> faces = turned(p.coupler, unit_at(T(x[8] + x[9])));
        return {{mechwright::miss(local, placement, Vector<T>{T(target.x), T(target.y)}),
                 std::min(value_of(p.margins.stretch), value_of(p.margins.fold))},
                Vector<T>{T(facing.x), T(facing.y)} - faces};
    }

    /// The same with first derivatives; not at a toggle, where it returns false.
    static bool miss_and_gradient(std::size_t assembly, const std::array<double, reads + 1>& x,
                                  const Vector<double>& target, const Vector<double>& facing, PoseMiss& out) {
        const FourBar<double> links{x[0], x[1], x[2], x[3]};
        const CouplerPoint<double> point{x[4], x[5]};
        const auto p = pose(links, x[10], assembly_of(assembly));
        if (p.transmission_sine == 0) return false;
        out.place.margin = out.turn.margin = std::min(p.margins.stretch, p.margins.fold);
        out.place.gradient_x[9] = out.place.gradient_y[9] = 0;
        place_with_gradient(position(links, point, p), position_gradient(links, point, p), x, 10, target, out.place);
        const double turn = x[8] + x[9];
        const Vector<double> faces = turned(p.coupler, Vector<double>{std::cos(turn), std::sin(turn)});
        const LinkTurn<double> coupler = coupler_turn(links, p);
        face_with_gradient(faces, coupler.links, coupler.crank_angle, {8, 9}, 10, facing, out.turn);
        return true;
    }
};

}  // namespace mechwright::four_bar

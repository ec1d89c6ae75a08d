#pragma once
/// \file
/// The coupler point of the four-bar as a path-guiding point (guided_point.h).

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
};

}  // namespace mechwright::four_bar

#include "synthesis/mechanism/four_bar/path.h"

#include <algorithm>
#include <array>

#include "analysis/four_bar.h"
#include "synthesis/mechanism/measured.h"

namespace mechwright::four_bar {

namespace {

template <class T>
struct MissAndMargin {
    Vector<T> miss;
    double margin;
};

/// x: ground, crank, coupler, rocker, point-along, point-across, origin-x, origin-y, tilt, crank angle.
template <class T>
MissAndMargin<T> miss_of(std::size_t assembly, const std::array<T, path_reads + 1>& x, const Vector<double>& target) {
    const FourBar<T> links{x[0], x[1], x[2], x[3]};
    const auto p = pose(links, x[9], assembly == 0 ? Assembly::open : Assembly::crossed);
    const Vector<T> local = position(links, CouplerPoint<T>{x[4], x[5]}, p);
    const Placement<T> placement{{x[6], x[7]}, x[8]};
    return {miss(local, placement, Vector<T>{T(target.x), T(target.y)}),
            std::min(value_of(p.margins.stretch), value_of(p.margins.fold))};
}

}  // namespace

void path_miss(std::size_t assembly, std::span<const double> dimensions, double crank_angle,
               const Vector<double>& target, PathMiss& out) {
    constexpr std::size_t n = path_reads + 1;
    std::array<double, n> at{};
    std::copy_n(dimensions.begin(), path_reads, at.begin());
    at[path_reads] = crank_angle;
    if (!out.hessian_x.empty()) {
        const auto r = miss_of(assembly, seeded<SecondDual<double, n>, n>(at), target);
        out.miss = {r.miss.x.value, r.miss.y.value};
        out.margin = r.margin;
        std::copy(r.miss.x.first.begin(), r.miss.x.first.end(), out.gradient_x.begin());
        std::copy(r.miss.y.first.begin(), r.miss.y.first.end(), out.gradient_y.begin());
        std::copy(r.miss.x.second.begin(), r.miss.x.second.end(), out.hessian_x.begin());
        std::copy(r.miss.y.second.begin(), r.miss.y.second.end(), out.hessian_y.begin());
    } else if (!out.gradient_x.empty()) {
        const auto r = miss_of(assembly, seeded<Dual<double, n>, n>(at), target);
        out.miss = {r.miss.x.value, r.miss.y.value};
        out.margin = r.margin;
        std::copy(r.miss.x.partial.begin(), r.miss.x.partial.end(), out.gradient_x.begin());
        std::copy(r.miss.y.partial.begin(), r.miss.y.partial.end(), out.gradient_y.begin());
    } else {
        const auto r = miss_of(assembly, at, target);
        out.miss = r.miss;
        out.margin = r.margin;
    }
}

}  // namespace mechwright::four_bar

#include "synthesis/mechanism/four_bar/path/screening.h"

#include "analysis/four_bar.h"
#include "synthesis/mechanism/four_bar/path/guide_in_lanes.h"

namespace mechwright {

namespace {

/// Where the coupler is.
struct CouplerGuide {
    static constexpr std::size_t lengths = 4;

    template <class T>
    struct Direction {
        Vector<T> pin;
        Vector<T> link;
        T margin;
    };

    template <class T>
    static Direction<T> direction(std::size_t assembly, const std::array<T, lengths>& x, const HalfTurn<T>& half) {
        const FourBar<T> links{x[0], x[1], x[2], x[3]};
        const FourBarPose<T> p = pose(links, half, assembly == 0 ? Assembly::open : Assembly::crossed);
        const T& stretch = p.margins.stretch;
        const T& fold = p.margins.fold;
        return {links.crank * p.crank, p.coupler, select(stretch < fold, stretch, fold)};
    }
};

template <class T>
void points_in_lanes(Assembly assembly, std::span<const FourBarGroup> linkages, const HalfTurn<double>& half,
                     std::span<PointGroup> out) {
    const HalfTurn<T> at{T(half.cosine), T(half.sine)};
    for (std::size_t i = 0; i < linkages.size(); ++i)
        for (std::size_t first = 0; first < std::tuple_size_v<Group>; first += T::count) {
            const auto& m = linkages[i].links;
            const FourBar<T> links{loaded<T>(m[0], first), loaded<T>(m[1], first), loaded<T>(m[2], first),
                                   loaded<T>(m[3], first)};
            const CouplerPoint<T> point{loaded<T>(linkages[i].along, first), loaded<T>(linkages[i].across, first)};
            const Vector<T> reached = position(links, point, pose(links, at, assembly));
            reached.x.write(out[i].x.data() + first);
            reached.y.write(out[i].y.data() + first);
        }
}

// One body for each instruction set, with everything it calls made part of it.

[[gnu::flatten]] Screened screened_baseline(std::size_t assembly, std::span<const Group> lengths,
                                            std::span<const ScreenedPoint> points, const PathFreedom& free) {
    return screened<CouplerGuide, BaselineLanes>(assembly, lengths, points, free);
}

[[gnu::flatten]] void points_baseline(Assembly assembly, std::span<const FourBarGroup> linkages,
                                      const HalfTurn<double>& half, std::span<PointGroup> out) {
    points_in_lanes<BaselineLanes>(assembly, linkages, half, out);
}

#if defined(__x86_64__)

[[gnu::flatten, gnu::target("avx2")]] Screened screened_avx2(std::size_t assembly, std::span<const Group> lengths,
                                                             std::span<const ScreenedPoint> points,
                                                             const PathFreedom& free) {
    return screened<CouplerGuide, Avx2Lanes>(assembly, lengths, points, free);
}

[[gnu::flatten, gnu::target("avx2")]] void points_avx2(Assembly assembly, std::span<const FourBarGroup> linkages,
                                                       const HalfTurn<double>& half, std::span<PointGroup> out) {
    points_in_lanes<Avx2Lanes>(assembly, linkages, half, out);
}

[[gnu::flatten, gnu::target("avx512f")]] Screened screened_avx512(std::size_t assembly, std::span<const Group> lengths,
                                                                  std::span<const ScreenedPoint> points,
                                                                  const PathFreedom& free) {
    return screened<CouplerGuide, Avx512Lanes>(assembly, lengths, points, free);
}

[[gnu::flatten, gnu::target("avx512f")]] void points_avx512(Assembly assembly, std::span<const FourBarGroup> linkages,
                                                            const HalfTurn<double>& half, std::span<PointGroup> out) {
    points_in_lanes<Avx512Lanes>(assembly, linkages, half, out);
}

#endif

}  // namespace

Screened four_bar_screening(InstructionSet set, std::size_t assembly, std::span<const Group> lengths,
                            std::span<const ScreenedPoint> points, const PathFreedom& free) {
#if defined(__x86_64__)
    if (set == InstructionSet::avx512) return screened_avx512(assembly, lengths, points, free);
    if (set == InstructionSet::avx2) return screened_avx2(assembly, lengths, points, free);
#endif
    static_cast<void>(set);
    return screened_baseline(assembly, lengths, points, free);
}

void coupler_points(InstructionSet set, Assembly assembly, std::span<const FourBarGroup> linkages,
                    const HalfTurn<double>& half, std::span<PointGroup> out) {
#if defined(__x86_64__)
    if (set == InstructionSet::avx512) return points_avx512(assembly, linkages, half, out);
    if (set == InstructionSet::avx2) return points_avx2(assembly, linkages, half, out);
#endif
    static_cast<void>(set);
    points_baseline(assembly, linkages, half, out);
}

}  // namespace mechwright

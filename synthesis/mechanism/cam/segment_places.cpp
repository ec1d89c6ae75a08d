#include "synthesis/mechanism/cam/segment_places.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <vector>

#include "analysis/numbers/extremes.h"

namespace mechwright::cam {

namespace {

/// Parts of a piece at which a slope is sampled: even steps, and steps that shrink towards both ends, where a follower
/// near the cam's centre moves fast.
std::span<const double> sample_parts() {
    static const std::vector<double> parts = [] {
        std::vector<double> p{0, 1};
        constexpr int even = 16;
        for (int i = 1; i < even; ++i)
            p.push_back(static_cast<double>(i) / even);
        for (double x = 0.5 / even; x > 1e-4; x *= 0.5) {
            p.push_back(x);
            p.push_back(1 - x);
        }
        std::sort(p.begin(), p.end());
        return p;
    }();
    return parts;
}

/// The greatest of the places that were offered, the greatest first.
struct Greatest {
    struct Found {
        SegmentPlace place;
        double value;
    };
    std::size_t count;  ///< that are wanted
    std::size_t kept = 0;
    std::array<Found, most_places> best{};

    void offer(const SegmentPlace& place, double value) {
        // The same place as the end of the piece before.
        for (std::size_t i = 0; i < kept; ++i)
            if (best[i].place.u == place.u && std::abs(best[i].value - value) <= 1e-9 * std::abs(value)) return;
        std::size_t at = kept;
        for (std::size_t i = 0; i < kept; ++i)
            if (!(value <= best[i].value)) {
                at = i;
                break;
            }
        if (at >= count) return;
        for (std::size_t i = std::min(kept, count - 1); i > at; --i)
            best[i] = best[i - 1];
        best[at] = {place, value};
        kept = std::min(kept + 1, count);
    }
};

}  // namespace

void find_greatest(const Segment<double>& segment, std::size_t index, double start_lift, const Sought& f,
                   std::span<SegmentPlace> places) {
    assert(places.size() <= most_places);
    Greatest greatest{places.size()};
    const auto offer = [&](std::size_t piece, double u, bool stationary) {
        greatest.offer({index, piece, u, stationary}, f.value(f.function, lift_at(segment, piece, u, start_lift)));
    };
    if (segment.kind == SegmentKind::dwell) {
        offer(0, 0, false);
    } else {
        using Slope = Dual<double, 1>;
        const auto wide = converted<Slope>(segment);
        for (std::size_t piece = 0; piece < pieces(segment); ++piece) {
            const double from = break_before(segment, piece), to = break_before(segment, piece + 1);
            const auto slope = [&](double u) {
                return f.slope(f.function, lift_at(wide, piece, Slope::variable(u, 0), Slope(start_lift)));
            };
            std::array<double, 64> grid;
            std::size_t n = 0;
            for (const double part : sample_parts())
                grid[n++] = from + part * (to - from);
            offer(piece, from, false);
            offer(piece, to, false);
            // Closer to an end than this a zero is the rounding of a slope that vanishes there.
            const double beside = 1e-6 * (to - from);
            zeros_on_grid(slope, std::span<const double>(grid.data(), n), [&](double u) {
                const bool peak = slope(u - beside) >= 0 && slope(u + beside) <= 0;
                if (u > from + beside && u < to - beside && peak) offer(piece, u, true);
            });
        }
    }
    if (greatest.kept == 0) offer(0, 0, false);
    for (std::size_t i = 0; i < places.size(); ++i)
        places[i] = greatest.best[std::min(i, greatest.kept - 1)].place;
}

}  // namespace mechwright::cam

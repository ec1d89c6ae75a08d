#pragma once
/// \file
/// Where on the motion program a measure is extreme: at breaks between analytic pieces, or where it is stationary in
/// one of them. Always the same number of places for a segment, so that the components of a quantity stay the same
/// functions while a design changes.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <span>
#include <vector>

#include "analysis/numbers/extremes.h"
#include "synthesis/mechanism/cam/layout.h"

namespace mechwright::cam {

/// A place on a segment: on an analytic piece, at part u of the segment.
struct Place {
    std::size_t segment;
    std::size_t piece;
    double u;
    bool stationary;
};

namespace detail {

/// Parts of a piece at which a slope is sampled: even steps, and steps that shrink towards both ends, where a follower
/// near the cam's centre moves fast.
inline std::span<const double> sample_parts() {
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

}  // namespace detail

/// The places of a segment at which f(lift) is greatest: `count` of them, the greatest first; where there are fewer
/// local maxima the first one is repeated. f is a template on the number type.
template <std::size_t count, class Function>
std::array<Place, count> greatest_places(const Segment<double>& segment, std::size_t index, double start_lift,
                                         const Function& f) {
    struct Found {
        Place place;
        double value;
    };
    std::array<Found, count> best{};
    std::size_t kept = 0;
    const auto offer = [&](std::size_t piece, double u, bool stationary) {
        const double value = f(lift_at(segment, piece, u, start_lift));
        // The same place as the end of the piece before.
        for (std::size_t i = 0; i < kept; ++i)
            if (best[i].place.u == u && std::abs(best[i].value - value) <= 1e-9 * std::abs(value)) return;
        std::size_t at = kept;
        for (std::size_t i = 0; i < kept; ++i)
            if (!(value <= best[i].value)) {
                at = i;
                break;
            }
        if (at >= count) return;
        for (std::size_t i = std::min(kept, count - 1); i > at; --i)
            best[i] = best[i - 1];
        best[at] = {{index, piece, u, stationary}, value};
        kept = std::min(kept + 1, count);
    };
    if (segment.kind == SegmentKind::dwell) {
        offer(0, 0, false);
    } else {
        using Slope = Dual<double, 1>;
        const auto wide = converted<Slope>(segment);
        for (std::size_t piece = 0; piece < pieces(segment); ++piece) {
            const double from = break_before(segment, piece), to = break_before(segment, piece + 1);
            const auto slope = [&](double u) {
                return f(lift_at(wide, piece, Slope::variable(u, 0), Slope(start_lift))).partial[0];
            };
            std::array<double, 64> grid;
            const auto parts = detail::sample_parts();
            std::size_t n = 0;
            for (const double part : parts)
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
    if (kept == 0) offer(0, 0, false);
    std::array<Place, count> places;
    for (std::size_t i = 0; i < count; ++i)
        places[i] = best[std::min(i, kept - 1)].place;
    return places;
}

}  // namespace mechwright::cam

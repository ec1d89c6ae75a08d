#pragma once
/// \file
/// Where on the motion program a measure is extreme: at breaks between analytic pieces, or where it is stationary in
/// one of them. Always the same number of places for a segment, so that the components of a quantity stay the same
/// functions while a design changes.

#include <array>
#include <cstddef>
#include <span>

#include "analysis/numbers/dual.h"
#include "synthesis/mechanism/cam/layout.h"

namespace mechwright::cam {

/// A place on a segment: on an analytic piece, at part u of the segment.
struct SegmentPlace {
    std::size_t segment;
    std::size_t piece;
    double u;
    bool stationary;
};

/// What is to be greatest, as a function of the lift: its value, and its slope along the segment.
struct Sought {
    const void* function;
    double (*value)(const void* function, const Lift<double>& lift);
    double (*slope)(const void* function, const Lift<Dual<double, 1>>& lift);
};

/// As many places as there is room for are kept of one segment at a time.
inline constexpr std::size_t most_places = 4;

/// The places of a segment at which f(lift) is greatest, the greatest first: as many as `places` has room for, at most
/// `most_places`; where there are fewer local maxima the first one is repeated.
void find_greatest(const Segment<double>& segment, std::size_t index, double start_lift, const Sought& f,
                   std::span<SegmentPlace> places);

/// The same for a template f on the number type.
template <std::size_t count, class Function>
std::array<SegmentPlace, count> greatest_places(const Segment<double>& segment, std::size_t index, double start_lift,
                                                const Function& f) {
    static_assert(count <= most_places);
    const Sought sought{&f,
                        [](const void* function, const Lift<double>& lift) -> double {
                            return (*static_cast<const Function*>(function))(lift);
                        },
                        [](const void* function, const Lift<Dual<double, 1>>& lift) -> double {
                            return (*static_cast<const Function*>(function))(lift).partial[0];
                        }};
    std::array<SegmentPlace, count> places;
    find_greatest(segment, index, start_lift, sought, places);
    return places;
}

}  // namespace mechwright::cam

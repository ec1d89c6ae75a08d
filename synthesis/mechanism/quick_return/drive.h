#pragma once
/// \file
/// What the registry entries of all ram-driving mechanisms share, as templates on the mechanism.

#include <algorithm>
#include <array>
#include <span>
#include <vector>

#include "synthesis/mechanism/quick_return/formulas.h"
#include "synthesis/mechanism/quick_return/transmission.h"

namespace mechwright::quick_return {

inline std::vector<Setting> settings() {
    return {{"quick-return", "working-share", 0.6, 0, 1,
             "the middle part of the slow stroke over which cutting is judged"}};
}

template <template <class> class Drive>
Drive<double> drive_of(std::span<const double> dimensions, std::size_t assembly) {
    std::array<double, Layout<Drive>::reads> x;
    std::copy_n(dimensions.begin(), x.size(), x.begin());
    return Layout<Drive>::make(x, assembly);
}

template <template <class> class Drive>
Motion motion_by_drive(Form form, std::span<const double> dimensions, const double* crank_range) {
    const Drive<double> m = drive_of<Drive>(dimensions, form.assembly);
    const CrankRange<double> range = assembled_range(m);
    Motion motion;
    motion.assembly = form.assembly;
    motion.full_turn = range.full_turn && crank_range == nullptr;
    motion.family = motion.full_turn && makes_two_strokes(m) ? full_turn : limited_range;
    motion.from = crank_range ? crank_range[0] : range.from;
    motion.to = crank_range ? crank_range[1] : range.to;
    return motion;
}

/// Of a whole turn: over a given range of crank angles there are no strokes.
inline bool of_two_strokes(const Motion& motion) { return motion.family == full_turn && motion.full_turn; }
inline bool of_any(const Motion&) { return true; }
inline bool of_known_range(const Motion& motion) { return motion.from <= motion.to; }

/// How many components a formula has, which depends on the motion but not on the dimensions.
template <std::size_t over_full_turn, std::size_t otherwise>
std::size_t count_of(const Motion& motion) {
    return motion.family == full_turn ? over_full_turn : otherwise;
}

/// Transmission angles: at the ram, and `each` for every extreme at the four-bar of a drag link.
template <template <class> class Drive, std::size_t at_ram, std::size_t each>
std::size_t transmission_count(const Motion& motion) {
    const std::size_t rods = motion.family == full_turn ? at_ram : detail::limited_places;
    if constexpr (!HasFourBar<Drive<double>>) return rods;
    const std::size_t extremes = motion.full_turn ? 1 : four_bar::transmission_extremes_of(motion).count;
    return rods + each * extremes;
}

template <template <class> class Drive>
std::size_t assembly_margin_count(const Motion& motion) {
    if (motion.family == full_turn) return 3;
    if constexpr (!HasFourBar<Drive<double>>) return 2 * detail::limited_places;
    return 2 * detail::limited_places + 2 * four_bar::transmission_extremes_of(motion).count;
}

/// The quantities that every ram-driving mechanism has. The texts say what total-length and the transmission
/// angles mean for it; `Again` measures a second time.
template <template <class> class Drive, class Again>
std::vector<Quantity> ram_quantities(const char* total_length, const char* transmission_least,
                                     const char* transmission_greatest, const char* transmission_worst) {
    constexpr std::size_t reads = Layout<Drive>::reads;
    const auto quantity = [](const char* name, Unit unit, const char* meaning, Reduce reduce, auto defined,
                             auto components, auto measure, auto again) {
        Quantity made{name, unit, meaning, reduce, reads, defined, components, measure, again};
        made.of_motion = made.defined != of_any;
        return made;
    };
    return {
        quantity("time-ratio", Unit::none, "time of the slow stroke over time of the fast stroke, >= 1",
                 Reduce::greatest, of_two_strokes, count_of<TimeRatio<Drive>::most, 0>, measure_by<TimeRatio<Drive>>,
                 Again::time_ratio),
        quantity("stroke", Unit::length, "way of the ram between its extreme positions", Reduce::greatest,
                 of_known_range, count_of<1, Stroke<Drive>::most>, measure_by<Stroke<Drive>>, Again::stroke),
        quantity("transmission-angle-min", Unit::angle, transmission_least, Reduce::least, of_known_range,
                 transmission_count<Drive, 2, 1>, measure_by<TransmissionAngleMin<Drive>>,
                 Again::transmission_angle_min),
        quantity("transmission-angle-max", Unit::angle, transmission_greatest, Reduce::greatest, of_known_range,
                 transmission_count<Drive, 1, 1>, measure_by<TransmissionAngleMax<Drive>>,
                 Again::transmission_angle_max),
        quantity("transmission-angle-worst", Unit::angle, transmission_worst, Reduce::least, of_known_range,
                 transmission_count<Drive, 2, 2>, measure_by<TransmissionAngleWorst<Drive>>,
                 Again::transmission_angle_worst),
        quantity("ram-speed-max", Unit::length, "greatest speed of the ram for unit angular velocity of the crank",
                 Reduce::greatest, of_known_range,
                 count_of<RamSpeedMax<Drive>::stationary_points, RamSpeedMax<Drive>::most>,
                 measure_by<RamSpeedMax<Drive>>, Again::ram_speed_max),
        quantity("ram-speed-min-working", Unit::length,
                 "least speed of the ram over the working share of the slow stroke, for unit angular velocity of the "
                 "crank",
                 Reduce::least, of_two_strokes, count_of<RamSpeedMinWorking<Drive>::most, 0>,
                 measure_by<RamSpeedMinWorking<Drive>>, Again::ram_speed_min_working),
        quantity("speed-variation", Unit::none,
                 "greatest less least speed of the ram over the working share of the slow stroke, over its mean in "
                 "time there",
                 Reduce::greatest, of_two_strokes, count_of<SpeedVariation<Drive>::most, 0>,
                 measure_by<SpeedVariation<Drive>>, Again::speed_variation),
        quantity("ram-acceleration-max", Unit::length,
                 "greatest acceleration of the ram for unit angular velocity of the crank", Reduce::greatest,
                 of_known_range,
                 count_of<RamAccelerationMax<Drive>::stationary_points, RamAccelerationMax<Drive>::most>,
                 measure_by<RamAccelerationMax<Drive>>, Again::ram_acceleration_max),
        quantity("link-ratio", Unit::none, "longest link over shortest link", Reduce::greatest, of_any,
                 count_of<LinkRatio<Drive>::most, LinkRatio<Drive>::most>, measure_by<LinkRatio<Drive>>,
                 Again::link_ratio),
        quantity("total-length", Unit::length, total_length, Reduce::only, of_any, count_of<1, 1>,
                 measure_by<TotalLength<Drive>>, Again::total_length),
    };
}

/// What keeps a design assembled where linear conditions do not: not a quantity of the contract.
template <template <class> class Drive>
Quantity assembly_margin_quantity() {
    return {.name = "assembly margin",
            .unit = Unit::length,
            .meaning = "the mechanism assembles",
            .reduce = Reduce::least,
            .reads = Layout<Drive>::reads,
            .defined = of_known_range,
            .components = assembly_margin_count<Drive>,
            .measure = measure_by<AssemblyMargin<Drive>>};
}

}  // namespace mechwright::quick_return

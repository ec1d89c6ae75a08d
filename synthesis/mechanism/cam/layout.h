#pragma once
/// \file
/// How the geometry of each follower stands in the registry.

#include <array>
#include <cstddef>

#include "analysis/cam/contact_force.h"
#include "analysis/cam/flat_follower.h"
#include "analysis/cam/roller_follower.h"
#include "synthesis/mechanism/cam/motion_program.h"

namespace mechwright::cam {

/// Of every follower; those with fewer leave the last ones alone.
inline constexpr std::size_t most_geometry = 12;

/// Dimensions of a loaded follower, after those that shape the cam: spring rate, precompression, load, weight, guide
/// length, overhang, stem diameter.
inline constexpr std::size_t load_count = 7;

/// Settings of a cam's mechanism.
enum CamSetting : std::size_t { mass_setting, speed_setting, friction_setting };

/// `shape`: how many of the first dimensions shape the cam; `geometry`: the same with those of the load; `make`: the
/// follower.
template <template <class> class Follower>
struct Layout;

template <>
struct Layout<TranslatingRoller> {
    static constexpr std::size_t shape = 3;
    static constexpr std::size_t geometry = shape + load_count;
    static constexpr bool roller = true;
    static constexpr bool oscillating = false;
    template <class T>
    static TranslatingRoller<T> make(const std::array<T, most_geometry>& g, int sense) {
        return {g[0], g[1], g[2], sense};
    }
};

template <>
struct Layout<OscillatingRoller> {
    static constexpr std::size_t shape = 4;
    static constexpr std::size_t geometry = shape;
    static constexpr bool roller = true;
    static constexpr bool oscillating = true;
    template <class T>
    static OscillatingRoller<T> make(const std::array<T, most_geometry>& g, int sense) {
        return {g[0], g[1], g[2], g[3], sense};
    }
};

template <>
struct Layout<TranslatingFlat> {
    static constexpr std::size_t shape = 1;
    static constexpr std::size_t geometry = shape + load_count;
    static constexpr bool roller = false;
    static constexpr bool oscillating = false;
    template <class T>
    static TranslatingFlat<T> make(const std::array<T, most_geometry>& g, int sense) {
        return {g[0], sense};
    }
};

template <>
struct Layout<OscillatingFlat> {
    static constexpr std::size_t shape = 3;
    static constexpr std::size_t geometry = shape;
    static constexpr bool roller = false;
    static constexpr bool oscillating = true;
    template <class T>
    static OscillatingFlat<T> make(const std::array<T, most_geometry>& g, int sense) {
        return {g[0], g[1], g[2], sense};
    }
};

template <>
struct Layout<ContourRoller> {
    static constexpr std::size_t shape = 5;
    static constexpr std::size_t geometry = shape + load_count;
    static constexpr bool roller = true;
    static constexpr bool oscillating = false;
    template <class T>
    static ContourRoller<T> make(const std::array<T, most_geometry>& g, int sense) {
        return {g[0], g[1], g[2], g[3], g[4], sense};
    }
    template <class T>
    static Contour<T> contour(ContourKind kind, const std::array<T, most_geometry>& g) {
        return completed<T>({kind, g[0], g[1], g[2], g[3], g[4], true});
    }
};

template <>
struct Layout<ContourFlat> {
    static constexpr std::size_t shape = 4;
    static constexpr std::size_t geometry = shape + load_count;
    static constexpr bool roller = false;
    static constexpr bool oscillating = false;
    template <class T>
    static ContourFlat<T> make(const std::array<T, most_geometry>& g, int sense) {
        return {g[0], g[1], g[2], g[3], sense};
    }
    template <class T>
    static Contour<T> contour(ContourKind kind, const std::array<T, most_geometry>& g) {
        return completed<T>({kind, g[0], g[1], g[2], g[3], T(), false});
    }
};

/// Whether a follower's cam is one of a specified contour.
template <template <class> class Follower>
constexpr bool is_contour = requires(const std::array<double, most_geometry>& g) {
    Layout<Follower>::contour(ContourKind::none, g);
};

/// Gives a segment the contour that its lift follows from, if the follower's cam has one.
template <template <class> class Follower, class T>
Segment<T> with_contour(Segment<T> segment, const SegmentPlan& plan, const std::array<T, most_geometry>& geometry) {
    if constexpr (is_contour<Follower>) {
        segment.law.form = SegmentLaw::Form::contour;
        segment.contour = Layout<Follower>::contour(plan.contour, geometry);
    }
    return segment;
}

template <template <class> class Follower>
constexpr ProgramSlots slots{Layout<Follower>::geometry};

/// How many dimensions a cam with this follower has.
template <template <class> class Follower>
constexpr std::size_t dimension_count = slots<Follower>.end();

/// The geometry in numbers that are made of the dimensions.
template <template <class> class Follower, class T, class Number>
std::array<T, most_geometry> geometry_of(std::span<const Number> dimensions) {
    std::array<T, most_geometry> g{};
    for (std::size_t i = 0; i < Layout<Follower>::geometry; ++i)
        g[i] = T(dimensions[i]);
    return g;
}

template <template <class> class Follower, class T, class Number>
Follower<T> follower_of(std::span<const Number> dimensions, std::size_t assembly) {
    return Layout<Follower>::make(geometry_of<Follower, T>(dimensions), sense_of(assembly));
}

/// The load of a follower from its geometry. Only translating followers have one.
template <template <class> class Follower, class T>
FollowerLoad<T> load_of(const std::array<T, most_geometry>& g, const Motion& motion) {
    if constexpr (Layout<Follower>::geometry == Layout<Follower>::shape) {
        return {};
    } else {
        constexpr std::size_t first = Layout<Follower>::shape;
        return {g[first],
                g[first + 1],
                g[first + 2],
                g[first + 3],
                g[first + 4],
                g[first + 5],
                g[first + 6],
                motion.settings[mass_setting],
                motion.settings[speed_setting] * pi<double>() / 30,
                motion.settings[friction_setting]};
    }
}

}  // namespace mechwright::cam

#pragma once
/// \file
/// The measure of a quantity of a linkage by series of one order in time, each instantiated in a file of its own
/// (measured_by_*.cpp): they are long to compile.

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "synthesis/mechanism/linkage/components.h"
#include "synthesis/mechanism/linkage/rooms/found_apart.h"
#include "synthesis/mechanism/linkage/rooms/found_room.h"
#include "synthesis/mechanism/linkage/rooms/swept/search.h"
#include "synthesis/mechanism/linkage/rooms/turned_box.h"
#include "synthesis/mechanism/linkage/targets/generated.h"
#include "synthesis/mechanism/linkage/targets/seeded.h"

namespace mechwright::measuring {

/// How many components a quantity has, and what is made of them.
struct ComponentsOfKind {
    std::size_t count;
    Reduce reduce;
};
ComponentsOfKind components_of(Kind kind);

/// Calls write(k, component) for as many components as a quantity has: where there are fewer, the last is repeated.
template <class T, class Write>
void write_components(const std::vector<T>& all, std::size_t count, const Write& write) {
    for (std::size_t k = 0; k < count; ++k)
        write(k, all[std::min(k, all.size() - 1)]);
}

/// Whether a margin is to a stop of the master that no dimension changes: a motion lies between these by its own
/// making.
inline bool is_given_stop_of_master(const LinkageModel& model, const linkage::Limit& margin) {
    if (!model.order.is_stop(margin.margin)) return false;
    const linkage::Step& step = linkage::step_of(model.order, margin.margin);
    if (step.input != 0) return false;
    const linkage::Stops& stops = model.structure.drives.front().stops;
    return model.numbers[step.reversed ? *stops.max : *stops.min].terms.empty();
}

/// Whether it is a margin of parts that keep out of a region, and not by their points alone.
inline bool keeps_out(const Over& over) {
    return over.measure.kind == Kind::region_margin && !over.model.regions[over.measure.of_room].is_by_points();
}

/// Where they come closest to it; absent where the linkage does not close over the motion.
template <std::size_t K>
std::optional<FoundApart> closest_apart(const Over& over, std::span<const double> arguments) {
    const std::span<const double> dimensions = over.dimensions_of(arguments);
    if (!closes_at_samples(over, dimensions)) return {};
    auto bare = measured<double, K>(over, arguments, {});
    const Course course = course_of(over, dimensions, bare, {});
    if (needs_turns(over, {}) && (course.turns.empty() || course.turns.to() < course.travel.to)) return {};
    FoundApart found = closest_to_region(over, dimensions, course);
    return found.found.possible ? std::optional(std::move(found)) : std::nullopt;
}

/// Where the components of a quantity of rooms or regions are, by the order of series that these go by; of regions that
/// parts keep out of, of these places where they come closest.
template <std::size_t K>
Found found_of_parts(const Over& over, linkage::Measured<double, K>& plain, const Course& course,
                     std::span<const double> dimensions, Found apart) {
    const Kind kind = over.measure.kind;
    Found found;
    found.possible = false;
    if constexpr (K == order_of_slopes) {
        if (is_of_turned_box(kind)) {
            found.box =
                TurnedBoxSearch<K>(over, over.model.rooms[over.measure.of_room], plain, course, dimensions).found();
            found.possible = found.box.possible;
        } else {
            plain.keep_poses();
            auto outline = swept_outline(over, plain, course);
            found.possible = outline.has_value();
            if (outline) found.swept = std::move(*outline);
        }
    } else if constexpr (K == order_of_places) {
        if (is_of_room(kind)) return found_of_room(over, plain, course, dimensions);
        if (kind == Kind::self_distance) {
            plain.keep_poses();
            ApproachSearch<K> search(over, over.model.rooms[over.measure.of_room], plain, course, dimensions);
            found.approaches = search.found(most_extremes);
            found.possible = search.closes && !found.approaches.empty();
        } else if (keeps_out(over)) {
            found = std::move(apart);
            settle_some(plain, course, found.plus, most_extremes, keep_least);
            found.possible = std::isfinite(found.plus.front().value());
        } else {
            return found_of_points(over, plain, course, dimensions);
        }
    }
    return found;
}

/// The margins of a quantity that is the least of them, and the course that they are along. False: it has no value.
template <std::size_t K>
bool find_margins(const Over& over, std::span<const double> dimensions, linkage::Measured<double, K>& plain,
                  Course& course, Found& found) {
    const Kind kind = over.measure.kind;
    const linkage::Driven<double> driven = over.driven(dimensions);
    const linkage::Travel all = kind == Kind::full_turn_margin && !over.model.driven_by_slide()
                                    ? linkage::Travel{0, over.period(), true}
                                    : course.travel;
    if (kind == Kind::assembly_margin && !over.stays(dimensions, all)) return false;
    found.margins = linkage::margin_places(plain, driven, all);
    std::erase_if(found.margins, [&](const linkage::MarginPlace& place) {
        return kind == Kind::full_turn_margin ? !linkage::is_length(over.model.order, place.margin.margin)
                                              : is_given_stop_of_master(over.model, place.margin);
    });
    std::stable_sort(found.margins.begin(), found.margins.end(),
                     [](const auto& a, const auto& b) { return is_less(a.place.value, b.place.value); });
    if (found.margins.size() > most_extremes) found.margins.resize(most_extremes);
    if (found.margins.empty() && (kind == Kind::full_turn_margin || linkage::closes_by_lengths(over.model.order)))
        return false;
    if (needs_turns(over, over.measure.signals)) course = linkage::course_along(driven, all);
    return true;
}

/// Values, gradients and Hessians of the components, as far as they are asked for. False: there are none.
template <std::size_t K>
bool measure_by_series(const Over& over, std::span<const double> arguments, const Measurement& out) {
    const std::span<const double> dimensions = over.dimensions_of(arguments);
    const Kind kind = over.measure.kind;
    std::vector<Signal> own = own_signals(over.model, over.measure);
    Found apart;
    if constexpr (K == order_of_places)
        if (keeps_out(over)) {
            auto closest = closest_apart<K>(over, arguments);
            if (!closest) return false;
            own = std::move(closest->signals);
            apart = std::move(closest->found);
        }
    const std::span<const Signal> signals =
        over.measure.signals.empty() ? std::span<const Signal>(own) : std::span<const Signal>(over.measure.signals);
    auto plain = measured<double, K>(over, arguments, signals);
    const bool of_lengths = kind == Kind::total_length || kind == Kind::link_ratio;
    if (kind == Kind::joint_distance_least && own.empty()) return false;
    if (of_lengths && link_lengths(over.model, dimensions).empty()) return false;
    const bool of_margins = kind == Kind::full_turn_margin || kind == Kind::assembly_margin;
    Course course{over.travel()};
    Found found;
    std::array<double, 2> stretch{course.travel.from, course.travel.to};
    if constexpr (K == order_of_places)
        if (of_margins && !find_margins(over, dimensions, plain, course, found)) return false;
    if (!of_margins && !of_lengths) {
        if (!closes_at_samples(over, dimensions)) return false;
        course = course_of(over, dimensions, plain, signals);
        if (needs_turns(over, signals)) {
            if (course.turns.empty() || course.turns.to() < course.travel.to) return false;
            plain.start_at(course);
        }
        if (over.is_of_function()) {
            found = found_of_error(over, plain, course, arguments);
        } else if (kind == Kind::transmission_angle_worst || kind == Kind::joint_distance_least) {
            if constexpr (K == order_of_places) {
                plain.keep_poses();
                found = found_of_all(over, plain, course);
            }
        } else if (is_of_parts(kind)) {
            found = found_of_parts(over, plain, course, dimensions, std::move(apart));
        } else {
            const auto asked = kind == Kind::at ? std::optional(std::array{over.measure.input, over.measure.input})
                                                : over.measure.stretch;
            if (asked) {
                const auto in = stretch_in(over, *asked);
                if (!in) return false;
                stretch = *in;
            }
            const auto shape = over.shape_of(arguments);
            found = found_of_signal(over, plain, course, dimensions, stretch[0], stretch[1],
                                    shape.size() == ArcShape::parameters ? shape.back() : 0);
        }
    }
    if (!found.possible) return false;

    const std::size_t n = arguments.size(), count = components_of(kind).count, pairs = n * (n + 1) / 2;
    const auto seeded_components = [&]<class T>(std::span<const T> seeded) {
        return Components<T, K>(over, seeded, signals, plain, course, found, stretch).all();
    };
    write_components(seeded_components(arguments), count, [&](std::size_t k, double value) { out.value[k] = value; });
    if (out.hessian.empty() && !out.gradient.empty())
        by_few(arguments, [&](const auto& seeded, std::size_t from, std::size_t carried) {
            write_components(seeded_components(seeded), count, [&](std::size_t k, const auto& c) {
                for (std::size_t i = 0; i < carried; ++i)
                    out.gradient[k * n + from + i] = c.partial[i];
            });
        });
    if (out.hessian.empty()) return true;
    by_pairs(arguments, [&](const auto& seeded, const SeededPair& carried) {
        write_components(seeded_components(seeded), count, [&](std::size_t k, const auto& c) {
            for (std::size_t v = 0; v < seeded_at_once && !out.gradient.empty(); ++v)
                if (carried[v] < n) out.gradient[k * n + carried[v]] = c.first[v];
            for_each_pair(carried, n, [&](std::size_t v, std::size_t w, std::size_t entry) {
                out.hessian[k * pairs + entry] = c.mixed(v, w);
            });
        });
    });
    return true;
}

extern template bool measure_by_series<0>(const Over&, std::span<const double>, const Measurement&);
extern template bool measure_by_series<2>(const Over&, std::span<const double>, const Measurement&);
extern template bool measure_by_series<4>(const Over&, std::span<const double>, const Measurement&);
extern template bool measure_by_series<7>(const Over&, std::span<const double>, const Measurement&);

}  // namespace mechwright::measuring

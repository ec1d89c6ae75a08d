#pragma once
/// \file
/// A made linkage with signals along its widest travel.

#include <utility>
#include <vector>

#include "analysis/linkage/measuring/course.h"
#include "tests/analysis/made_linkage.h"

namespace mechwright::test {

struct Watched {
    MadeLinkage made;
    std::vector<linkage::Signal> signals;
    linkage::Order order = linkage::order_of(made.s);
    std::vector<std::int8_t> sides;
    std::vector<linkage::DriveLaw> laws;
    linkage::Driven<double> driven;
    linkage::Course course{};
    double rate = 1;
    linkage::Placing<double> placing{};

    Watched(MadeLinkage linkage, std::vector<linkage::Signal> watched, std::vector<std::int8_t> on_sides = {},
            std::vector<linkage::DriveLaw> drive_laws = {}, linkage::Inputs inputs = {})
        : made(std::move(linkage)),
          signals(std::move(watched)),
          sides(std::move(on_sides)),
          laws(std::move(drive_laws)),
          driven(made.s, order, std::span<const double>(made.numbers), resized(), laws) {
        linkage::Travel widest{0, -1};
        for (const linkage::Travel& travel : linkage::travels(driven, inputs))
            if (travel.to - travel.from > widest.to - widest.from) widest = travel;
        if (widest.from < widest.to) course = linkage::course_along(driven, widest);
    }
    Watched(const Watched&) = delete;

    bool moves() const { return !course.turns.empty(); }
    double from() const { return course.travel.from; }
    double to() const { return course.travel.to; }

    template <std::size_t K, class T = double>
    linkage::Measured<T, K> measured(const std::vector<T>& numbers) const {
        linkage::Measured<T, K> m(made.s, order, numbers, sides, laws, signals,
                                  {{T(placing.origin.x), T(placing.origin.y)}, T(placing.tilt), T(placing.scale)},
                                  rate);
        m.start_at(course);
        return m;
    }
    template <std::size_t K>
    linkage::Measured<double, K> measured() const {
        return measured<K, double>(made.numbers);
    }
    /// All places at which a derivative of a signal can be extreme, over the motion or a stretch of it.
    template <std::size_t K = 4>
    std::vector<linkage::Extreme> extremes(std::size_t signal, std::size_t derivative = 0) const {
        return extremes<K>(signal, derivative, from(), to());
    }
    template <std::size_t K = 4>
    std::vector<linkage::Extreme> extremes(std::size_t signal, std::size_t derivative, double start, double end) const {
        auto m = measured<K>();
        return linkage::extremes(m, {signal, derivative}, course, start, end);
    }
    std::size_t pin(const char* name) { return made.pin(name); }

private:
    std::vector<std::int8_t> resized() {
        sides.resize(order.choices, 1);
        return sides;
    }
};

inline linkage::Signal angle_of(std::size_t link, std::size_t to = 0, double near = 0) {
    return {linkage::Signal::Kind::angle, link, to, linkage::none, linkage::none, near};
}
inline linkage::Signal signal_of(linkage::Signal::Kind kind, std::size_t of, std::size_t to = 0,
                                 std::size_t end = linkage::none) {
    return {kind, of, to, end};
}

inline double least_of(const std::vector<linkage::Extreme>& places) {
    double least = std::numeric_limits<double>::infinity();
    for (const linkage::Extreme& each : places)
        least = std::min(least, each.value);
    return least;
}
inline double greatest_of(const std::vector<linkage::Extreme>& places) {
    double greatest = -std::numeric_limits<double>::infinity();
    for (const linkage::Extreme& each : places)
        greatest = std::max(greatest, each.value);
    return greatest;
}

}  // namespace mechwright::test

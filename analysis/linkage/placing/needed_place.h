#pragma once
/// \file
/// Runs through the plain steps of what is asked of a linkage (needed.h), for one input or, with lanes, for several
/// side by side. The formulas are those of place.h in the same order, so that every number has the same bits. Nothing
/// is allocated.

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>

#include "analysis/geometry/vector.h"
#include "analysis/linkage/placing/dyads.h"
#include "analysis/linkage/placing/place.h"
#include "analysis/linkage/placing/plain_steps.h"
#include "analysis/numbers/scalar.h"

namespace mechwright::linkage {

namespace detail {

/// The row of numbers that steps take from and write to.
template <class T>
struct Row {
    T* at;

    const T& number(Spot spot) const { return at[spot]; }
    Vector<T> vector(Spot spot) const { return {at[spot], at[spot + 1]}; }
    void put(Spot spot, const T& x) const { at[spot] = x; }
    void put(Spot spot, const Vector<T>& x) const {
        at[spot] = x.x;
        at[spot + 1] = x.y;
    }
};

/// Cosine and sine, lane by lane where there are lanes.
template <class T>
Vector<T> direction_at(const T& angle) {
    if constexpr (requires { angle.lane; }) {
        Vector<T> u{T(0.0), T(0.0)};
        for (std::size_t i = 0; i < T::count; ++i) {
            const Vector<double> one = unit_at(angle.lane[i]);
            u.x.lane[i] = one.x;
            u.y.lane[i] = one.y;
        }
        return u;
    } else {
        return unit_at(angle);
    }
}

template <class T>
T angle_of(const Vector<T>& along) {
    using std::atan2;
    if constexpr (requires { along.x.lane; }) {
        T angle(0.0);
        for (std::size_t i = 0; i < T::count; ++i)
            angle.lane[i] = atan2(along.y.lane[i], along.x.lane[i]);
        return angle;
    } else {
        return atan2(along.y, along.x);
    }
}

/// The direction and the length of an arm. Of a `line` that has none (0, 0), as direction_of.
template <class T>
void put_arm(const Row<T>& row, Spot out, const Vector<T>& arm, bool line) {
    const T length = hypotenuse(arm.x, arm.y);
    if constexpr (plain_doubles<T>) {
        const T per = T(1) / select(length > T(0), length, T(1));
        row.put(out, line ? Vector<T>{per * arm.x, per * arm.y} : T(T(1) / length) * arm);
    } else {
        row.put(out, line && !(length > T(0)) ? arm : T(T(1) / length) * arm);
    }
    row.put(out + 2, length);
}

/// Whether a margin is not short of zero by more than that; in lanes the caller looks at the margins.
template <class T>
bool is_closed(const Margin<T>& margin, double shortfall) {
    if constexpr (requires { margin.outer.lane; })
        return true;
    else
        return value_of(margin.outer) >= -shortfall && value_of(margin.inner) >= -shortfall;
}

template <class T>
void put_margin(const Row<T>& row, Spot out, const Margin<T>& margin) {
    row.put(out, margin.outer);
    row.put(out + 1, margin.inner);
}

/// The circles of a dyad that is carried round.
template <class T>
[[gnu::always_inline]] inline Circles<T> round_circles(const PlainStep& step, const Row<T>& row) {
    const Spot* in = step.in;
    const T &a = row.number(in[2]), &b = row.number(in[3]), &side = row.number(in[4]);
    if constexpr (goes_round<T>)
        return {RoundDyad<T>{row.at + in[6]}, row.vector(in[5]), a, b, side};
    else
        return {row.vector(in[0]), row.vector(in[1]), a, b, side};
}

/// Returns whether they meet.
template <class T>
[[gnu::always_inline]] inline bool put_circles(const PlainStep& step, const Row<T>& row, const Circles<T>& met,
                                               double shortfall) {
    if (step.first) row.put(step.out, met.from_first());
    if (step.second) row.put(step.out + 2, met.from_second());
    put_margin(row, step.out + 4, met.margin);
    row.put(step.out + 6, met.double_root);
    return is_closed(met.margin, shortfall);
}

/// One step. Returns whether it closes, if it is a dyad.
template <class T>
[[gnu::always_inline]] inline bool run(const PlainStep& step, const Row<T>& row, std::span<const double> near,
                                       double shortfall) {
    using Kind = PlainStep::Kind;
    const Spot *in = step.in, out = step.out;
    const auto number = [&](int i) -> const T& { return row.number(in[i]); };
    const auto vector = [&](int i) { return row.vector(in[i]); };
    switch (step.kind) {
        case Kind::pair: row.put(out, Vector<T>{number(0), number(1)}); break;
        case Kind::unit: row.put(out, direction_at(number(0))); break;
        case Kind::scaled: row.put(out, number(0) * vector(1)); break;
        case Kind::less: row.put(out, vector(0) - vector(1)); break;
        case Kind::negated: row.put(out, -vector(0)); break;
        case Kind::offset: row.put(out, vector(0) + number(1) * left_of(vector(2))); break;
        case Kind::reached: row.put(out, vector(0) + number(1) * vector(2)); break;
        case Kind::arm: put_arm(row, out, vector(0), false); break;
        case Kind::line: put_arm(row, out, vector(0), true); break;
        case Kind::height: row.put(out, T(number(0) + dot(left_of(vector(1)), vector(2)))); break;
        case Kind::turned: row.put(out, turned(vector(0), vector(1))); break;
        case Kind::turned_back: row.put(out, turned(vector(0), conjugate(vector(1)))); break;
        case Kind::carried: row.put(out, vector(0) + turned(vector(1), vector(2))); break;
        case Kind::hung: row.put(out, vector(0) - turned(vector(1), vector(2))); break;
        case Kind::sum: row.put(out, T(number(0) + number(1))); break;
        case Kind::difference: row.put(out, T(number(0) - number(1))); break;
        case Kind::displacement: row.put(out, T(dot(vector(0), vector(1) - vector(2)))); break;
        case Kind::circles:
            return put_circles(step, row, Circles<T>(vector(0), vector(1), number(2), number(3), number(4)), shortfall);
        case Kind::round_dyad:
            if constexpr (goes_round<T>)
                put_round_dyad(vector(0), vector(1), number(2), number(3), step.first, row.at + out);
            break;
        case Kind::round_circles: return put_circles(step, row, round_circles(step, row), shortfall);
        case Kind::circle_line: {
            const CircleAndLine<T> met(vector(0), {vector(1), vector(2)}, number(3), number(4));
            row.put(out, met.at);
            row.put(out + 2, met.from_centre);
            put_margin(row, out + 4, met.margin);
            row.put(out + 6, met.run);
            return is_closed(met.margin, shortfall);
        }
        case Kind::meeting: {
            Vector<T> at;
            const Margin<T> margin = meet<T>({vector(0), vector(1)}, {vector(2), vector(3)}, at);
            row.put(out, at);
            put_margin(row, out + 2, margin);
            return is_closed(margin, shortfall);
        }
        case Kind::passing: {
            const Through<T> passing(vector(0), vector(1), vector(2), number(3), number(4));
            row.put(out, passing.along);
            put_margin(row, out + 2, passing.margin);
            row.put(out + 4, passing.run);
            row.put(out + 5, passing.inverse);
            return is_closed(passing.margin, shortfall);
        }
        case Kind::geared_second: row.put(out, T(number(2) + (number(3) * (number(0) - number(2)) + number(4)))); break;
        case Kind::geared_first: row.put(out, T(number(2) + ((number(1) - number(2)) - number(4)) / number(3))); break;
        case Kind::geared_carrier:
            row.put(out, T(((number(3) * number(0) - number(1)) + number(4)) / (number(3) - T(1))));
            break;
        case Kind::rack_turn: row.put(out, T((number(0) - number(1)) / number(2))); break;
        case Kind::rack_way: row.put(out, T(number(2) * (number(0) - number(1)) + number(3))); break;
        case Kind::unwound: {
            const T angle = angle_of(vector(0));
            if constexpr (requires { angle.lane; })
                row.put(out, angle);
            else
                row.put(out, near.empty() ? angle : unwound(angle, near[step.link]));
            break;
        }
    }
    return true;
}

}  // namespace detail

/// Writes what does not depend on inputs: `numbers` of the structure and `sides`, 1 or -1 for each choice of the order
/// (0: exactly at a limit), and what the first steps make of them. Returns whether all dyads of fixed places close, as
/// place_needed. `row` is of Needed::size.
template <class T, class Number>
bool set_design(const Needed& needed, std::span<const Number> numbers, std::span<const std::int8_t> sides,
                std::span<T> row, double shortfall = 0) {
    const detail::Row<T> to{row.data()};
    to.put(Needed::origin, Vector<T>{T(0), T(0)});
    to.put(Needed::axis, Vector<T>{T(1), T(0)});
    for (std::uint32_t i = 0; i < needed.sides; ++i)
        to.put(needed.side(i), T(static_cast<double>(sides[i])));
    for (std::uint32_t i = 0; i < needed.numbers; ++i)
        to.put(needed.number(i), T(numbers[i]));
    bool closed = true;
    for (std::size_t i = 0; i < needed.moving; ++i)
        closed = detail::run(needed.steps[i], to, {}, shortfall) && closed;
    return closed;
}

/// Takes over a design that was set in single numbers, the same in all lanes.
template <class T>
void take_design(const Needed& needed, std::span<const double> design, std::span<T> row) {
    const std::size_t end = needed.moving < needed.steps.size() ? needed.steps[needed.moving].out : needed.size;
    for (std::size_t i = 0; i < end; ++i)
        row[i] = T(design[i]);
}

/// Sets the input of a drive, an angle or a displacement.
template <class T>
void set_input(const Needed& needed, std::size_t drive, const T& input, std::span<T> row) {
    const detail::Row<T> to{row.data()};
    to.put(needed.drive(drive), input);
    if (needed.turning[drive]) to.put(needed.drive(drive) + 1, detail::direction_at(input));
}

/// The same by an angle and its direction: for many designs at the same angles.
template <class T>
void set_input(const Needed& needed, std::size_t drive, const T& input, const Vector<T>& direction, std::span<T> row) {
    const detail::Row<T> to{row.data()};
    to.put(needed.drive(drive), input);
    to.put(needed.drive(drive) + 1, direction);
}

/// Places what is asked for at the inputs that were set. Returns whether every dyad closes but for `shortfall`; where
/// one does not, nothing after it is placed. In lanes everything is placed, and margins say which lanes close. `near`:
/// turns within half a turn of which those of links are; (-pi, pi] if empty.
template <class T>
[[gnu::always_inline]] inline bool place_needed(const Needed& needed, std::span<T> row, double shortfall = 0,
                                                std::span<const double> near = {}) {
    const detail::Row<T> to{row.data()};
    const PlainStep* const end = needed.steps.data() + needed.steps.size();
    for (const PlainStep* step = needed.steps.data() + needed.moving; step != end; ++step)
        if (!detail::run(*step, to, near, shortfall)) return false;
    return true;
}

}  // namespace mechwright::linkage

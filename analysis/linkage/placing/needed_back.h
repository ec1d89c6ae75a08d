#pragma once
/// \file
/// Derivatives of what is asked of a linkage (needed.h) by all numbers and inputs in one sweep back through its plain
/// steps: beside each number of the row stands how much what is asked for changes with it (Griewank and Walther,
/// Evaluating Derivatives, section 3.2). Dyads are differentiated by their triangle, not through the formulas of their
/// margins: the angle at which one stands follows from one linear equation, divided by the sine of its transmission
/// angle, which has all its digits from the margins. As dual numbers have it, a root of what is not positive does not
/// change, and neither does the whole number of turns that a link is counted on by. Nothing is allocated.

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>

#include "analysis/linkage/placing/needed_place.h"

namespace mechwright::linkage {

namespace detail {

/// Goes back through steps: `row` as they were placed, `change` beside it.
template <class T>
struct Back {
    Row<T> row;
    Row<T> change;

    void one(const PlainStep& step) const {
        using Kind = PlainStep::Kind;
        const Spot *in = step.in, out = step.out;
        switch (step.kind) {
            case Kind::pair:
                add(in[0], change.number(out));
                add(in[1], change.number(out + 1));
                break;
            case Kind::unit: add(in[0], T(dot(left_of(row.vector(out)), change.vector(out)))); break;
            case Kind::scaled:
                add(in[0], T(dot(row.vector(in[1]), change.vector(out))));
                add(in[1], row.number(in[0]) * change.vector(out));
                break;
            case Kind::less:
                add(in[0], change.vector(out));
                add(in[1], -change.vector(out));
                break;
            case Kind::negated: add(in[0], -change.vector(out)); break;
            case Kind::offset:
                add(in[0], change.vector(out));
                add(in[1], T(dot(left_of(row.vector(in[2])), change.vector(out))));
                add(in[2], row.number(in[1]) * right_of(change.vector(out)));
                break;
            case Kind::reached:
                add(in[0], change.vector(out));
                add(in[1], T(dot(row.vector(in[2]), change.vector(out))));
                add(in[2], row.number(in[1]) * change.vector(out));
                break;
            case Kind::arm:
            case Kind::line: arm(in[0], out); break;
            case Kind::height: {
                const T& of_out = change.number(out);
                add(in[0], of_out);
                add(in[1], of_out * right_of(row.vector(in[2])));
                add(in[2], of_out * left_of(row.vector(in[1])));
                break;
            }
            case Kind::turned: product(in[0], in[1], change.vector(out)); break;
            case Kind::turned_back: {
                const Vector<T> of_out = change.vector(out);
                add(in[0], turned(of_out, row.vector(in[1])));
                add(in[1], turned(row.vector(in[0]), conjugate(of_out)));
                break;
            }
            case Kind::carried:
                add(in[0], change.vector(out));
                product(in[1], in[2], change.vector(out));
                break;
            case Kind::hung:
                add(in[0], change.vector(out));
                product(in[1], in[2], -change.vector(out));
                break;
            case Kind::sum:
                add(in[0], change.number(out));
                add(in[1], change.number(out));
                break;
            case Kind::difference:
                add(in[0], change.number(out));
                add(in[1], T(-change.number(out)));
                break;
            case Kind::displacement: {
                const T& of_out = change.number(out);
                add(in[0], of_out * (row.vector(in[1]) - row.vector(in[2])));
                add(in[1], of_out * row.vector(in[0]));
                add(in[2], T(-of_out) * row.vector(in[0]));
                break;
            }
            case Kind::circles:
            case Kind::round_circles: circles(step); break;
            case Kind::round_dyad: break;  // the triangle says it all
            case Kind::circle_line: circle_line(step); break;
            case Kind::meeting: meeting(step); break;
            case Kind::passing: passing(step); break;
            case Kind::geared_second:
            case Kind::geared_first:
            case Kind::geared_carrier: geared(step); break;
            case Kind::rack_turn: {
                const T of_way = change.number(out) / row.number(in[2]);
                add(in[0], of_way);
                add(in[1], T(-of_way));
                add(in[2], T(-(row.number(out) * of_way)));
                break;
            }
            case Kind::rack_way: {
                const T &of_out = change.number(out), of_turn = row.number(in[2]) * of_out;
                add(in[0], of_turn);
                add(in[1], T(-of_turn));
                add(in[2], (row.number(in[0]) - row.number(in[1])) * of_out);
                add(in[3], of_out);
                break;
            }
            case Kind::unwound: {
                const Vector<T> along = row.vector(in[0]);
                add(in[0], T(change.number(out) / dot(along, along)) * left_of(along));
                break;
            }
        }
    }

private:
    static Vector<T> right_of(const Vector<T>& a) { return {a.y, -a.x}; }

    void add(Spot spot, const T& x) const { change.at[spot] = change.at[spot] + x; }
    void add(Spot spot, const Vector<T>& x) const {
        change.at[spot] = change.at[spot] + x.x;
        change.at[spot + 1] = change.at[spot + 1] + x.y;
    }
    /// Of A B as complex numbers.
    void product(Spot a, Spot b, const Vector<T>& of_out) const {
        add(a, turned(of_out, conjugate(row.vector(b))));
        add(b, turned(of_out, conjugate(row.vector(a))));
    }
    /// What changes of a vector with its direction, a unit vector, and its length.
    static Vector<T> of_polar(const Vector<T>& direction, const T& per_length, const Vector<T>& of_direction,
                              const T& of_length) {
        const Vector<T> left = left_of(direction);
        return T(dot(left, of_direction) * per_length) * left + of_length * direction;
    }

    void arm(Spot in, Spot out) const {
        const T& length = row.number(out + 2);
        if (!(length > T(0))) return add(in, change.vector(out));
        add(in, of_polar(row.vector(out), T(T(1) / length), change.vector(out), change.number(out + 2)));
    }

    /// With unit vectors f and g from the centres to the pin, (second - first) + db g - da f = a f' - b g' of their
    /// turns; and a b cross(f, g) is twice the area of the triangle, which has its digits from the margins.
    void circles(const PlainStep& step) const {
        const Spot *in = step.in, out = step.out;
        const T &a = row.number(in[2]), &b = row.number(in[3]), &side = row.number(in[4]);
        const T area = side * row.number(out + 6);  // eight times that
        if (!(value_of(area) != 0)) return circles_in_line(step);
        const bool all = step.first && step.second;
        Vector<T> f = row.vector(out), g = row.vector(out + 2);
        if (!all) {
            const Circles<T> met = step.kind == PlainStep::Kind::round_circles
                                       ? round_circles(step, row)
                                       : Circles<T>(row.vector(in[0]), row.vector(in[1]), a, b, side);
            if (!step.first) f = met.from_first();
            if (!step.second) g = met.from_second();
        }
        const T per_area = T(4) / area;
        Vector<T> force{T(0), T(0)};
        if (step.first) force = T(dot(left_of(f), change.vector(out)) * (b * per_area)) * g;
        if (step.second) force = force + T(dot(left_of(g), change.vector(out + 2)) * (a * per_area)) * f;
        add(in[0], -force);
        add(in[1], force);
        add(in[2], T(-dot(force, f)));
        add(in[3], T(dot(force, g)));
    }
    /// A triangle without area: f = p u and g = -q u, u along the centres, p and q by the law of cosines.
    void circles_in_line(const PlainStep& step) const {
        const Spot *in = step.in, out = step.out;
        const T &a = row.number(in[2]), &b = row.number(in[3]);
        const Vector<T> apart = row.vector(in[1]) - row.vector(in[0]);
        const T d = hypotenuse(apart.x, apart.y), inverse = T(1) / d;
        const Vector<T> along = inverse * apart, none{T(0), T(0)};
        const Vector<T> of_f = step.first ? change.vector(out) : none,
                        of_g = step.second ? change.vector(out + 2) : none;
        const T p = ((a - b) * (a + b) / d + d) / (T(2) * a), q = ((b - a) * (b + a) / d + d) / (T(2) * b);
        const T of_p = dot(along, of_f), of_q = -dot(along, of_g);
        add(in[2], of_p * (inverse - p / a) - of_q * (a * inverse / b));
        add(in[3], of_q * (inverse - q / b) - of_p * (b * inverse / a));
        const T of_d = of_p * (T(1) / a - p * inverse) + of_q * (T(1) / b - q * inverse);
        const Vector<T> force = of_polar(along, inverse, p * of_f - q * of_g, of_d);
        add(in[0], -force);
        add(in[1], force);
    }

    /// centre + run direction + height left; run^2 + height^2 = radius^2.
    void circle_line(const PlainStep& step) const {
        const Spot *in = step.in, out = step.out;
        const Vector<T> direction = row.vector(in[2]), left = left_of(direction);
        const Vector<T> apart = row.vector(in[1]) - row.vector(in[0]), from = row.vector(out + 2);
        const T &radius = row.number(in[3]), &run = row.number(out + 6), height = dot(left, apart);
        const Vector<T> of_from = (T(1) / radius) * change.vector(out + 2), of_arm = change.vector(out) + of_from;
        T of_height = dot(left, of_arm), of_radius = -dot(from, of_from);
        if (value_of(run) != 0) {
            const T of_run = dot(direction, of_arm) / run;
            of_radius = of_radius + of_run * radius;
            of_height = of_height - of_run * height;
        }
        add(in[0], change.vector(out) - of_height * left);
        add(in[1], of_height * left);
        add(in[2], run * of_arm + right_of(height * of_arm + of_height * apart));
        add(in[3], of_radius);
    }

    /// A + k B, k = (C - A) x D / B x D.
    void meeting(const PlainStep& step) const {
        const Spot *in = step.in, out = step.out;
        const Vector<T> b = row.vector(in[1]), d = row.vector(in[3]), apart = row.vector(in[2]) - row.vector(in[0]);
        const T per_sine = T(1) / cross(b, d), k = cross(apart, d) * per_sine;
        const Vector<T> of_at = change.vector(out);
        const T of_cross = dot(b, of_at) * per_sine, of_sine = -(k * of_cross);
        const Vector<T> of_apart = of_cross * right_of(d);
        add(in[0], of_at - of_apart);
        add(in[1], k * of_at + of_sine * right_of(d));
        add(in[2], of_apart);
        add(in[3], of_cross * left_of(apart) + of_sine * left_of(b));
    }

    /// The direction between the pins, turned back by that of the line and by the angle whose sine is the height over
    /// the pins' distance.
    void passing(const PlainStep& step) const {
        const Spot *in = step.in, out = step.out;
        const T &height = row.number(in[3]), &run = row.number(out + 4), &inverse = row.number(out + 5);
        const Vector<T> direction = row.vector(in[2]);
        const Vector<T> along = inverse * (row.vector(in[1]) - row.vector(in[0]));
        const Vector<T> lean{run * inverse, height * inverse}, of_out = change.vector(out);
        const Vector<T> of_along = turned(turned(of_out, direction), lean);
        add(in[2], turned(turned(along, conjugate(lean)), conjugate(of_out)));
        const Vector<T> of_lean = turned(turned(along, conjugate(direction)), conjugate(of_out));
        T of_height = inverse * of_lean.y, of_distance = -(lean.y * of_height);
        if (value_of(run) != 0) {
            const T of_angle = dot(left_of(lean), of_lean) / run;
            of_height = of_angle;
            of_distance = -(of_angle * lean.y);
        }
        add(in[3], of_height);
        const Vector<T> force = of_polar(along, inverse, of_along, of_distance);
        add(in[0], -force);
        add(in[1], force);
    }

    void geared(const PlainStep& step) const {
        const Spot *in = step.in, out = step.out;
        const T &of_out = change.number(out), &ratio = row.number(in[3]);
        const T& first = row.number(in[0]);
        if (step.kind == PlainStep::Kind::geared_second) {
            add(in[0], ratio * of_out);
            add(in[2], (T(1) - ratio) * of_out);
            add(in[3], (first - row.number(in[2])) * of_out);
            add(in[4], of_out);
        } else if (step.kind == PlainStep::Kind::geared_first) {
            const T part = of_out / ratio;
            add(in[1], part);
            add(in[2], of_out - part);
            add(in[3], (row.number(in[2]) - row.number(out)) * part);
            add(in[4], T(-part));
        } else {
            const T part = of_out / (ratio - T(1));
            add(in[0], ratio * part);
            add(in[1], T(-part));
            add(in[3], (first - row.number(out)) * part);
            add(in[4], part);
        }
    }
};

}  // namespace detail

/// Begins a sweep: nothing of the row changes anything. What is asked for is then set in `change` at its spots:
/// `change[needed.point] = 1` for the x of the pin, the spot after it for its y.
template <class T>
void start_back(const Needed& needed, std::span<T> change) {
    std::fill_n(change.begin(), needed.size, T(0));
}

/// Sweeps back through all steps of what was placed in `row` last. Afterwards `change` holds the derivatives at the
/// spots of numbers (Needed::number) and inputs (Needed::drive) of the weighted sum of what `change` was set at.
template <class T>
void sweep_back(const Needed& needed, std::span<T> row, std::span<T> change) {
    const detail::Back<T> back{{row.data()}, {change.data()}};
    for (std::size_t i = needed.steps.size(); i-- > 0;)
        back.one(needed.steps[i]);
    for (std::uint32_t i = 0; i < needed.drives; ++i) {
        if (!needed.turning[i]) continue;
        const Spot at = needed.drive(i), direction = at + 1;
        change[at] = change[at] + dot(left_of(back.row.vector(direction)), back.change.vector(direction));
    }
}

}  // namespace mechwright::linkage

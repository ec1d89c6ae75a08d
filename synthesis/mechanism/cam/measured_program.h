#pragma once
/// \file
/// Turns a measure of a cam at one place, written once as a template, into the Measure functions of the registry. At a
/// place a measure depends on the geometry of the follower and on the parameters of one segment alone; its derivatives
/// are taken in those and then spread over the dimensions of the whole mechanism, the lift at the segment's start over
/// the lifts before it.

#include <array>
#include <cstddef>
#include <span>

#include "synthesis/mechanism/cam/segment_places.h"
#include "synthesis/mechanism/measured.h"

namespace mechwright::cam {

/// Geometry, then start lift, lift, angle, and the numbers of a polynomial.
inline constexpr std::size_t local_count = most_geometry + 3 + 2 * MotionProgram::most_ends + MotionProgram::most_shape;

/// A share of a local parameter in a dimension of the mechanism.
struct Share {
    std::size_t local;
    std::size_t dimension;
    double factor;
};

/// The local parameters of a segment with the dimensions that they come from.
class Shares {
public:
    void add(const Share& share) { all_[count_++] = share; }
    const Share* begin() const { return all_.data(); }
    const Share* end() const { return all_.data() + count_; }

private:
    std::array<Share, local_count + MotionProgram::most_segments> all_;
    std::size_t count_ = 0;
};

template <template <class> class Follower>
Shares shares_of(const MotionProgram& program, std::size_t index) {
    constexpr ProgramSlots at = slots<Follower>;
    Shares shares;
    for (std::size_t i = 0; i < Layout<Follower>::geometry; ++i)
        shares.add({i, i, 1});
    constexpr std::size_t start_lift = most_geometry, lift = start_lift + 1, angle = lift + 1, ends = angle + 1;
    for (std::size_t i = 0; i < index; ++i)
        if (const int sign = lift_sign(program.segments[i].kind); sign != 0)
            shares.add({start_lift, at.lift(i), static_cast<double>(sign)});
    shares.add({lift, at.lift(index), 1});
    shares.add({angle, at.angle(index), 1});
    const SegmentPlan& plan = program.segments[index];
    std::size_t c = plan.first_coefficient;
    const auto add = [&](std::size_t first, std::size_t count) {
        for (std::size_t i = 0; i < count; ++i)
            shares.add({first + i, at.coefficient(c++), 1});
    };
    add(ends, plan.start_count);
    add(ends + MotionProgram::most_ends, plan.end_count);
    add(ends + 2 * MotionProgram::most_ends, plan.shape_count);
    return shares;
}

/// Geometry and segment of a place from its local parameters, as numbers of type T.
template <template <class> class Follower, class T>
struct Local {
    Follower<T> follower;
    FollowerLoad<T> load;
    Segment<T> segment;
    T start_lift;
};

template <template <class> class Follower, class T>
Local<Follower, T> local_of(const Motion& motion, std::size_t index, const std::array<T, local_count>& x) {
    std::array<T, most_geometry> geometry;
    std::copy_n(x.begin(), most_geometry, geometry.begin());
    SegmentParameters<T> p;
    auto from = x.begin() + most_geometry;
    p.start_lift = *from++;
    p.lift = *from++;
    p.angle = *from++;
    std::copy_n(from, p.start.size(), p.start.begin());
    std::copy_n(from + p.start.size(), p.end.size(), p.end.begin());
    std::copy_n(from + p.start.size() + p.end.size(), p.shape.size(), p.shape.begin());
    return {Layout<Follower>::make(geometry, sense_of(motion.assembly)), load_of<Follower>(geometry, motion),
            with_contour<Follower>(segment_of(program_of(motion), motion.assembly, index, p),
                                   program_of(motion).segments[index], geometry),
            p.start_lift};
}

/// The follower, its load and its lift at a place, from the local parameters of the place's segment.
template <template <class> class Follower, class T>
struct Located {
    Local<Follower, T> local;
    Lift<T> lift;
};

/// Compiled once for each follower and type of numbers, whatever is measured there.
template <template <class> class Follower, class T>
[[gnu::noinline]] Located<Follower, T> located(const Motion& motion, const SegmentPlace& place,
                                               const std::array<T, local_count>& x, const T& u) {
    Located<Follower, T> at{local_of<Follower, T>(motion, place.segment, x),
                            lift_at(at.local.segment, place.piece, u, at.local.start_lift)};
    return at;
}

/// The values of the local parameters.
std::array<double, local_count> local_values(const Shares& shares, std::span<const double> dimensions);

/// A component of a measurement that terms are added to, of so many dimensions.
struct Sum {
    const Measurement* out;
    std::size_t component;
    std::size_t dimensions;

    void add(double factor, double value) const { out->value[component] += factor * value; }
    void add(double factor, const Dual<double, local_count>& value, const Shares& shares) const;
    void add(double factor, const SecondDual<double, local_count>& value, const Shares& shares) const;
};

/// A measure at places, times factors, added up: one component of a quantity.
struct Term {
    SegmentPlace place;
    double factor;
};

/// Adds factor * value(follower, lift), value(follower, lift, load) or value(contour), at a place to a component of a
/// measurement.
template <template <class> class Follower, class Value>
void add_term(const Motion& motion, std::span<const double> dimensions, const Term& term, const Value& value,
              std::size_t component, const Measurement& out) {
    const SegmentPlace& place = term.place;
    const auto shares = shares_of<Follower>(program_of(motion), place.segment);
    const auto plain = local_values(shares, dimensions);
    const auto at = [&]<class T>(const std::array<T, local_count>& x, const T& u) {
        const auto here = located<Follower, T>(motion, place, x, u);
        if constexpr (requires { value(here.local.segment.contour); })
            return value(here.local.segment.contour);
        else if constexpr (requires { value(here.local.follower, here.lift, here.local.load); })
            return value(here.local.follower, here.lift, here.local.load);
        else
            return value(here.local.follower, here.lift);
    };
    const Sum sum{&out, component, dimension_count<Follower>};
    if (!out.hessian.empty()) {
        using T = SecondDual<double, local_count>;
        const auto seeds = seeded<T, local_count>(plain);
        sum.add(term.factor, place.stationary ? at_stationary(seeds, place.u, at) : at(seeds, T(place.u)), shares);
    } else if (!out.gradient.empty()) {
        using T = Dual<double, local_count>;
        sum.add(term.factor, at(seeded<T, local_count>(plain), T(place.u)), shares);
    } else {
        sum.add(term.factor, at(plain, place.u));
    }
}

/// Sets the first components to zero, where terms are to be added.
void clear(const Measurement& out, std::size_t components, std::size_t dimensions);

/// Says of the first components that they have no value.
void set_to_nothing(const Measurement& out, std::size_t components);

/// A segment as it stands, with the lift at its start.
struct PlacedSegment {
    Segment<double> segment;
    double start_lift;
};

template <template <class> class Follower>
PlacedSegment placed_segment(const Motion& motion, std::span<const double> dimensions, std::size_t index) {
    const auto p = parameters_of<double>(program_of(motion), slots<Follower>, dimensions, index);
    return {with_contour<Follower>(segment_of(program_of(motion), motion.assembly, index, p),
                                   program_of(motion).segments[index], geometry_of<Follower, double>(dimensions)),
            p.start_lift};
}

}  // namespace mechwright::cam

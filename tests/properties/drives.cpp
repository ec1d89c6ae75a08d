// Properties that hold for every drive of a ram: velocity and acceleration are the derivatives of the position in time
// (Coriolis terms included), closed forms of limits and strokes are what the motion does, extremes are all found, and
// sizes do not matter.

#include "tests/properties/drives.h"

namespace mechwright::test {
namespace {

constexpr double turn = 2 * std::numbers::pi;

/// Relative to the greatest it is over a few places, so that zeros do not count.
template <class Function>
double greatest_size(const Function& f) {
    double most = 0;
    for (int i = 0; i < 64; ++i)
        most = std::max(most, std::abs(f(turn * i / 64)));
    return most;
}

/// A crank angle, half of the time next to where links of a drag link next to a change point are in line: there they
/// move so fast that few places of a turn tell.
double drawn_crank_angle() {
    if (*rc::gen::arbitrary<bool>()) return between(0, turn);
    return *rc::gen::element(0.0, turn / 2, turn) + drawn_sign() * log_between(1e-9, 1);
}

RC_GTEST_PROP(Drives, MoveAsTheDerivativesOfTheirPosition, ()) {
    const double at = drawn_crank_angle();
    for_each_drive([&](const auto& m) {
        using Rate = Dual<double, 1>;
        const auto dual = converted<Rate>(m);
        const Rate angle = Rate::variable(at, 0);
        const double speed = ram_velocity(m, at);
        const double acceleration = ram_acceleration(m, at);
        const double jerk = ram_acceleration(dual, angle).partial[0];
        const double speeds = std::max(std::abs(speed), greatest_size([&](double x) { return ram_velocity(m, x); }));
        const double accelerations =
            std::max(std::abs(acceleration), greatest_size([&](double x) { return ram_acceleration(m, x); }));
        // A crank angle is known within its rounding, which fast motion makes much of.
        const double rounding = 8 * std::numeric_limits<double>::epsilon() * turn;
        RC_ASSERT(std::abs(speed - ram_position(dual, angle).partial[0]) <=
                  1e-11 * speeds + rounding * std::abs(acceleration));
        RC_ASSERT(std::abs(acceleration - ram_velocity(dual, angle).partial[0]) <=
                  1e-9 * accelerations + rounding * std::abs(jerk));
    });
}

RC_GTEST_PROP(Drives, MoveWithAnAcceleratedCrankAsTheChainRuleSays, ()) {
    const double at = between(0, turn), speed = between(-3, 3), push = between(-3, 3);
    for_each_drive([&](const auto& m) {
        const auto p = pose_at(m, at);
        const auto v = velocity(m, p, speed);
        const double scale = greatest_size([&](double x) { return ram_velocity(m, x); }) +
                             greatest_size([&](double x) { return ram_acceleration(m, x); });
        RC_ASSERT(std::abs(ram_of(v).ram - speed * ram_velocity(m, at)) <= 1e-11 * scale);
        RC_ASSERT(std::abs(ram_of(acceleration(m, p, v, push)).ram -
                           (speed * speed * ram_acceleration(m, at) + push * ram_velocity(m, at))) <= 1e-10 * scale);
    });
}

RC_GTEST_PROP(Drives, TurnBackAtTheirLimitsAndNowhereElse, ()) {
    for_each_drive([&](const auto& m) {
        const auto limits = ram_limits(m);
        const auto angles = strokes(m);
        const double way = stroke(m);
        RC_ASSERT(angles.outward > 0 && angles.inward > 0);
        RC_ASSERT(std::abs(angles.outward + angles.inward - turn) <= 1e-14 * turn);
        RC_ASSERT(std::abs(limits.outer.position - limits.inner.position - way) <=
                  1e-13 * (way + std::abs(limits.outer.position)));
        RC_ASSERT(std::abs(limits.outer.crank_angle + angles.inward - limits.inner.crank_angle) <= 1e-13);
        RC_ASSERT(std::abs(ram_position(m, limits.outer.crank_angle) - limits.outer.position) <= 1e-9 * way);
        RC_ASSERT(std::abs(ram_position(m, limits.inner.crank_angle) - limits.inner.position) <= 1e-9 * way);
        double last = limits.outer.position;
        for (int i = 1; i < 40; ++i) {  // all the way in, then all the way out
            const double x = ram_position(m, limits.outer.crank_angle + angles.inward * i / 40);
            RC_ASSERT(x <= last + 1e-12 * way);
            last = x;
        }
        last = limits.inner.position;
        for (int i = 1; i < 40; ++i) {
            const double x = ram_position(m, limits.inner.crank_angle + angles.outward * i / 40);
            RC_ASSERT(x >= last - 1e-12 * way);
            last = x;
        }
    });
}

/// Sign changes of a function over a turn at many places: no fewer zeros can there be.
template <class Function>
int changes_of_sign(const Function& f) {
    constexpr int places = 4000;
    int count = 0;
    bool before = f(0) > 0;
    for (int i = 1; i <= places; ++i) {
        const bool now = f(turn * i / places) > 0;
        count += now != before;
        before = now;
    }
    return count;
}

RC_GTEST_PROP(Drives, HaveAllTheirExtremesFound, ()) {
    const CrankRange<double> full{true, 0, turn};
    for_each_drive([&](const auto& m) {
        const auto found = [&](const RamExtremes& extremes) { return static_cast<int>(extremes.count); };
        const auto velocity_at = [&](double x) { return ram_velocity(m, x); };
        const auto acceleration_at = [&](double x) { return ram_acceleration(m, x); };
        RC_ASSERT(found(ram_position_extremes(m, full)) == 2);
        RC_ASSERT(found(ram_velocity_extremes(m, full)) >= changes_of_sign(acceleration_at));
        RC_ASSERT(found(ram_acceleration_extremes(m, full)) >=
                  changes_of_sign([&](double x) { return ram_jerk(m, x); }));
        // None of many places is beyond them.
        double fastest = 0, most = 0;
        const auto velocities = ram_velocity_extremes(m, full), accelerations = ram_acceleration_extremes(m, full);
        for (const double x : velocities.all())
            fastest = std::max(fastest, std::abs(velocity_at(x)));
        for (const double x : accelerations.all())
            most = std::max(most, std::abs(acceleration_at(x)));
        RC_ASSERT(greatest_size(velocity_at) <= fastest * (1 + 1e-12));
        RC_ASSERT(greatest_size(acceleration_at) <= most * (1 + 1e-12));
    });
}

RC_GTEST_PROP(Drives, DoTheMiddleShareOnTheirSlowStroke, ()) {
    const double share = between(0.01, 0.99);
    for_each_drive([&](const auto& m) {
        const auto angles = strokes(m);
        const auto limits = ram_limits(m);
        const auto part = working_part(m, share);
        const double way = stroke(m), inset = 0.5 * (1 - share) * way;
        RC_ASSERT(part.outward == (angles.outward >= angles.inward));
        RC_ASSERT(part.from < part.to);
        RC_ASSERT(part.to - part.from < std::max(angles.outward, angles.inward));
        const double first = part.outward ? limits.inner.position + inset : limits.outer.position - inset;
        const double last = part.outward ? limits.outer.position - inset : limits.inner.position + inset;
        // A crank angle is known to its own rounding.
        const auto near = [&](double x, double position) {
            const double moves = 8 * ulp * std::abs(x * ram_velocity(m, x));
            return std::abs(ram_position(m, x) - position) <= 1e-12 * (way + std::abs(position)) + moves;
        };
        RC_ASSERT(near(part.from, first));
        RC_ASSERT(near(part.to, last));
        RC_ASSERT((ram_velocity(m, 0.5 * (part.from + part.to)) > 0) == part.outward);
    });
}

SliderCrank<double> scaled(const SliderCrank<double>& m, double k) { return {k * m.crank, k * m.rod, k * m.offset}; }
CrankShaper<double> scaled(const CrankShaper<double>& m, double k) {
    return {k * m.centre_distance, k * m.crank, k * m.lever, k * m.rod, k * m.ram_distance};
}
Whitworth<double> scaled(const Whitworth<double>& m, double k) {
    return {k * m.centre_distance, k * m.crank, k * m.arm, k * m.rod, m.slide_angle};
}
DragLink<double> scaled(const DragLink<double>& m, double k) {
    const FourBar<double> links{k * m.links.ground, k * m.links.crank, k * m.links.coupler, k * m.links.rocker};
    return {links, k * m.arm, m.arm_angle, k * m.rod, m.slide_angle, k * m.slide_offset, m.assembly};
}

RC_GTEST_PROP(Drives, KeepEveryBitAtAnotherSize, ()) {
    const double at = between(0, turn);
    const double k = std::ldexp(1.0, *rc::gen::inRange(-20, 21));
    for_each_drive([&](const auto& m) {
        const auto other = scaled(m, k);
        RC_ASSERT(k * ram_position(m, at) == ram_position(other, at));
        RC_ASSERT(k * ram_velocity(m, at) == ram_velocity(other, at));
        RC_ASSERT(k * ram_acceleration(m, at) == ram_acceleration(other, at));
        RC_ASSERT(k * stroke(m) == stroke(other));
        RC_ASSERT(strokes(m).outward == strokes(other).outward);
        RC_ASSERT(working_part(m, 0.6).from == working_part(other, 0.6).from);
    });
}

}  // namespace
}  // namespace mechwright::test

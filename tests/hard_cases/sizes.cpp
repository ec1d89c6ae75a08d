// The unit of length does not matter: every hard case again at sizes from 2^-40 to 2^40. Directions, angles, ratios and
// angular accelerations have the same bits, lengths are scaled exactly.

#include <array>
#include <cmath>
#include <functional>

#include "analysis/cam/flat_follower.h"
#include "analysis/cam/roller_follower.h"
#include "analysis/quick_return.h"
#include "analysis/quick_return/assembled.h"
#include "tests/hard_cases/table.h"

namespace mechwright::test {
namespace {

constexpr std::array sizes{-40, -31, -20, -7, 7, 20, 31, 40};

/// The numbers of a case that have no unit, and those that are lengths.
struct Measured {
    std::vector<double> plain;
    std::vector<double> lengths;
};

/// Measures a row at a size: `at` takes the factor for its lengths.
void expect_same_at_all_sizes(const Row& row, const std::function<Measured(double)>& at) {
    const auto same = [](double a, double b) { return a == b || (std::isnan(a) && std::isnan(b)); };
    const Measured one = at(1);
    for (const int k : sizes) {
        const Measured other = at(std::ldexp(1, k));
        for (std::size_t i = 0; i < one.plain.size(); ++i)
            EXPECT_TRUE(same(other.plain[i], one.plain[i])) << i << " at 2^" << k << ": " << row.label();
        for (std::size_t i = 0; i < one.lengths.size(); ++i)
            EXPECT_TRUE(same(other.lengths[i], std::ldexp(one.lengths[i], k)))
                << "length " << i << " at 2^" << k << ": " << row.label();
    }
}

FourBar<double> times(double unit, const FourBar<double>& m) {
    return {unit * m.ground, unit * m.crank, unit * m.coupler, unit * m.rocker};
}

TEST(HardSizes, KeepFourBarsTheSame) {
    for (const Row& row : table("poses.csv"))
        expect_same_at_all_sizes(row, [&](double unit) {
            const auto m = times(unit, row.links());
            const CouplerPoint<double> point{unit * row.number("along"), unit * row.number("across")};
            const auto p = pose(m, row.half(), row.assembly());
            const auto v = velocity(m, p);
            const auto a = acceleration(m, p, v);
            const auto at = position(m, point, p), moving = velocity(m, point, p, v);
            const auto speeding = acceleration(m, point, p, v, a);
            return Measured{
                {p.coupler.x, p.coupler.y, p.rocker.x, p.rocker.y, p.transmission_sine, p.transmission_cosine,
                 transmission_angle(m, row.half()), v.coupler, v.rocker, a.coupler, a.rocker},
                {p.margins.stretch, p.margins.fold, at.x, at.y, moving.x, moving.y, speeding.x, speeding.y}};
        });
}

TEST(HardSizes, KeepLimitPositionsTheSame) {
    for (const Row& row : table("limits.csv"))
        expect_same_at_all_sizes(row, [&](double unit) {
            const auto m = times(unit, row.links());
            const auto limits = limit_positions(m, Assembly::open);
            return Measured{{swing(m), stroke_excess(m), limits.extended.crank_angle, limits.folded.crank_angle,
                             limits.extended.rocker_angle, limits.folded.rocker_angle,
                             limits.extended.transmission_angle, limits.folded.transmission_angle},
                            {grashof_margin(m)}};
        });
}

/// A drive with everything that it does at a crank angle, and its strokes where it has any.
template <class Drive>
Measured measured(const Drive& m, double crank_angle, bool turns) {
    const auto p = pose_at(m, crank_angle);
    const auto v = velocity(m, p);
    const auto a = acceleration(m, p, v);
    Measured all{{transmission_angle(ram_of(p)), ram_of(p).rod.x, ram_of(p).rod.y, ram_of(v).crank, ram_of(v).rod,
                  ram_of(a).crank, ram_of(a).rod},
                 {ram_of(p).position, ram_of(v).ram, ram_of(a).ram}};
    if (!turns) return all;
    const auto both = strokes(m);
    all.plain.insert(all.plain.end(), {both.outward, both.inward});
    all.lengths.push_back(stroke(m));
    return all;
}

TEST(HardSizes, KeepSliderCranksTheSame) {
    for (const Row& row : table("slider_cranks.csv"))
        expect_same_at_all_sizes(row, [&](double unit) {
            const SliderCrank<double> m{unit * row.number("crank"), unit * row.number("rod"),
                                        unit * row.number("offset")};
            return measured(m, row.number("crank_angle"), makes_two_strokes(m));
        });
}

double angle_in(const Row& row) {
    return row.text("crank_angle") == "pi" ? std::numbers::pi : row.number("crank_angle");
}

TEST(HardSizes, KeepQuickReturnsTheSame) {
    for (const Row& row : table("crank_shapers.csv"))
        expect_same_at_all_sizes(row, [&](double unit) {
            const CrankShaper<double> m{unit * row.number("centre_distance"), unit * row.number("crank"),
                                        unit * row.number("lever"), unit * row.number("rod"),
                                        unit * row.number("ram_distance")};
            return measured(m, angle_in(row), makes_two_strokes(m));
        });
    for (const Row& row : table("whitworths.csv"))
        expect_same_at_all_sizes(row, [&](double unit) {
            const Whitworth<double> m{unit * row.number("centre_distance"), unit * row.number("crank"),
                                      unit * row.number("arm"), unit * row.number("rod"), row.number("slide_angle")};
            return measured(m, angle_in(row), makes_two_strokes(m));
        });
    for (const Row& row : table("drag_links.csv"))
        expect_same_at_all_sizes(row, [&](double unit) {
            const DragLink<double> m{
                times(unit, {row.number("ground"), row.number("crank"), row.number("coupler"), row.number("follower")}),
                unit * row.number("arm"),
                row.number("arm_angle"),
                unit * row.number("rod"),
                row.number("slide_angle"),
                unit * row.number("offset"),
                row.assembly()};
            return measured(m, angle_in(row), makes_two_strokes(m));
        });
}

template <class Follower>
Measured measured_roller(const Follower& follower, const cam::Lift<double>& lift, double unit) {
    const auto p = pitch_point(follower, lift);
    const auto contact = contact_point(p, follower.roller_radius);
    return {{pressure_angle(p), 1 - follower.roller_radius * curvature(p), unit * curvature(p)},
            {contact.x, contact.y}};
}

template <class Follower>
Measured measured_flat(const Follower& follower, const cam::Lift<double>& lift) {
    const auto contact = face_contact(follower, lift);
    return {{contact.pressure_angle, contact.margin, contact.radius / follower.base_radius},
            {contact.radius, contact.position.x, contact.position.y}};
}

TEST(HardSizes, KeepCamsTheSame) {
    for (const Row& row : table("cams.csv"))
        expect_same_at_all_sizes(row, [&](double unit) {
            const std::string& follower = row.text("follower");
            const auto size = [&](const char* column) { return unit * row.number(column); };
            const cam::Lift<double> angles{row.number("lift_here"), row.number("velocity"), row.number("acceleration"),
                                           0};
            const cam::Lift<double> lengths{size("lift_here"), size("velocity"), size("acceleration"), 0};
            if (follower == "roller")
                return measured_roller(cam::TranslatingRoller<double>{size("size_1"), size("size_2"), size("size_3")},
                                       lengths, unit);
            if (follower == "arm")
                return measured_roller(
                    cam::OscillatingRoller<double>{size("size_1"), size("size_3"), size("size_4"), size("size_2")},
                    angles, unit);
            if (follower == "flat") return measured_flat(cam::TranslatingFlat<double>{size("size_1")}, lengths);
            return measured_flat(cam::OscillatingFlat<double>{size("size_1"), size("size_2"), size("size_3")}, angles);
        });
}

}  // namespace
}  // namespace mechwright::test

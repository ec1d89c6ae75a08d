// Contacts of cams next to cusps and inflections, where motions join dwells, and at odd sizes; against fifty digits.

#include <algorithm>
#include <cmath>

#include "analysis/cam/flat_follower.h"
#include "analysis/cam/roller_follower.h"
#include "analysis/cam/segment.h"
#include "tests/hard_cases/digits.h"

namespace mechwright::test {
namespace {

cam::Law law_of(const Row& row) {
    const std::string& name = row.text("law");
    if (name == "cycloidal") return cam::Law::cycloidal;
    if (name == "harmonic") return cam::Law::harmonic;
    if (name == "modified-sine") return cam::Law::modified_sine;
    if (name == "3-4-5") return cam::Law::polynomial_345;
    if (name == "4-5-6-7") return cam::Law::polynomial_4567;
    EXPECT_EQ(name, "kloomok-muffley");
    return cam::Law::kloomok_muffley;
}

cam::Lift<double> lift_of(const Row& row) {
    cam::Segment<double> segment;
    segment.kind = cam::SegmentKind::rise;
    segment.law.law = law_of(row);
    segment.angle = row.number("angle");
    segment.lift = row.number("lift");
    const double part = row.number("part");
    std::size_t piece = 0;
    while (piece + 1 < pieces(segment) && part > break_before(segment, piece + 1))
        ++piece;
    return lift_at(segment, piece, part, 0.0);
}

void expect_lift(Digits& kept, const Row& row, const cam::Lift<double>& lift) {
    const double rise = row.number("lift"), angle = row.number("angle");
    kept.expect(row, "lift_here", lift.s, rise);
    kept.expect(row, "velocity", lift.v, rise / angle);
    kept.expect(row, "acceleration", lift.a, rise / (angle * angle));
}

void expect_place(Digits& kept, const Row& row, const Vector<double>& contact) {
    const double size = std::hypot(row.number("contact_x"), row.number("contact_y"));
    kept.expect(row, "contact", contact, size);
}

/// On the scale of the curvature that the terms of the formula would make alone.
template <class Follower>
void expect_roller(Digits& kept, const Row& row, const Follower& follower, const cam::Lift<double>& lift) {
    const auto p = pitch_point(follower, lift);
    const double speed = std::hypot(p.across, p.along);
    const double arm = [&] {
        if constexpr (requires { follower.arm_length; })
            return follower.arm_length;
        else
            return 1.0;
    }();
    const double bend = std::abs(p.bend) / (speed * speed * speed);
    const double bent = (1 + arm * std::abs(lift.a) / speed) / speed;
    kept.expect(row, "pressure_angle", pressure_angle(p), 1);
    kept.expect(row, "curvature", curvature(p), std::max(bend, bent));
    kept.expect(row, "undercut_margin", 1 - follower.roller_radius * curvature(p),
                1 + follower.roller_radius * std::max(bend, bent));
    expect_place(kept, row, contact_point(p, follower.roller_radius));
}

template <class Follower>
void expect_flat(Digits& kept, const Row& row, const Follower& follower, const cam::Lift<double>& lift) {
    const auto contact = face_contact(follower, lift);
    const double arm = [&] {
        if constexpr (requires { follower.pivot_distance; })
            return follower.pivot_distance;
        else
            return 1.0;
    }();
    const double scale = follower.base_radius + arm * (std::abs(lift.s) + std::abs(lift.a));
    kept.expect(row, "pressure_angle", contact.pressure_angle, 1);
    kept.expect(row, "curvature", contact.radius, scale);  // of a flat face the table has the radius
    kept.expect(row, "undercut_margin", contact.radius / follower.base_radius, scale / follower.base_radius);
    expect_place(kept, row, contact.position);
}

TEST(HardCamContacts, AreAsExactAsTheirConditioning) {
    const auto rows = table("cams.csv");
    ASSERT_EQ(rows.size(), 558u);
    Digits kept("cams: contacts"), motion("cams: lift");
    for (const Row& row : rows) {
        const auto lift = lift_of(row);
        const int sense = row.number("sense") > 0 ? 1 : -1;
        const auto size = [&](const char* column) { return row.number(column); };
        expect_lift(motion, row, lift);
        const std::string& follower = row.text("follower");
        if (follower == "roller")
            expect_roller(kept, row,
                          cam::TranslatingRoller<double>{size("size_1"), size("size_2"), size("size_3"), sense}, lift);
        else if (follower == "arm")
            expect_roller(
                kept, row,
                cam::OscillatingRoller<double>{size("size_1"), size("size_3"), size("size_4"), size("size_2"), sense},
                lift);
        else if (follower == "flat")
            expect_flat(kept, row, cam::TranslatingFlat<double>{size("size_1"), sense}, lift);
        else
            expect_flat(kept, row, cam::OscillatingFlat<double>{size("size_1"), size("size_2"), size("size_3"), sense},
                        lift);
    }
}

}  // namespace
}  // namespace mechwright::test

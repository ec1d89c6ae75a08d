// The quantities of ram-driving mechanisms measured twice, by the analysis and by the geometry of verification, which
// share no formula; and verification's own measures against closed forms in fifty digits.

#include <algorithm>
#include <array>
#include <vector>

#include "synthesis/mechanism/crank_shaper/again.h"
#include "synthesis/mechanism/crank_shaper/layout.h"
#include "synthesis/mechanism/drag_link/again.h"
#include "synthesis/mechanism/drag_link/layout.h"
#include "synthesis/mechanism/possible_values.h"
#include "synthesis/mechanism/slider_crank/again.h"
#include "synthesis/mechanism/slider_crank/layout.h"
#include "synthesis/mechanism/whitworth/again.h"
#include "synthesis/mechanism/whitworth/layout.h"
#include "tests/properties/drives.h"

namespace mechwright::test {
namespace {

using namespace quick_return;

std::vector<double> dimensions_of(const SliderCrank<double>& m) { return {m.crank, m.rod, m.offset, 0, 0, 0, 0, 0, 0}; }
std::vector<double> dimensions_of(const CrankShaper<double>& m) {
    return {m.centre_distance, m.crank, m.lever, m.rod, m.ram_distance};
}
std::vector<double> dimensions_of(const Whitworth<double>& m) {
    return {m.centre_distance, m.crank, m.arm, m.rod, m.slide_angle};
}
std::vector<double> dimensions_of(const DragLink<double>& m) {
    return {m.links.ground, m.links.crank, m.links.coupler, m.links.rocker, m.arm,
            m.arm_angle,    m.rod,         m.slide_angle,   m.slide_offset};
}
std::string_view name_of(const SliderCrank<double>&) { return "slider-crank"; }
std::string_view name_of(const CrankShaper<double>&) { return "crank-shaper"; }
std::string_view name_of(const Whitworth<double>&) { return "whitworth"; }
std::string_view name_of(const DragLink<double>&) { return "drag-link"; }
template <class Drive>
std::size_t assembly_of(const Drive&) {
    return 0;
}
std::size_t assembly_of(const DragLink<double>& m) { return m.assembly == Assembly::open ? 0 : 1; }

std::vector<Digits50> precise_of(const std::vector<double>& x) { return {x.begin(), x.end()}; }

double measured(const Quantity& quantity, const Motion& motion, const std::vector<double>& dimensions) {
    std::array<double, Quantity::most_components> components;
    Measurement out;
    out.value = components;
    measure(quantity, motion, dimensions, out);
    const std::span<const double> all(components.data(), quantity.components(motion));
    return quantity.reduce == Reduce::least ? *std::min_element(all.begin(), all.end())
                                            : *std::max_element(all.begin(), all.end());
}

std::string listed(const std::vector<double>& dimensions) {
    std::ostringstream text;
    for (const double x : dimensions)
        text << std::setprecision(17) << x << ' ';
    return text.str();
}

/// All quantities of a drive over a motion, both ways, to a part of their size.
void expect_measured_alike(const Mechanism& mechanism, const Motion& motion, const std::vector<double>& dimensions,
                           double part) {
    double longest = 0;
    for (std::size_t i = 0; i < dimensions.size(); ++i)
        if (mechanism.dimensions[i].kind == DimensionKind::length) longest = std::max(longest, dimensions[i]);
    for (const Quantity& quantity : mechanism.quantities) {
        if (quantity.path != PathMeasure::none || !quantity.defined(motion)) continue;
        const double value = measured(quantity, motion, dimensions);
        const double again = measure_again(quantity, motion, precise_of(dimensions)).convert_to<double>();
        const PossibleValues possible = possible_values(quantity.name);
        RC_ASSERT(again >= possible.least && again <= possible.greatest);
        const double rounding = quantity.unit == Unit::length ? 1e-13 * longest
                                : quantity.unit == Unit::none ? part
                                                              : 0;
        const double slack = part * std::abs(again) + rounding;
        if (!(std::abs(value - again) <= slack)) {
            RC_LOG() << mechanism.name << ' ' << quantity.name << ": " << value << " and " << again << " of "
                     << listed(dimensions) << '\n';
        }
        RC_ASSERT(std::abs(value - again) <= slack);
    }
}

RC_GTEST_PROP(RamAgain, MeasuresOverAFullTurnWhatTheAnalysisMeasures, ()) {
    const double share = between(0.05, 0.95);
    for_some_drive([&](const auto& m) {
        const Mechanism& mechanism = *find_mechanism(name_of(m));
        const auto dimensions = dimensions_of(m);
        Motion motion = motion_of(mechanism, dimensions, assembly_of(m), nullptr);
        motion.settings[working_share] = share;
        RC_ASSERT(motion.family == quick_return::full_turn);
        expect_measured_alike(mechanism, motion, dimensions, 1e-9);
        for (const Check& check : mechanism.check_motion(motion, precise_of(dimensions))) {
            if (!check.passed) RC_LOG() << check.name << ": " << check.detail << " of " << listed(dimensions) << '\n';
            RC_ASSERT(check.passed);
        }
    });
}

RC_GTEST_PROP(RamAgain, MeasuresOverALimitedMotionWhatTheAnalysisMeasures, ()) {
    const std::array<double, 2> range{between(-3, 3), 0};
    const std::array<double, 2> crank_range{range[0], range[0] + between(0.1, 6)};
    for_some_drive([&](const auto& m) {
        const Mechanism& mechanism = *find_mechanism(name_of(m));
        const auto dimensions = dimensions_of(m);
        const Motion motion = motion_of(mechanism, dimensions, assembly_of(m), crank_range.data());
        RC_ASSERT(motion.family == limited_range);
        expect_measured_alike(mechanism, motion, dimensions, 1e-9);
        for (const Check& check : mechanism.check_motion(motion, precise_of(dimensions)))
            RC_ASSERT(check.passed);
    });
}

constexpr double far_below_double = 1e-40;

Digits50 full(std::string_view mechanism, const std::vector<Digits50>& dimensions, std::string_view quantity) {
    const Mechanism& m = *find_mechanism(mechanism);
    const int index = find_quantity(m, quantity);
    Motion motion;
    motion.to = 2 * std::numbers::pi;
    motion.settings[working_share] = 0.6;
    return measure_again(m.quantities[static_cast<std::size_t>(index)], motion, dimensions);
}

TEST(RamAgain, FindsStrokeAndRatioOfSliderCranksToFortyDigits) {
    for (const auto& [r, l, e] : {std::array<double, 3>{1, 3, 0.8}, {2, 5, 2.5}, {2, 5, -2.5}, {50, 150, 20}}) {
        const Digits50 R = r, L = l, E = e;
        const Digits50 stroke = sqrt((L + R) * (L + R) - E * E) - sqrt((L - R) * (L - R) - E * E);
        const Digits50 excess = abs(asin(E / (L - R)) - asin(E / (L + R)));
        const Digits50 pi = boost::math::constants::pi<Digits50>();
        const std::vector<Digits50> d{R, L, E, 0, 0, 0, 0, 0, 0};
        EXPECT_LE(abs(full("slider-crank", d, "stroke") / stroke - 1), far_below_double);
        EXPECT_LE(abs(full("slider-crank", d, "time-ratio") / ((pi + excess) / (pi - excess)) - 1), far_below_double);
        EXPECT_LE(abs(full("slider-crank", d, "transmission-angle-worst") - acos((R + abs(E)) / L)), far_below_double);
    }
}

TEST(RamAgain, FindsStrokeAndRatioOfSlottedDrivesNextToEqualLengths) {
    const Digits50 pi = boost::math::constants::pi<Digits50>();
    const Digits50 d = 1.5;
    // A lever that swings farther than this falls into line with its rod.
    for (int k = 1; k <= 4; ++k) {
        const Digits50 r = d * (1 - ldexp(Digits50(1), -k));
        const Digits50 shaper = 2 * acos(r / d);
        const std::vector<Digits50> s{d, r, 1, 8, (1 + sqrt(1 - r * r / (d * d))) / 2};
        EXPECT_LE(abs(full("crank-shaper", s, "time-ratio") * shaper / (2 * pi - shaper) - 1), far_below_double) << k;
        EXPECT_LE(abs(full("crank-shaper", s, "stroke") / (2 * r / d) - 1), far_below_double) << k;
    }
    for (int k = 2; k <= 50; k += 8) {
        const Digits50 longer = d * (1 + ldexp(Digits50(1), -k));
        const Digits50 whitworth = 2 * acos(d / longer);
        const std::vector<Digits50> w{d, longer, 1, 3, pi / 2};
        EXPECT_LE(abs(full("whitworth", w, "time-ratio") * whitworth / (2 * pi - whitworth) - 1), 1e-30) << k;
        EXPECT_LE(abs(full("whitworth", w, "stroke") / 2 - 1), far_below_double) << k;
    }
}

TEST(RamAgain, FindsExtremesThatADenseScanConfirms) {
    // Example W5-1, scanned by differences of positions that are formed here, at steps that leave ten digits.
    const std::vector<Digits50> d{65, 100, 150, 125, 200, 0, 375, 0, 0};
    const auto position = [](double x) {
        const double ax = 100 * std::cos(x), ay = 100 * std::sin(x);
        const double dx = 65 - ax, dy = -ay, q = dx * dx + dy * dy;
        const double along = (1 + (150. * 150 - 125. * 125) / q) / 2;
        const double across = std::sqrt((275. * 275 - q) * (q - 25. * 25)) / (2 * q);
        const double bx = ax + along * dx - across * dy - 65, by = ay + along * dy + across * dx;
        const double cx = 1.6 * bx, cy = 1.6 * by;
        return cx + std::sqrt(375. * 375 - cy * cy);
    };
    double least = 1e9, greatest = -1e9, fastest = 0, most = 0;
    constexpr int steps = 400000;
    constexpr double h = 2 * std::numbers::pi / steps;
    for (int i = 0; i < steps; ++i) {
        const double x = position(i * h);
        least = std::min(least, x);
        greatest = std::max(greatest, x);
        if (i % 20 != 0) continue;
        constexpr double wide = 2e-4;
        fastest = std::max(fastest, std::abs(position(i * h + wide) - position(i * h - wide)) / (2 * wide));
        most = std::max(most, std::abs(position(i * h + wide) - 2 * x + position(i * h - wide)) / (wide * wide));
    }
    EXPECT_NEAR(full("drag-link", d, "stroke").convert_to<double>(), greatest - least, 1e-6);
    EXPECT_NEAR(full("drag-link", d, "stroke").convert_to<double>(), 400, 1e-12);
    EXPECT_NEAR(full("drag-link", d, "ram-speed-max").convert_to<double>(), fastest, 1e-5 * fastest);
    EXPECT_NEAR(full("drag-link", d, "ram-acceleration-max").convert_to<double>(), most, 1e-5 * most);
}

std::vector<Check> checks(std::string_view mechanism, const std::vector<double>& dimensions) {
    const Mechanism& m = *find_mechanism(mechanism);
    return m.check_motion(motion_of(m, dimensions, 0, nullptr), precise_of(dimensions));
}

bool fails(const std::vector<Check>& checks, std::string_view name) {
    return std::any_of(checks.begin(), checks.end(), [&](const Check& c) { return c.name == name && !c.passed; });
}

TEST(RamAgain, SeesWhatDoesNotWork) {
    Motion full_turn_wanted;
    full_turn_wanted.to = 2 * std::numbers::pi;
    const auto demanded = [&](std::string_view mechanism, const std::vector<double>& dimensions) {
        return find_mechanism(mechanism)->check_motion(full_turn_wanted, precise_of(dimensions));
    };
    EXPECT_TRUE(fails(demanded("slider-crank", {1, 1.5, 0.500001, 0, 0, 0, 0, 0, 0}),
                      "rod reaches the slide over the whole motion"));
    EXPECT_TRUE(fails(demanded("slider-crank", {1, 1.5, 0.5, 0, 0, 0, 0, 0, 0}), "rod stays on one branch"));
    EXPECT_TRUE(
        fails(demanded("crank-shaper", {100, 101, 200, 300, 180}), "crank is shorter than the centre distance"));
    EXPECT_TRUE(fails(demanded("whitworth", {101, 100, 50, 300, 1.5}), "crank is longer than the centre distance"));
    EXPECT_TRUE(fails(demanded("whitworth", {80, 100, 300, 299, 1.5}), "rod reaches the slide over the whole motion"));
    EXPECT_TRUE(fails(demanded("drag-link", {65, 100, 150, 190, 200, 0, 375, 0, 0}),
                      "four-bar assembles over the whole motion"));
    // A lever that swings far and a steep rod fall into line: the ram turns back four times.
    EXPECT_TRUE(fails(demanded("crank-shaper", {100, 99, 200, 400, 300}), "makes two strokes in each turn"));
    EXPECT_TRUE(fails(checks("slider-crank", {-1, 3, 0, 0, 0, 0, 0, 0, 0}), "dimensions are positive and finite"));
    EXPECT_TRUE(fails(checks("slider-crank", {1, 0.2, 3, 0, 0, 0, 0, 0, 0}), "assembles over the whole motion"));
    // What the crank cannot do in a full turn it does between two dead positions.
    for (const Check& check : checks("slider-crank", {1, 1.25, 0.5, 0, 0, 0, 0, 0, 0}))
        EXPECT_TRUE(check.passed) << check.name << ": " << check.detail;
}

TEST(RamAgain, PlacesThePointOfTheRod) {
    // Crank up, rod 5 spans 3: the point 2.5 along the rod is half way between (0, 3) and (4, 0); then turned by 90
    // deg.
    const Digits50 right_angle = boost::math::constants::half_pi<Digits50>();
    const std::vector<Digits50> d{3, 5, 0, Digits50(2.5), 0, 10, 20, right_angle, 0};
    const auto p = rod_path_point({}, d, right_angle);
    EXPECT_LE(abs(p.x - Digits50(8.5)), far_below_double);
    EXPECT_LE(abs(p.y - Digits50(22)), far_below_double);
}

}  // namespace
}  // namespace mechwright::test

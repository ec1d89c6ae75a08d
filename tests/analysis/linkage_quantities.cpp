// The quantities of linkages: a four-bar and a slider-crank written as such have those of the built-in kinds, with all
// derivatives; others have the derivatives that differences have.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "analysis/four_bar.h"
#include "synthesis/mechanism/linkage/model.h"
#include "synthesis/mechanism/linkage/quantities.h"
#include "synthesis/mechanism/mechanism.h"
#include "tests/analysis/known_linkages.h"
#include "tests/analysis/random_linkage.h"
#include "tests/analysis/watched.h"
#include "tests/degree.h"

namespace mechwright::test {
namespace {

using Of = LinkageMeasure::Kind;
using linkage::Signal;

/// Dimensions stand where these numbers are in a made linkage.
constexpr double dimension_at = 1000;

struct Design {
    LinkageModel model;
    std::vector<double> dimensions;

    Design(const MadeLinkage& made, std::vector<double> values, std::vector<std::int8_t> sides = {})
        : dimensions(std::move(values)) {
        model.structure = made.s;
        model.order = linkage::order_of(made.s);
        for (const double number : made.numbers) {
            const bool named = number >= dimension_at;
            model.numbers.push_back(named ? Affine{0, {{static_cast<std::size_t>(number - dimension_at), 1}}}
                                          : Affine{number, {}});
        }
        model.drives.resize(made.s.drives.size());
        sides.resize(model.order.choices, 1);
        model.sides = {sides};
    }
    Design(const Design&) = delete;
    Motion whole() const {
        Motion motion;
        motion.model = &model;
        motion.to = 2 * std::numbers::pi;
        return motion;
    }
    Motion limited(double from, double to) const {
        Motion motion = whole();
        motion.full_turn = false;
        motion.from = from;
        motion.to = to;
        return motion;
    }
};

struct Worth {
    std::vector<double> value, gradient, hessian;
};

Worth first_worth(const Quantity& quantity, const Motion& over, const std::vector<double>& dimensions) {
    const Motion motion = motion_for(quantity, over);
    const std::size_t count = count_components(quantity, motion);
    Worth w{std::vector<double>(count), std::vector<double>(count * dimensions.size()), {}};
    quantity.measure(motion, dimensions, {w.value, w.gradient, {}});
    return w;
}

/// With second derivatives; the first ones are the same with and without them.
Worth worth(const Quantity& quantity, const Motion& over, const std::vector<double>& dimensions) {
    const Motion motion = motion_for(quantity, over);
    const std::size_t n = dimensions.size();
    const Worth first = first_worth(quantity, over, dimensions);
    Worth w = first;
    w.hessian.resize(w.value.size() * n * (n + 1) / 2);
    quantity.measure(motion, dimensions, {w.value, w.gradient, w.hessian});
    for (std::size_t i = 0; i < w.gradient.size(); ++i)
        if (std::isfinite(w.gradient[i])) {
            EXPECT_NEAR(first.gradient[i], w.gradient[i], 1e-11 * (1 + std::abs(w.gradient[i]))) << quantity.name;
        }
    return w;
}

Quantity quantity_of(const Design& design, Of kind, std::vector<Signal> signals = {}, std::size_t derivative = 0,
                     std::optional<std::array<double, 2>> stretch = {}, double input = 0) {
    return linkage_quantity("quantity", Unit::none, "", {kind, std::move(signals), {0, derivative}, stretch, input},
                            design.dimensions.size());
}

/// The same worst component, with all derivatives.
void expect_same(const Worth& a, std::size_t k, const Worth& b, std::size_t l, std::size_t n, double within) {
    ASSERT_NEAR(a.value[k], b.value[l], 1e-12 * (1 + std::abs(b.value[l])));
    for (std::size_t i = 0; i < n; ++i)
        EXPECT_NEAR(a.gradient[k * n + i], b.gradient[l * n + i], within) << i;
    const std::size_t pairs = n * (n + 1) / 2;
    for (std::size_t i = 0; i < pairs; ++i)
        EXPECT_NEAR(a.hessian[k * pairs + i], b.hessian[l * pairs + i], 10 * within) << i;
}

std::size_t worst_of(const Quantity& quantity, const Worth& w) {
    const auto begin = w.value.begin();
    return static_cast<std::size_t>((quantity.reduce == Reduce::least ? std::min_element(begin, w.value.end())
                                                                      : std::max_element(begin, w.value.end())) -
                                    begin);
}

/// What a built-in kind's quantity is worth is what the linkage's is.
void compare(const Mechanism& built_in, const char* name, const Motion& its, const Design& design, const Motion& motion,
             const Quantity& quantity, double within = 1e-9) {
    const std::size_t n = design.dimensions.size();
    Quantity other = built_in.quantities[static_cast<std::size_t>(find_quantity(built_in, name))];
    ASSERT_LE(other.reads.size(), n) << name;
    SCOPED_TRACE(name);
    const std::vector<double> arguments(design.dimensions.begin(),
                                        design.dimensions.begin() + static_cast<std::ptrdiff_t>(other.reads.size()));
    const Worth b = worth(other, its, arguments), a = worth(quantity, motion, design.dimensions);
    EXPECT_TRUE(a.value.size() == 1 || quantity.worst_first);
    ASSERT_EQ(arguments.size(), n);
    expect_same(a, 0, b, worst_of(other, b), n, within);
}

/// Lengths, then zeros for the other dimensions of a built-in kind.
std::vector<double> padded(const Mechanism& mechanism, std::vector<double> lengths) {
    lengths.resize(mechanism.dimensions.size());
    return lengths;
}

const MadeLinkage four_bars = four_bar_linkage({dimension_at, dimension_at + 1, dimension_at + 2, dimension_at + 3});

TEST(LinkageQuantities, AreTheFourBars) {
    const auto four_bar = find_mechanism("four-bar");
    for (const std::vector<double>& lengths : {std::vector<double>{4, 1, 3.5, 3}, {6, 2.1, 5, 3.9}, {10, 3, 8.5, 5}}) {
        const Design design(four_bars, lengths);
        const Motion its = motion_of(*four_bar, padded(*four_bar, lengths), 0, nullptr);
        ASSERT_TRUE(its.full_turn);
        const std::vector<Signal> rocker{angle_of(3)};
        const auto check = [&](const char* name, const Quantity& quantity) {
            compare(*four_bar, name, its, design, design.whole(), quantity);
        };
        check("swing", quantity_of(design, Of::range, rocker));
        check("time-ratio", quantity_of(design, Of::time_ratio, rocker));
        check("transmission-angle-worst", quantity_of(design, Of::transmission_angle_worst));
        check("transmission-angle-min",
              quantity_of(design, Of::least, {signal_of(Signal::Kind::transmission_angle, 0)}));
        check("total-length", quantity_of(design, Of::total_length));
        check("link-ratio", quantity_of(design, Of::link_ratio));
        // The least margin over a full turn is that of Grashof's conditions that is least.
        const auto margins = crank_rocker_margins(FourBar<double>{lengths[0], lengths[1], lengths[2], lengths[3]});
        const Worth full = worth(quantity_of(design, Of::full_turn_margin), design.whole(), lengths);
        EXPECT_NEAR(full.value[0], std::min({margins.ground_longest, margins.coupler_longest, margins.rocker_longest}),
                    1e-14);
    }
}

TEST(LinkageQuantities, AreTheLimitedFourBars) {
    const auto four_bar = find_mechanism("four-bar");
    const std::vector<double> lengths{5, 3, 4, 3.2};
    const Design design(four_bars, lengths);
    const auto range = assembled_range(FourBar<double>{5, 3, 4, 3.2});
    ASSERT_FALSE(range.full_turn);
    const Worth worst =
        worth(quantity_of(design, Of::transmission_angle_worst), design.limited(range.from, range.to), lengths);
    EXPECT_EQ(worst.value[0], 0);
    const double given[]{-0.5, 1.5};
    const Motion its = motion_of(*four_bar, padded(*four_bar, lengths), 0, given);
    const Motion motion = design.limited(-0.5, 1.5);
    compare(*four_bar, "transmission-angle-worst", its, design, motion,
            quantity_of(design, Of::transmission_angle_worst));
    // The ends of its whole range: both where coupler and rocker are stretched, at +-a with cos a by the law of
    // cosines; the rocker there points to the crank pin.
    const Worth greatest = worth(quantity_of(design, Of::greatest, {angle_of(3, 0, std::numbers::pi)}),
                                 design.limited(range.from, range.to), lengths);
    const auto swung = [](const std::vector<double>& l) {
        const double d = l[2] + l[3], angle = std::acos((l[0] * l[0] + l[1] * l[1] - d * d) / (2 * l[0] * l[1]));
        return std::numbers::pi + std::atan2(l[1] * std::sin(angle), l[0] - l[1] * std::cos(angle));
    };
    EXPECT_NEAR(greatest.value[0], swung(lengths), 1e-13);
    const double h = 1e-4;
    for (std::size_t i = 0; i < 4; ++i) {
        std::vector<double> up = lengths, down = lengths;
        up[i] += h;
        down[i] -= h;
        EXPECT_NEAR(greatest.gradient[i], (swung(up) - swung(down)) / (2 * h), 1e-7);
        EXPECT_NEAR(greatest.hessian[i * (i + 1) / 2 + i], (swung(up) - 2 * swung(lengths) + swung(down)) / (h * h),
                    1e-5);
    }
    // Over a turn it falls short: by the stretched dyad at 180 degrees.
    const Worth full = worth(quantity_of(design, Of::full_turn_margin), design.whole(), lengths);
    EXPECT_NEAR(full.value[0], 4 + 3.2 - 8, 1e-14);
    const Worth over = worth(quantity_of(design, Of::assembly_margin), motion, lengths);
    EXPECT_NEAR(over.value[0], (5 - 3) - 0.8, 1e-14);
    EXPECT_NEAR(over.gradient[0], 1, 1e-14);
    EXPECT_NEAR(over.gradient[1], -1, 1e-14);
    // What does not close over the motion cannot be measured.
    for (const Of kind : {Of::least, Of::mean})
        EXPECT_TRUE(std::isnan(worth(quantity_of(design, kind, {angle_of(3)}), design.whole(), lengths).value[0]));
    EXPECT_TRUE(
        std::isnan(worth(quantity_of(design, Of::least, {angle_of(3)}, 0, {{1, 2}}), motion, lengths).value[0]));
}

TEST(LinkageQuantities, AreTheSliderCranks) {
    const auto slider_crank = find_mechanism("slider-crank");
    const MadeLinkage made = slider_crank_linkage({dimension_at, dimension_at + 1, dimension_at + 2});
    for (const std::vector<double>& lengths : {std::vector<double>{1, 3, 0.4}, {2, 7, -1}}) {
        const Design design(made, lengths);
        const Motion its = motion_of(*slider_crank, padded(*slider_crank, lengths), 0, nullptr);
        const std::vector<Signal> ram{signal_of(Signal::Kind::slide, 0)};
        const auto check = [&](const char* name, const Quantity& quantity) {
            compare(*slider_crank, name, its, design, design.whole(), quantity);
        };
        check("stroke", quantity_of(design, Of::range, ram));
        check("time-ratio", quantity_of(design, Of::time_ratio, ram));
        check("transmission-angle-worst", quantity_of(design, Of::transmission_angle_worst));
        check("total-length", quantity_of(design, Of::total_length));
        check("link-ratio", quantity_of(design, Of::link_ratio));
        check("ram-speed-max", lengths[2] > 0 ? quantity_of(design, Of::greatest, ram, 1)
                                              : quantity_of(design, Of::greatest, {{Signal::Kind::speed, 2}}, 0));
    }
}

TEST(LinkageQuantities, HaveTheDerivativesOfDifferences) {
    // A six-bar of twelve dimensions: blocks of derivatives are put together from several passes.
    MadeLinkage made = six_bar(false);
    std::vector<double> values;
    for (double& number : made.numbers) {
        if (number == 0) continue;
        values.push_back(number);
        number = dimension_at + static_cast<double>(values.size() - 1);
    }
    const Design design(made, values, sides_of(made, {{"C", 1}, {"H", 1}}));
    const std::size_t n = values.size(), p = made.pin("P");
    ASSERT_GT(n, 8u);
    const std::vector<Signal> output{angle_of(5)}, speed{{Signal::Kind::speed, p}};
    Design other(made, values, sides_of(made, {{"C", 1}, {"H", 1}}));
    other.model.drives[0].speed = 30;
    for (const Quantity& quantity :
         {quantity_of(design, Of::range, output), quantity_of(design, Of::deviation, output, 0, {{5.5, 1}}),
          quantity_of(design, Of::greatest, output, 1), quantity_of(design, Of::least, output, 2),
          quantity_of(design, Of::greatest, output, 3), quantity_of(design, Of::mean, output),
          quantity_of(design, Of::rms, output, 1), quantity_of(design, Of::mean, output, 1, {{1, 2}}),
          quantity_of(design, Of::at, output, 0, {}, 1.3), quantity_of(design, Of::time_ratio, output),
          quantity_of(design, Of::greatest, speed), quantity_of(design, Of::least, speed, 1),
          quantity_of(design, Of::full_turn_margin), quantity_of(design, Of::joint_distance_least),
          quantity_of(design, Of::link_ratio)}) {
        const auto kind = static_cast<int>(static_cast<const LinkageMeasure*>(quantity.of.data())->kind);
        const Worth w = worth(quantity, design.whole(), values);
        ASSERT_TRUE(std::isfinite(w.value[0])) << kind;
        const double h = 1e-4;
        for (std::size_t i = 1; i < n; i += 3) {
            std::vector<double> up = values, down = values;
            up[i] += h;
            down[i] -= h;
            const Worth above = first_worth(quantity, design.whole(), up),
                        below = first_worth(quantity, design.whole(), down);
            const double size = 1 + std::abs(w.hessian[i * (i + 1) / 2 + i]);
            EXPECT_NEAR(w.gradient[i], (above.value[0] - below.value[0]) / (2 * h), 3e-6 * size) << kind << ' ' << i;
            for (std::size_t j = 0; j < n; ++j) {
                const double second = w.hessian[std::max(i, j) * (std::max(i, j) + 1) / 2 + std::min(i, j)];
                EXPECT_NEAR(second, (above.gradient[j] - below.gradient[j]) / (2 * h), 3e-5 * (size + std::abs(second)))
                    << kind << ' ' << i << ' ' << j;
            }
        }
        // Half a turn of the crank in a second: each derivative by the time is pi times that by the angle.
        const Worth timed = first_worth(
            quantity,
            [&] {
                Motion motion = design.whole();
                motion.model = &other.model;
                return motion;
            }(),
            values);
        const auto& m = *static_cast<const LinkageMeasure*>(quantity.of.data());
        const std::size_t order = m.signals.empty() ? 0 : m.asked.derivative + linkage::order_of(m.signals, 0);
        const double expected = w.value[0] * std::pow(std::numbers::pi, order);
        EXPECT_NEAR(timed.value[0], expected, 1e-11 * (1 + std::abs(expected))) << kind;
    }
}

}  // namespace
}  // namespace mechwright::test

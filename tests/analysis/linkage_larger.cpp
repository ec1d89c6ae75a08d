// Larger groups: configurations, branches and turning points against numbers computed apart (triad_circuits.py and
// linkage_benchmarks.py of the reference, 40 digits) and against fifty digits; derivatives against differences.

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "analysis/linkage/measuring/margins.h"
#include "analysis/linkage/measuring/moving_extremes.h"
#include "analysis/linkage/motion/configurations.h"
#include "analysis/linkage/motion/follow_way.h"
#include "analysis/numbers/second_dual.h"
#include "tests/analysis/made_linkage.h"

namespace mechwright::test {

namespace {

using namespace linkage;

constexpr double turn = 2 * std::numbers::pi, degree = std::numbers::pi / 180;

/// A plate on three legs: two on the frame, the third on a crank. Links: crank, left, plate, right, rod.
struct TriadData {
    double base, crank_x, crank_y, crank, left, right, rod;
    double plate[3][2];
};
constexpr std::size_t plate_link = 3;

MadeLinkage plate_on_legs(const TriadData& d) {
    MadeLinkage m;
    m.points(0, {{"A", 0, 0}, {"B", d.base, 0}, {"O", d.crank_x, d.crank_y}});
    m.drive(m.link({{"O", 0, 0}, {"C", d.crank, 0}}));
    m.link({{"A", 0, 0}, {"P", d.left, 0}});
    m.link({{"P", d.plate[0][0], d.plate[0][1]},
            {"Q", d.plate[1][0], d.plate[1][1]},
            {"R", d.plate[2][0], d.plate[2][1]}});
    m.link({{"B", 0, 0}, {"Q", d.right, 0}});
    m.link({{"C", 0, 0}, {"R", d.rod, 0}});
    return m;
}

/// Reference 5.8, case A and case B.
constexpr TriadData case_a{2.5, 1.5, 2, 0.5, 1.5, 2, 2.5, {{0, 0}, {2, 0}, {1, -1.5}}};
constexpr TriadData case_b{2.5, 1.2, 2, 0.6, 2, 2, 2.5, {{0, 0}, {2, 0}, {1, -1.5}}};

/// A made linkage with its first larger group.
struct Larger {
    const MadeLinkage& made;
    Order order = order_of(made.s);
    Driven<double> driven{made.s, order, std::span<const double>(made.numbers), {}};

    Configurations at(double input) {
        driven.place(input);
        return configurations(made.s, made.numbers, driven, 0);
    }
    /// Which unknown the turn of a link is.
    std::size_t turn_of(std::size_t link) const {
        const auto& unknowns = order.larger[0].unknowns;
        for (std::size_t i = 0; i < unknowns.size(); ++i)
            if (unknowns[i].link == link && unknowns[i].part == 2) return i;
        return none;
    }
    std::vector<double> turns(double input, std::size_t link) {
        std::vector<double> all;
        for (const auto& one : at(input).all)
            all.push_back(one[turn_of(link)] / degree);
        std::sort(all.begin(), all.end());
        return all;
    }
    std::shared_ptr<const Way> way(double input, const std::vector<double>& places, double period = turn) const {
        return follow_ways(made.s, order, made.numbers, {}, driven.laws, {input, {places}}, {0, 0, period, 1})[0];
    }
};

void expect_all_near(const std::vector<double>& found, std::vector<double> expected, double within) {
    std::sort(expected.begin(), expected.end());
    ASSERT_EQ(found.size(), expected.size());
    for (std::size_t i = 0; i < found.size(); ++i)
        EXPECT_NEAR(found[i], expected[i], within) << i;
}

TEST(LargerGroups, OfATriadAllTwelveConfigurationsAreFound) {
    // Reference 5.7: two pairs are only 0.032 and 0.063 degrees apart.
    for (const double side : {1.0, -1.0}) {
        const double x = (2.2 * 2.2 + 2.9 * 2.9 - 2.15 * 2.15) / (2 * 2.2), y = side * std::sqrt(2.9 * 2.9 - x * x);
        const MadeLinkage made = plate_on_legs({2, 0, std::sqrt(3.0), 1, 1.75, 1.97, 2.7, {{0, 0}, {2.2, 0}, {x, y}}});
        Larger larger{made};
        EXPECT_TRUE(larger.at(0).complete);
        const std::vector<double> left{3.1243914341533036, 3.1559496929466244, 50.498794580499282,
                                       119.34072266128111, 258.73334294012704, 357.45604462780256},
            right{4.1208967504801309, 18.51420558781313,  57.787542234132523,
                  94.694422999030624, 236.25527714723399, 236.31840934449968};
        expect_all_near(larger.turns(0, plate_link), side > 0 ? left : right, 1e-10);
    }
}

TEST(LargerGroups, PlatesHaveTheirPinsWhereTheReferenceHasThem) {
    const double x = (2.2 * 2.2 + 2.9 * 2.9 - 2.15 * 2.15) / (2 * 2.2), y = std::sqrt(2.9 * 2.9 - x * x);
    const MadeLinkage made = plate_on_legs({2, 0, std::sqrt(3.0), 1, 1.75, 1.97, 2.7, {{0, 0}, {2.2, 0}, {x, y}}});
    Larger larger{made};
    const double pins[6][2]{{1.1313179783898883, 1.3351477939808073},   {1.7066311730330947, 0.38718217834978316},
                            {-1.2983812720849707, -1.1733311861103042}, {1.6618894785368659, -0.54829131046229792},
                            {0.52095539133777889, 1.6706601929285625},  {1.62580601219529, -0.6474988885779254}};
    for (const auto& one : larger.at(0).all) {
        larger.driven.groups[0].near = one;
        ASSERT_TRUE(larger.driven.place(0));
        const Vector<double>& at = larger.driven.pose.links[plate_link].origin;
        double nearest = 1;
        for (const auto& pin : pins)
            nearest = std::min(nearest, std::hypot(at.x - pin[0], at.y - pin[1]));
        // The determinant of the closest pair is 1e-3.
        EXPECT_LT(nearest, 1e-12);
    }
}

TEST(LargerGroups, SixCircuitsWithoutATurningPointGoRound) {
    const MadeLinkage made = plate_on_legs(case_b);
    Larger larger{made};
    expect_all_near(larger.turns(0, plate_link),
                    {19.217130135104067, 66.368777948591608, 102.34461344566289, 244.98243845302464, 250.37454847053023,
                     351.31815899383071},
                    1e-11);
    const std::vector<double> half_round{8.002213795986366,  113.06285560842495, 117.07236593899778,
                                         258.00575050944216, 298.33922497031405, 339.18149928007581};
    expect_all_near(larger.turns(std::numbers::pi, plate_link), half_round, 1e-11);
    std::vector<double> there;
    const std::size_t column = larger.turn_of(plate_link);
    for (const auto& one : larger.at(0).all) {
        const auto way = larger.way(0, one);
        ASSERT_TRUE(way);
        EXPECT_TRUE(way->whole);
        larger.driven.groups[0].way = way;
        larger.driven.groups[0].near.clear();
        ASSERT_TRUE(larger.driven.place(std::numbers::pi));
        there.push_back(linkage::detail::folded_turn(larger.driven.groups[0].solution()[column]) / degree);
        // A period later everything has advanced by whole turns.
        ASSERT_TRUE(larger.driven.place(std::numbers::pi - 3 * turn));
        EXPECT_NEAR(linkage::detail::folded_turn(larger.driven.groups[0].solution()[column]) / degree, there.back(),
                    1e-9);
    }
    std::sort(there.begin(), there.end());
    expect_all_near(there, half_round, 1e-11);
}

TEST(LargerGroups, TurningPointsAreExact) {
    const MadeLinkage made = plate_on_legs(case_a);
    Larger larger{made};
    expect_all_near(larger.turns(0, plate_link), {7.6504810121770191, 87.028558162229783}, 1e-11);
    EXPECT_EQ(larger.at(100 * degree).all.size(), 4U);
    EXPECT_EQ(larger.at(180 * degree).all.size(), 6U);
    EXPECT_EQ(larger.at(260 * degree).all.size(), 4U);
    EXPECT_EQ(larger.at(300 * degree).all.size(), 2U);
    const std::size_t column = larger.turn_of(plate_link);
    int limited = 0, whole = 0;
    for (const double input : {150 * degree, 255 * degree})
        for (const auto& one : larger.at(input).all) {
            const auto way = larger.way(input, one);
            ASSERT_TRUE(way);
            if (way->whole) {
                ++whole;
                continue;
            }
            ++limited;
            ASSERT_TRUE(way->first.limit && way->last.limit);
            const bool early = input < std::numbers::pi;
            EXPECT_NEAR(way->first.at / degree, early ? 43.75894663936723 : 153.6758828683045, 1e-10);
            EXPECT_NEAR(way->last.at / degree, early ? 224.8118250556021 : 289.3459869530447, 1e-10);
            EXPECT_NEAR(linkage::detail::folded_turn(way->first.places[column]) / degree,
                        early ? 45.56343253017661 : 259.5452003188505, 1e-9);
            EXPECT_NEAR(linkage::detail::folded_turn(way->last.places[column]) / degree,
                        early ? 52.32960980463734 : 258.4659951188304, 1e-9);
            // Right up to its ends there is a pose, and none beyond.
            larger.driven.groups[0].way = way;
            larger.driven.groups[0].near.clear();
            for (const double share : {0.0, 1e-14, 1e-9, 1e-4, 0.3, 1 - 1e-7, 1.0})
                EXPECT_TRUE(larger.driven.place(way->from() + share * (way->to() - way->from()))) << share;
            EXPECT_FALSE(larger.driven.place(way->to() + 1e-9));
            EXPECT_FALSE(larger.driven.place(way->from() - 1e-9));
        }
    EXPECT_EQ(limited, 4);  // two branches of each of the circuits that do not go round
    EXPECT_EQ(whole, 4);
}

/// A crank that nothing hangs on, for groups that stand still.
void add_idle_crank(MadeLinkage& m) {
    m.points(0, {{"O", 9, 9}});
    m.drive(m.link({{"O", 0, 0}, {"Z", 1, 0}}));
}

TEST(LargerGroups, TiesByLinesLoseConfigurations) {
    // Reference 5.11: CLL and LLL.
    for (const bool with_bar : {true, false}) {
        MadeLinkage m;
        add_idle_crank(m);
        m.points(0, {{"F", 0.5, 0.3}});
        m.link({{"X", 0, 0}, {"Y", 3, 0}, {"E", 1, 1}});
        m.slot("X", m.line(0, 0, 0, 0));
        m.slot("Y", m.line(0, 0, 0, std::numbers::pi / 2));
        if (with_bar)
            m.link({{"F", 0, 0}, {"E", 1.5, 0}});
        else
            m.slot("E", m.line(0, 0, 0.4, std::atan(0.5)));
        Larger larger{m};
        EXPECT_TRUE(larger.at(0).complete);
        if (with_bar)
            expect_all_near(larger.turns(0, 2),
                            {93.904805459247599, 163.64258100901266, 266.29271397640946, 323.0297972011743}, 1e-10);
        else
            expect_all_near(larger.turns(0, 2), {117.66300142449812, 316.07679386718992}, 1e-10);
    }
}

/// A body on three random ties: at a distance, on a line of the frame by slot or slide, or over a pin of it.
MadeLinkage random_triad(std::uint64_t seed) {
    std::mt19937_64 draw(seed);
    const auto number = [&draw](double from, double to) {
        return from + (to - from) * (static_cast<double>(draw() >> 11) * 0x1p-53);
    };
    MadeLinkage m;
    add_idle_crank(m);
    const std::size_t body = m.link({});
    for (int i = 0; i < 3; ++i) {
        const std::string own = "own" + std::to_string(i), far = "far" + std::to_string(i);
        const double x = number(-2, 2), y = number(-2, 2);
        const auto place = [&] { m.points(0, {{far.c_str(), number(-2, 2), number(-2, 2)}}); };
        switch (draw() % 5) {
            case 0:
            case 1:
                m.points(body, {{own.c_str(), x, y}});
                place();
                m.link({{own.c_str(), 0, 0}, {far.c_str(), number(1, 4), number(-1, 1)}});
                break;
            case 2:
                m.points(body, {{own.c_str(), x, y}});
                m.slot(own, m.line(0, number(-1, 1), number(-1, 1), number(-3, 3)));
                break;
            case 3:
                place();
                if (draw() % 2 == 0)
                    m.slot(far, m.line(body, x, y, number(-3, 3)));
                else
                    m.slide(m.link({{far.c_str(), number(-1, 1), number(-1, 1)}}), m.line(body, x, y, number(-3, 3)),
                            number(-3, 3), number(-0.5, 0.5));
                break;
            default:
                m.points(body, {{own.c_str(), x, y}});
                m.slide(m.link({{own.c_str(), number(-1, 1), number(-1, 1)}}),
                        m.line(0, number(-1, 1), number(-1, 1), number(-3, 3)), number(-3, 3), number(-1, 1));
        }
    }
    return m;
}

TEST(LargerGroups, OfRandomTriadsThePolynomialFindsWhatSearchesFind) {
    int groups = 0, found_at_all = 0;
    for (std::uint64_t seed = 1; seed <= 16; ++seed) {
        const MadeLinkage made = random_triad(seed);
        if (!mobility<double>(made.s, 1).settled()) continue;
        Larger larger{made};
        if (larger.order.larger.size() != 1) continue;
        ++groups;
        const Configurations all = larger.at(0);
        EXPECT_TRUE(all.complete) << seed;
        linkage::detail::ConfigurationList searched(larger.driven.groups[0]);
        linkage::detail::search_configurations(larger.driven.groups[0], searched);
        // A search may miss some: what it finds is among those of the polynomial.
        for (const auto& one : all.all) {
            larger.driven.groups[0].places = one;
            searched.add(16, 1e3);
        }
        EXPECT_EQ(all.all.size(), searched.found.size()) << seed;
        EXPECT_EQ(all.all.size() % 2, 0U) << seed;
        found_at_all += static_cast<int>(all.all.size());
        // In fifty digits the equations hold next to what was found.
        std::vector<Precise> numbers(made.numbers.begin(), made.numbers.end());
        Driven<Precise> precise(made.s, larger.order, std::span<const Precise>(numbers), {});
        for (const auto& one : all.all) {
            precise.groups[0].near = one;
            ASSERT_TRUE(precise.place(Precise(0))) << seed;
            std::vector<Precise> missed(one.size());
            precise.groups[0].residual(precise.pose, precise.inputs(), missed);
            for (const Precise& each : missed)
                EXPECT_LT(static_cast<double>(abs(each)), 1e-35) << seed;
            const std::size_t body = 2;
            const Precise off = precise.pose.turns[body] - one[larger.turn_of(body)];
            EXPECT_LT(std::abs(static_cast<double>(off)) * std::abs(precise.groups[0].determinant()), 1e-14) << seed;
        }
    }
    EXPECT_GT(groups, 9);
    EXPECT_GT(found_at_all, 16);
}

/// The coupler point R of a plate, at an input, of these numbers on the branch of `near`.
Vector<double> plate_point(const MadeLinkage& made, const Order& order, const std::vector<double>& numbers,
                           double input, const std::vector<double>& near) {
    Driven<double> driven(made.s, order, std::span<const double>(numbers), {});
    driven.groups[0].near = near;
    EXPECT_TRUE(driven.place(input));
    return driven.pose.links[plate_link].at({1, -1.5});
}

TEST(LargerGroups, DerivativesAreThoseOfDifferences) {
    const MadeLinkage made = plate_on_legs(case_b);
    Larger larger{made};
    constexpr double input = 0.7, step = 1e-4;
    constexpr std::size_t count = 6;
    using Number = Series<SecondDual<double, count>, 2>;
    // Some numbers of legs, plate and base, among them the crank's centre.
    const std::size_t some[count]{2, 5, 8, 12, 14, 18};
    for (const auto& near : larger.at(input).all) {
        std::vector<Number> numbers(made.numbers.begin(), made.numbers.end());
        for (std::size_t i = 0; i < count; ++i)
            numbers[some[i]] = Number(SecondDual<double, count>::variable(made.numbers[some[i]], i));
        Driven<Number> driven(made.s, larger.order, std::span<const Number>(numbers), {});
        driven.groups[0].near = near;
        ASSERT_TRUE(driven.place(Number::variable(SecondDual<double, count>(input))));
        const Number x = driven.pose.links[plate_link].at({Number(1), Number(-1.5)}).x;
        const auto at = [&](double first, std::size_t i, double second, std::size_t k, double later) {
            std::vector<double> moved = made.numbers;
            moved[some[i]] += first;
            moved[some[k]] += second;
            return plate_point(made, larger.order, moved, input + later, near).x;
        };
        for (std::size_t i = 0; i < count; ++i) {
            EXPECT_NEAR(x.c[0].first[i], (at(step, i, 0, 0, 0) - at(-step, i, 0, 0, 0)) / (2 * step), 1e-5);
            EXPECT_NEAR(x.c[1].first[i],
                        (at(step, i, 0, 0, step) - at(-step, i, 0, 0, step) - at(step, i, 0, 0, -step) +
                         at(-step, i, 0, 0, -step)) /
                            (4 * step * step),
                        1e-4);
            for (std::size_t k = 0; k < i; ++k)
                EXPECT_NEAR(x.c[0].mixed(i, k),
                            (at(step, i, step, k, 0) - at(-step, i, step, k, 0) - at(step, i, -step, k, 0) +
                             at(-step, i, -step, k, 0)) /
                                (4 * step * step),
                            1e-4);
        }
        EXPECT_NEAR(x.c[1].value, (at(0, 0, 0, 0, step) - at(0, 0, 0, 0, -step)) / (2 * step), 1e-5);
        EXPECT_NEAR(2 * x.c[2].value,
                    (at(0, 0, 0, 0, step) - 2 * at(0, 0, 0, 0, 0) + at(0, 0, 0, 0, -step)) / (step * step), 1e-4);
    }
}

TEST(LargerGroups, LimitsMoveWithTheDimensions) {
    const MadeLinkage made = plate_on_legs(case_a);
    Larger larger{made};
    constexpr double input = 150 * degree, step = 1e-5;
    constexpr std::size_t rod = 26;  // the length of the last link
    const std::size_t column = larger.turn_of(plate_link);
    const std::vector<Signal> signals{{Signal::Kind::x, 4}};
    for (const auto& near : larger.at(input).all) {
        const auto way = larger.way(input, near);
        if (way->whole) continue;
        const auto end_with = [&](double change) {
            MadeLinkage other = made;
            other.numbers[rod] += change;
            Larger changed{other};
            return *changed.way(input, near);
        };
        const Way longer = end_with(step), shorter = end_with(-step);
        using First = Dual<double, 1>;
        std::vector<First> numbers(made.numbers.begin(), made.numbers.end());
        numbers[rod] = First::variable(made.numbers[rod], 0);
        const std::vector<std::shared_ptr<const Way>> ways{way};
        Measured<First, 2> measured(made.s, larger.order, numbers, {}, {}, signals,
                                    {{First(0), First(0)}, First(0), First(1)}, 1, ways);
        for (const bool last : {false, true}) {
            const Limit limit{margin_of_larger(larger.order, 0), last};
            const WayEnd& end = last ? way->last : way->first;
            const First shift = linkage::detail::shift_of_zero(measured.margin(limit, end.at, {}), 0, 1);
            const WayEnd &a = last ? longer.last : longer.first, &b = last ? shorter.last : shorter.first;
            EXPECT_NEAR(shift.partial[0], (a.at - b.at) / (2 * step), 1e-6);
            // The place at the limit changes as the limit does.
            const auto at = measured.value(0, end.at, {}, limit);
            EXPECT_NEAR(value_of(at), end.places[column - 2], 1e-10);
            EXPECT_NEAR(linkage::detail::after_shift(at, 0, shift).partial[0],
                        (a.places[column - 2] - b.places[column - 2]) / (2 * step), 1e-6);
        }
    }
}

}  // namespace

}  // namespace mechwright::test

// What is asked of a linkage, placed by no more steps than it needs: bit for bit as everything placed, and its
// derivatives in one sweep back against dual numbers, for every kind of step.

#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "analysis/linkage/groups/group_solver.h"
#include "analysis/linkage/placing/needed.h"
#include "analysis/linkage/placing/needed_back.h"
#include "analysis/linkage/structure/mobility.h"
#include "analysis/numbers/dual.h"
#include "tests/analysis/random_linkage.h"

namespace mechwright::test {

namespace {

using namespace linkage;

constexpr std::size_t at_once = 8;
using First = Dual<double, at_once>;

/// What is compared over many linkages.
struct Compared {
    std::set<PlainStep::Kind> kinds{};
    int placed = 0;
    double worst = 0;  ///< difference of derivatives over their size
};

/// The four numbers that are asked for, and their derivatives by numbers and drives.
struct Found {
    std::array<double, 4> values{};
    std::vector<std::array<double, 4>> derivatives{};
};

Found by_duals(const MadeLinkage& made, const std::vector<double>& drives, const std::vector<std::int8_t>& sides,
               std::size_t pin, std::size_t link) {
    std::vector<double> all = made.numbers;
    all.insert(all.end(), drives.begin(), drives.end());
    Found answer;
    answer.derivatives.resize(all.size());
    const Order order = order_of(made.s);
    for (std::size_t from = 0; from < all.size(); from += at_once) {
        std::vector<First> x(all.begin(), all.end());
        for (std::size_t i = from; i < std::min(from + at_once, all.size()); ++i)
            x[i] = First::variable(all[i], i - from);
        const std::span<const First> numbers(x.data(), made.numbers.size());
        const auto sizes = sizes_of(made.s, order, numbers);
        Pose<First> pose = empty_pose<First>(made.s, order);
        place<First>(order, sizes, {std::span<const First>(x).last(drives.size()), sides}, pose);
        const First asked[]{pose.pins[pin].x, pose.pins[pin].y, pose.links[link].along.x, pose.links[link].along.y};
        for (std::size_t c = 0; c < 4; ++c) {
            answer.values[c] = asked[c].value;
            for (std::size_t i = from; i < std::min(from + at_once, all.size()); ++i)
                answer.derivatives[i][c] = asked[c].partial[i - from];
        }
    }
    return answer;
}

/// Places all of a linkage and what is asked for, compares, and says whether it closes.
bool compare(const MadeLinkage& made, const std::vector<double>& drives, const std::vector<std::int8_t>& sides,
             std::size_t pin, std::size_t link, Compared& compared) {
    const Placed<double> whole(made, drives, sides);
    const Needed needed = needed_of(made.s, whole.order, made.numbers.size(), pin, link, true);
    std::vector<double> row(needed.size), change(needed.size);
    bool closed = set_design<double, double>(needed, made.numbers, sides, row);
    for (std::size_t i = 0; i < drives.size(); ++i)
        set_input<double>(needed, i, drives[i], row);
    closed = place_needed<double>(needed, row) && closed;
    EXPECT_EQ(closed, whole.closed);
    if (!closed) return false;
    ++compared.placed;
    for (const PlainStep& step : needed.steps)
        compared.kinds.insert(step.kind);
    EXPECT_EQ(row[needed.point], whole.pose.pins[pin].x);
    EXPECT_EQ(row[needed.point + 1], whole.pose.pins[pin].y);
    EXPECT_EQ(row[needed.along], whole.pose.links[link].along.x);
    EXPECT_EQ(row[needed.along + 1], whole.pose.links[link].along.y);
    EXPECT_EQ(needed.margins.size(), whole.pose.margins.size());
    for (std::size_t i = 0; i < needed.margins.size(); ++i) {
        EXPECT_EQ(row[needed.margins[i].outer], whole.pose.margins[i].outer) << i;
        EXPECT_EQ(row[needed.margins[i].inner], whole.pose.margins[i].inner) << i;
    }
    const Found duals = by_duals(made, drives, sides, pin, link);
    const Spot spots[]{needed.point, needed.point + 1, needed.along, needed.along + 1};
    for (std::size_t c = 0; c < 4; ++c) {
        start_back<double>(needed, change);
        change[spots[c]] += 1;
        sweep_back<double>(needed, row, change);
        double size = 1;
        for (const auto& one : duals.derivatives)
            size = std::max(size, std::abs(one[c]));
        for (std::size_t i = 0; i < duals.derivatives.size(); ++i) {
            const Spot spot = i < made.numbers.size() ? needed.number(i) : needed.drive(i - made.numbers.size());
            const double apart = std::abs(change[spot] - duals.derivatives[i][c]) / size;
            EXPECT_LE(apart, 1e-8) << "derivative " << i << " of " << c << ": " << change[spot];
            compared.worst = std::max(compared.worst, apart);
        }
    }
    return true;
}

void compare_at_random(const MadeLinkage& made, std::uint64_t seed, Compared& compared) {
    RandomLinkage random(seed);
    const Order order = order_of(made.s);
    if (!order.closed()) return;
    std::vector<double> drives;
    for (const Drive& drive : made.s.drives)
        drives.push_back(drive.of_slide ? random.number(0.5, 2) : random.number(-3, 3));
    std::vector<std::int8_t> sides;
    for (std::size_t i = 0; i < order.choices; ++i)
        sides.push_back(random.below(2) == 0 ? 1 : -1);
    compare(made, drives, sides, random.below(made.s.pins.size()), random.below(made.s.links), compared);
}

/// A slide that a drive moves, with a rack on it that turns a wheel, which moves another rack; a telescope; stops.
MadeLinkage racks_and_telescope(RandomLinkage& random, bool inner_named_first) {
    MadeLinkage& m = random.made;
    m.points(0, {{"A", 0, 0}, {"B", 3, 0.2}, {"W", 0.5, -2}});
    const std::size_t first = m.link({{"A", 0, 0}, {"F", 0.3, 0.1}}), second = m.link({{"C", 2, 0.1}});
    m.link({{"B", 0, 0.1}, {"C", 2.5, 0.2}});
    const std::size_t ram = inner_named_first ? m.slide(second, m.line(first, 0.1, 0.2, 0.3), 0.2, 0.1)
                                              : m.slide(first, m.line(second, 0.1, 0.2, 0.3), 0.2, 0.1);
    m.drive_slide(ram);
    const std::size_t rack = m.link({{"R", 0.2, 0.3}}), wheel = m.link({{"W", 0, 0}, {"V", 0.4, 0.3}}),
                      far_rack = m.link({{"S", 0.1, 0.2}});
    const std::size_t driven = m.slide(rack, m.line(0, 0.3, -1.2, 0.1), 0.3, 0.2);
    m.drive_slide(driven);
    const Number radius = m.number(0.7), phase = m.number(0.2);
    m.s.racks.push_back({driven, wheel, 0, radius, phase});
    const std::size_t slid = m.slide(far_rack, m.line(0, -0.3, -2.8, 0.4), 0.1, 0.3);
    const Number far_radius = m.number(0.4), far_phase = m.number(-0.1);
    m.s.racks.push_back({slid, wheel, 0, far_radius, far_phase});
    m.s.slides[slid].stops.min = m.number(-20);
    m.s.slides[slid].stops.max = m.number(20);
    return m;
}

/// Gears that turn their first link, or their carrier; places by length and angle, in numbers that are apart, and a
/// slot between two places.
MadeLinkage gears_and_places(RandomLinkage& random) {
    MadeLinkage& m = random.made;
    m.points(0, {{"A", 0, 0}, {"B", 2, 0.2}, {"D", -2, 0.3}});
    const std::size_t sun = m.link({{"A", 0, 0}}), ring = m.link({{"A", 0.1, 0}});
    m.drive(sun);
    m.drive(ring);
    const std::size_t carrier = m.link({{"A", 0, 0}}), wheel = m.link({{"B", 0, 0.1}});
    m.gear(sun, ring, carrier, random.number(-3, -1), random.number(-1, 1));
    m.gear(wheel, sun, 0, random.number(1, 2), random.number(-1, 1));
    const Number length = m.number(random.number(0.5, 1)), angle = m.number(random.number(-3, 3));
    m.s.pins[m.pin("C")].points.push_back({carrier, {length, angle, true}});
    const Number y = m.number(random.number(-1, 1)), x = m.number(random.number(0.5, 1));
    m.s.pins[m.pin("E")].points.push_back({wheel, {x, y}});
    m.link({{"C", 0, 0}, {"F", random.number(3, 4), 0.2}});
    Line line = m.line(0, random.number(-1, 1), random.number(-1, 1), 0);
    line.by_angle = false;
    line.towards = m.at(random.number(2, 3), random.number(-1, 1));
    m.slot("F", line);
    m.link({{"E", 0, 0}, {"G", random.number(3, 4), 0.2}});
    m.link({{"F", 0, 0}, {"G", random.number(3, 4), 0.2}});
    return m;
}

// The digits: where a dyad is near a limit, derivatives by the formulas of its margins and by its triangle differ by
// rounding over the sine of its transmission angle; those of a gear's wheel by that of its turns.
TEST(NeededSteps, IsPlacedBitForBitAndItsDerivativesAreThoseOfDuals) {
    Compared compared;
    for (std::uint64_t seed = 1; seed <= 1500; ++seed) {
        const MadeLinkage made = random_linkage(seed);
        if (made.pins.empty() || made.s.drives.empty()) continue;
        SCOPED_TRACE(seed);
        if (!mobility<double>(made.s, 5, made.numbers).settled()) continue;
        compare_at_random(made, seed, compared);
    }
    for (std::uint64_t seed = 1; seed <= 60; ++seed) {
        SCOPED_TRACE(seed);
        RandomLinkage random(seed);
        compare_at_random(racks_and_telescope(random, seed % 2 == 0), seed, compared);
        RandomLinkage other(seed);
        compare_at_random(gears_and_places(other), seed, compared);
    }
    EXPECT_GT(compared.placed, 500);
    EXPECT_EQ(compared.kinds.size(), static_cast<std::size_t>(PlainStep::Kind::unwound) + 1);
}

}  // namespace

}  // namespace mechwright::test

// Circuits and branches of six-bars against brute force that knows neither sides nor limits: all poses at many crank
// angles by intersecting circles, joined to their nearest neighbours at the next one, and to each other where they
// vanish together.

#include <gtest/gtest.h>

#include <complex>

#include "analysis/linkage/motion/branches.h"
#include "tests/analysis/known_linkages.h"
#include "tests/analysis/random_linkages.h"

namespace mechwright::test {

namespace {

using Place = std::complex<double>;

struct SixBar {
    bool watt;  ///< the second dyad hangs on the rocker, else on the coupler
    double ground, crank, coupler, rocker, rod, output;
    Place on_link;  ///< where it hangs, in the frame of that link
    Place pivot;
};

SixBar random_six_bar(Random& random, bool watt) {
    const auto length = [&] { return random.between(1, 3); };
    return {watt,
            length(),
            length(),
            length(),
            length(),
            random.between(1.5, 4),
            random.between(1.5, 4),
            {random.between(-1, 3), random.between(-2, 2)},
            {random.between(-2, 4), random.between(-3, 3)}};
}

MadeLinkage made_of(const SixBar& m) {
    MadeLinkage made;
    made.points(0, {{"A", 0, 0}, {"D", m.ground, 0}, {"F", m.pivot.real(), m.pivot.imag()}});
    made.link({{"A", 0, 0}, {"B", m.crank, 0}});
    const MadeLinkage::Place hang{"P", m.on_link.real(), m.on_link.imag()};
    if (m.watt) {
        made.link({{"B", 0, 0}, {"C", m.coupler, 0}});
        made.link({{"D", 0, 0}, {"C", m.rocker, 0}, hang});
    } else {
        made.link({{"B", 0, 0}, {"C", m.coupler, 0}, hang});
        made.link({{"D", 0, 0}, {"C", m.rocker, 0}});
    }
    made.link({{"P", 0, 0}, {"E", m.rod, 0}});
    made.link({{"F", 0, 0}, {"E", m.output, 0}});
    made.drive(1);
    return made;
}

/// Both places at two distances from two others; none where there is none.
std::vector<Place> meetings(const Place& a, double from_a, const Place& b, double from_b) {
    const double d = std::abs(b - a), along = (d * d + from_a * from_a - from_b * from_b) / (2 * d);
    const double square = from_a * from_a - along * along;
    if (square < 0) return {};
    const Place direction = (b - a) / d;
    return {a + direction * Place(along, std::sqrt(square)), a + direction * Place(along, -std::sqrt(square))};
}

/// The places of C and E at a crank angle, of every assembly.
std::vector<std::array<Place, 2>> poses_of(const SixBar& m, double angle) {
    std::vector<std::array<Place, 2>> all;
    const Place b = std::polar(m.crank, angle), d(m.ground, 0);
    for (const Place& c : meetings(b, m.coupler, d, m.rocker)) {
        const Place origin = m.watt ? d : b, along = (c - origin) / std::abs(c - origin);
        for (const Place& e : meetings(origin + along * m.on_link, m.rod, m.pivot, m.output))
            all.push_back({c, e});
    }
    return all;
}

double apart(const std::array<Place, 2>& a, const std::array<Place, 2>& b) {
    return std::abs(a[0] - b[0]) + std::abs(a[1] - b[1]);
}

struct Counted {
    std::size_t circuits, branches;
};

struct Joined {
    std::vector<std::size_t> to;
    std::size_t root(std::size_t i) {
        while (to[i] != i)
            i = to[i] = to[to[i]];
        return i;
    }
    void join(std::size_t a, std::size_t b) { to[root(a)] = root(b); }
    std::size_t count() {
        std::size_t n = 0;
        for (std::size_t i = 0; i < to.size(); ++i)
            n += root(i) == i ? 1 : 0;
        return n;
    }
};

Counted by_brute_force(const SixBar& m, int samples) {
    std::vector<std::vector<std::array<Place, 2>>> poses;
    std::vector<std::size_t> first;
    std::size_t count = 0;
    for (int k = 0; k < samples; ++k) {
        poses.push_back(poses_of(m, 2 * std::numbers::pi * k / samples));
        first.push_back(count);
        count += poses.back().size();
    }
    Joined branches{std::vector<std::size_t>(count)};
    std::iota(branches.to.begin(), branches.to.end(), std::size_t{0});
    Joined circuits = branches;
    const auto nearest = [&](const std::array<Place, 2>& pose, const auto& among, std::size_t but) {
        std::size_t best = linkage::none;
        for (std::size_t j = 0; j < among.size(); ++j)
            if (j != but && (best == linkage::none || apart(pose, among[j]) < apart(pose, among[best]))) best = j;
        return best;
    };
    for (int k = 0; k < samples; ++k) {
        const int l = (k + 1) % samples;
        const auto &here = poses[k], &there = poses[l];
        std::vector<bool> joined_here(here.size(), false), joined_there(there.size(), false);
        for (std::size_t i = 0; i < here.size(); ++i) {
            const std::size_t j = nearest(here[i], there, linkage::none);
            if (j == linkage::none || nearest(there[j], here, linkage::none) != i) continue;
            branches.join(first[k] + i, first[l] + j);
            circuits.join(first[k] + i, first[l] + j);
            joined_here[i] = joined_there[j] = true;
        }
        // Poses vanish, or appear, two by two where two are one at a toggle.
        for (const auto& [set, joined, at] :
             {std::tuple(&here, &joined_here, first[k]), {&there, &joined_there, first[l]}})
            for (std::size_t i = 0; i < set->size(); ++i)
                if (!(*joined)[i]) {
                    double least = 1e9;
                    std::size_t mate = i;
                    for (std::size_t j = 0; j < set->size(); ++j)
                        if (j != i && !(*joined)[j] && apart((*set)[i], (*set)[j]) < least) {
                            least = apart((*set)[i], (*set)[j]);
                            mate = j;
                        }
                    circuits.join(at + i, at + mate);
                }
    }
    return {circuits.count(), branches.count()};
}

/// Whether a sampling cannot miss a branch, or what lies between two.
bool is_wide(const std::vector<linkage::Branch>& all) {
    constexpr double narrow = 0.02;
    std::vector<double> ends;
    for (const linkage::Branch& branch : all) {
        if (branch.travel.whole) continue;
        if (branch.travel.to - branch.travel.from < narrow) return false;
        for (const double end : {branch.travel.from, branch.travel.to})
            ends.push_back(std::remainder(end, 2 * std::numbers::pi));
    }
    for (const double a : ends)
        for (const double b : ends)
            if (std::abs(a - b) > 1e-9 && std::abs(a - b) < narrow) return false;
    return true;
}

const std::vector<std::vector<std::int8_t>> all_sides{{1, 1}, {1, -1}, {-1, 1}, {-1, -1}};

TEST(LinkageBranches, OfRandomSixBarsAreThoseOfBruteForce) {
    Random random(7);
    int tested = 0;
    std::size_t circuits = 0, branches = 0;
    for (int i = 0; i < 60; ++i) {
        const SixBar m = random_six_bar(random, i % 2 == 0);
        const MadeLinkage made = made_of(m);
        const linkage::Order order = linkage::order_of(made.s);
        ASSERT_EQ(order.choices, 2u);
        const linkage::Driven<double> driven(made.s, order, std::span<const double>(made.numbers), all_sides[0],
                                             std::vector<linkage::DriveLaw>{{}});
        const auto all = linkage::branches_of(driven, all_sides, {});
        if (all.empty() || !is_wide(all)) continue;
        ++tested;
        const Counted counted = by_brute_force(m, 4000);
        EXPECT_EQ(all.size(), counted.branches) << i;
        EXPECT_EQ(static_cast<std::size_t>(all.back().circuit), counted.circuits) << i;
        circuits += counted.circuits;
        branches += counted.branches;
    }
    EXPECT_GT(tested, 30);
    EXPECT_GT(branches, circuits + 30);
}

TEST(LinkageBranches, OfACrankRockerAreItsTwoCircuitsAndOfATripleRockerTheTwoBranchesOfOne) {
    const auto branches = [](const FourBar<double>& m) {
        const MadeLinkage made = four_bar_linkage(m);
        const linkage::Order order = linkage::order_of(made.s);
        const std::vector<std::vector<std::int8_t>> sides{{1}, {-1}};
        return linkage::branches_of(
            {made.s, order, std::span<const double>(made.numbers), sides[0], std::vector<linkage::DriveLaw>{{}}}, sides,
            {});
    };
    const auto turning = branches({100, 40, 110, 80});
    ASSERT_EQ(turning.size(), 2u);
    EXPECT_TRUE(turning[0].travel.whole && turning[1].travel.whole);
    EXPECT_EQ(turning[0].circuit, 1);
    EXPECT_EQ(turning[1].circuit, 2);
    EXPECT_EQ(turning[1].branch, 1);
    const auto rocking = branches({100, 85, 90, 120});  // longest and shortest are more than the others
    ASSERT_EQ(rocking.size(), 2u);
    EXPECT_EQ(rocking[0].circuit, 1);
    EXPECT_EQ(rocking[1].circuit, 1);
    EXPECT_EQ(rocking[1].branch, 2);
    EXPECT_FALSE(rocking[0].travel.whole);
}

/// Two couplers and rockers of the same lengths on the same pins come to their toggle together.
TEST(LinkageBranches, MeetWhereSeveralDyadsAreAtTheirLimitsAtOnce) {
    MadeLinkage made = four_bar_linkage({100, 85, 90, 120});
    made.link({{"B", 0, 0}, {"E", 90, 0}});
    made.link({{"D", 0, 0}, {"E", 120, 0}});
    const linkage::Order order = linkage::order_of(made.s);
    ASSERT_EQ(order.choices, 2u);
    const auto all = linkage::branches_of(
        {made.s, order, std::span<const double>(made.numbers), all_sides[0], std::vector<linkage::DriveLaw>{{}}},
        all_sides, {});
    ASSERT_EQ(all.size(), 4u);
    EXPECT_EQ(all[3].circuit, 1);
    EXPECT_EQ(all[3].branch, 4);
}

/// Stops part what toggles join: of a rocking four-bar whose crank is stopped before them there are two circuits.
TEST(LinkageBranches, OfWhatIsStoppedBeforeItsToggleDoNotMeet) {
    MadeLinkage made = four_bar_linkage({100, 85, 90, 120});
    made.s.drives[0].stops = {made.number(0.5), made.number(1.0)};
    const linkage::Order order = linkage::order_of(made.s);
    const std::vector<std::vector<std::int8_t>> sides{{1}, {-1}};
    const auto all = linkage::branches_of(
        {made.s, order, std::span<const double>(made.numbers), sides[0], std::vector<linkage::DriveLaw>{{}}}, sides,
        linkage::inputs_of(made.s, made.numbers, 100, 1));
    ASSERT_EQ(all.size(), 2u);
    for (const linkage::Branch& one : all) {
        EXPECT_NEAR(one.travel.from, 0.5, 1e-14);
        EXPECT_NEAR(one.travel.to, 1.0, 1e-14);
        EXPECT_TRUE(one.travel.first.stop && one.travel.last.stop);
    }
    EXPECT_NE(all[0].circuit, all[1].circuit);
}

}  // namespace

}  // namespace mechwright::test

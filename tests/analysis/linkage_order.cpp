// Mobility and order of linkages: known structures, and random ones against fifty digits and against the equations of
// their joints.

#include <gtest/gtest.h>

#include <cmath>

#include "analysis/linkage/structure/mobility.h"
#include "analysis/linkage/structure/order.h"
#include "tests/analysis/random_linkage.h"

namespace mechwright::test {
namespace {

using linkage::Group;

std::vector<Group::Kind> kinds_of(const MadeLinkage& made) {
    std::vector<Group::Kind> kinds;
    for (const Group& group : linkage::order_of(made.s).groups)
        kinds.push_back(group.kind);
    return kinds;
}

TEST(LinkageMobility, IsNotDeceivedByCounts) {
    MadeLinkage m;  // two links pinned together twice, one of them pinned to the frame: counted 0, and it turns
    m.points(0, {{"A", 0, 0}});
    m.link({{"A", 0, 0}, {"B", 1, 0}, {"C", 2, 0}});
    m.link({{"B", 0, 0}, {"C", 1, 0}});
    const auto found = linkage::mobility<double>(m.s, 1);
    EXPECT_EQ(found.counted, 0);
    EXPECT_EQ(found.mobility, 1);
    EXPECT_EQ(found.redundant, 1u);
    EXPECT_EQ(found.free, (std::vector<std::size_t>{1, 2}));
    for (const auto& equation : found.dependent)
        EXPECT_NE(equation.index, 0u);  // pin A has no part in it
}

TEST(LinkageMobility, NamesWhatMovesFreely) {
    MadeLinkage m;
    m.points(0, {{"A", 0, 0}, {"D", 4, 0}});
    m.drive(m.link({{"A", 0, 0}, {"B", 1, 0}}));
    m.link({{"B", 0, 0}, {"C", 3, 0}});
    m.link({{"D", 0, 0}, {"C", 3, 0}});
    m.link({{"C", 0, 0}, {"E", 1, 0}});
    const auto loose = linkage::mobility<double>(m.s, 1);
    EXPECT_EQ(loose.mobility, 2);
    EXPECT_EQ(loose.free, (std::vector<std::size_t>{4}));
    EXPECT_FALSE(loose.settled());
    m.s.pins[m.pin("E")].points.push_back({2, m.at(0.5, 0.5)});
    const auto stiff = linkage::mobility<double>(m.s, 1);  // now it stiffens the coupler twice
    EXPECT_EQ(stiff.mobility, 1);
    EXPECT_EQ(stiff.redundant, 1u);
    EXPECT_TRUE(stiff.free.empty());
    EXPECT_FALSE(stiff.settled());
}

TEST(LinkageOrder, FindsTheGroupsOfSixBars) {
    // Stephenson III driven in its four-bar, and in its five-bar: the triad.
    MadeLinkage four;
    four.points(0, {{"A", 0, 0}, {"D", 4, 0}, {"G", 6, 2}});
    four.link({{"A", 0, 0}, {"B", 1, 0}});
    four.link({{"B", 0, 0}, {"C", 3, 0}, {"P", 1, 1}});
    four.link({{"D", 0, 0}, {"C", 3, 0}});
    four.link({{"P", 0, 0}, {"H", 3, 0}});
    four.link({{"G", 0, 0}, {"H", 3, 0}});
    MadeLinkage five = four;
    four.drive(1);
    five.drive(5);
    EXPECT_EQ(kinds_of(four), (std::vector<Group::Kind>{Group::Kind::drive, Group::Kind::rrr, Group::Kind::rrr}));
    EXPECT_EQ(kinds_of(five), (std::vector<Group::Kind>{Group::Kind::drive, Group::Kind::larger}));
    EXPECT_EQ(linkage::order_of(five.s).groups[1].links, (std::vector<std::size_t>{1, 2, 3, 4}));
    EXPECT_FALSE(linkage::order_of(five.s).closed());
}

TEST(LinkageOrder, GoesOnAfterALargerGroup) {
    MadeLinkage m;
    m.points(0, {{"A", 0, 0}, {"D", 4, 0}, {"G", 6, 2}, {"K", 9, 0}});
    m.link({{"A", 0, 0}, {"B", 1, 0}});
    m.link({{"B", 0, 0}, {"C", 3, 0}, {"P", 1, 1}});
    m.link({{"D", 0, 0}, {"C", 3, 0}, {"Q", 1, 1}});
    m.link({{"P", 0, 0}, {"H", 3, 0}});
    m.drive(m.link({{"G", 0, 0}, {"H", 3, 0}}));
    m.link({{"Q", 0, 0}, {"R", 3, 0}});
    m.link({{"K", 0, 0}, {"R", 3, 0}});
    EXPECT_EQ(kinds_of(m), (std::vector<Group::Kind>{Group::Kind::drive, Group::Kind::larger, Group::Kind::rrr}));
}

bool same_mobility(const linkage::Mobility& a, const linkage::Mobility& b) {
    const auto count = [](const std::vector<linkage::Equation>& e) { return e.size(); };
    return a.mobility == b.mobility && a.redundant == b.redundant && a.free == b.free &&
           count(a.dependent) == count(b.dependent) && count(a.conflicting) == count(b.conflicting);
}

TEST(LinkageMobility, OfRandomStructuresIsThatOfFiftyDigits) {
    int settled = 0;
    for (std::uint64_t seed = 1; seed <= 150; ++seed) {
        const MadeLinkage made = random_linkage(seed);
        const auto found = linkage::mobility<double>(made.s, 3, made.numbers);
        EXPECT_TRUE(same_mobility(found, linkage::mobility<Precise>(made.s, 4, made.numbers))) << "seed " << seed;
        settled += found.settled();
    }
    EXPECT_GT(settled, 60);
    EXPECT_LT(settled, 140);
}

TEST(LinkageOrder, OfRandomStructuresPlacesEveryLinkWhereItsJointsHold) {
    int held = 0, larger = 0;
    for (std::uint64_t seed = 1; seed <= 4000; ++seed) {
        const MadeLinkage made = random_linkage(seed);
        const linkage::Order order = linkage::order_of(made.s);  // of any structure, it ends
        if (!linkage::mobility<double>(made.s, 5, made.numbers).settled()) continue;
        std::vector<int> in(made.s.links, 0);
        for (const Group& group : order.groups)
            for (const std::size_t link : group.links)
                ++in[link];
        if (!order.closed()) {
            ++larger;
            continue;
        }
        EXPECT_EQ(std::count(in.begin() + 1, in.end(), 1), static_cast<long>(made.s.links - 1)) << "seed " << seed;
        std::vector<double> drives;
        for (std::size_t i = 0; i < made.s.drives.size(); ++i)
            drives.push_back(0.3 + static_cast<double>(i));
        std::vector<std::int8_t> sides;
        for (std::size_t i = 0; i < order.choices; ++i)
            sides.push_back(seed >> i & 1 ? 1 : -1);
        const Placed<double> placed(made, drives, sides);
        double least = 1;
        for (const auto& margin : placed.pose.margins)
            least = std::min({least, margin.outer, margin.inner});
        if (!placed.closed || least < 1e-3) continue;
        ++held;
        std::vector<Precise> places;
        bool whole_turns = true;
        for (std::size_t link = 1; link < made.s.links; ++link) {
            const auto& at = placed.pose.links[link];
            const double principal = std::atan2(at.along.y, at.along.x), turns = placed.pose.turns[link];
            const double off = std::remainder(turns - principal, 2 * std::numbers::pi);
            places.insert(places.end(), {at.origin.x, at.origin.y, std::abs(off) < 1e-9 ? turns : principal});
            whole_turns = whole_turns && std::hypot(at.along.x, at.along.y) > 1 - 1e-12;
        }
        EXPECT_TRUE(whole_turns) << "seed " << seed;
        for (const Precise& miss : misses(made, std::vector<Precise>(drives.begin(), drives.end()), places)) {
            const double off = std::abs(static_cast<double>(miss));
            // Angles of slides are known up to full turns.
            EXPECT_LT(std::min(off, std::abs(std::remainder(off, 2 * std::numbers::pi))), 1e-9) << "seed " << seed;
        }
    }
    EXPECT_GT(held, 300);
    EXPECT_GT(larger, 5);
}

}  // namespace
}  // namespace mechwright::test

#include <gtest/gtest.h>

#include "synthesis/mechanism/four_bar/measure_again.h"
#include "tests/verify/random_linkages.h"

namespace mechwright {

namespace {

using namespace test;

/// The checks as one line, for messages and for finding words in them.
std::string told(const std::vector<Check>& checks) {
    std::string text;
    for (const Check& c : checks)
        text += (c.passed ? "passed: " : "FAILED: ") + c.name + ": " + c.detail + "\n";
    return text;
}

std::vector<bool> outcomes(const std::vector<Check>& checks) {
    std::vector<bool> passed;
    for (const Check& c : checks)
        passed.push_back(c.passed);
    return passed;
}

const std::vector<bool> all_pass{true, true, true, true};
const std::vector<bool> comes_apart{true, false, false, false};
const std::vector<bool> changes_branch{true, true, false, false};

std::vector<Check> check(const FourBar<double>& m, const Motion& motion) {
    return four_bar_check_motion(motion, dimensions_of(m));
}

TEST(CheckMotion, HasItsChecksInAFixedOrder) {
    const auto checks = check({4, 1, 3, 3.5}, full_turn(0));
    ASSERT_EQ(checks.size(), 4u);
    EXPECT_EQ(checks[0].name, "dimensions are positive and finite");
    EXPECT_EQ(checks[1].name, "assembles over the whole motion");
    EXPECT_EQ(checks[2].name, "stays on one branch");
    EXPECT_EQ(checks[3].name, "stays on one circuit");
}

TEST(CheckMotion, PassesEveryCrankRockerAndDragLink) {
    for (const FourBarClass kind : {FourBarClass::crank_rocker, FourBarClass::double_crank})
        for (const auto& m : random_linkages(kind, 100, 7))
            for (const std::size_t assembly : {0, 1}) {
                const auto checks = check(m, full_turn(kind == FourBarClass::crank_rocker ? 0 : 1, assembly));
                EXPECT_EQ(outcomes(checks), all_pass) << told(checks);
            }
}

TEST(CheckMotion, FailsAFullTurnOfEveryOtherLinkage) {
    for (const FourBarClass kind : {FourBarClass::double_rocker, FourBarClass::rocker_crank,
                                    FourBarClass::triple_rocker, FourBarClass::open_chain})
        for (const auto& m : random_linkages(kind, 50, 8)) {
            const auto checks = check(m, full_turn(0));
            EXPECT_EQ(outcomes(checks), comes_apart) << told(checks);
        }
}

TEST(CheckMotion, PassesTheWholeAssembledRangeWithItsTogglesAtTheEnds) {
    for (const FourBarClass kind :
         {FourBarClass::double_rocker, FourBarClass::rocker_crank, FourBarClass::triple_rocker})
        for (const auto& m : random_linkages(kind, 50, 9)) {
            const auto range = assembled_range(m);
            const auto checks = check(m, limited(range.from, range.to));
            EXPECT_EQ(outcomes(checks), all_pass) << told(checks);
            EXPECT_NE(told(checks).find("toggles"), std::string::npos) << told(checks);
        }
}

TEST(CheckMotion, FailsARangeThatReachesOverAToggle) {
    for (const auto& m : random_linkages(FourBarClass::triple_rocker, 50, 10)) {
        const auto range = assembled_range(m);
        for (const Motion& motion : {limited(range.from, range.to + 1e-6), limited(range.from - 1e-6, range.to),
                                     limited(range.to - 0.1, range.to + 1e-9)}) {
            const auto checks = check(m, motion);
            EXPECT_EQ(outcomes(checks), comes_apart) << told(checks);
        }
    }
}

TEST(CheckMotion, FailsARangeWithAGapInside) {
    const FourBar<double> m{4, 3, 2, 2.5};  // assembles from -78.6 deg to 78.6 deg
    const auto range = assembled_range(m);
    ASSERT_FALSE(range.full_turn);
    const auto checks = check(m, limited(0, 2 * std::numbers::pi));
    EXPECT_EQ(outcomes(checks), comes_apart) << told(checks);
    EXPECT_NE(checks[1].detail.find("at crank angle 180 deg"), std::string::npos) << checks[1].detail;
}

TEST(CheckMotion, TellsMarginAndSineWithTheirPlaces) {
    const auto checks = check({4, 1, 3, 3.5}, full_turn(0));
    // Diagonal 5 at 180 deg, coupler + rocker 6.5; 3 at 0 deg, |coupler - rocker| 0.5.
    EXPECT_EQ(checks[1].detail, "the least margin is 1.5 (length) at crank angle 180 deg");
    // cos = (9 + 12.25 - 9) / 21 at 0 deg, (9 + 12.25 - 25) / 21 at 180 deg
    const double sine = std::sqrt(1 - std::pow(12.25 / 21, 2));
    EXPECT_NE(checks[2].detail.find(std::to_string(sine).substr(0, 6)), std::string::npos) << checks[2].detail;
    EXPECT_NE(checks[3].detail.find("Grashof margin 1.5"), std::string::npos) << checks[3].detail;
}

TEST(CheckMotion, FailsAndNamesChangePoints) {
    const auto parallelogram = check({3, 1, 3, 1}, full_turn(0));
    EXPECT_EQ(outcomes(parallelogram), changes_branch);
    EXPECT_NE(parallelogram[2].detail.find("parallelogram"), std::string::npos) << parallelogram[2].detail;

    const auto kite = check({50, 1.25, 1.25, 50}, full_turn(0));
    EXPECT_EQ(outcomes(kite), changes_branch);
    EXPECT_NE(kite[2].detail.find("kite"), std::string::npos) << kite[2].detail;

    const auto other_kite = check({3, 3, 5, 5}, full_turn(0));
    EXPECT_EQ(outcomes(other_kite), changes_branch);
    EXPECT_NE(other_kite[2].detail.find("kite"), std::string::npos) << other_kite[2].detail;

    const auto change_point = check({6, 1, 3, 4}, full_turn(0));
    EXPECT_EQ(outcomes(change_point), changes_branch);
    EXPECT_NE(change_point[2].detail.find("change point"), std::string::npos) << change_point[2].detail;
}

TEST(CheckMotion, TellsAChangePointFromItsNearestNeighbours) {
    for (int k = 10; k <= 50; k += 5) {
        const double step = std::ldexp(1.0, -k);
        EXPECT_EQ(outcomes(check({6 - step, 1, 3, 4}, full_turn(0))), all_pass) << k;
        EXPECT_EQ(outcomes(check({6 + step, 1, 3, 4}, full_turn(0))), comes_apart) << k;
        EXPECT_EQ(outcomes(check({3 + step, 1, 3 + step, 1 + step}, full_turn(0))), all_pass) << k;
        EXPECT_EQ(outcomes(check({3, 1, 3, 1 - step}, full_turn(0))), comes_apart) << k;
    }
}

TEST(CheckMotion, RefusesDimensionsThatAreNoLengths) {
    const double infinity = std::numeric_limits<double>::infinity();
    for (const double bad : {0.0, -1.0, infinity, std::numeric_limits<double>::quiet_NaN()}) {
        const auto checks = check({4, 1, bad, 3.5}, full_turn(0));
        EXPECT_EQ(outcomes(checks), std::vector<bool>{false}) << told(checks);
    }
}

TEST(CheckMotion, RefusesWhatIsNoRange) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    for (const Motion& motion : {limited(1, 0), limited(nan, 1), limited(0, 1e300)}) {
        const auto checks = check({4, 1, 3, 3.5}, motion);
        EXPECT_EQ(outcomes(checks), comes_apart) << told(checks);
    }
}

}  // namespace

}  // namespace mechwright

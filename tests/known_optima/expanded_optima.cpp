// Optima of four-bars and quick returns, found again from nothing as those of the linkages that they are: another
// formula for every quantity, another search.

#include <cmath>

#include "synthesis/problem/linkage/of_kinds/expand.h"
#include "tests/known_optima/solved.h"

namespace mechwright {

namespace {

using testing::shipped;
using testing::Solved;
using testing::solved;

struct KnownProblem {
    const char* folder;
    const char* file;
};

class ExpandedOptima : public ::testing::TestWithParam<KnownProblem> {};

TEST_P(ExpandedOptima, AreThoseOfTheKind) {
    const std::string text = shipped(GetParam().file, GetParam().folder);
    const ExpandedProblem expanded = expand_problem(text, GetParam().file, {});
    ASSERT_TRUE(expanded.ok());
    const Solved kind = solved(text);
    const Solved linkage = solved(expanded.text + "\n[solver]\nstarts = 4\n", "slsqp", 1, 2, 2);
    ASSERT_EQ(kind.result.status, Status::solved);
    ASSERT_EQ(linkage.result.status, Status::solved);
    const double best = kind.result.best->objective;
    EXPECT_NEAR(linkage.result.best->objective, best, 1e-9 * std::abs(best));
}

INSTANTIATE_TEST_SUITE_P(Shipped, ExpandedOptima,
                         ::testing::Values(KnownProblem{"four-bar", "crank-rocker.toml"},
                                           KnownProblem{"quick-return", "slider-crank-best-transmission.toml"},
                                           KnownProblem{"quick-return", "slider-crank-compact.toml"},
                                           KnownProblem{"quick-return", "shaper-stroke-100.toml"},
                                           KnownProblem{"quick-return", "drag-link-compact.toml"}),
                         [](const auto& tested) {
                             std::string name = tested.param.file;
                             std::replace(name.begin(), name.end(), '-', '_');
                             return name.substr(0, name.find('.'));
                         });

}  // namespace

}  // namespace mechwright

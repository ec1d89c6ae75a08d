#include <gtest/gtest.h>

#include <vector>

#include "synthesis/problem/reader.h"
#include "synthesis/search/optima.h"

namespace mechwright {
namespace {

TEST(SearchEnds, SayHowManySearchesWouldEndWhereNoneDid) {
    SearchEnds ends(1e-3);
    EXPECT_EQ(ends.unseen(), 1);
    for (int i = 0; i < 10; ++i)
        ends.add(2);
    // w (w + 1) / (n (n - 1)), of one end of ten searches.
    EXPECT_DOUBLE_EQ(ends.unseen(), 2.0 / 90);
    ends.add(2.001);  // the same end
    EXPECT_DOUBLE_EQ(ends.unseen(), 2.0 / 110);
    ends.add(2.1);
    EXPECT_DOUBLE_EQ(ends.unseen(), 6.0 / 132);
}

TEST(SearchEnds, AreAllDifferentWhereEachIsNew) {
    SearchEnds ends(1e-3);
    for (int i = 1; i <= 5; ++i)
        ends.add(i);
    EXPECT_EQ(ends.unseen(), 1);
}

/// Designs of one family are as good as each other: many of them do not make it likely that a better one was missed.
TEST(DistinctOptima, CountByTheirObjectivesForWhatWasMissed) {
    const Problem problem =
        parse_problem(
            "schema = 1\nmechanism = \"four-bar\"\n[dimensions]\nground = 100\ncrank = { min = 0, max "
            "= 50 }\ncoupler = 90\nrocker = 80\n[objective]\nminimize = \"total-length\"\n",
            "family.toml")
            .problem;
    std::vector<Solution> family(8);
    for (std::size_t i = 0; i < family.size(); ++i) {
        family[i].design.dimensions.assign(problem.dimensions.size(), 100);
        family[i].design.dimensions[1] = 10 + static_cast<double>(i);
        family[i].objective = 3 + 1e-9 * static_cast<double>(i % 3);
        family[i].feasible = true;
    }
    const auto counted = [&] {
        SearchReport report;
        report.starts = 8;
        std::vector<const Solution*> all;
        for (const Solution& one : family)
            all.push_back(&one);
        EXPECT_EQ(distinct_optima(problem, all, report).size(), 8u);
        EXPECT_EQ(report.local_optima, 8);
        return report;
    };
    EXPECT_EQ(counted().hits, 8);
    EXPECT_DOUBLE_EQ(counted().missed_chance, 2.0 / 56);
    family[5].objective = 4;
    EXPECT_EQ(counted().hits, 7);
    EXPECT_DOUBLE_EQ(counted().missed_chance, 6.0 / 56);
}

}  // namespace
}  // namespace mechwright

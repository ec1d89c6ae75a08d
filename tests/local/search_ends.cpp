#include <gtest/gtest.h>

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

}  // namespace
}  // namespace mechwright

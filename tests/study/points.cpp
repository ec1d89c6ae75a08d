// Designs of points, and the strands they are solved in.

#include "synthesis/study/points.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "synthesis/problem/reader.h"

namespace mechwright::testing {
namespace {

StudyAxis range(const std::string& name, double from, double to, std::uint64_t count, bool logarithmic = false) {
    return {name, StudyRange{from, to, count, logarithmic, false}, {}, {}};
}

StudyAxis list(const std::string& name, int count) {
    StudyAxis axis{name, {}, {}, {}};
    for (int i = 0; i < count; ++i) {
        axis.values.push_back("value");
        axis.labels.emplace_back("value");
    }
    return axis;
}

TEST(Points, OfAGridAreAllCombinationsTheLastAxisFastest) {
    Study study;
    study.axes = {range("a", 1, 2, 3), list("b", 2), range("c", 10, 40, 4)};
    ASSERT_EQ(point_count(study), 24u);
    EXPECT_EQ(point_values(study, 0)[0].number, 1);
    EXPECT_EQ(point_values(study, 1)[2].number, 20);
    EXPECT_EQ(point_values(study, 4)[1].index, 1u);
    EXPECT_EQ(point_values(study, 23)[0].number, 2);
    EXPECT_EQ(point_values(study, 8)[0].number, 1.5);
}

TEST(Points, OfARangeAreRoundNumbersAndEndExactly) {
    const StudyRange linear{1.05, 1.5, 10, false, false};
    EXPECT_EQ(linear.at(1.0 / 9), 1.1);
    EXPECT_EQ(linear.at(1), 1.5);
    const StudyRange logarithmic{0.01, 100, 5, true, false};
    EXPECT_EQ(logarithmic.at(0.25), 0.1);
    EXPECT_EQ(logarithmic.at(0.5), 1);
    EXPECT_EQ((StudyRange{-1, -100, 3, true, false}).at(0.5), -10);
}

TEST(Points, OneAtATimeStartWithTheFileItself) {
    Study study;
    study.design = StudyDesign::one_at_a_time;
    study.axes = {range("a", 1, 2, 3), range("b", 5, 9, 5)};
    ASSERT_EQ(point_count(study), 9u);
    EXPECT_TRUE(point_values(study, 0)[0].as_in_file);
    EXPECT_EQ(point_values(study, 3)[0].number, 2);
    EXPECT_TRUE(point_values(study, 3)[1].as_in_file);
    EXPECT_EQ(point_values(study, 4)[1].number, 5);
    EXPECT_TRUE(point_values(study, 4)[0].as_in_file);
}

TEST(Points, OfALatinHypercubeFillEveryCellOfEveryAxisOnce) {
    for (const std::uint64_t count : {1u, 2u, 7u, 100u, 1000u}) {
        Study study;
        study.design = StudyDesign::latin_hypercube;
        study.count = count;
        study.seed = 5;
        study.axes = {range("a", 0, 1, 0), range("b", 0, 1, 0), range("c", 0, 1, 0)};
        for (std::size_t axis = 0; axis < 3; ++axis) {
            std::set<int> cells;
            for (std::uint64_t k = 0; k < count; ++k)
                cells.insert(static_cast<int>(point_values(study, k)[axis].number * static_cast<double>(count)));
            EXPECT_EQ(cells.size(), count);
            EXPECT_EQ(*cells.rbegin(), static_cast<int>(count) - 1);
        }
    }
}

/// A net in base 2: of 2^m points every box of sides 2^-i, 2^-(m-i) over two axes holds exactly one.
TEST(Points, OfSobolsSequenceAreANetOnItsFirstTwoAxes) {
    constexpr int m = 8;
    Study study;
    study.design = StudyDesign::sobol;
    study.count = 1 << m;
    study.seed = 11;
    study.axes = {range("a", 0, 1, 0), range("b", 0, 1, 0)};
    for (int i = 0; i <= m; ++i) {
        std::set<std::pair<int, int>> boxes;
        for (std::uint64_t k = 0; k < study.count; ++k) {
            const auto v = point_values(study, k);
            boxes.emplace(static_cast<int>(std::ldexp(v[0].number, i)),
                          static_cast<int>(std::ldexp(v[1].number, m - i)));
        }
        EXPECT_EQ(boxes.size(), study.count) << i;
    }
}

TEST(Points, OfRandomDesignsDependOnTheSeed) {
    for (const StudyDesign design : {StudyDesign::sobol, StudyDesign::latin_hypercube}) {
        Study study;
        study.design = design;
        study.count = 10;
        study.axes = {range("a", 0, 1, 0), list("b", 3)};
        const double one = point_values(study, 3)[0].number;
        study.seed = 2;
        EXPECT_NE(point_values(study, 3)[0].number, one);
        for (std::uint64_t k = 0; k < study.count; ++k)
            EXPECT_LT(point_values(study, k)[1].index, 3u);
    }
}

TEST(Strands, HoldEveryPointOnceInOrder) {
    for (const StudyDesign design : {StudyDesign::grid, StudyDesign::one_at_a_time, StudyDesign::sobol}) {
        for (const std::uint64_t along : {1u, 5u, 16u, 37u}) {
            Study study;
            study.design = design;
            study.count = 123;
            study.axes = {range("a", 1, 2, 7), range("b", 1, 2, along)};
            std::uint64_t next = 0;
            for (std::uint64_t s = 0; s < strand_count(study); ++s) {
                const Strand strand = strand_at(study, s);
                EXPECT_EQ(strand.first, next);
                EXPECT_GT(strand.count, 0u);
                next += strand.count;
            }
            EXPECT_EQ(next, point_count(study));
        }
    }
}

TEST(Strands, OfAGridDoNotCrossFromOneLineToTheNext) {
    Study study;
    study.axes = {range("a", 1, 2, 7), range("b", 1, 2, 37)};
    std::uint64_t next = 0;
    for (std::uint64_t s = 0; s < strand_count(study); ++s) {
        const Strand strand = strand_at(study, s);
        EXPECT_EQ(strand.first, next);
        EXPECT_EQ(strand.first / 37, (strand.first + strand.count - 1) / 37);
        EXPECT_TRUE(strand.neighbours);
        next += strand.count;
    }
    EXPECT_EQ(next, 7u * 37u);
}

}  // namespace
}  // namespace mechwright::testing

// The range of use in [motion], and quantities over the whole motion.

#include <cmath>
#include <numbers>

#include "synthesis/mechanism/whole_quantities.h"
#include "tests/problem/problem_text.h"

namespace mechwright::test {

namespace {

/// Poses in lines 8 and 9; [motion] in line 10, what is given of it from line 11 on.
ReadProblem read_use(const std::string& lines) {
    return read(valid + "[poses]\nposes = [[1, 2, 90], [3, 4, 180]]\n[motion]\n" + lines + "\n");
}

constexpr const char* ends = "from = \"first-target\"\nto = \"last-target\"\n";

TEST(RangeOfUse, IsFromTheFirstTargetToTheLastWithMargins) {
    const ReadProblem plain = read_use(ends);
    ASSERT_TRUE(accepted(plain));
    ASSERT_TRUE(plain.problem.use);
    EXPECT_EQ(plain.problem.use->before, 0);
    EXPECT_EQ(plain.problem.use->after, 0);
    const ReadProblem longer = read_use(std::string(ends) + "before = 5\nafter = 90");
    ASSERT_TRUE(accepted(longer));
    EXPECT_DOUBLE_EQ(longer.problem.use->before, std::numbers::pi / 36);
    EXPECT_DOUBLE_EQ(longer.problem.use->after, std::numbers::pi / 2);
    EXPECT_FALSE(read_use("").problem.use);
}

TEST(RangeOfUse, HasBothEndsByTheirNames) {
    EXPECT_TRUE(only_says(read_use("from = \"first-target\""), "p.toml:11:1", {"'to'", "to = \"last-target\""}));
    EXPECT_TRUE(only_says(read_use("to = \"last-target\""), "p.toml:11:1", {"'from'", "from = \"first-target\""}));
    EXPECT_TRUE(says(read_use("before = 5"), "p.toml:11:1", {"'before'", "from = \"first-target\""}));
    EXPECT_TRUE(only_says(read_use("from = \"first-targt\"\nto = \"last-target\""), "p.toml:11:8", {"first-target"}));
    EXPECT_TRUE(only_says(read_use("from = 30\nto = \"last-target\""), "p.toml:11:8", {"a string"}));
}

TEST(RangeOfUse, HasMarginsOfAtMostHalfATurn) {
    EXPECT_TRUE(
        only_says(read_use(std::string(ends) + "before = -5"), "p.toml:13:10", {"from 0 to half a turn", "-5"}));
    EXPECT_TRUE(
        only_says(read_use(std::string(ends) + "after = 181"), "p.toml:13:9", {"from 0 to half a turn", "181"}));
    EXPECT_TRUE(only_says(read_use(std::string(ends) + "after = \"5\""), "p.toml:13:9", {"a number"}));
}

TEST(RangeOfUse, NeedsTargetsThatAreMetInOrder) {
    const auto motion = std::string("[motion]\n") + ends;
    EXPECT_TRUE(only_says(read(valid + motion), "p.toml:9:1", {"[path] or [poses]", "there are none"}));
    EXPECT_TRUE(only_says(read_use(std::string(ends) + "crank_range = [0, 90]"), "p.toml:11:1", {"'crank_range'"}));
    EXPECT_TRUE(only_says(read(valid + motion + "[path]\nclosed = true\npoints = [[1, 2], [3, 4], [5, 7]]\n"),
                          "p.toml:9:1", {"closed path"}));
    EXPECT_TRUE(only_says(read(valid + motion + "[path]\ntiming = \"none\"\npoints = [[1, 2], [3, 4], [5, 7]]\n"),
                          "p.toml:9:1", {"timing = \"free\""}));
    EXPECT_TRUE(only_says(read(valid + motion + "[path]\npoints = [[1, 2]]\n"), "p.toml:9:1", {"one target"}));
    EXPECT_TRUE(accepted(read(valid + motion + "after = 10\n[path]\npoints = [[1, 2]]\n")));
    EXPECT_TRUE(says(read("schema = 1\nmechanism = \"whitworth\"\n[dimensions]\ncentre-distance = 1\ncrank = 3\n"
                          "arm = 1\nrod = 5\nslide-angle = 90\n" +
                          motion),
                     "p.toml:10:1", {"there are none"}));
}

TEST(RangeOfUse, HasQuantitiesOverTheWholeMotionBeside) {
    const auto required = [](const std::string& quantity) {
        return "[[require]]\nquantity = \"" + quantity + "\"\nmin = 0\n";
    };
    const ReadProblem read_both =
        read_use(ends + required("transmission-angle-worst") + required("transmission-angle-worst.whole"));
    ASSERT_TRUE(accepted(read_both));
    const Problem& problem = read_both.problem;
    EXPECT_FALSE(problem.mechanism->quantities[problem.requirements[0].quantity].whole);
    EXPECT_TRUE(problem.mechanism->quantities[problem.requirements[1].quantity].whole);
    EXPECT_TRUE(only_says(read_use(ends + required("total-length.whole")), "p.toml:14:12",
                          {"'total-length' is the same", "without '.whole'"}));
    EXPECT_TRUE(only_says(read_use(required("transmission-angle-worst.whole")), "p.toml:12:12",
                          {"has no value here", "first-target"}));
    EXPECT_TRUE(says(read_use(ends + required("transmision-angle-worst.whole")), "p.toml:14:12", {"quantity"}));
    EXPECT_EQ(without_whole("swing.whole"), "swing");
    EXPECT_EQ(without_whole("swing"), "swing");
}

TEST(RangeOfUse, HasNoValuesOfWhatIsOfAFullTurn) {
    const auto text = [](const std::string& quantity) {
        return "schema = 1\nmechanism = \"slider-crank\"\n[dimensions]\ncrank = 1\nrod = 3\noffset = 0\n[poses]\n"
               "poses = [[1, 2, 3], [2, 2, 3]]\n[motion]\n" +
               std::string(ends) + "[objective]\nminimize = \"" + quantity + "\"\n";
    };
    EXPECT_TRUE(only_says(read(text("time-ratio")), "p.toml:13:12", {"of the whole motion", "'time-ratio.whole'"}));
    EXPECT_TRUE(accepted(read(text("time-ratio.whole"))));
    EXPECT_TRUE(accepted(read(text("stroke"))));
}

TEST(RangeOfUse, OfALinkageHasItsSignalsOverTheWholeMotion) {
    const auto text = [](const std::string& quantity) {
        return "schema = 1\nmechanism = \"linkage\"\n[links]\nframe = { A = [0, 0], D = [4, 0] }\n"
               "crank = { A = [0, 0], B = [1, 0] }\ncoupler = { B = [0, 0], C = [4, 0], P = [2, 1] }\n"
               "rocker = { D = [0, 0], C = [3, 0] }\n[drive]\nlink = \"crank\"\n[signals]\n"
               "swing = { angle = \"rocker\" }\n[path]\npoint = \"P\"\npoints = [[1, 2], [2, 2]]\n[motion]\n" +
               std::string(ends) + "[objective]\nminimize = \"" + quantity + "\"\n";
    };
    for (const char* quantity : {"swing.range", "swing.range.whole", "swing.speed.greatest.whole", "swing.at(60).whole",
                                 "swing.time-ratio.whole", "transmission-angle-worst.whole"})
        EXPECT_TRUE(accepted(read(text(quantity)))) << quantity;
    EXPECT_TRUE(only_says(read(text("swing.time-ratio")), "p.toml:19:12", {"'swing.time-ratio.whole'"}));
    EXPECT_TRUE(only_says(read(text("link-ratio.whole")), "p.toml:19:12", {"'link-ratio' is the same"}));
    EXPECT_TRUE(only_says(read(text("swing.rnge.whole")), "p.toml:19:12", {"range"}));
}

TEST(RangeOfUse, OfAFullTurnBeyondALineIsNamed) {
    const auto text = [](const std::string& turn) {
        return valid + "[line]\nstart = 0\nrange = { min = 10, max = 90 }\n" + turn +
               "[objective]\nmaximize = \"transmission-angle-worst.whole\"\n";
    };
    EXPECT_TRUE(accepted(read(text("full_turn = true\n"))));
    EXPECT_TRUE(says(read(text("")), "p.toml:12:12", {"'transmission-angle-worst'"}));
}

}  // namespace

}  // namespace mechwright::test

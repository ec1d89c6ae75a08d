#include <cmath>

#include "tests/problem/problem_text.h"

namespace mechwright::test {

namespace {

/// The section starts in line 8, what is given in line 9.
ReadProblem read_poses(const std::string& lines) { return read(valid + "[poses]\n" + lines + "\n"); }

TEST(Poses, AreReadAsAPathWithDirections) {
    const ReadProblem read = read_poses("poses = [[1, 2, 90], [3, 4, 180]]");
    ASSERT_TRUE(accepted(read));
    const PathTarget& path = *read.problem.path;
    ASSERT_EQ(path.points.size(), 2u);
    EXPECT_EQ(path.points[1].y, 4);
    EXPECT_NEAR(path.directions[1], std::acos(-1.0), 1e-15);
    EXPECT_NEAR(path.body_length, std::sqrt(2.0), 1e-15) << "half the distance between the two";
    EXPECT_TRUE(path.guides_body());
    EXPECT_EQ(read_poses("poses = [[1, 2, 90], [3, 4, 180]]\nlength = 5").problem.path->body_length, 5);
}

TEST(Poses, OnePoseIsNoMotion) {
    EXPECT_TRUE(only_says(read_poses("poses = [[1, 2, 3]]"), "p.toml:9:9", {"from 2 to", "not 1"}));
    EXPECT_TRUE(only_says(read_poses("poses = []"), "p.toml:9:9", {"from 2 to", "not 0"}));
    EXPECT_TRUE(says(read_poses("poses = [[1, 2, 3], [1, 2, 3]]\nlength = 1"), "p.toml:9:21", {"1 and 2", "one pose"}));
    EXPECT_TRUE(only_says(read_poses("poses = [[1, 2, 3], [1, 2, 4]]"), "p.toml:8:1", {"one place", "length"}));
    EXPECT_TRUE(accepted(read_poses("poses = [[1, 2, 3], [1, 2, 4]]\nlength = 1")));
}

TEST(Poses, AreThreeNumbersEachOrTwoWhereAnyAngleWillDo) {
    EXPECT_TRUE(accepted(read_poses("poses = [[1, 2, 3], [2, 2]]")));
    EXPECT_TRUE(only_says(read_poses("poses = [[1, 2, 3], [1, 2, 3, 4]]"), "p.toml:9:21",
                          {"pose 2", "[x, y, angle]", "[x, y] where any angle will do"}));
    EXPECT_TRUE(only_says(read_poses("poses = [[1, 2], [2, 2]]"), "p.toml:9:9", {"[path]"}));
    EXPECT_TRUE(says(read_poses("poses = [[1, 2, 3], [1, 2]]\nlength = 1"), "p.toml:9:21", {"one pose"}));
    EXPECT_TRUE(only_says(read_poses("poses = [[1, 2, nan], [1, 2, 3]]"), "p.toml:9:17", {"pose 1", "finite"}));
    EXPECT_TRUE(only_says(read_poses("poses = 3"), "p.toml:9:9", {"list"}));
    EXPECT_TRUE(only_says(read_poses(""), "p.toml:8:1", {"poses = [[x, y, angle], ...]"}));
}

TEST(Poses, ABodyHasAPositiveLength) {
    EXPECT_TRUE(
        only_says(read_poses("poses = [[1, 2, 3], [2, 2, 3]]\nlength = 0"), "p.toml:10:10", {"greater than 0"}));
}

TEST(Poses, StandAloneAndHaveQuantitiesOfTheirOwn) {
    EXPECT_TRUE(says(read(valid + "[path]\npoints = [[1, 2]]\n[poses]\nposes = [[1, 2, 3], [2, 2, 3]]\n"),
                     "p.toml:10:1", {"not both"}));
    EXPECT_TRUE(says(read_poses("poses = [[1, 2, 3], [2, 2, 3]]\n[objective]\nminimize = \"path-rms\""), "p.toml:11:12",
                     {"[path]"}));
    EXPECT_TRUE(
        says(read("schema = 1\nmechanism = \"whitworth\"\n[dimensions]\ncentre-distance = 1\ncrank = 3\narm = 1\n"
                  "[poses]\nposes = [[1, 2, 3], [2, 2, 3]]\n"),
             "p.toml:7:1", {"guides no body"}));
    EXPECT_TRUE(
        accepted(read("schema = 1\nmechanism = \"slider-crank\"\n[dimensions]\ncrank = 1\nrod = 3\noffset = 0\n"
                      "[poses]\nposes = [[1, 2, 3], [2, 2, 3]]\n")));
}

TEST(Poses, HaveCrankAnglesWhereTheyArePrescribed) {
    const std::string angles = "poses = [[1, 2, 90], [3, 4, 180]]\ncrank_angles = [0, 90]\n";
    const ReadProblem timed = read_poses(angles + "timing = \"prescribed\"");
    ASSERT_TRUE(accepted(timed));
    EXPECT_NEAR(timed.problem.path->crank_angles.at(1), std::acos(-1.0) / 2, 1e-15);
    EXPECT_TRUE(only_says(read_poses(angles), "p.toml:10:16", {"need timing = \"prescribed\""}));
}

}  // namespace

}  // namespace mechwright::test

#include <cmath>

#include "tests/problem/problem_text.h"

namespace mechwright::test {

namespace {

/// The section starts in line 8, what is given in line 9.
ReadProblem read_path(const std::string& lines) { return read(valid + "[path]\n" + lines + "\n"); }

/// "key = [a, b, ...]"
template <class Element>
std::string list(const std::string& key, int count, const Element& element) {
    std::string text = key + " = [";
    for (int i = 0; i < count; ++i)
        text += element(i) + ", ";
    return text + "]\n";
}

std::string many_points(int count) {
    return list("points", count, [](int i) { return "[" + std::to_string(i) + ", 1]"; });
}

std::string timed(const std::string& angles) {
    return "points = [[0, 0], [1, 0], [2, 0]]\ntiming = \"prescribed\"\ncrank_angles = " + angles;
}

}  // namespace

TEST(Path, APathNeedsPoints) {
    EXPECT_TRUE(only_says(read_path(""), "p.toml:8:1", {"'points'", "'points_file'"}));
    EXPECT_TRUE(only_says(read_path("points = []"), "p.toml:9:10", {"empty point list", "at least one"}));
    EXPECT_TRUE(accepted(read_path("points = [[1, 2]]")));
}

TEST(Path, PointsAreGivenOneWay) {
    EXPECT_TRUE(only_says(read_path("points = [[1, 2]]\npoints_file = \"a.csv\""), "p.toml:10:15", {"not both"}));
    EXPECT_EQ(read_path("points = [[1, 2], 3]\npoints_file = \"a.csv\"").messages.size(), 2u);
}

TEST(Path, PointsArePairsOfFiniteNumbers) {
    EXPECT_TRUE(only_says(read_path("points = 3"), "p.toml:9:10", {"'points'", "list of pairs", "a number"}));
    EXPECT_TRUE(
        only_says(read_path("points = [1, 2]").messages.size() == 2 ? read_path("points = [[1, 2], 2]") : ReadProblem{},
                  "p.toml:9:19", {"point 2", "pair [x, y]", "a number"}));
    EXPECT_TRUE(only_says(read_path("points = [[1, 2], [3]]"), "p.toml:9:19", {"point 2", "pair", "1 values"}));
    EXPECT_TRUE(only_says(read_path("points = [[1, 2, 3]]"), "p.toml:9:11", {"point 1", "pair", "3 values"}));
    EXPECT_TRUE(only_says(read_path("points = [[1, \"2\"]]"), "p.toml:9:15", {"y of point 1", "string"}));
    EXPECT_TRUE(only_says(read_path("points = [[nan, 2]]"), "p.toml:9:12", {"x of point 1", "finite"}));
    EXPECT_TRUE(only_says(read_path("points = [[1, -inf]]"), "p.toml:9:15", {"y of point 1", "finite"}));
}

TEST(Path, NeighbouringPointsMustNotCoincide) {
    EXPECT_TRUE(
        only_says(read_path("points = [[1, 2], [3, 4], [3.0, 4]]"), "p.toml:9:27", {"points 2 and 3", "coincide"}));
}

TEST(Path, AWrongPointHidesNoOthersAndKeepsItsNumber) {
    const ReadProblem problem = read_path("points = [[1, 2], 3, [4, 5], [4, 5], [nan, 4], [\"x\", 4]]\nweights = [1]");
    EXPECT_EQ(problem.messages.size(), 4u) << all_messages(problem);
    EXPECT_TRUE(says(problem, "p.toml:9:19", {"point 2"}));
    EXPECT_TRUE(says(problem, "p.toml:9:30", {"points 3 and 4", "coincide"}));
    EXPECT_TRUE(says(problem, "p.toml:9:39", {"x of point 5", "finite"}));
    EXPECT_TRUE(says(problem, "p.toml:9:49", {"x of point 6", "string"}));
}

TEST(Path, APathMayReturnToItsFirstPoint) {
    EXPECT_TRUE(accepted(read_path("points = [[1, 2], [3, 4], [1, 2]]")));
    EXPECT_TRUE(accepted(read_path("points = [[1, 2], [3, 4], [1, 2]]\nclosed = true")));
}

TEST(Path, TooManyPointsAreOneMessage) {
    EXPECT_TRUE(only_says(read_path(many_points(10001)), "p.toml:9:10", {"10001 points", "at most 10000", "thin"}));
}

TEST(Path, FreeTimingTakesFewerPoints) {
    EXPECT_TRUE(accepted(read_path(many_points(200))));
    EXPECT_TRUE(only_says(read_path(many_points(201)), "p.toml:9:10", {"201", "at most 200", "thin", "timing"}));
    const std::string angles = list("crank_angles", 10000, [](int i) { return std::to_string(i / 100.0); });
    EXPECT_TRUE(accepted(read_path(many_points(10000) + "timing = \"prescribed\"\n" + angles)));
}

TEST(Path, TimingIsFreeOrPrescribed) {
    EXPECT_TRUE(accepted(read_path("points = [[1, 2]]\ntiming = \"free\"")));
    EXPECT_TRUE(only_says(read_path("points = [[1, 2]]\ntiming = \"fee\""), "p.toml:10:10",
                          {"unknown timing 'fee'", "'free'"}));
    EXPECT_TRUE(only_says(read_path("points = [[1, 2]]\ntiming = true"), "p.toml:10:10", {"'timing'", "string"}));
}

TEST(Path, PrescribedTimingNeedsCrankAngles) {
    EXPECT_TRUE(only_says(read_path("points = [[1, 2]]\ntiming = \"prescribed\""), "p.toml:10:10", {"'crank_angles'"}));
}

TEST(Path, CrankAnglesNeedPrescribedTiming) {
    EXPECT_TRUE(only_says(read_path("points = [[1, 2]]\ncrank_angles = [0]"), "p.toml:10:16",
                          {"'crank_angles'", "\"prescribed\""}));
    EXPECT_TRUE(only_says(read_path("points = [[1, 2]]\ntiming = \"free\"\ncrank_angles = [0]"), "p.toml:11:16",
                          {"'crank_angles'", "\"prescribed\""}));
}

TEST(Path, ThereIsOneCrankAngleForEachPoint) {
    EXPECT_TRUE(only_says(read_path(timed("[0, 10]")), "p.toml:11:16", {"'crank_angles'", "2 numbers", "3 points"}));
    EXPECT_TRUE(only_says(read_path(timed("30")), "p.toml:11:16", {"'crank_angles'", "list of numbers"}));
    EXPECT_TRUE(only_says(read_path(timed("[0, \"x\", 2]")), "p.toml:11:20", {"number 2", "a string"}));
    EXPECT_TRUE(only_says(read_path(timed("[0, nan, 2]")), "p.toml:11:20", {"number 2", "finite"}));
}

TEST(Path, CrankAnglesAllRiseOrAllFall) {
    EXPECT_TRUE(accepted(read_path(timed("[10, 20, 30]"))));
    EXPECT_TRUE(accepted(read_path(timed("[10, 0, -30]"))));
    EXPECT_TRUE(only_says(read_path(timed("[0, 20, 10]")), "p.toml:11:24", {"crank angle 3", "rise", "fall"}));
    EXPECT_TRUE(only_says(read_path(timed("[0, 20, 20]")), "p.toml:11:24", {"crank angle 3", "rise", "fall"}));
    EXPECT_TRUE(only_says(read_path(timed("[5, 5, 20]")), "p.toml:11:20", {"crank angle 2"}));
}

TEST(Path, CrankAnglesStayWithinOneTurn) {
    EXPECT_TRUE(accepted(read_path(timed("[10, 20, 370]"))));
    EXPECT_TRUE(only_says(read_path(timed("[10, 20, 371]")), "p.toml:11:16", {"10", "371", "one full turn"}));
    EXPECT_TRUE(only_says(read_path(timed("[10, -20, -351]")), "p.toml:11:16", {"one full turn"}));
}

TEST(Path, WeightsArePositiveAndOneForEachPoint) {
    EXPECT_TRUE(only_says(read_path("points = [[1, 2], [3, 4]]\nweights = [1]"), "p.toml:10:11",
                          {"'weights'", "1 numbers", "2 points"}));
    EXPECT_TRUE(only_says(read_path("points = [[1, 2], [3, 4]]\nweights = [1, 0]"), "p.toml:10:15",
                          {"weight of point 2", "greater than 0"}));
    EXPECT_TRUE(only_says(read_path("points = [[1, 2]]\nweights = [-1]"), "p.toml:10:12", {"weight of point 1"}));
    EXPECT_TRUE(only_says(read_path("points = [[1, 2]]\nweights = [inf]"), "p.toml:10:12", {"number 1", "finite"}));
    EXPECT_TRUE(only_says(read_path("points = [[1, 2]]\nweights = 1"), "p.toml:10:11", {"list of numbers"}));
}

TEST(Path, ClosedIsTrueOrFalse) {
    EXPECT_TRUE(only_says(read_path("points = [[1, 2]]\nclosed = \"yes\""), "p.toml:10:10",
                          {"'closed'", "true or false", "a string"}));
}

TEST(Path, AnUnknownKeyIsAnErrorWithTheNearestName) {
    EXPECT_TRUE(only_says(read_path("points = [[1, 2]]\nweight = [1]"), "p.toml:10:1", {"'weight'", "'weights'"}));
    EXPECT_TRUE(only_says(read_path("point = [[1, 2]]\npoints = [[1, 2]]"), "p.toml:9:1", {"'point'", "'points'"}));
}

}  // namespace mechwright::test

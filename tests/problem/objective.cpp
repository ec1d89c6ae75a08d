#include "tests/problem/problem_text.h"

namespace mechwright::test {

namespace {

/// The section starts in line 8, what is given in line 9.
ReadProblem read_objective(const std::string& lines) { return read(valid + "[objective]\n" + lines + "\n"); }
ReadProblem read_objectives(const std::string& lines) { return read(valid + "[[objective]]\n" + lines + "\n"); }

TEST(Pareto, NeedsTwoObjectives) {
    const std::string pair =
        "[[objective]]\nmaximize = \"transmission-angle-worst\"\n[[objective]]\nminimize = \"total-length\"\n";
    const ReadProblem two = read(valid + pair + "[solver]\npareto = 20\n");
    ASSERT_TRUE(accepted(two));
    EXPECT_EQ(two.problem.solver.pareto, 20);
    EXPECT_TRUE(says(read(valid + "[solver]\npareto = 20\n"), "p.toml:9:10", {"two", "[[objective]]"}));
    EXPECT_TRUE(says(read(valid + "[objective]\nminimize = \"total-length\"\n[solver]\npareto = 20\n"), "p.toml:11:10",
                     {"two"}));
    EXPECT_TRUE(says(read(valid + pair + "[solver]\npareto = 1\n"), "p.toml:13:10", {"between 2 and 1000"}));
    EXPECT_TRUE(says(read(valid + pair + "[solver]\npareto = \"many\"\n"), "p.toml:13:10", {"whole number"}));
}

}  // namespace

TEST(Objective, OneQuantityIsMinimizedOrMaximized) {
    const ReadProblem minimized = read_objective("minimize = \"link-ratio\"");
    ASSERT_TRUE(accepted(minimized));
    ASSERT_EQ(minimized.problem.objective->terms.size(), 1u);
    EXPECT_FALSE(minimized.problem.objective->terms[0].maximize);
    EXPECT_TRUE(read_objective("maximize = \"link-ratio\"").problem.objective->terms[0].maximize);
}

TEST(Objective, SenselessOrTwofoldSensesAreErrors) {
    EXPECT_TRUE(only_says(read_objective(""), "p.toml:8:1", {"'minimize'", "'maximize'"}));
    EXPECT_TRUE(only_says(read_objective("minimize = \"swing\"\nmaximize = \"swing\""), "p.toml:10:12",
                          {"both 'minimize' and 'maximize'", "[[objective]]"}));
}

TEST(Objective, AMisspeltQuantityIsAnErrorWithTheNearestName) {
    EXPECT_TRUE(only_says(read_objective("maximize = \"transmission-angle-wrost\""), "p.toml:9:12",
                          {"unknown quantity", "'transmission-angle-worst'"}));
    EXPECT_TRUE(only_says(read_objective("maximize = 1"), "p.toml:9:12", {"'maximize'", "string"}));
}

TEST(Objective, AnUnknownKeyIsAnErrorWithTheNearestName) {
    EXPECT_TRUE(only_says(read_objective("minimize = \"swing\"\nreduec = \"max\""), "p.toml:10:1",
                          {"'reduec' in [objective]", "'reduce'"}));
    EXPECT_TRUE(only_says(read_objectives("minimize = \"swing\"\nwieght = 1"), "p.toml:10:1",
                          {"'wieght' in [[objective]]", "'weight'"}));
}

TEST(Objective, TheWorstOfSeveralIsOptimized) {
    const ReadProblem read_file =
        read_objective("maximize = [\"transmission-angle-min\", \"velocity-ratio-min\"]\nreduce = \"max\"");
    ASSERT_TRUE(accepted(read_file));
    EXPECT_TRUE(read_file.problem.objective->worst);
    ASSERT_EQ(read_file.problem.objective->terms.size(), 2u);
    EXPECT_TRUE(read_file.problem.objective->terms[1].maximize);
}

TEST(Objective, AListNeedsToBeReduced) {
    EXPECT_TRUE(only_says(read_objective("minimize = [\"swing\", \"link-ratio\"]"), "p.toml:9:12",
                          {"list", "reduce = \"max\"", "[[objective]]"}));
    EXPECT_TRUE(only_says(read_objective("minimize = [\"swing\"]\nreduce = \"sum\""), "p.toml:10:10",
                          {"unknown reduction 'sum'", "max"}));
    EXPECT_TRUE(only_says(read_objective("minimize = \"swing\"\nreduce = \"max\""), "p.toml:10:10",
                          {"'reduce'", "list of quantities"}));
}

TEST(Objective, AListNamesQuantities) {
    EXPECT_TRUE(only_says(read_objective("minimize = []\nreduce = \"max\""), "p.toml:9:12", {"empty"}));
    EXPECT_TRUE(only_says(read_objective("minimize = [\"swing\", \"swang\"]\nreduce = \"max\""), "p.toml:9:22",
                          {"unknown quantity 'swang'", "'swing'"}));
    EXPECT_TRUE(only_says(read_objective("minimize = [\"swing\", 2]\nreduce = \"max\""), "p.toml:9:22", {"string"}));
}

TEST(Objective, WeightsArePositiveNumbers) {
    EXPECT_TRUE(
        only_says(read_objectives("minimize = \"swing\"\nweight = 0"), "p.toml:10:10", {"'weight'", "greater than 0"}));
    EXPECT_TRUE(only_says(read_objectives("minimize = \"swing\"\nweight = -1"), "p.toml:10:10", {"greater than 0"}));
    EXPECT_TRUE(only_says(read_objectives("minimize = \"swing\"\nweight = \"1\""), "p.toml:10:10", {"a number"}));
    EXPECT_TRUE(only_says(read_objectives("minimize = \"swing\"\nweight = inf"), "p.toml:10:10", {"finite"}));
    EXPECT_TRUE(
        only_says(read_objective("minimize = \"swing\"\nweight = 2"), "p.toml:10:10", {"'weight'", "[[objective]]"}));
}

TEST(Objective, AWeightedTermHasOneQuantity) {
    EXPECT_TRUE(only_says(read_objectives("minimize = [\"swing\", \"link-ratio\"]"), "p.toml:9:12",
                          {"'minimize'", "string", "a list"}));
    EXPECT_TRUE(only_says(read_objectives("weight = 1"), "p.toml:8:1", {"'minimize'", "'maximize'"}));
}

TEST(Objective, AnObjectiveIsASectionOrSeveral) {
    EXPECT_TRUE(only_says(read("objective = \"swing\"\n" + valid), "p.toml:1:13", {"'objective'", "[objective]"}));
    EXPECT_TRUE(only_says(read("objective = []\n" + valid), "p.toml:1:13", {"'objective'", "empty"}));
    EXPECT_TRUE(only_says(read("objective = [1]\n" + valid), "p.toml:1:14", {"[[objective]]", "a number"}));
}

TEST(Objective, APathQuantityNeedsAPath) {
    EXPECT_TRUE(only_says(read_objective("minimize = \"path-sse\""), "p.toml:9:12", {"'path-sse'", "no [path]"}));
}

TEST(Objective, ObjectivesOfALowerRankComeFirst) {
    const ReadProblem ranked = read(valid +
                                    "[[objective]]\nminimize = \"total-length\"\nrank = 3\n[[objective]]\n"
                                    "maximize = \"swing\"\nrank = 2\n[[objective]]\n"
                                    "maximize = \"transmission-angle-worst\"\nwithin = 90\n"
                                    "[[objective]]\nminimize = \"link-ratio\"\nweight = 2\nrank = 3\n");
    ASSERT_TRUE(accepted(ranked));
    const Problem& problem = ranked.problem;
    ASSERT_EQ(problem.wishes.size(), 2u);
    EXPECT_EQ(problem.mechanism->quantities[problem.wishes[0].term.quantity].name, "transmission-angle-worst");
    EXPECT_TRUE(problem.wishes[0].term.maximize);
    EXPECT_NEAR(problem.wishes[0].within, 1.5707963267948966, 1e-15);
    EXPECT_EQ(problem.mechanism->quantities[problem.wishes[1].term.quantity].name, "swing");
    ASSERT_EQ(problem.objective->terms.size(), 2u);
    EXPECT_EQ(problem.objective->terms[1].weight, 2);
}

TEST(Objective, RanksThatMeanNothingAreErrors) {
    EXPECT_TRUE(only_says(read_objective("minimize = \"swing\"\nrank = 2"), "p.toml:10:8", {"'rank'", "no effect"}));
    EXPECT_TRUE(only_says(read_objectives("minimize = \"swing\"\nwithin = 2"), "p.toml:10:10",
                          {"'within'", "that none comes after"}));
    EXPECT_TRUE(only_says(read_objectives("minimize = \"swing\"\nrank = 0"), "p.toml:10:8", {"1 or greater, not 0"}));
    EXPECT_TRUE(only_says(read_objectives("minimize = \"swing\"\nwithin = -1\n[[objective]]\nrank = 2\n"
                                          "minimize = \"link-ratio\""),
                          "p.toml:10:10", {"'within'", "0 or greater"}));
    EXPECT_TRUE(only_says(read_objectives("minimize = \"swing\"\n[[objective]]\nminimize = \"total-length\"\nrank = 1\n"
                                          "[[objective]]\nrank = 2\nminimize = \"link-ratio\""),
                          "p.toml:12:8", {"two objectives have rank 1"}));
    EXPECT_TRUE(only_says(read_objectives("minimize = \"swing\"\n[[objective]]\nrank = 2\nminimize = \"link-ratio\"\n"
                                          "[solver]\npareto = 5"),
                          "p.toml:14:10", {"'pareto'", "one rank"}));
}

}  // namespace mechwright::test

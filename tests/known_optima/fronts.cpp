// Trade-offs between two objectives: known points, no design better in both than another, each verified by itself.

#include <algorithm>
#include <functional>

#include "synthesis/verify/verify.h"
#include "tests/known_optima/solved.h"

namespace mechwright {

namespace {

using testing::shipped;
using testing::Solved;
using testing::solved;

double value_of(const Solved& s, const VerifiedDesign& point, std::size_t term) {
    return quantity_value(s.problem, s.problem.objective->terms[term].quantity, point.solution.design).value();
}

/// Both objectives change one way from each design to the next: none is beaten.
void expect_front(const Solved& s) {
    ASSERT_EQ(s.result.status, Status::solved);
    const auto& terms = s.problem.objective->terms;
    for (std::size_t i = 1; i < s.result.front.size(); ++i) {
        const auto gain = [&](std::size_t term) {
            const double change = value_of(s, s.result.front[i], term) - value_of(s, s.result.front[i - 1], term);
            return terms[term].maximize ? change : -change;
        };
        EXPECT_LT(gain(0), 0) << i;
        EXPECT_GT(gain(1), 0) << i;
    }
    for (const Check& check : verify(document(s.problem, s.result)))
        EXPECT_TRUE(check.passed) << check.name << ": " << check.detail;
}

TEST(Fronts, OfPathAndGrashofMarginHoldTheKnownPoints) {
    const Solved s = solved(shipped("case-4-margin.toml", "trade-off"));
    expect_front(s);
    ASSERT_EQ(s.result.front.size(), 8u);
    EXPECT_NEAR(value_of(s, s.result.front.front(), 0), 1.798233, 1e-6);
    EXPECT_NEAR(value_of(s, s.result.front.front(), 1), 0.05, 1e-9);
    // A point between, by a problem of its own.
    std::string text = shipped("case-4-margin.toml", "trade-off");
    text = text.substr(0, text.find("[[objective]]"));
    text.replace(text.find("min = 0.05"), 10, "min = " + std::to_string(value_of(s, s.result.front[3], 1)));
    const Solved alone = solved(text + "[objective]\nminimize = \"path-sse\"\n");
    EXPECT_NEAR(value_of(s, s.result.front[3], 0), alone.result.best->objective, 1e-5);
}

TEST(Fronts, OfErrorAndTransmissionAngleStartAtTheLeastError) {
    std::string text = shipped("error-against-transmission.toml", "trade-off");
    const Solved s = solved(text);
    expect_front(s);
    EXPECT_GE(s.result.front.size(), 10u);
    text = text.substr(0, text.find("[[objective]]"));
    const Solved alone = solved(text + "[objective]\nminimize = \"function-max\"\n");
    EXPECT_NEAR(value_of(s, s.result.front.front(), 0) * 180 / 3.141592653589793, alone.result.best->objective, 1e-8);
    const Solved other = solved(text + "[objective]\nmaximize = \"transmission-angle-worst\"\n");
    EXPECT_NEAR(value_of(s, s.result.front.back(), 1) * 180 / 3.141592653589793, other.result.best->objective, 1e-4);
}

TEST(Fronts, TellHowManySearchesThereAre) {
    std::string text = shipped("straightness-against-size.toml", "trade-off");
    text.replace(text.find("pareto = 10"), 11, "pareto = 3");
    const ReadProblem read = parse_problem(text, "straightness-against-size.toml");
    ASSERT_TRUE(read.ok());
    RunOptions options;
    options.jobs = 2;
    // The points, the best design in the other objective, and a choice among those that are as good in that one.
    constexpr int searches = 3 + 1 + 1;
    std::vector<int> ended;
    options.progress = [&](int done, int total, double) {
        EXPECT_LE(done, total);
        if (total == searches) ended.push_back(done);
    };
    const Result result = solve(read.problem, options);
    EXPECT_GE(result.front.size(), 2u);
    ASSERT_GE(ended.size(), 3u);
    EXPECT_EQ(std::adjacent_find(ended.begin(), ended.end(), std::greater_equal<>()), ended.end());
}

TEST(Fronts, ThatWereTamperedWithAreNotVerified) {
    std::string text = shipped("straightness-against-size.toml", "trade-off");
    text.replace(text.find("pareto = 10"), 11, "pareto = 5");
    const Solved s = solved(text);
    expect_front(s);
    auto json = document(s.problem, s.result);
    json["front"][2]["design"]["crank"] = json["front"][2]["design"]["crank"].get<double>() * 1.001;
    const auto checks = verify(json);
    const auto failed = [&](std::string_view name) {
        return std::any_of(checks.begin(), checks.end(), [&](const Check& c) { return c.name == name && !c.passed; });
    };
    EXPECT_TRUE(failed("front design 3"));
    EXPECT_FALSE(failed("front design 2"));
    json["front"][1] = 7;
    const auto odd = verify(json);
    EXPECT_TRUE(std::any_of(odd.begin(), odd.end(), [](const Check& c) { return !c.passed; }));
    json["front"] = "none";
    EXPECT_FALSE(all_passed(verify(json)));
}

}  // namespace

}  // namespace mechwright

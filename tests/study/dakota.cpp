// Dakota's files: a driver that speaks them.

#include "synthesis/study/dakota.h"

#include <gtest/gtest.h>

#include <cmath>
#include <sstream>

namespace mechwright::dakota {
namespace {

const std::string given = R"(schema = 1
mechanism = "four-bar"
[dimensions]
ground = 100
crank = 30
coupler = 90
rocker = 70
)";

const std::string sought = R"(schema = 1
mechanism = "four-bar"
[dimensions]
ground  = 100.0
crank   = { min = 5, max = 60 }
coupler = { min = 20, max = 300 }
rocker  = { min = 20, max = 300 }
[[require]]
quantity = "time-ratio"
equal    = 1.1176470588235294
[[require]]
quantity = "swing"
equal    = 60
[objective]
maximize = "transmission-angle-worst"
)";

/// As Dakota writes it (User's Manual, "Parameters file format (standard)").
std::string parameters(const std::vector<std::pair<std::string, double>>& variables,
                       const std::vector<std::pair<std::string, int>>& responses, const std::string& id = "1") {
    std::ostringstream text;
    text << "                    " << variables.size() << " variables\n";
    for (const auto& [name, value] : variables)
        text << "  " << std::scientific << value << " " << name << "\n";
    text << "                    " << responses.size() << " functions\n";
    int k = 0;
    for (const auto& [name, wanted] : responses)
        text << "                    " << wanted << " ASV_" << ++k << ":" << name << "\n";
    text << "                    " << variables.size() << " derivative_variables\n";
    for (std::size_t i = 0; i < variables.size(); ++i)
        text << "                    " << i + 1 << " DVV_" << i + 1 << ":" << variables[i].first << "\n";
    text << "                    0 analysis_components\n                    " << id << " eval_id\n";
    return text.str();
}

std::string answer(const std::string& file, const std::string& problem) {
    const ReadEvaluations read = read_parameters(file);
    EXPECT_EQ(read.fault, "");
    return results_of(read.evaluations, problem, "p.toml");
}

TEST(Dakota, GetsValuesOfAGivenDesign) {
    std::istringstream results(
        answer(parameters({{"dimensions.crank", 31}}, {{"total-length", 1}, {"design.crank", 1}}), given));
    double value = 0;
    std::string label;
    results >> value >> label;
    EXPECT_EQ(value, 291);
    EXPECT_EQ(label, "total-length");
    results >> value >> label;
    EXPECT_EQ(value, 31);
}

TEST(Dakota, GetsGradientsOfAGivenDesign) {
    const auto swing = [](double crank) {
        return std::stod(answer(parameters({{"dimensions.crank", crank}}, {{"swing", 1}}), given));
    };
    const std::string both = answer(parameters({{"dimensions.crank", 30}}, {{"swing", 3}}), given);
    const std::size_t bracket = both.find("\n[ ");
    ASSERT_NE(bracket, std::string::npos) << both;
    EXPECT_NEAR(std::stod(both.substr(bracket + 3)), (swing(30.001) - swing(29.999)) / 0.002, 1e-5);
}

TEST(Dakota, GetsTheOptimumOfAProblem) {
    const double best = std::stod(answer(parameters({{"require.swing.equal", 60}}, {{"objective", 1}}), sought));
    EXPECT_NEAR(best, 45.00822, 1e-5);
}

TEST(Dakota, IsToldOfFailures) {
    for (const auto& [text, why] : std::vector<std::pair<std::string, std::string>>{
             {parameters({{"require.swing.equal", 179.9}}, {{"objective", 1}}), "FAIL\ninfeasible"},
             {parameters({{"require.stroke.equal", 60}}, {{"objective", 1}}),
              "FAIL\n'require' has no element 'stroke'"},
             {parameters({{"require.swing.equal", 60}}, {{"swong", 1}}), "FAIL\nthere is no quantity 'swong'"},
             {parameters({{"require.swing.equal", 60}}, {{"swing", 2}}), "FAIL\ngradients are offered"},
             {parameters({{"require.swing.equal", 60}}, {{"swing", 4}}), "FAIL\nHessian"}})
        EXPECT_TRUE(answer(text, sought).starts_with(why)) << answer(text, sought);
}

TEST(Dakota, GetsABatchInItsOrder) {
    const std::string results = answer(parameters({{"dimensions.crank", 31}}, {{"total-length", 1}}, "7") +
                                           parameters({{"dimensions.crank", -1}}, {{"total-length", 1}}, "8") +
                                           parameters({{"dimensions.crank", 33}}, {{"total-length", 1}}, "9"),
                                       given);
    EXPECT_EQ(results.find("# 7\n291 total-length\n# 8\nFAIL\n"), 0u) << results;
    EXPECT_NE(results.find("# 9\n293 total-length\n"), std::string::npos);
}

TEST(Dakota, DamagedFilesAreNamed) {
    for (const char* text :
         {"", "x variables\n", "1 variables\n", "1 variables\n1.5\n", "-1 variables\n",
          "1 variables\n1 a\n1 functions\n1 f\n1 derivative_variables\n2 DVV_1:a\n", "99999999999 variables\n"})
        EXPECT_NE(read_parameters(text).fault, "") << text;
}

}  // namespace
}  // namespace mechwright::dakota

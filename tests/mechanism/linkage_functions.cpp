// Linkages that generate functions: against the built-in kinds, differences, fifty digits and scans of closed forms.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <numbers>
#include <random>
#include <string>

#include "synthesis/document/document.h"
#include "synthesis/problem/reader.h"
#include "synthesis/solve/solve.h"
#include "synthesis/target/function/function_target.h"
#include "tests/checked.h"
#include "tests/mechanism/linkage_texts.h"

namespace mechwright {

namespace {

using testing::expect_slopes;
using testing::expect_verified;
using testing::first_error;
using testing::free_four_bar;
using testing::is_refused;
using testing::read_without_fault;

constexpr double degree = std::numbers::pi / 180;

const std::string power = R"(
expression = "x^1.5"
x = [1, 4]
input = { start = { min = 0, max = 360 }, range = { min = 30, max = 90 } }
output = { start = { min = 0, max = 360 }, range = { min = 30, max = 90 } }
)";
const std::string sampled = R"(
samples = [[0, 0], [1, 1], [2, 4], [4, 16]]
input = { start = { min = 0, max = 360 }, range = { min = 30, max = 90 } }
output = { start = { min = 0, max = 360 }, range = { min = 30, max = 90 } }
)";

std::string with_function(const std::string& signal, const std::string& function) {
    return "\n[signals]\nout = { " + signal + " }\n[function]\nsignal = \"out\"\n" + function;
}

nlohmann::ordered_json solved_text(const std::string& text, const std::string& method = "slsqp") {
    ReadProblem read = read_without_fault(text);
    if (!read.ok()) return {};
    read.problem.solver.method = method;
    read.problem.solver.time_limit = 600;  // no machine is too busy
    return document(read.problem, solve(read.problem, {}));
}

std::string text_of_problem(const std::string& name) {
    std::ifstream file(MECHWRIGHT_SOURCE_DIR "/problems/" + name);
    return {std::istreambuf_iterator<char>(file), {}};
}

Motion motion_of_function(const Problem& problem, const Quantity& quantity, std::size_t assembly) {
    Motion motion;
    motion.assembly = assembly;
    motion.model = problem.mechanism->model.data();
    motion.of = quantity.of.data();
    motion.function = problem.function.get();
    motion.full_turn = false;
    return motion;
}

double measured(const Quantity& quantity, const Motion& motion, std::span<const double> arguments) {
    std::vector<double> value(quantity.components(motion));
    quantity.measure(motion, arguments, {value, {}, {}});
    return *std::max_element(value.begin(), value.end());
}

}  // namespace

/// The same errors at the same places as the built-in four-bar's, for random ones, and in fifty digits.
TEST(LinkageFunctions, ErrorsOfAFourBarAreThoseOfTheBuiltInKind) {
    const auto built_in = find_mechanism("four-bar");
    std::mt19937_64 random(3);
    const auto between = [&](double low, double high) { return std::uniform_real_distribution<>(low, high)(random); };
    for (const std::string& function : {power, sampled}) {
        const ReadProblem read = read_without_fault(free_four_bar + with_function("angle = \"rocker\"", function));
        ASSERT_TRUE(read.ok());
        const Problem& problem = read.problem;
        const auto& own = *problem.mechanism->function;
        int compared = 0;
        for (int i = 0; i < 60; ++i) {
            const std::size_t assembly = i % 2;
            std::array<double, 8> known{
                between(2, 8),  between(1, 6), between(2, 8), between(2, 8), between(0, 6), between(0.3, 1.5), 0,
                between(0.3, 1)};
            if (i % 3 == 0) known[5] = -known[5];
            // Beside the angle that the rocker has in the middle.
            known[6] = built_in->function->extremes(*problem.function, built_in->form(assembly), known).front().error +
                       between(-0.2, 0.2);
            std::array<double, 13> arguments{known[0], known[1], known[2], known[3], 1, 2, 0.5, 0.1, 0.3};
            std::copy(known.begin() + 4, known.end(), arguments.begin() + 9);
            const auto expected = built_in->function->extremes(*problem.function, built_in->form(assembly), known);
            const Motion plain = motion_of_function(problem, own.quantities[0], assembly);
            const double greatest = measured(own.quantities[0], plain, arguments);
            if (!(greatest < 2)) continue;  // it does not close, or is half a turn off
            ++compared;
            const auto extremes = own.extremes(*problem.function, problem.mechanism->form(assembly), arguments);
            ASSERT_EQ(extremes.size(), expected.size());
            for (std::size_t k = 0; k < extremes.size(); ++k) {
                EXPECT_NEAR(extremes[k].share, expected[k].share, 1e-7);
                EXPECT_NEAR(extremes[k].error, expected[k].error, 1e-12);
            }
            for (std::size_t q = 0; q < 2; ++q) {
                const Motion over = motion_of_function(problem, own.quantities[q], assembly);
                Motion of_built_in = over;
                of_built_in.model = nullptr;
                EXPECT_NEAR(measured(own.quantities[q], over, arguments),
                            measured(built_in->function->quantities[q], of_built_in, known), 1e-12);
                if (compared > 3) continue;
                Motion again = over;
                again.from = std::min(known[4], known[4] + known[5]);
                again.to = std::max(known[4], known[4] + known[5]);
                const std::vector<Digits50> precise(arguments.begin(), arguments.end());
                EXPECT_NEAR(own.quantities[q].measure_again(again, precise).convert_to<double>(),
                            measured(own.quantities[q], over, arguments), 1e-11)
                    << own.quantities[q].name;
            }
        }
        EXPECT_GT(compared, 15);
    }
}

TEST(LinkageFunctions, SlopesOfErrorsAreTheirDifferences) {
    for (const std::string signal : {"angle = \"rocker\"", "y = \"P\""})
        for (const std::string& function : {power, sampled}) {
            const ReadProblem read = read_without_fault(free_four_bar + with_function(signal, function));
            ASSERT_TRUE(read.ok());
            const Mechanism& m = *read.problem.mechanism;
            for (const double range : {1.1, -0.9}) {
                const std::vector<double> arguments{7, 2, 6, 5, 2, 1, 0.3, -0.4, 0.5, 0.9, range, 1.3, 0.7};
                for (const Quantity& quantity : m.function->quantities)
                    expect_slopes(m, quantity, motion_of_function(read.problem, quantity, 0), arguments);
            }
        }
}

/// Example 9-2 of the source: 0.610531 degrees.
TEST(LinkageFunctions, AFourBarsOptimumIsThatOfTheBuiltInKind) {
    const std::string text = R"(
schema = 1
mechanism = "linkage"
[dimensions]
crank = { min = 2, max = 20, start = 9 }
coupler = { min = 2, max = 30, start = 15 }
rocker = { min = 2, max = 30, start = 12 }
[links]
frame = { A = [0, 0], D = [5, 0] }
crank = { A = [0, 0], B = ["crank", 0] }
coupler = { B = [0, 0], C = ["coupler", 0] }
rocker = { D = [0, 0], C = ["rocker", 0] }
[drive]
link = "crank"
[assembly]
C = "either"
)" + with_function("angle = \"rocker\"", R"(
expression = "x^1.5"
x = [1, 4]
input = { start = 210, range = 90 }
output = { start = 270, range = 90 }
[objective]
minimize = "function-max"
[solver]
starts = 1
)");
    const auto found = solved_text(text), known = solved_text(text_of_problem("function/power.toml"));
    ASSERT_EQ(found["status"], "solved");
    EXPECT_NEAR(found["objective"]["value"].get<double>(), known["objective"]["value"].get<double>(), 1e-9);
    EXPECT_NEAR(found["objective"]["value"].get<double>(), 0.610531, 5e-7);
    EXPECT_NEAR(found["design"]["crank"].get<double>(), 8.957615, 1e-5);
    EXPECT_EQ(found["function"]["alternating"], 4);
    EXPECT_EQ(found["function"]["free"], 3);
    expect_verified(found);
    for (const char* tampered : {"/design/crank", "/design/output-start", "/objective/value",
                                 "/function/extremes/1/error", "/quantities/function-rms"}) {
        auto changed = found;
        auto& number = changed[nlohmann::ordered_json::json_pointer(tampered)];
        number = number.get<double>() + 1e-5;
        EXPECT_TRUE(is_refused(changed)) << tampered;
    }
    auto changed = found;
    changed["function"]["alternating"] = 3;
    EXPECT_TRUE(is_refused(changed));
    changed = found;
    changed["linkage"]["signals"]["out"]["angle"] = "coupler";
    EXPECT_TRUE(is_refused(changed));
}

namespace {

/// The direction of a rocker at `pivot` whose pin a coupler holds at a distance from `from`, on one side, by the law of
/// cosines.
double rocker_angle(const std::array<double, 2>& from, const std::array<double, 2>& pivot, double coupler,
                    double rocker, double side) {
    const double x = from[0] - pivot[0], y = from[1] - pivot[1], d = std::hypot(x, y);
    return std::atan2(y, x) + side * std::acos((rocker * rocker + d * d - coupler * coupler) / (2 * rocker * d));
}

}  // namespace

/// The output by the law of cosines, scanned: five dimensions are free, so that six extremes alternate.
TEST(LinkageFunctions, AWattSixBarsErrorsAlternate) {
    const auto found = solved_text(text_of_problem("linkage/function-watt-two.toml"), "auto");
    ASSERT_EQ(found["status"], "solved");
    expect_verified(found);
    const auto number = [&](const char* name) { return found["design"][name].get<double>(); };
    const double greatest = found["objective"]["value"].get<double>();
    EXPECT_LT(greatest, 0.1);
    // The sides for which the scan has the greatest error that is stated are those of the design.
    double closest = 1e9;
    int alternating = 0;
    for (const double first : {1.0, -1.0})
        for (const double second : {1.0, -1.0}) {
            constexpr int steps = 20000;
            std::vector<double> errors;
            for (int i = 0; i <= steps; ++i) {
                const double share = static_cast<double>(i) / steps, crank = (210 + 90 * share) * degree;
                const std::array<double, 2> b{number("crank") * std::cos(crank), number("crank") * std::sin(crank)};
                const double rocker = rocker_angle(b, {5, 0}, number("coupler"), number("rocker"), first);
                const std::array<double, 2> e{5 + number("arm") * std::cos(rocker), number("arm") * std::sin(rocker)};
                const double output = rocker_angle(e, {-9.14, -14.14}, number("rod"), number("output"), second);
                const double x = 1 + 3 * share, asked = 270 + 90 * (std::pow(x, 1.5) - 1) / 7;
                errors.push_back(std::remainder(output / degree - asked, 360));
            }
            double worst = 0;
            for (const double e : errors)
                worst = std::max(worst, std::abs(e));
            if (!(std::abs(worst - greatest) < closest)) continue;
            closest = std::abs(worst - greatest);
            alternating = 0;
            double last = 0;
            for (const double e : errors)
                if (std::abs(e) > (1 - 1e-5) * worst && e * last <= 0) {
                    ++alternating;
                    last = e;
                }
        }
    EXPECT_LT(closest, 1e-8);
    EXPECT_EQ(alternating, 6);
    EXPECT_EQ(found["function"]["alternating"], 6);
    EXPECT_EQ(found["function"]["free"], 5);
}

/// A length as the output: the ram of problems/function/ram-square.toml, described by its links.
TEST(LinkageFunctions, ARamsOptimumIsThatOfTheBuiltInKind) {
    std::string text = R"(
schema = 1
mechanism = "linkage"
[dimensions]
crank = { min = 10, max = 300 }
rod = { min = 10, max = 600 }
offset = { min = -300, max = 300 }
[links]
frame = { O = [0, 0] }
crank = { O = [0, 0], A = ["crank", 0] }
rod = { A = [0, 0], B = ["rod", 0] }
ram = { B = [0, 0] }
[[slide]]
link = "ram"
on = "frame"
point = [0, "offset"]
direction = 0
[drive]
link = "crank"
)" + with_function("x = \"B\"", R"(
expression = "x^2"
x = [1, 3]
input = { start = { min = 0, max = 360 }, range = 80 }
output = { start = { min = -600, max = 600 }, range = 60 }
[[require]]
quantity = "transmission-angle-worst"
min = 40
[objective]
minimize = "function-max"
[solver]
starts = 1
)");
    const auto known = solved_text(text_of_problem("function/ram-square.toml"), "auto");
    ASSERT_EQ(known["status"], "solved");
    // From a little beside it.
    const auto start = [&](const std::string& old, const char* name, double away) {
        const std::size_t at = text.find(old);
        text.insert(at + old.size(), ", start = " + std::to_string(known["design"][name].get<double>() + away));
    };
    start("min = 10, max = 300", "crank", 1);
    start("min = 10, max = 600", "rod", -2);
    start("min = -300, max = 300", "offset", 1);
    start("min = 0, max = 360", "input-start", 0.5);
    start("min = -600, max = 600", "output-start", 1);
    const auto found = solved_text(text);
    ASSERT_EQ(found["status"], "solved");
    EXPECT_NEAR(found["objective"]["value"].get<double>(), known["objective"]["value"].get<double>(), 1e-9);
    EXPECT_EQ(found["function"]["alternating"], known["function"]["alternating"]);
    expect_verified(found);
}

TEST(LinkageFunctions, WrongOnesAreSaidWithARemedy) {
    const auto error = [](const std::string& signals, const std::string& name) {
        return first_error(free_four_bar + "\n[signals]\n" + signals + "\n[function]\n" + name + power);
    };
    EXPECT_NE(error("out = { angle = \"rocker\" }", "").find("'signal' in [function] is missing"), std::string::npos);
    EXPECT_EQ(error("swing = { angle = \"rocker\" }", "signal = \"swung\""),
              "there is no signal 'swung'; did you mean 'swing'?");
    EXPECT_NE(error("a = { x = \"P\" }\nb = { y = \"P\" }\nc = { ratio = [\"a\", \"b\"] }", "signal = \"c\"")
                  .find("'c' is a ratio"),
              std::string::npos);
    EXPECT_NE(error("a = { angle = \"rocker\" }\nb = { sum = { a = 0.5 } }", "signal = \"b\"").find("no whole numbers"),
              std::string::npos);
    EXPECT_NE(
        first_error(free_four_bar + "[instant]\ncrank = 3\n").find("[[require]] quantity = \"NAME.speed.at(60)\""),
        std::string::npos);
}

}  // namespace mechwright

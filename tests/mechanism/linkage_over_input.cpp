// Linkages with functions, lines and arcs beside paths and beside each other: each over an input range of its own.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>

#include "synthesis/document/document.h"
#include "synthesis/problem/reader.h"
#include "synthesis/program/assess.h"
#include "synthesis/program/quantity_value.h"
#include "synthesis/solve/solve.h"
#include "synthesis/target/path/rows/stretch.h"
#include "tests/checked.h"
#include "tests/long_form.h"
#include "tests/mechanism/linkage_texts.h"

namespace mechwright::over_input_tests {

namespace {

using Json = nlohmann::ordered_json;
using testing::expect_verified;
using testing::first_error;
using testing::free_four_bar;
using testing::is_refused;
using testing::read_without_fault;

constexpr double degree = 0.017453292519943295;

std::string shipped_linkage(const std::string& name) {
    std::ifstream file(std::string(MECHWRIGHT_SOURCE_DIR) + "/problems/linkage/" + name);
    std::stringstream text;
    text << file.rdbuf();
    return text.str();
}

const std::string signals = "[signals]\nswing = { angle = \"rocker\" }\nrise = { y = \"P\" }\n";
const std::string swing = R"(name = "dial"
signal = "swing"
expression = "x^2"
x = [1, 2]
input = { start = { min = 0, max = 360 }, range = 60 }
output = { start = { min = 0, max = 360 }, range = 30 }
)";
const std::string rise = R"(name = "lift"
weight = 3
signal = "rise"
samples = [[0, 0], [1, 2], [2, 3]]
input = { start = { min = 0, max = 360 }, range = -50 }
output = { start = { min = 0, max = 36 }, range = 1 }
)";
const std::string flat = "name = \"flat\"\npoint = \"P\"\nstart = { min = 0, max = 360 }\nrange = 40\n";
const std::string round = "name = \"round\"\npoint = \"C\"\nstart = { min = 0, max = 360 }\nrange = 80\n";

std::string many_targets() {
    return free_four_bar + signals + "[[function]]\n" + swing + "[[function]]\n" + rise + "[[line]]\n" + flat +
           "[arc]\n" + round;
}

/// A crank-rocker with its numbers after its nine dimensions.
struct Measured {
    ReadProblem read;
    Design design;

    Measured(const std::string& text, std::vector<double> numbers) : read(read_without_fault(text)) {
        design.dimensions = {7, 2, 6, 5, 2, 1.5, 0.3, -0.4, 0.5};
        design.dimensions.insert(design.dimensions.end(), numbers.begin(), numbers.end());
    }
    double value(const std::string& name) const {
        return value_named(read.problem, design, name).value_or(std::nan(""));
    }
};

const std::vector<double> of_dial{20 * degree, 60 * degree, 100 * degree, 30 * degree},
    of_lift{300 * degree, -50 * degree, 2.5, 1}, of_flat{30 * degree, 40 * degree, 0.2, 1.1},
    of_round{100 * degree, 80 * degree, 6.5, 3, 4};

std::vector<double> numbers_of_many() {
    std::vector<double> all;
    for (const auto& some : {of_dial, of_lift, of_flat, of_round})
        all.insert(all.end(), some.begin(), some.end());
    return all;
}

}  // namespace

TEST(OverInput, EachHasItsOwnNumbersAndQuantities) {
    const ReadProblem read = read_without_fault(many_targets());
    ASSERT_TRUE(read.ok());
    const Mechanism& m = *read.problem.mechanism;
    for (const char* name : {"dial.input-start", "dial.output-range", "lift.input-range", "lift.output-start",
                             "flat.line-angle", "flat.input-start", "round.arc-radius"})
        EXPECT_GE(find_dimension(m, name), 0) << name;
    for (const char* name : {"input-start", "line-angle", "crank-start"})
        EXPECT_LT(find_dimension(m, name), 0) << name;
    for (const char* name : {"dial.function-max", "lift.function-rms", "flat.line-deviation", "flat.line-length",
                             "round.arc-angle", "line-deviation", "arc-deviation"})
        EXPECT_GE(find_quantity(m, name), 0) << name;
    // An angle and a length have no greatest together.
    for (const char* name : {"function-max", "function-rms", "line-length"})
        EXPECT_LT(find_quantity(m, name), 0) << name;
}

/// What each target has among the others is what it has in a problem of its own, where it needs no name.
TEST(OverInput, EachIsMeasuredAsIfItStoodAlone) {
    const Measured many(many_targets(), numbers_of_many());
    const auto alone = [&](const std::string& section, const std::string& text, const std::vector<double>& numbers,
                           const std::string& name, const std::string& quantity) {
        const std::string rest = text.substr(text.find('\n') + 1), weight = "weight = 3\n";
        const std::size_t at = rest.find(weight);
        const std::string without =
            at == std::string::npos ? rest : rest.substr(0, at) + rest.substr(at + weight.size());
        const Measured one(free_four_bar + signals + "[" + section + "]\n" + without, numbers);
        EXPECT_DOUBLE_EQ(many.value(name + "." + quantity), one.value(quantity)) << quantity;
        EXPECT_GT(one.value(quantity), 0) << quantity;
    };
    for (const char* quantity : {"function-max", "function-rms"}) {
        alone("function", swing, of_dial, "dial", quantity);
        alone("function", rise, of_lift, "lift", quantity);
    }
    for (const char* quantity : {"line-deviation", "line-length"})
        alone("line", flat, of_flat, "flat", quantity);
    for (const char* quantity : {"arc-deviation", "arc-angle"})
        alone("arc", round, of_round, "round", quantity);
    EXPECT_DOUBLE_EQ(many.value("line-deviation"), many.value("flat.line-deviation"));
}

/// sqrt(sum w rms^2 / sum w) over all, and the greatest of all.
TEST(OverInput, QuantitiesOfAllAreTheWeightedOnesOfEach) {
    std::string other = rise;
    other.replace(other.find("\"rise\""), 6, "\"swing\"");
    std::vector<double> numbers = of_dial;
    for (const double number : {300 * degree, -50 * degree, 110 * degree, 20 * degree})
        numbers.push_back(number);
    const Measured m(free_four_bar + signals + "[[function]]\n" + swing + "[[function]]\n" + other, numbers);
    const double dial = m.value("dial.function-rms"), lift = m.value("lift.function-rms");
    ASSERT_GT(dial * lift, 0);
    EXPECT_NEAR(m.value("function-rms"), std::sqrt((dial * dial + 3 * lift * lift) / 4), 1e-15);
    EXPECT_DOUBLE_EQ(m.value("function-max"), std::max(m.value("dial.function-max"), m.value("lift.function-max")));
}

/// The dial moves from 20 to 80 deg, the lift from 250 to 300, the line is followed from 30 to 70, the arc from 100 to
/// 180.
TEST(OverInput, TheMotionIsTheShortestThatCoversAll) {
    Measured m(many_targets(), numbers_of_many());
    const CrankStretch stretch = *stretch_of(m.read.problem, m.design);
    EXPECT_NEAR(stretch.first, 20 * degree, 1e-12);
    EXPECT_NEAR(stretch.last, 300 * degree, 1e-12);
    // The dial two turns later, and the lift from 350 to 400 deg: it is shorter to begin with the lift.
    m.design.dimensions[9] = (20 + 720) * degree;
    m.design.dimensions[13] = 400 * degree;
    const CrankStretch other = *stretch_of(m.read.problem, m.design);
    EXPECT_NEAR(other.last - other.first, (180 + 10) * degree, 1e-12);
    EXPECT_NEAR(motion_of(m.read.problem, m.design).to - motion_of(m.read.problem, m.design).from, 190 * degree, 1e-12);
    // With a path beside them that is met from 310 to 320 deg.
    Measured with_path(many_targets() + "[path]\npoint = \"P\"\npoints = [[1, 2], [3, 4], [5, 5]]\n", {});
    std::vector<double> numbers{0};
    for (const double number : numbers_of_many())
        numbers.push_back(number);
    with_path.design.dimensions.insert(with_path.design.dimensions.end(), numbers.begin(), numbers.end());
    with_path.design.path_angles = {-50 * degree, -45 * degree, -40 * degree};
    const CrankStretch more = *stretch_of(with_path.read.problem, with_path.design);
    EXPECT_NEAR(more.last - more.first, (540 - 250) * degree, 1e-12);
}

TEST(OverInput, WrongOnesAreSaidWithARemedy) {
    const auto error = [](const std::string& targets) { return first_error(free_four_bar + signals + targets); };
    const auto contains = [](const std::string& text, const std::string& part) {
        EXPECT_NE(text.find(part), std::string::npos) << text;
    };
    const std::string unnamed = swing.substr(swing.find('\n') + 1), function = "[[function]]\n",
                      path = "[path]\npoint = \"P\"\npoints = [[1, 2], [3, 4], [5, 5]]\n";
    contains(error(function + unnamed + function + rise),
             "'name' in [[function]] number 1 is missing: where there are several functions, lines and arcs");
    contains(error(function + swing + function + swing), "'dial' is another target already");
    contains(error(function + unnamed + "[line]\n" + flat), "'name' in [[function]] is missing");
    contains(error("[[path]]\nname = \"dial\"\npoint = \"P\"\npoints = [[0, 0], [1, 2]]\n" + function + swing),
             "'dial' is another target already");
    contains(error(function + swing + "weight = -1\n"), "must be greater than 0, not -1");
    contains(error(function + swing + function + rise + "[objective]\nminimize = \"dial.line-deviation\"\n"),
             "it has dial.function-max and dial.function-rms");
    contains(error(function + swing + "[objective]\nminimize = \"deal.function-max\"\n"), "did you mean 'dial'?");
    contains(error(function + swing + function + rise + "[objective]\nminimize = \"function-max\"\n"),
             "unknown quantity 'function-max': known are");
    contains(error(function + unnamed + path + "timing = \"none\"\n"), "only where the path has closed = true");
    std::string many;
    for (int i = 0; i < 17; ++i)
        many += "[[line]]\nname = \"l" + std::to_string(i) + "\"\npoint = \"P\"\nstart = 0\nrange = 40\n";
    contains(error(many), "16 at most");
    contains(error("line = []\n"), "'line'");
    const std::string built_in =
        "schema = 1\nmechanism = \"four-bar\"\n[dimensions]\nground = 4\ncrank = 1\ncoupler = 3\nrocker = 3\n";
    const std::string line = "start = 0\nrange = 40\n";
    contains(first_error(built_in + "[[line]]\n" + line + "[[line]]\n" + line), "'mechwright expand' writes it so");
    contains(first_error(built_in + "[line]\n" + line + "[arc]\n" + line), "it cannot have [arc] beside [line]");
}

namespace {

Json solved(const std::string& text) {
    const ReadProblem read = read_without_fault(text);
    return read.ok() ? document(read.problem, solve(read.problem, {})) : Json();
}

}  // namespace

/// The shipped feeder is found by the path and the functions that it made; a document with any part changed is refused.
TEST(OverInput, AFeederIsFoundByItsPathAndItsFunctions) {
    std::string text = shipped_linkage("function-and-path.toml");
    text.replace(text.find("starts = 2"), 10, "starts = 1");
    const Json found = solved(text);
    ASSERT_EQ(found["status"], "solved");
    EXPECT_LT(found["objective"]["value"].get<double>(), 1e-6);
    EXPECT_NEAR(found["design"]["crank"].get<double>(), 40, 1e-5);
    EXPECT_NEAR(found["design"]["p-across"].get<double>(), 60, 1e-5);
    EXPECT_NEAR(found["design"]["lever"].get<double>(), 90, 1e-5);
    EXPECT_NEAR(found["design"]["lift.input-start"].get<double>(), 200, 1e-5);
    expect_verified(found);
    int changes = 0;
    const auto refused = [&](const auto& change) {
        if (changes++ % cases_to_try(5, 1) != 0) return;
        Json changed = found;
        change(changed);
        EXPECT_TRUE(is_refused(changed));
    };
    const auto shifted = [](Json& number) { number = number.get<double>() + 1e-3; };
    refused([&](Json& json) { shifted(json["design"]["lift.input-start"]); });
    refused([&](Json& json) { shifted(json["quantities"]["roll.function-max"]); });
    refused([&](Json& json) { shifted(json["quantities"]["function-rms"]); });
    refused([&](Json& json) { shifted(json["quantities"]["rocker-angle.range"]); });
    refused([&](Json& json) { shifted(json["function"][1]["samples"][2][1]); });
    refused([&](Json& json) { shifted(json["function"][0]["extremes"][1]["error"]); });
    refused([&](Json& json) { json["function"][0]["weight"] = 1; });
    refused([&](Json& json) { json["function"][0]["name"] = "lift"; });
    refused([&](Json& json) { json["function"] = json["function"][0]; });
    refused([&](Json& json) { json["linkage"]["function"][0]["signal"] = "lever-angle"; });
    refused([&](Json& json) { json["path"]["crank_angles"][0] = 0; });
    refused([&](Json& json) { json.erase("function"); });
}

}  // namespace mechwright::over_input_tests

// Problems of built-in kinds said as the linkages that they are: the same quantities, path errors and optima; and what
// linkages cannot carry, named.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <nlohmann/json.hpp>
#include <sstream>

#include "synthesis/document/document.h"
#include "synthesis/problem/linkage/of_kinds/expand.h"
#include "synthesis/problem/units.h"
#include "synthesis/program/assess.h"
#include "synthesis/program/quantity_value.h"
#include "synthesis/solve/solve.h"
#include "tests/checked.h"

namespace mechwright {

namespace {

using Json = nlohmann::ordered_json;

const std::string problems = MECHWRIGHT_SOURCE_DIR "/problems/";

std::string text_of_file(const std::string& file) {
    std::ifstream in(file);
    return {std::istreambuf_iterator<char>(in), {}};
}

/// Designs that `mechwright solve` found for shipped problems: `design` of the document, and the crank angles at which
/// a path's points are met.
const Json& found_designs() {
    static const Json found = Json::parse(text_of_file(MECHWRIGHT_SOURCE_DIR "/tests/mechanism/found_designs.json"));
    return found;
}

ExpandedProblem expanded(const std::string& name, const DesignPutIn& put_in = {}) {
    return expand_problem(text_of_file(problems + name), problems + name, put_in);
}

/// The text of a shipped problem without the one objective that no linkage can carry.
std::string text_to_carry(const std::string& name) {
    std::string text = text_of_file(problems + name);
    const std::string objective = "minimize = \"speed-variation\"";
    if (const std::size_t at = text.find(objective); at != std::string::npos)
        text.replace(at, objective.size(), "minimize = \"total-length\"");
    return text;
}

/// The quantities of the linkage that a quantity of the kind is the least or greatest of.
std::vector<std::string> names_of(const Counterpart& counterpart) {
    std::vector<std::string> names;
    for (const std::string_view name : counterpart.is)
        if (!name.empty()) names.emplace_back(name);
    return names;
}

/// A problem with a design as its numbers.
struct GivenDesign {
    Problem problem;
    Solution solution;

    GivenDesign(Problem of, const Json& design, std::size_t assembly, const Json& crank_angles)
        : problem(std::move(of)) {
        Design given;
        for (std::size_t i = 0; i < problem.dimensions.size(); ++i) {
            const Dimension& d = problem.mechanism->dimensions[i];
            const auto at = design.find(d.name);
            const bool open = !problem.dimensions[i].fixed() && at != design.end();
            given.dimensions.push_back(open ? from_file_unit(at->get<double>(), unit_of(d.kind), problem.units)
                                            : problem.dimensions[i].min);
        }
        given.assembly = assembly;
        for (const Json& angle : crank_angles)
            given.path_angles.push_back(from_file_unit(angle.get<double>(), Unit::angle, problem.units));
        solution = assess(problem, std::move(given));
    }
    std::optional<double> value(std::string_view quantity) const {
        const int index = find_quantity(*problem.mechanism, quantity);
        if (index < 0) return {};
        return quantity_value(problem, static_cast<std::size_t>(index), solution.design);
    }
};

/// The text of a linkage that reports more quantities, whatever they are.
std::string reporting(std::string text, std::span<const Counterpart> counterparts) {
    for (const Counterpart& counterpart : counterparts)
        for (const std::string& name : names_of(counterpart))
            text += "\n[[require]]\nquantity = \"" + name + "\"\nmin = -1e9\n";
    return text;
}

/// The same quantities, and errors of targets, of a design by both ways.
void expect_same_quantities(const std::string& name, const Json& found) {
    SCOPED_TRACE(name);
    const Json& design = found["design"];
    const std::string text = text_to_carry(name);
    const ExpandedProblem linkage = expand_problem(text, problems + name, {&design, false});
    for (const Message& message : linkage.messages)
        ADD_FAILURE() << to_string(message);
    ASSERT_TRUE(linkage.ok());
    const ReadProblem built_in = parse_problem(text, problems + name);
    const Mechanism& kind = *built_in.problem.mechanism;
    const auto counterparts = kind.as_linkage->quantities;
    const ReadProblem read = parse_problem(reporting(linkage.text, counterparts), problems + name);
    // Found dimensions are given ones now: that they meet equations is warned of.
    for (const Message& message : read.messages)
        if (!message.warning) ADD_FAILURE() << to_string(message);
    ASSERT_TRUE(read.ok());
    std::size_t assembly = 0;
    if (design.contains("assembly"))
        assembly = static_cast<std::size_t>(
            std::find(kind.assemblies.begin(), kind.assemblies.end(), design["assembly"].get<std::string>()) -
            kind.assemblies.begin());
    const GivenDesign own(built_in.problem, design, assembly, found["crank_angles"]),
        other(read.problem, Json::object(), 0, found["crank_angles"]);
    const auto expect_near = [](double is, double expected, std::string_view of) {
        EXPECT_NEAR(is, expected, 1e-12 * std::max(1.0, std::abs(expected))) << of;
    };
    std::size_t compared = 0;
    for (const Counterpart& counterpart : counterparts) {
        const auto expected = own.value(counterpart.quantity);
        const std::vector<std::string> names = names_of(counterpart);
        if (!expected || names.empty() || (counterpart.least_limit && *expected < *counterpart.least_limit)) continue;
        // Of a ram drive it is folded at a right angle, which signals are not.
        if (counterpart.quantity == "transmission-angle-max" && kind.name != "four-bar") continue;
        // Over an input range a linkage measures signals there alone.
        if (has_input_range(built_in.problem) && names.front().find('.') != std::string::npos) continue;
        std::vector<double> values;
        for (const std::string& one : names)
            values.push_back(other.value(one).value_or(std::nan("")));
        if (counterpart.of_full_turn && values.front() < 0) continue;
        // A linkage that goes from target to target makes no cycle whose parts could be compared.
        if (counterpart.quantity == "time-ratio" && std::isnan(values.front())) continue;
        expect_near(counterpart.by == Counterpart::By::greatest ? *std::max_element(values.begin(), values.end())
                                                                : *std::min_element(values.begin(), values.end()),
                    *expected, counterpart.quantity);
        ++compared;
    }
    EXPECT_GE(compared, 3u);
    for (const Quantity& quantity : kind.quantities)
        if (quantity.path != PathMeasure::none || !quantity.section.empty()) {
            const auto expected = own.value(quantity.name), is = other.value(quantity.name);
            if (!expected) continue;
            ASSERT_TRUE(is) << quantity.name;
            expect_near(*is, *expected, quantity.name);
        }
}

TEST(Expanded, HasTheQuantitiesAndErrorsOfEveryShippedProblemWithItsFoundDimensions) {
    ASSERT_GE(found_designs().size(), 30u);
    for (const auto& [name, found] : found_designs().items())
        expect_same_quantities(name, found);
}

/// What a linkage cannot carry of a shipped problem; empty where it carries it whole.
std::string reason_to_refuse(const std::string& name) {
    static const std::map<std::string, std::string> reasons{
        {"path/case-4-margin.toml", "no 'grashof-margin'"},
        {"exact/velocities-of-an-instant.toml", "cannot carry [instant]"},
        {"quick-return/uniform-speed-crank-shaper.toml", "no 'speed-variation'"},
        {"quick-return/uniform-speed-drag-link.toml", "no 'speed-variation'"},
        {"quick-return/uniform-speed-whitworth.toml", "no 'speed-variation'"},
        {"trade-off/case-4-margin.toml", "no 'grashof-margin'"},
        {"studies/prime-radius-nomogram.toml", "a cam is no linkage"},
        {"studies/crank-rocker-tolerances.toml", ""},
        {"studies/crank-rocker-allocation.toml", ""},
    };
    if (const auto reason = reasons.find(name); reason != reasons.end()) return reason->second;
    if (name.starts_with("studies/")) return "cannot carry [study]";
    if (name.starts_with("cam/")) return "a cam is no linkage";
    if (read_problem(problems + name).problem.mechanism->name == "linkage") return "this is a linkage already";
    return "";
}

TEST(Expanded, NamesWhatALinkageCannotCarryOfShippedProblems) {
    for (const auto& entry : std::filesystem::recursive_directory_iterator(problems)) {
        const std::string name = std::filesystem::relative(entry.path(), problems).string();
        if (entry.path().extension() != ".toml" || name.starts_with("linkage/")) continue;
        SCOPED_TRACE(name);
        const ExpandedProblem linkage = expanded(name);
        std::string said;
        for (const Message& message : linkage.messages)
            said += to_string(message) + '\n';
        const std::string reason = reason_to_refuse(name);
        EXPECT_EQ(linkage.ok(), reason.empty()) << said;
        if (reason.empty()) continue;
        EXPECT_NE(said.find(reason), std::string::npos) << said;
        EXPECT_NE(said.find(name + ':'), std::string::npos) << said;
    }
}

/// The dimension of a design by its name in a document, which is that of a number of a target, too.
void expect_local_solve_stays(const std::string& name, double objective_within, double dimensions_within) {
    SCOPED_TRACE(name);
    const Json& found = found_designs()[name];
    const ExpandedProblem linkage = expanded(name, {&found["design"], true});
    ASSERT_TRUE(linkage.ok()) << (linkage.messages.empty() ? "" : to_string(linkage.messages.front()));
    ReadProblem read = parse_problem(linkage.text, problems + name);
    ASSERT_TRUE(read.ok()) << to_string(read.messages.front());
    read.problem.solver.starts = 1;
    read.problem.solver.time_limit = 600;
    const Result result = solve(read.problem, {});
    ASSERT_TRUE(result.best);
    EXPECT_TRUE(result.best->feasible);
    const Json document = mechwright::document(read.problem, result);
    const double objective = found["objective"];
    EXPECT_NEAR(document["objective"]["value"].get<double>(), objective,
                objective_within * std::max(1.0, std::abs(objective)));
    for (const auto& [dimension, value] : document["design"].items()) {
        if (!value.is_number() || !found["design"].contains(dimension)) continue;
        const double expected = found["design"][dimension];
        EXPECT_NEAR(value.get<double>(), expected, dimensions_within * std::max(1.0, std::abs(expected))) << dimension;
    }
}

TEST(Expanded, ALocalSolveFromTheFoundDimensionsEndsWhereItStarted) {
    expect_local_solve_stays("four-bar/crank-rocker.toml", 1e-8, 1e-4);
    expect_local_solve_stays("four-bar/drag-link-velocity-ratio.toml", 1e-8, 1e-4);
    expect_local_solve_stays("quick-return/slider-crank-compact.toml", 1e-8, 1e-4);
    expect_local_solve_stays("line/lambda-120.toml", 1e-8, 1e-4);
}

TEST(Expanded, KeepsUnitsTiesPlacesAndComments) {
    const std::string text = R"(# A lambda linkage.
schema = 1
title = "In radians"
mechanism = "four-bar"
[units]
angle = "rad"
length = "in"
[dimensions]
ground = 3
crank = { min = 0.5, max = 2, start = 1 }
coupler = 2.5
rocker = { of = "coupler" }
origin-x = { of = "ground", times = -0.5 }
tilt = { min = -1, max = 1 }
assembly = "crossed"
[[require]]
quantity = "swing"
max = 1
)";
    const ExpandedProblem linkage = expand_problem(text, "lambda.toml");
    ASSERT_TRUE(linkage.ok()) << to_string(linkage.messages.front());
    for (const char* expected :
         {"# A lambda linkage.\n", "title     = \"In radians\"\n", "mechanism = \"linkage\"\n", "angle = \"rad\"\n",
          "length = \"in\"\n", "crank", "{ min = 0.5, max = 2, start = 1 }", "{ of = \"coupler\" }",
          "origin-x = \"-0.5 ground\"\n", "tilt = { min = -1, max = 1 }\n", "side = \"right\"",
          "quantity = \"rocker-angle.range\"\nmax = 1\n", "quantity = \"full-turn-margin\"\nmin = 0\n", "P = [0, 0]",
          "max = 3.141592653589793\n"})
        EXPECT_NE(linkage.text.find(expected), std::string::npos) << expected << '\n' << linkage.text;
    EXPECT_TRUE(parse_problem(linkage.text, "lambda.toml").ok());
}

/// Messages of what cannot be expanded, with their places.
std::string refusal_of(const std::string& text) {
    const ExpandedProblem linkage = expand_problem(text, "file.toml");
    EXPECT_FALSE(linkage.ok());
    std::string said;
    for (const Message& message : linkage.messages)
        said += to_string(message) + '\n';
    return said;
}

/// Over an input range and over a range of use signals are measured where the kind's own quantities are.
TEST(Expanded, AsksForSignalsOverTheMotionThatThereIs) {
    const std::string slider_crank =
        "schema = 1\nmechanism = \"slider-crank\"\n[dimensions]\ncrank = { min = 1, max = 100 }\nrod = { min = 1, max "
        "= "
        "100 }\noffset = 0\n";
    const std::string limit = "[[require]]\nquantity = \"ram-speed-max\"\nmax = 3\n";
    for (const std::string& motion :
         {std::string("[function]\nexpression = \"x^1.5\"\nx = [1, 4]\ninput = { start = 210, range = 90 }\n"
                      "output = { start = 5, range = 9 }\n"),
          std::string("point-along = { min = 1, max = 100 }\npoint-across = 0\n[path]\npoints = [[1, 2], [3, 4]]\n"
                      "[motion]\nfrom = \"first-target\"\nto = \"last-target\"\n")}) {
        const ExpandedProblem expanded = expand_problem(slider_crank + motion + limit, "file.toml");
        ASSERT_TRUE(expanded.ok()) << motion;
        EXPECT_NE(expanded.text.find("quantity = \"ram-speed.greatest\"\nmax = 3\n"), std::string::npos)
            << expanded.text;
        EXPECT_TRUE(parse_problem(expanded.text, "expanded.toml").ok()) << expanded.text;
    }
}

TEST(Expanded, RefusesWithPlaceAndRemedy) {
    const auto expect_said = [](const std::string& said, const std::string& expected) {
        EXPECT_NE(said.find(expected), std::string::npos) << said;
    };
    const std::string four_bar =
        "schema = 1\nmechanism = \"four-bar\"\n[dimensions]\nground = 100\ncrank = { min = 20, max = 90 }\ncoupler = "
        "110\nrocker = 80\n";
    expect_said(
        refusal_of(four_bar + "[[require]]\nquantity = \"grashof-margin\"\nmin = 1\n"),
        "file.toml:9:12: a linkage has no 'grashof-margin': full-turn-margin is the same where the crank turns");
    EXPECT_TRUE(expand_problem(four_bar +
                                   "[[require]]\nquantity = \"grashof-margin\"\nmin = 1\n[[require]]\nquantity = "
                                   "\"swing\"\nmin = 1\n",
                               "file.toml")
                    .ok());
    expect_said(refusal_of(four_bar + "[study]\n\"dimensions.ground\" = [90, 100]\n"),
                "file.toml:8:1: a linkage cannot");
    expect_said(
        refusal_of("schema = 1\nmechanism = \"whitworth\"\n[dimensions]\ncentre-distance = 100\ncrank = { min = "
                   "90, max = 200 }\narm = 50\nrod = 200\nslide-angle = 90\n"),
        "let the ranges of 'centre-distance' and 'crank' exclude them");
    expect_said(
        refusal_of("schema = 1\nmechanism = \"slider-crank\"\n[dimensions]\ncrank = 20\nrod = { min = 50, max = "
                   "90 }\noffset = 0\n[[require]]\nquantity = \"speed-variation\"\nmax = 0.2\n"),
        "file.toml:8:12: a linkage has no 'speed-variation': the part of the stroke");
    const std::string drag_link =
        "schema = 1\nmechanism = \"drag-link\"\n[dimensions]\nground = 65\ncrank = { min = 90, max = 110 }\ncoupler = "
        "150\nfollower = 125\narm = 200\narm-angle = 0\nrod = 375\nslide-angle = 0\nslide-offset = 0\n";
    expect_said(refusal_of(drag_link + "[[require]]\nquantity = \"transmission-angle-max\"\nmax = 80\n"),
                "file.toml:15:7: a linkage has no 'transmission-angle-max': only limits of 90 deg or more");
    expect_said(refusal_of(drag_link + "[[require]]\nquantity = \"transmission-angle-min\"\nmax = 80\n"),
                "file.toml:14:12: a linkage has no 'transmission-angle-min': it is the least of several");
    const ExpandedProblem objective =
        expand_problem(drag_link + "[objective]\nmaximize = \"transmission-angle-min\"\n", "file.toml");
    ASSERT_TRUE(objective.ok());
    EXPECT_NE(objective.text.find("maximize = [\"coupler-transmission-angle.least\", \"transmission-angle.least\", "
                                  "\"transmission-other.least\"]\nreduce = \"max\"\n"),
              std::string::npos)
        << objective.text;
    expect_said(refusal_of(text_of_file(problems + "linkage/whitworth.toml")), "is a linkage already");
    expect_said(refusal_of(text_of_file(problems + "cam/flat-harmonic.toml")),
                "a cam is no linkage of links and joints");
}

}  // namespace

}  // namespace mechwright

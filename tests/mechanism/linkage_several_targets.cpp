// Linkages with several paths and poses: each with its own point or body, numbers, quantities and weight.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>

#include "synthesis/document/claimed_problem.h"
#include "synthesis/document/document.h"
#include "synthesis/problem/reader.h"
#include "synthesis/program/assess.h"
#include "synthesis/program/quantity_value.h"
#include "synthesis/program/standing/validity.h"
#include "synthesis/solve/solve.h"
#include "synthesis/target/path/rows/stretch.h"
#include "tests/checked.h"
#include "tests/long_form.h"
#include "tests/mechanism/linkage_texts.h"

namespace mechwright::several_targets {

namespace {

using Json = nlohmann::ordered_json;
using testing::expect_verified;
using testing::first_error;
using testing::free_four_bar;
using testing::head;
using testing::is_refused;
using testing::read_without_fault;

std::string shipped_linkage(const std::string& name) {
    std::ifstream file(std::string(MECHWRIGHT_SOURCE_DIR) + "/problems/linkage/" + name);
    std::stringstream text;
    text << file.rdbuf();
    return text.str();
}

std::string replaced(std::string text, const std::string& from, const std::string& to) {
    const std::size_t at = text.find(from);
    EXPECT_NE(at, std::string::npos) << from;
    return text.replace(at, from.size(), to);
}

const std::string points = "points = [[0, 0], [1, 2], [2, 3]]\n";

/// A path of P, another of C, and poses of the coupler, all with names.
const std::string three_targets = R"(
[[path]]
name = "along"
point = "P"
points = [[5, 4], [4, 5], [2.5, 5]]
weights = [1, 2, 3]
[[path]]
name = "pin"
weight = 0.5
point = "C"
points = [[6, 3], [5.5, 4]]
[poses]
name = "plate"
weight = 3
point = "P"
link = "coupler"
body-angle = { min = 0, max = 360 }
length = 2
poses = [[5, 4, 20], [4, 4], [3, 4, 50]]
)";

/// Of a design with all targets met as they fall at some crank angles.
struct Measured {
    ReadProblem read;
    Design design;
    Solution solution;

    explicit Measured(const std::string& text) : read(read_without_fault(text)) {
        // ground, crank, coupler, rocker, along, across, origin, tilt, three starts, the angle of the body.
        design.dimensions = {7, 2, 6, 5, 2, 1.5, 0.3, -0.4, 0.5, 0, 0, 0, 0.7};
        design.path_angles = {0.4, 0.9, 1.5, 0.2, 1.1, 0.5, 1.2, 1.9};
        solution = assess(read.problem, design);
    }
    double value(const std::string& name) const {
        return value_named(read.problem, design, name).value_or(std::nan(""));
    }
};

}  // namespace

TEST(SeveralTargets, EachHasItsOwnPointNumbersAndQuantities) {
    const ReadProblem read = read_without_fault(free_four_bar + three_targets);
    ASSERT_TRUE(read.ok());
    const Mechanism& m = *read.problem.mechanism;
    const PathTarget& path = *read.problem.path;
    ASSERT_EQ(path.parts.size(), 3u);
    ASSERT_EQ(m.guided.size(), 3u);
    EXPECT_EQ(path.points.size(), 8u);
    EXPECT_EQ(path.target_of(3), 1u);
    EXPECT_EQ(path.target_of(5), 2u);
    EXPECT_FALSE(path.guides_body_at(4));
    EXPECT_TRUE(path.guides_body_at(5));
    EXPECT_TRUE(path.faces(5));
    EXPECT_FALSE(path.faces(6));
    EXPECT_FALSE(path.faces(0));
    EXPECT_DOUBLE_EQ(path.body_length_at(7), 2);
    for (const char* name : {"along.crank-start", "pin.crank-start", "plate.crank-start", "plate.body-angle"})
        EXPECT_GE(find_dimension(m, name), 0) << name;
    for (const char* name : {"crank-start", "body-angle", "along.body-angle"})
        EXPECT_LT(find_dimension(m, name), 0) << name;
    for (const char* name : {"path-rms", "path-max", "along.path-sse", "along.path-rms", "pin.path-max",
                             "plate.pose-rms", "plate.pose-max"})
        EXPECT_GE(find_quantity(m, name), 0) << name;
    for (const char* name : {"path-sse", "pose-rms", "plate.path-rms", "along.pose-rms"})
        EXPECT_LT(find_quantity(m, name), 0) << name;
}

/// sqrt(sum w rms^2 / sum w) over all, the greatest of all, and of each what it has alone.
TEST(SeveralTargets, QuantitiesOfAllAreTheWeightedOnesOfEach) {
    const Measured m(free_four_bar + three_targets);
    const double along = m.value("along.path-rms"), pin = m.value("pin.path-rms"), plate = m.value("plate.pose-rms");
    ASSERT_GT(along + pin + plate, 0);
    EXPECT_NEAR(m.value("path-rms"), std::sqrt((along * along + 0.5 * pin * pin + 3 * plate * plate) / 4.5), 1e-14);
    EXPECT_DOUBLE_EQ(m.value("path-max"),
                     std::max({m.value("along.path-max"), m.value("pin.path-max"), m.value("plate.pose-max")}));
    EXPECT_NEAR(m.value("along.path-sse"), 6 * along * along, 1e-13);

    // Each target alone, by its own problem and without names.
    const auto alone = [&](const std::string& target, std::vector<double> angles, std::size_t more) {
        ReadProblem read = read_without_fault(free_four_bar + target);
        Design design = m.design;
        design.dimensions.resize(9);
        for (std::size_t i = 0; i < more; ++i)
            design.dimensions.push_back(i == 1 ? 0.7 : 0);
        design.path_angles = std::move(angles);
        return path_values(read.problem, design)->root_mean_square;
    };
    EXPECT_DOUBLE_EQ(along, alone("[path]\npoint = \"P\"\npoints = [[5, 4], [4, 5], [2.5, 5]]\nweights = [1, 2, 3]\n",
                                  {0.4, 0.9, 1.5}, 1));
    EXPECT_DOUBLE_EQ(pin, alone("[path]\npoint = \"C\"\npoints = [[6, 3], [5.5, 4]]\n", {0.2, 1.1}, 1));
    EXPECT_DOUBLE_EQ(plate, alone("[poses]\npoint = \"P\"\nlink = \"coupler\"\nlength = 2\n"
                                  "poses = [[5, 4, 20], [4, 4], [3, 4, 50]]\n",
                                  {0.5, 1.2, 1.9}, 2));
}

/// A single one, headed in double brackets, is the same problem with the same document as in single ones.
TEST(SeveralTargets, OneInDoubleBracketsIsThatInSingleOnes) {
    const std::string target = "path]\npoint = \"P\"\ncrank-start = 10\n" + points;
    const ReadProblem single = read_without_fault(free_four_bar + "[" + target),
                      twice = read_without_fault(free_four_bar + "[[" + replaced(target, "]", "]]"));
    EXPECT_TRUE(twice.problem.path->parts.empty());
    Json one = asked_document(single.problem), other = asked_document(twice.problem);
    EXPECT_EQ(one, other);
    EXPECT_TRUE(one["path"].is_object());
    EXPECT_EQ(one["linkage"]["path"], other["linkage"]["path"]);
}

/// One that has a name has its own quantities, which are those of all.
TEST(SeveralTargets, OneWithANameHasQuantitiesByIt) {
    const ReadProblem read =
        read_without_fault(free_four_bar + "[path]\nname = \"foot\"\npoint = \"P\"\nclosed = true\n" + points);
    const Mechanism& m = *read.problem.mechanism;
    EXPECT_GE(find_quantity(m, "foot.path-rms"), 0);
    EXPECT_GE(find_dimension(m, "foot.crank-start"), 0);
    EXPECT_TRUE(read.problem.path->closed);
    const Json document = asked_document(read.problem);
    ASSERT_TRUE(document["path"].is_array());
    EXPECT_EQ(document["path"][0]["name"], "foot");
}

TEST(SeveralTargets, WrongOnesAreSaidWithARemedy) {
    const auto error = [](const std::string& target) { return first_error(free_four_bar + target); };
    const auto contains = [](const std::string& text, const std::string& part) {
        EXPECT_NE(text.find(part), std::string::npos) << text;
    };
    const std::string p = "[[path]]\npoint = \"P\"\n" + points,
                      named = "[[path]]\nname = \"a\"\npoint = \"P\"\n" + points;
    contains(error(p + named), "'name' in [[path]] number 1 is missing");
    contains(error(named + named), "'a' is another target already");
    contains(error(named + replaced(named, "\"a\"", "\"A\"")), "differ by case only");
    contains(error(named + replaced(named, "\"a\"", "\"path-rms\"")), "give the target another name");
    contains(error(named + replaced(named, "\"a\"", "\"a.b\"")), "is no name");
    contains(error(named + "weight = 0\n"), "must be greater than 0, not 0");
    contains(error(named + "weight = \"x\"\n"), "must be a number");
    contains(error(named + "[signals]\na = { x = \"P\" }\n"), "'a' is a signal already");
    contains(error(named + replaced(named, "\"a\"", "\"b\"") + "timing = \"none\"\n"),
             "give all paths and poses of a problem one timing");
    contains(error("path = []\n"), "'path'");
    contains(error(named + "[objective]\nminimize = \"a.pose-rms\"\n"), "it has a.path-sse, a.path-rms and a.path-max");
    contains(error(named + "[objective]\nminimize = \"ab.path-rms\"\n"), "did you mean 'a'?");
    std::string many;
    for (int i = 0; i < 17; ++i)
        many += replaced(named, "\"a\"", "\"p" + std::to_string(i) + "\"");
    contains(error(many), "16 at most");
    // A built-in kind guides its coupler point along one path.
    const std::string built_in =
        "schema = 1\nmechanism = \"four-bar\"\n[dimensions]\nground = 4\ncrank = 1\ncoupler = 3\nrocker = 3\n";
    contains(first_error(built_in + "[[path]]\n" + points + "[[path]]\n" + points), "'mechwright expand' writes it so");
    contains(first_error(built_in + "[path]\nname = \"a\"\n" + points), "unknown key 'name'");
    EXPECT_TRUE(parse_problem(built_in + "[[path]]\n" + points, "four-bar.toml").ok());
}

namespace {

/// The same with crank angles.
std::string timed(std::string targets) {
    targets = replaced(std::move(targets), "weights = [1, 2, 3]\n",
                       "weights = [1, 2, 3]\ntiming = \"prescribed\"\ncrank_angles = [0, 20, 40]\n"
                       "crank-start = { min = 0, max = 90 }\n");
    targets = replaced(std::move(targets), "points = [[6, 3], [5.5, 4]]\n",
                       "points = [[6, 3], [5.5, 4]]\ntiming = \"prescribed\"\ncrank_angles = [0, 30]\n");
    return replaced(std::move(targets), "length = 2\n",
                    "length = 2\ntiming = \"prescribed\"\ncrank_angles = [0, 20, 50]\n"
                    "crank-start = { min = 200, max = 300 }\n");
}

}  // namespace

/// The crank is kept assembled over the shortest stretch that holds all targets, each turned on by whole turns.
TEST(SeveralTargets, TheMotionIsTheShortestStretchThatCoversAll) {
    ReadProblem read = read_without_fault(free_four_bar + three_targets);
    const double turn = 2 * std::acos(-1.0);
    Design design;
    design.path_angles = {0.4, 0.9, 1.5, 0.2 - turn, 1.1 - turn, 6.1, 6.2, 6.25};
    const CrankStretch stretch = *stretch_of(read.problem, design);
    EXPECT_NEAR(stretch.last - stretch.first, 1.5 + turn - 6.1, 1e-12);
    EXPECT_NEAR(std::remainder(stretch.first - 6.1, turn), 0, 1e-12);
}

TEST(SeveralTargets, AllPointsAreMetInOneDirection) {
    Measured m(free_four_bar + three_targets);
    const auto met_in_order = [&] {
        for (const ValidityMargin& margin : validity_margins(m.read.problem, m.design))
            if (margin.name.find("in their order") != std::string_view::npos) return margin.margin >= 0;
        return false;
    };
    EXPECT_TRUE(met_in_order());
    std::swap(m.design.path_angles[5], m.design.path_angles[7]);
    EXPECT_FALSE(met_in_order());
    std::swap(m.design.path_angles[0], m.design.path_angles[2]);
    std::swap(m.design.path_angles[3], m.design.path_angles[4]);
    EXPECT_TRUE(met_in_order());
}

namespace {

Json solved(const std::string& text) {
    const ReadProblem read = read_without_fault(text);
    return read.ok() ? document(read.problem, solve(read.problem, {})) : Json();
}

}  // namespace

/// The shipped six-bar is found by the path and the poses that it made; a document with any part changed is refused.
TEST(SeveralTargets, ASixBarIsFoundByItsPathAndItsPoses) {
    const Json found = solved(replaced(shipped_linkage("six-bar-path-and-poses.toml"), "starts = 8", "starts = 2"));
    EXPECT_EQ(found["status"], "solved");
    EXPECT_LT(found["objective"]["value"].get<double>(), 1e-6);
    EXPECT_NEAR(found["design"]["crank"].get<double>(), 40, 1e-5);
    EXPECT_NEAR(found["design"]["p-along"].get<double>(), 55, 1e-5);
    EXPECT_NEAR(found["design"]["plate.body-angle"].get<double>(), 90, 1e-5);
    expect_verified(found);
    int changes = 0;
    const auto refused = [&](const auto& change) {
        if (changes++ % cases_to_try(5, 1) != 0) return;
        Json changed = found;
        change(changed);
        EXPECT_TRUE(is_refused(changed));
    };
    const auto shifted = [](Json& number) { number = number.get<double>() + 1e-4; };
    refused([&](Json& json) { shifted(json["path"][0]["reached"][2][0]); });
    refused([&](Json& json) { shifted(json["poses"][0]["reached"][2][0]); });
    refused([&](Json& json) { shifted(json["poses"][0]["reached_directions"][1]); });
    refused([&](Json& json) { shifted(json["poses"][0]["distances"][4]); });
    refused([&](Json& json) { shifted(json["poses"][0]["crank_angles"][4]); });
    refused([&](Json& json) { shifted(json["design"]["plate.body-angle"]); });
    refused([&](Json& json) { shifted(json["quantities"]["plate.pose-rms"]); });
    refused([&](Json& json) { shifted(json["quantities"]["path-max"]); });
    refused([&](Json& json) { json["path"][0]["weight"] = 2; });
    refused([&](Json& json) { json["poses"][0]["weight"] = 0; });
    refused([&](Json& json) { json["path"][0]["name"] = "plate"; });
    refused([&](Json& json) { json["linkage"]["path"]["point"] = "T"; });
    refused([&](Json& json) { json["linkage"]["path"]["name"] = "other"; });
    refused([&](Json& json) { json["path"] = json["path"][0]; });
    refused([&](Json& json) { json.erase("poses"); });
    refused([&](Json& json) { json["path"][0]["crank_angles"].erase(1); });
    refused([&](Json& json) {  // as many entries as there are points in all
        json["path"][0]["distances"].push_back(0);
        json["poses"][0]["distances"].erase(0);
    });
    refused([&](Json& json) { json["poses"][0]["timing"] = "prescribed"; });
    refused([&](Json& json) { std::swap(json["poses"][0]["crank_angles"][0], json["poses"][0]["crank_angles"][1]); });
    // Of another design crank angles and distances are lists of all targets together.
    Json other{{"design", found["design"]}, {"objective", found["objective"]["value"]}};
    for (const char* kind : {"path", "poses"})
        for (const auto& [own, together] : {std::pair{"crank_angles", "path_angles"}, {"distances", "distances"}})
            for (const Json& number : found[kind][0][own])
                other[together].push_back(number);
    Json with_other = found;
    with_other["alternatives"] = Json::array({other});
    expect_verified(with_other);
    for (const std::size_t place : {std::size_t{1}, other["distances"].size() - 1}) {
        Json changed = with_other;
        shifted(changed["alternatives"][0]["distances"][place]);
        EXPECT_TRUE(is_refused(changed)) << place;
    }
}

namespace {

/// A path of a point at prescribed crank angles, after the links and before the points.
std::string timed_path(const std::string& name, const std::string& point, const std::string& crank_angles,
                       const std::string& start, const std::string& through) {
    return "[[path]]\nname = \"" + name + "\"\npoint = \"" + point +
           "\"\ntiming = \"prescribed\"\ncrank_angles = " + crank_angles + "\ncrank-start = " + start +
           "\npoints = " + through + "\n";
}

/// A double rocker, whose crank goes from 14.4 to 91.8 deg: points of its coupler and of its crank, in Python.
const std::string double_rocker =
    head + R"(
[dimensions]
crank = { min = 70, max = 90 }
along = { min = 10, max = 40 }
[links]
frame = { A = [0, 0], D = [100, 0] }
crank = { A = [0, 0], B = ["crank", 0], Q = [60, 30] }
coupler = { B = [0, 0], C = [50, 0], P = ["along", 40] }
rocker = { D = [0, 0], C = [80, 0] }
[drive]
link = "crank"
)" +
    timed_path("p", "P", "[0, 6.452439423, 12.904878847]", "{ min = 17, max = 37 }",
               "[[49.040721, 78.338477], [55.651539, 90.304997], [59.030235, 98.729135]]") +
    timed_path("q", "Q", "[0, 12.904878847, 19.35731827]", "{ min = 409, max = 429 }",
               "[[4.570035, 66.926189], [-10.492229, 66.25642], [-17.871557, 64.657617]]");

}  // namespace

/// Beside limits of the motion it is kept assembled from the first point of one target to the last of the other, which
/// is counted a whole turn on; and two targets are traded against each other.
TEST(SeveralTargets, ALimitedMotionCoversAll) {
    const Json found = solved(double_rocker + "[objective]\nminimize = \"path-rms\"\n[solver]\nstarts = 2\n");
    EXPECT_EQ(found["status"], "solved");
    EXPECT_LT(found["objective"]["value"].get<double>(), 1e-6);
    EXPECT_NEAR(found["design"]["crank"].get<double>(), 80, 1e-5);
    EXPECT_NEAR(found["design"]["q.crank-start"].get<double>(), 419.528588, 1e-5);
    expect_verified(found);
    const Json& checks = found["verification"]["checks"];
    EXPECT_TRUE(std::any_of(checks.begin(), checks.end(), [](const Json& check) {
        const std::string detail = check["detail"];
        return check["name"] == "stays assembled on one branch along the path" &&
               detail.starts_with("crank angles 27.26") && detail.find(" to 78.88") != std::string::npos;
    })) << checks;
}

/// Points of the coupler and of the crank's pin that no crank-rocker of the kind meets; in the long form of the double
/// rocker, too.
TEST(SeveralTargets, AreTradedAgainstEachOtherAndStudied) {
    const std::string turning =
        head + R"(
[dimensions]
crank = { min = 1.5, max = 2.5 }
along = { min = 1, max = 3 }
[links]
frame = { A = [0, 0], D = [7, 0] }
crank = { A = [0, 0], B = ["crank", 0] }
coupler = { B = [0, 0], C = [6, 0], P = ["along", 1.5] }
rocker = { D = [0, 0], C = [5, 0] }
[drive]
link = "crank"
)" + timed_path("p", "P", "[0, 30, 60]", "{ min = 10, max = 50 }", "[[3, 3], [2, 3.5], [1, 3.6]]") +
        timed_path("q", "B", "[0, 30, 60]", "{ min = 10, max = 50 }", "[[1.5, 0.7], [1.1, 1.4], [0.3, 1.6]]");
    for (const std::string& text : {turning, double_rocker}) {
        if (text == double_rocker && !in_long_form()) continue;
        const Json front = solved(text +
                                  "[[objective]]\nminimize = \"p.path-rms\"\n[[objective]]\nminimize = \"q.path-rms\"\n"
                                  "[solver]\nstarts = 1\npareto = 2\n");
        EXPECT_EQ(front["status"], "solved");
        ASSERT_GE(front["front"].size(), text == turning ? 2u : 1u);
        EXPECT_TRUE(front["front"][0]["path"].is_array());
        expect_verified(front);
    }
    const ReadProblem study = read_without_fault(double_rocker + "[study]\n\"path.2.weight\" = [1, 2]\n");
    EXPECT_TRUE(study.problem.study != nullptr);
}

/// What is read from a document is the problem that it was written from, with every part of it.
TEST(SeveralTargets, DocumentsHaveEveryPartBack) {
    for (const std::string& targets : {three_targets, timed(three_targets)}) {
        const Measured m(free_four_bar + targets);
        Result result;
        result.status = Status::solved;
        result.best = m.solution;
        const ReadClaim read = read_claim(document(m.read.problem, result));
        ASSERT_EQ(read.defect, "");
        const ClaimedDesign claimed = claimed_design(read.claim);
        const PathTarget &before = *m.read.problem.path, &after = *claimed.problem.path;
        ASSERT_EQ(after.parts.size(), 3u);
        EXPECT_EQ(after.weights, before.weights);
        EXPECT_EQ(after.part_of, before.part_of);
        for (std::size_t i = 0; i < 3; ++i) {
            EXPECT_EQ(after.parts[i].name, before.parts[i].name);
            EXPECT_EQ(after.parts[i].weight, before.parts[i].weight);
            EXPECT_EQ(after.parts[i].weights, before.parts[i].weights);
            EXPECT_EQ(after.parts[i].guides_body, before.parts[i].guides_body);
            EXPECT_EQ(after.parts[i].body_length, before.parts[i].body_length);
        }
        for (std::size_t i = 0; i < before.points.size(); ++i) {
            EXPECT_EQ(after.faces(i), before.faces(i));
            if (!before.faces(i)) continue;
            EXPECT_NEAR(after.directions[i], before.directions[i], 1e-15);
        }
        for (const char* name : {"path-rms", "path-max", "along.path-sse", "plate.pose-rms"})
            EXPECT_NEAR(*value_named(claimed.problem, claimed.design, name), m.value(name), 1e-12) << name;
    }
}

/// Points that count by the nearest of the curve of their own point: of a design that made them none is missed.
TEST(SeveralTargets, PointsOfNoOrderCountByTheCurvesOfTheirOwnPoints) {
    const Json found = solved(head + R"(
[dimensions]
crank = { min = 1.5, max = 2.5, start = 2.2 }
along = { min = 1, max = 3 }
[links]
frame = { A = [0, 0], D = [7, 0] }
crank = { A = [0, 0], B = ["crank", 0] }
coupler = { B = [0, 0], C = [6, 0], P = ["along", 1.5], Q = [1, -2] }
rocker = { D = [0, 0], C = [5, 0] }
[drive]
link = "crank"
[[path]]
name = "upper"
point = "P"
timing = "none"
points = [[2, 3], [3, 3.4], [1, 3]]
[[path]]
name = "lower"
point = "Q"
timing = "none"
points = [[0.5, -2], [2, -1]]
[objective]
minimize = "path-rms"
[solver]
starts = 2
)");
    EXPECT_EQ(found["status"], "solved");
    EXPECT_EQ(found["path"].size(), 2u);
    expect_verified(found);
    Json changed = found;
    std::swap(changed["linkage"]["path"][0]["point"], changed["linkage"]["path"][1]["point"]);
    EXPECT_TRUE(is_refused(changed));
}

}  // namespace mechwright::several_targets

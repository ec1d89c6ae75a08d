// Means and extremes of linkages where verification is hard: over motions that end at limits, at which speeds grow
// beyond all bounds, and beside the seam of a full turn.

#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "synthesis/document/document.h"
#include "synthesis/problem/reader.h"
#include "synthesis/program/assess.h"
#include "synthesis/solve/solve.h"
#include "tests/checked.h"
#include "tests/long_form.h"
#include "tests/replaced.h"

namespace mechwright {

namespace {

using Json = nlohmann::ordered_json;
using testing::expect_verified;
using testing::is_refused;

Json analysed_means(const std::string& text, const std::vector<std::string>& asked) {
    std::string all = text;
    for (const std::string& quantity : asked)
        all += "[[require]]\nquantity = \"" + quantity + "\"\nmin = -1e9\n";
    const ReadProblem read = parse_problem(all, "means.toml");
    EXPECT_TRUE(read.ok());
    return read.ok() ? analysis_document(read.problem, evaluate_given(read.problem)) : Json();
}

/// An isosceles slider-crank: its crank turns fully, and the slide's displacement is 2 cos(angle) exactly.
const std::string isosceles = R"(
schema = 1
mechanism = "linkage"
[links]
frame = { A = [0, 0] }
crank = { A = [0, 0], B = [1, 0] }
lever = { B = [0, 0], S = [1, 0], P = [-1, 0] }
ram   = { S = [0, 0] }
[[slide]]
name = "bed"
link = "ram"
on = "frame"
point = "A"
direction = 0
[drive]
link = "crank"
[motion]
crank_range = [-60, 75]
[signals]
way   = { slide = "bed" }
speed = { speed-of = "S" }
)";

TEST(LinkageMeans, AreThoseOfTheClosedForm) {
    const Json document =
        analysed_means(isosceles, {"way.mean", "way.rms", "speed.mean", "speed.rms", "way.speed.mean"});
    const Json& found = document["quantities"];
    constexpr double radian_per_degree = 3.14159265358979323846 / 180, from = -60 * radian_per_degree,
                     to = 75 * radian_per_degree, length = to - from;
    const auto expect = [&](const char* name, double value) {
        EXPECT_NEAR(found[name].get<double>(), value, 1e-12) << name;
    };
    const double squares = 2 * length + std::sin(2 * to) - std::sin(2 * from);  // of 2 cos, integrated
    expect("way.mean", 2 * (std::sin(to) - std::sin(from)) / length);
    expect("way.rms", std::sqrt(squares / length));
    expect("speed.mean", 2 * (2 - std::cos(to) - std::cos(from)) / length);
    expect("speed.rms", std::sqrt((4 * length - squares) / length));
    expect("way.speed.mean", 2 * (std::cos(to) - std::cos(from)) / length);
    expect_verified(document);
    Json changed = document;
    changed["quantities"]["speed.mean"] = found["speed.mean"].get<double>() * (1 + 1e-7);
    EXPECT_TRUE(is_refused(changed));
}

/// Where the slide turns back its speed, 2 |sin(angle)|, has a corner, and its derivatives jump from one side's to the
/// other's.
TEST(LinkageMeans, DerivativesOfSpeedsAreExtremeBesideRests) {
    const Json document =
        analysed_means(isosceles, {"speed.least", "speed.speed.greatest", "speed.speed.least",
                                   "speed.acceleration.greatest", "speed.jerk.greatest", "speed.jerk.least"});
    const auto expect = [&](const char* name, double value) {
        EXPECT_NEAR(document["quantities"][name].get<double>(), value, 1e-14) << name;
    };
    expect("speed.least", 0);
    expect("speed.speed.greatest", 2);
    expect("speed.speed.least", -2);
    expect("speed.acceleration.greatest", 0);
    expect("speed.jerk.greatest", 2);
    expect("speed.jerk.least", -2);
    expect_verified(document);
}

/// A crank-rocker whose rocker's pin comes to rest twice in a turn. At the dead centre at 33.557 degrees its speed has
/// the second derivative 405/616 after it: by the loop equation derived three times.
TEST(LinkageMeans, DerivativesOfARockersSpeedAreExtremeBesideItsDeadCentre) {
    const Json document = analysed_means(R"(
schema = 1
mechanism = "linkage"
[links]
frame   = { A = [0, 0], D = [4, 0] }
crank   = { A = [0, 0], B = [1, 0] }
coupler = { B = [0, 0], C = [3.5, 0] }
rocker  = { D = [0, 0], C = [2.5, 0] }
[drive]
link = "crank"
[signals]
speed = { speed-of = "C" }
)",
                                         {"speed.acceleration.greatest"});
    EXPECT_NEAR(document["quantities"]["speed.acceleration.greatest"].get<double>(), 405.0 / 616, 1e-13);
    expect_verified(document);
}

/// A rocker that swings between two limits of its dyad.
const std::string rocking = R"(
schema = 1
mechanism = "linkage"
[links]
frame   = { A = [0, 0], D = [5, -0.1] }
crank   = { A = [0, 0], B = [3.5, 0] }
coupler = { B = [0, 0], C = [2.8, 0], P = [-1.7, -0.5] }
rocker  = { D = [0, 0], C = [2.9, 0] }
[drive]
link = "crank"
[signals]
swing = { angle = "rocker" }
speed = { speed-of = "P" }
place = { x = "P" }
)";

TEST(LinkageMeans, AreVerifiedOverMotionsThatEndAtLimits) {
    const Json document =
        analysed_means(rocking, {"swing.mean", "swing.rms", "speed.mean", "place.mean", "speed.least"});
    for (const char* name : {"swing.mean", "swing.rms", "speed.mean", "place.mean", "speed.least"})
        EXPECT_TRUE(document["quantities"][name].is_number()) << name;
    // The way of P by the closed form of a four-bar in thirty digits, over the crank's range (mpmath, Gauss-Legendre).
    EXPECT_NEAR(document["quantities"]["speed.mean"].get<double>(), 5.12689026530519752, 1e-9);
    expect_verified(document);
}

/// A speed grows like the inverse root of the way from a limit: its square has no integral.
TEST(LinkageMeans, OfSquaresOfSpeedsAreNotThereWhereMotionsEndAtLimits) {
    for (const char* quantity : {"swing.speed.rms", "speed.rms"}) {
        // Except in the long form without the signal that is not asked for.
        const std::string signals =
            in_long_form() ? rocking : testing::replaced(rocking, "place = { x = \"P\" }\n", "");
        const ReadProblem read =
            parse_problem(signals + "[[require]]\nquantity = \"" + quantity + "\"\nmin = 0\n", "means.toml");
        ASSERT_TRUE(read.ok());
        const Json found = document(read.problem, solve(read.problem, {}));
        EXPECT_EQ(found["status"], "infeasible");
        EXPECT_FALSE(found["quantities"].contains(quantity));
        expect_verified(found);
        if (!in_long_form()) break;
    }
}

/// Its point nearly comes to rest 0.134 degrees before the end of the turn (brute force over 720 000 crank angles:
/// 0.04938717 at 359.866 degrees).
TEST(LinkageMeans, AnExtremeBesideTheSeamOfATurnIsVerified) {
    const Json document = analysed_means(R"(
schema = 1
mechanism = "linkage"
[links]
frame   = { A = [0, 0], D = [4.5, -0.36] }
crank   = { A = [0, 0], B = [0.5, 0] }
coupler = { B = [0, 0], C = [3.541, 0], P = [3.13, 2.285] }
rocker  = { D = [0, 0], C = [1.885, 0] }
[drive]
link = "crank"
[assembly]
C = "right"
[signals]
speed = { speed-of = "P" }
)",
                                         {});
    EXPECT_NEAR(document["quantities"]["speed.least"].get<double>(), 0.04938717, 1e-7);
    expect_verified(document);
}

/// A crank of 30 that turns about the origin, with what is measured of its pin B.
std::string turning_crank(const std::string& frame, const std::string& signals) {
    return "schema = 1\nmechanism = \"linkage\"\n[links]\nframe = { A = [0, 0]" + frame +
           " }\ncrank = { A = [0, 0], B = [30, 0] }\n[drive]\nlink = \"crank\"\n" + signals;
}

void expect_near(const Json& document, const std::vector<std::pair<std::string, double>>& known) {
    for (const auto& [name, value] : known) {
        ASSERT_TRUE(document["quantities"].contains(name)) << name;
        EXPECT_NEAR(document["quantities"][name].get<double>(), value, 1e-9) << name;
    }
}

/// The distance of B from where it is at a crank angle a, 60 |sin((angle - a) / 2)|, vanishes there: its slope jumps
/// from -30 to 30, wherever in the motion that is.
TEST(LinkageMeans, DerivativesOfDistancesAreExtremeBesideWhereTheyVanish) {
    const std::string distance = "[signals]\nd = { distance = [\"B\", \"F\"] }\n";
    const std::vector<std::string> asked{"d.speed.greatest", "d.speed.least", "d.acceleration.greatest",
                                         "d.acceleration.least", "d.speed.mean"};
    const std::vector<std::pair<std::string, double>> whole{{"d.speed.greatest", 30},
                                                            {"d.speed.least", -30},
                                                            {"d.acceleration.greatest", 0},
                                                            {"d.acceleration.least", -15}};
    for (const char* place : {", F = [30, 0]", ", F = [0, 30]", ", F = [18, -24]"}) {
        const Json document = analysed_means(turning_crank(place, distance), asked);
        expect_near(document, whole);
        expect_verified(document);
    }
    // At such a place itself the slope has two values, and none is stated.
    const Json at = analysed_means(turning_crank(", F = [0, 30]", distance), {"d.speed.at(90)", "d.speed.at(60)"});
    EXPECT_FALSE(at["quantities"].contains("d.speed.at(90)"));
    expect_near(at, {{"d.speed.at(60)", -30 * std::cos(15 * std::numbers::pi / 180)}});
    testing::count_of_stated(at);
    const Json half = analysed_means(turning_crank(", F = [30, 0]", "[motion]\ncrank_range = [0, 180]\n" + distance),
                                     {"d.speed.greatest", "d.speed.least", "d.speed.mean"});
    expect_near(half, {{"d.speed.greatest", 30}, {"d.speed.least", 0}, {"d.speed.mean", 60 / std::numbers::pi}});
    expect_verified(half);
    const Json back = analysed_means(turning_crank(", F = [-30, 0]", "[motion]\ncrank_range = [0, 180]\n" + distance),
                                     {"d.speed.greatest", "d.speed.least"});
    expect_near(back, {{"d.speed.greatest", 0}, {"d.speed.least", -30}});
    expect_verified(back);
}

/// Two gears: P comes back to the origin once a turn, at its start, and is 80 |sin(angle / 2)| from there.
TEST(LinkageMeans, ADistanceThatVanishesAtTheSeamOfAGearedTurnIsSteepThere) {
    const Json document = analysed_means(R"(
schema = 1
mechanism = "linkage"
[links]
frame = { O = [0, 0] }
arm   = { O = [0, 0], Q = [40, 0] }
pl    = { Q = [0, 0], P = [-40, 0] }
[[drive]]
link = "arm"
[[drive]]
link = "pl"
ratio = 2
[signals]
d = { distance = ["P", "O"] }
)",
                                         {"d.speed.greatest", "d.speed.least", "d.acceleration.greatest"});
    expect_near(document, {{"d.speed.greatest", 40}, {"d.speed.least", -40}, {"d.acceleration.greatest", 0}});
    expect_verified(document);
}

/// The tangent of the crank angle passes infinity where x passes zero: over a turn it has no extremes, over a stretch
/// without a quarter turn it has.
TEST(LinkageMeans, ARatioHasNoExtremesWhereItsDivisorVanishes) {
    const std::string signals = R"([signals]
x = { x = "B" }
y = { y = "B" }
t = { ratio = ["y", "x"] }
s = { sum = { t = 2 } }
)";
    const Json document = analysed_means(
        turning_crank("", signals),
        {"t.greatest", "t.least", "t.range", "t.mean", "t.rms", "t.speed.greatest", "s.greatest", "t.at(90)",
         "t.greatest(100, 280)", "t.greatest(90, 180)", "t.at(45)", "t.greatest(-45, 45)", "t.speed.least(100, 260)"});
    for (const Json& one : document["requirements"]) {
        const std::string name = one["quantity"];
        const bool has = name == "t.at(45)" || name == "t.greatest(-45, 45)" || name == "t.speed.least(100, 260)";
        EXPECT_EQ(one.contains("value"), has) << name;
    }
    expect_near(document, {{"t.at(45)", 1}, {"t.greatest(-45, 45)", 1}, {"t.speed.least(100, 260)", 1}});
    EXPECT_TRUE(is_refused(document));  // what has no value meets no requirement
    testing::count_of_stated(document);
    for (const std::size_t i : {0, 7, 9}) {  // over the turn, at an input, over a stretch
        Json stated = document;
        stated["requirements"][i]["value"] = 0.0;
        stated["requirements"][i]["violation"] = 0.0;
        const auto checks = verify(stated);
        EXPECT_TRUE(std::any_of(checks.begin(), checks.end(), [&](const Check& check) {
            return !check.passed &&
                   check.name == document["requirements"][i]["quantity"].get<std::string>() + " is as stated";
        })) << document["requirements"][i];
    }
}

TEST(LinkageMeans, NoDesignMeetsWhatARatioThatPassesInfinityIsRequiredToBe) {
    const ReadProblem read = parse_problem(R"(
schema = 1
mechanism = "linkage"
[dimensions]
r = { min = 20, max = 60 }
[links]
frame = { O = [0, 0] }
arm   = { O = [0, 0], Q = ["r", 0] }
[drive]
link = "arm"
[signals]
x = { x = "Q" }
y = { y = "Q" }
t = { ratio = ["y", "x"] }
[[require]]
quantity = "t.greatest"
max = 2
[objective]
maximize = "x.range"
[solver]
starts = 1
)",
                                           "tangent.toml");
    ASSERT_TRUE(read.ok());
    const Result result = solve(read.problem, {});
    EXPECT_NE(result.status, Status::solved);
    EXPECT_TRUE(!result.best || !result.best->feasible);
}

std::string folding(const std::string& links, const std::string& signals) {
    return "schema = 1\nmechanism = \"linkage\"\n[links]\n" + links + "[drive]\nlink = \"crank\"\n[signals]\n" +
           signals;
}

void expect_stated(const Json& document, const std::vector<std::string>& with,
                   const std::vector<std::string>& without) {
    for (const std::string& name : with)
        EXPECT_TRUE(document["quantities"].contains(name)) << name;
    for (const std::string& name : without)
        EXPECT_FALSE(document["quantities"].contains(name)) << name;
    ASSERT_TRUE(document.contains("warnings"));
    EXPECT_NEAR(document["warnings"][0]["margin"].get<double>(), 0, 1e-6);
}

/// The slot goes through the lever's own pivot, where the pin comes to: there the lever may stand anywhere, and on its
/// side it jumps by half a turn.
TEST(LinkageMeans, WhatJumpsAtASingularPositionIsNotStated) {
    const std::string slot = folding(
        "frame = { O = [0, 0], Q = [0, -40] }\ncrank = { O = [0, 0], B = [40, 0] }\n"
        "lever = { Q = [0, 0], T = [180, 0] }\n[[slot]]\npin = \"B\"\nin = \"lever\"\n"
        "along = [\"Q\", \"T\"]\n",
        "l = { angle = \"lever\" }\ntx = { x = \"T\" }\nb = { x = \"B\" }\n");
    const Json document = analysed_means(slot, {"b.speed.greatest", "tx.range(0, 180)"});
    expect_stated(document, {"b.range", "b.speed.greatest", "tx.range(0, 180)"},
                  {"l.least", "l.range", "tx.least", "tx.greatest", "tx.range"});
    EXPECT_NEAR(document["quantities"]["b.speed.greatest"].get<double>(), 40, 1e-12);
}

/// At a change point links fold onto each other and go on with another speed: a kite at both half turns, a slider
/// with a rod as long as its crank at both quarter turns.
TEST(LinkageMeans, SpeedsThatJumpAtAChangePointAreNotStated) {
    const std::string kite = folding(
        "frame = { A = [0, 0], D = [100, 0] }\ncrank = { A = [0, 0], B = [40, 0] }\n"
        "coupler = { B = [0, 0], C = [40, 0] }\nrocker = { D = [0, 0], C = [100, 0] }\n",
        "r = { angle = \"rocker\" }\nb = { y = \"B\" }\n");
    const Json of_kite = analysed_means(kite, {"r.speed.greatest", "r.speed.least", "r.acceleration.greatest",
                                               "r.speed.greatest(20, 160)", "b.speed.greatest"});
    expect_stated(of_kite, {"r.least", "r.range", "r.speed.greatest(20, 160)", "b.speed.greatest"},
                  {"r.speed.greatest", "r.speed.least", "r.acceleration.greatest"});
    const std::string slider = folding(
        "frame = { A = [0, 0] }\ncrank = { A = [0, 0], B = [50, 0] }\nrod = { B = [0, 0], C = [50, 0] }\n"
        "block = { C = [0, 0] }\n[[slide]]\nname = \"block\"\nlink = \"block\"\non = \"frame\"\n"
        "point = \"A\"\ndirection = 0\n",
        "s = { slide = \"block\" }\n");
    const Json of_slider = analysed_means(slider, {"s.speed.greatest", "s.speed.least", "s.speed.greatest(-80, 80)"});
    expect_stated(of_slider, {"s.greatest", "s.speed.greatest(-80, 80)"}, {"s.speed.greatest", "s.speed.least"});
    EXPECT_NEAR(of_slider["quantities"]["s.speed.greatest(-80, 80)"].get<double>(),
                100 * std::sin(80 * std::numbers::pi / 180), 1e-9);
}

}  // namespace

}  // namespace mechwright

// Proofs with certificates: what is proven verifies from the document alone, and does not where it was tampered with.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>

#include "synthesis/verify/proofs/proof_checks.h"
#include "synthesis/verify/verify.h"
#include "tests/known_optima/solved.h"
#include "tests/replaced.h"

namespace mechwright {
namespace {

using testing::replaced;
using Json = nlohmann::ordered_json;
using testing::shipped;
using testing::Solved;
using testing::solved;

std::string require(const char* quantity, const char* key, double value) {
    return fmt::format("[[require]]\nquantity = \"{}\"\n{} = {}\n", quantity, key, value);
}

std::string four_bar(const std::string& rest) {
    return "schema = 1\nmechanism = \"four-bar\"\n[dimensions]\nground = 100\ncrank = { min = 5, max = 90 }\n"
           "coupler = { min = 20, max = 300 }\nrocker = { min = 20, max = 200 }\n[solver]\nstarts = 4\n" +
           rest;
}

std::string slider_crank(const std::string& rest) {
    return "schema = 1\nmechanism = \"slider-crank\"\n[dimensions]\ncrank = { min = 5, max = 200 }\n"
           "rod = { min = 20, max = 100 }\noffset = { min = -100, max = 100 }\n[solver]\nstarts = 4\n" +
           rest;
}

const std::string short_linkage = "[objective]\nminimize = \"total-length\"\n";

/// A flat face whose cam is limited to a base radius.
std::string flat_cam(double greatest) {
    return fmt::format(R"(schema = 1
mechanism = "cam"
[cam]
follower = "flat"
[[segment]]
kind = "rise"
angle = 90
lift = 20
law = ["cycloidal", "harmonic"]
[[segment]]
kind = "return"
angle = 90
lift = 20
law = "cycloidal"
[[segment]]
kind = "dwell"
angle = 180
[dimensions]
base-radius = {{ min = 1, max = {} }}
[[require]]
quantity = "profile-radius-min"
min = 5
[objective]
minimize = "base-radius"
)",
                       greatest);
}

void expect_verified(const Solved& s, const std::string& text) {
    const auto checks = verify(document(s.problem, s.result));
    EXPECT_FALSE(checks.empty());
    for (const Check& check : checks)
        EXPECT_TRUE(check.passed) << check.name << ": " << check.detail << "\n" << text;
}

std::vector<std::string> infeasible_problems() {
    return {
        four_bar(require("swing", "equal", 200) + short_linkage),
        four_bar(require("swing", "equal", 110) + require("transmission-angle-worst", "min", 45) + short_linkage),
        four_bar(require("swing", "equal", 30) + require("time-ratio", "equal", 4) + short_linkage),
        four_bar(require("swing", "equal", 60) + require("time-ratio", "equal", 1.3) +
                 require("transmission-angle-worst", "min", 40) +
                 "[objective]\nmaximize = \"transmission-angle-worst\"\n"),
        four_bar(require("transmission-angle-worst", "min", 100) + short_linkage),
        slider_crank(require("time-ratio", "min", 3.2) + short_linkage),
        slider_crank(require("stroke", "min", 150) + require("transmission-angle-worst", "min", 60) + short_linkage),
        slider_crank(require("time-ratio", "equal", 1.5) + require("transmission-angle-worst", "min", 60) +
                     short_linkage),
        flat_cam(10),
        shipped("not-possible.toml", "cam")};
}

TEST(Certificates, OfProblemsWithoutADesignVerify) {
    for (const std::string& text : infeasible_problems()) {
        const Solved s = solved(text);
        EXPECT_EQ(s.result.status, Status::infeasible) << text;
        EXPECT_TRUE(s.result.search.complete()) << text;
        EXPECT_NE(s.result.note.find("proved"), std::string::npos) << s.result.note;
        expect_verified(s, text);
    }
}

// The same without the quantity that makes it impossible: solved, or at least not said to be impossible.
TEST(Certificates, NothingIsProvenOfProblemsWithADesign) {
    for (const std::string& text :
         {four_bar(require("swing", "equal", 110) + require("transmission-angle-worst", "min", 30) + short_linkage),
          slider_crank(require("stroke", "min", 90) + require("transmission-angle-worst", "min", 60) + short_linkage),
          flat_cam(100)}) {
        const Solved s = solved(text);
        EXPECT_EQ(s.result.status, Status::solved) << text;
        expect_verified(s, text);
    }
}

TEST(Certificates, RangesThatHoldNoLinkageAreSaidToHoldNone) {
    const std::string text = R"(schema = 1
mechanism = "four-bar"
[dimensions]
ground = { min = 1, max = 10 }
crank = 1e12
coupler = { min = 1, max = 10 }
rocker = { of = "coupler" }
point-along = { of = "coupler", times = 2 }
[line]
start = 90
range = 180
full_turn = true
[objective]
minimize = "line-deviation"
)";
    const Solved s = solved(text);
    EXPECT_EQ(s.result.status, Status::infeasible);
    EXPECT_TRUE(s.result.search.complete());
    expect_verified(s, text);
}

void expect_refused(const Json& document, const char* what) {
    const auto checks = check_proof(document);
    EXPECT_FALSE(all_passed(checks)) << what;
}

TEST(Certificates, ThatWereTamperedWithDoNotHold) {
    const Solved cam = solved(shipped("roller-offset.toml", "cam"));
    ASSERT_TRUE(cam.result.search.complete());
    const Json good = document(cam.problem, cam.result);
    ASSERT_TRUE(all_passed(check_proof(good)));
    Json bad = good;
    bad["search"].erase("certificate");
    expect_refused(bad, "no certificate");
    bad = good;
    bad["search"]["complete"] = false;
    expect_refused(bad, "not complete");
    for (const char* kind : {"zero", "count", "bound", "given", "ranges", "curvature", "limit", "other"}) {
        bad = good;
        bad["search"]["certificate"]["kind"] = kind;
        expect_refused(bad, kind);
    }
    const auto rows = [](Json& json) -> Json& { return json["search"]["certificate"]["parts"][0]["half_planes"]; };
    for (const auto& [key, value] : {std::pair{"weight", -1.0},
                                     {"weight", 1e6},
                                     {"side", -rows(bad = good)[0].value("side", 1.0)},
                                     {"at", 0.9},
                                     {"limit", 5.0},
                                     {"segment", 9.0},
                                     {"piece", 7.0}}) {
        bad = good;
        rows(bad)[0][key] = value;
        expect_refused(bad, key);
    }
    bad = good;
    bad["search"]["certificate"]["parts"] = Json::array();
    expect_refused(bad, "parts");
    bad = good;
    bad["status"] = "infeasible";
    expect_refused(bad, "status");
    bad = good;
    bad["design"]["prime-radius"] = 2 * good["design"]["prime-radius"].get<double>();
    expect_refused(bad, "design");

    const Solved wiper = solved(
        four_bar(require("swing", "equal", 110) + require("transmission-angle-worst", "min", 45) + short_linkage));
    const Json none = document(wiper.problem, wiper.result);
    ASSERT_TRUE(all_passed(check_proof(none)));
    for (const double value : {20.0, 50.0}) {
        bad = none;
        bad["search"]["certificate"]["value"] = value;
        expect_refused(bad, "value");
    }
    bad = none;
    bad["search"]["certificate"]["limit"] = "stroke";
    expect_refused(bad, "limit");
    bad = none;
    bad["requirements"][1]["min"] = 34;
    expect_refused(bad, "requirement");
    bad = none;
    bad["status"] = "solved";
    expect_refused(bad, "status");
}

// The least size that would do, which the argument names, is that of the certificate.
TEST(Certificates, ArgumentsNameTheLeastSizeThatTheyShow) {
    for (const std::string& text : {flat_cam(10), shipped("not-possible.toml", "cam")}) {
        const Solved s = solved(text);
        const Json good = document(s.problem, s.result);
        ASSERT_TRUE(all_passed(check_proof(good))) << text;
        const auto argument = good["search"]["argument"].get<std::string>();
        const std::size_t at = argument.find("; the least ");
        ASSERT_NE(at, std::string::npos) << argument;
        const std::size_t number = argument.find(" is ", at) + 4;
        const double least = std::stod(argument.substr(number));
        for (const double other : {0.99, 1.01, 10.0}) {
            Json bad = good;
            bad["search"]["argument"] = argument.substr(0, number) + std::to_string(other * least);
            expect_refused(bad, "argument");
        }
    }
}

// A linkage that does not turn fully moves over the range in which it assembles: 95, 151 and 60 meet the requirement.
const std::string triple_rockers = R"(schema = 1
mechanism = "four-bar"
[dimensions]
ground = 100
crank = { min = 95, max = 96 }
coupler = { min = 150, max = 151 }
rocker = { min = 59, max = 60 }
[[require]]
quantity = "grashof-margin"
max = -16
[objective]
minimize = "link-ratio"
[solver]
starts = 4
)";

TEST(Certificates, RangesWithoutAFullTurnAreNotEmpty) {
    const Solved s = solved(triple_rockers);
    EXPECT_FALSE(s.result.search.complete()) << s.result.note;
    Json bad = document(s.problem, s.result);
    bad["status"] = "infeasible";
    bad["search"]["complete"] = true;
    bad["search"]["certificate"] = {{"kind", "ranges"}};
    expect_refused(bad, "ranges");
    // With a quantity that only full turns have nothing is left.
    bad["requirements"] = Json::array({{{"quantity", "time-ratio"}, {"min", 1.1}}});
    EXPECT_TRUE(all_passed(check_proof(bad)));
}

/// A mechanism whose ranges hold no motion, and why, as verification finds again from the document alone; and a number
/// with which they hold one.
struct Motionless {
    std::string dimensions;
    const char* why;
    const char* dimension;
    double enough;
};

TEST(Certificates, RangesWithoutAMotionAreFoundAgain) {
    for (const auto& [dimensions, why, dimension, enough] :
         {Motionless{
              "\"crank-shaper\"\n[dimensions]\ncentre-distance = { min = 20, max = 50 }\ncrank = { min = 10, max "
              "= 15 }\nlever = { min = 200, max = 220 }\nrod = { min = 50, max = 60 }\nram-distance = { min = "
              "100, max = 110 }\n",
              "the rod reaches the ram line from the upright lever", "rod", 150},
          Motionless{"\"whitworth\"\n[dimensions]\ncentre-distance = { min = 10, max = 20 }\ncrank = { min = 40, max = "
                     "50 }\narm = { min = 100, max = 120 }\nrod = { min = 50, max = 60 }\nslide-angle = 90\n",
                     "the arm turns past the rod", "rod", 150},
          Motionless{
              "\"drag-link\"\n[dimensions]\nground = { min = 10, max = 20 }\ncrank = { min = 40, max = 50 }\n"
              "coupler = { min = 40, max = 50 }\nfollower = { min = 40, max = 50 }\narm = { min = 100, max = 120 "
              "}\narm-angle = 0\nrod = { min = 50, max = 60 }\nslide-angle = 90\nslide-offset = 0\n",
              "the rod reaches the slide line from the pin where it is farthest away", "rod", 150},
          Motionless{"\"slider-crank\"\n[dimensions]\ncrank = { min = 40, max = 50 }\nrod = { min = 20, max = 30 }\n"
                     "offset = { min = 0, max = 5 }\n",
                     "the rod reaches the slide line from the pin where it is farthest away", "rod", 60}}) {
        const Solved s = solved("schema = 1\nmechanism = " + dimensions + "[objective]\nmaximize = \"time-ratio\"\n");
        EXPECT_EQ(s.result.status, Status::infeasible) << dimensions;
        ASSERT_TRUE(s.result.search.complete()) << dimensions;
        Json json = document(s.problem, s.result);
        // The design that is shown has no time ratio: it does not move far enough.
        EXPECT_TRUE(all_passed(verify(json))) << dimensions;
        const auto checks = check_proof(json);
        ASSERT_EQ(checks.size(), 1u);
        EXPECT_TRUE(checks[0].passed) << checks[0].detail;
        EXPECT_NE(checks[0].detail.find(why), std::string::npos) << checks[0].detail;
        json["dimensions"][dimension]["max"] = enough;
        expect_refused(json, dimension);
    }
}

/// No stroke is less than 0: that one of 0 cannot be is no proof, however small a length is next to the others.
TEST(Certificates, ALimitAtZeroExcludesNothingAtZero) {
    const Solved s = solved(slider_crank(require("stroke", "max", 0) + "[objective]\nminimize = \"link-ratio\"\n"));
    ASSERT_EQ(s.result.status, Status::infeasible);
    EXPECT_FALSE(s.result.search.complete());
    Json json = document(s.problem, s.result);
    json["search"]["complete"] = true;
    json["search"]["certificate"] = {
        {"kind", "limit"}, {"limit", "possible-values"}, {"quantity", "stroke"}, {"value", 0.0}};
    expect_refused(json, "0");
    json["requirements"][0]["max"] = -1e-3;
    EXPECT_TRUE(all_passed(check_proof(json)));
}

// The stated value lies below the exact limit by less than a coarse look at it would show.
TEST(Certificates, OfLimitsAreExact) {
    const std::string shaper =
        "schema = 1\nmechanism = \"crank-shaper\"\n[dimensions]\ncentre-distance = 300\n"
        "crank = { min = 20, max = 290 }\nlever = { min = 100, max = 900 }\n"
        "rod = { min = 100, max = 400 }\nram-distance = { min = 301, max = 500 }\n";
    const std::string best = "[objective]\nmaximize = \"transmission-angle-worst\"\n";
    const std::string ratio = require("time-ratio", "equal", 1.5);
    for (const std::string& text :
         {shaper + ratio + best, slider_crank(ratio + best),
          four_bar(require("swing", "equal", 60) + require("time-ratio", "equal", 1.2) + best)}) {
        const Solved s = solved(text);
        ASSERT_EQ(s.result.status, Status::solved);
        ASSERT_TRUE(s.result.search.complete()) << text;
        Json json = document(s.problem, s.result);
        ASSERT_TRUE(all_passed(check_proof(json))) << text << check_proof(json)[0].detail;
        Json& value = json["search"]["certificate"]["value"];
        ASSERT_TRUE(value.is_number());
        value = value.get<double>() - 1.2e-7;  // degrees, 2e-9 rad
        expect_refused(json, text.c_str());
    }
}

/// The document of a problem whose search is said to be complete by branch and bound.
Json said_to_be_bounded(const Solved& s) {
    Json json = document(s.problem, s.result);
    json["search"]["complete"] = true;
    json["search"]["certificate"] = {{"kind", "bound"}};
    json["search"]["bound"] = json["objective"]["value"].get<double>() * (1 - 1e-6);
    return json;
}

TEST(Certificates, OfBoundsThatOtherLinkagesUndercutDoNotHold) {
    const std::string power = shipped("power.toml", "function");
    EXPECT_TRUE(all_passed(check_proof(said_to_be_bounded(solved(power)))));
    const std::string coupler = "coupler  = { min = 0, max = 100 }";
    expect_refused(said_to_be_bounded(solved(replaced(power, coupler, "coupler = { min = 0, max = 14.5 }"))), "power");
    const std::string free = replaced(replaced(power, "start = 210", "start = { min = 180, max = 240 }"), coupler,
                                      "coupler = { min = 0, max = 12 }");
    expect_refused(said_to_be_bounded(solved(free)), "scales");
    const std::string timed = shipped("case-2.toml", "path");
    EXPECT_TRUE(all_passed(check_proof(said_to_be_bounded(solved(timed)))));
    const std::string links = "coupler      = { min = 0, max = 50 }";
    expect_refused(said_to_be_bounded(solved(replaced(timed, links, "coupler = { min = 0, max = 2 }"))), "path");
}

// Poses of a slider-crank of the ranges: a greatest distance of zero is the end of the search.
TEST(Certificates, ZeroOfWhatCannotBeNegativeEndsTheSearch) {
    const Solved s = solved(R"(schema = 1
mechanism = "slider-crank"
[poses]
poses=[[-4.505142428228116, -6.394951387925073, 68.81154742526309], [-3.4958780860062353, -3.5170617062447533, 67.28260620752809], [-3.9586581054057874, -0.40341157998903254, 62.497838940716875], [-5.875501155682532, 3.340752490006716, 53.837309789331876], [-8.616788865720515, 6.176294543061843, 44.156319121703916], [-10.432407188133077, 7.194686847796179, 38.53849108865869], [-12.466638740529351, 7.495588179470178, 33.112097000915995], [-15.607381115691446, 4.4871308113368675, 29.77905954821618]]
length=5.0
[dimensions]
crank = { min = 0.0, max = 60.0 }
rod = { min = 0.0, max = 60.0 }
offset = { min = -60.0, max = 60.0 }
point-along = { min = -60.0, max = 60.0 }
point-across = { min = -60.0, max = 60.0 }
origin-x = { min = -60.0, max = 60.0 }
origin-y = { min = -60.0, max = 60.0 }
tilt = { min = -180.0, max = 180.0 }
body-angle = { min = -180.0, max = 180.0 }
[objective]
minimize = "pose-max"
)");
    ASSERT_EQ(s.result.status, Status::solved);
    EXPECT_TRUE(s.result.search.complete());
    EXPECT_LT(s.result.best->objective, 1e-12);
    EXPECT_LT(s.result.search.starts, 40);
    expect_verified(s, "poses");
}

// The centre that comes closest to an oscillating cam's limits need not be a mechanism: then no design is shown, and
// the proof verifies without one.
TEST(Certificates, OfACamWhoseClosestCentreIsNoMechanismVerify) {
    const std::string text = R"(schema = 1
mechanism = "cam"
[cam]
follower = "roller"
motion = "oscillating"
[[segment]]
kind = "rise"
angle = 50.2275
lift = 29.3978
law = "cycloidal"
[[segment]]
kind = "return"
angle = 89.5963
lift = 29.3978
law = "harmonic"
[[segment]]
kind = "dwell"
angle = 220.1762
[dimensions]
prime-radius = { min = 5, max = 400 }
roller-radius = 1
pivot-distance = { min = 10, max = 400 }
arm-length = 93.6885
)" + require("pressure-angle-rise", "max", 15.3349) +
                             require("pressure-angle-return", "max", 46.9723) +
                             "[objective]\nminimize = \"pivot-distance\"\n";
    const Solved s = solved(text);
    EXPECT_EQ(s.result.status, Status::infeasible);
    EXPECT_TRUE(s.result.search.complete());
    expect_verified(s, text);
}

}  // namespace
}  // namespace mechwright

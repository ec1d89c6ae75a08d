// Cams measured twice: random cams of every follower, whose quantities must be the same by the analysis in double and
// by positions alone in fifty digits; and documents of cams, also spoilt ones.

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "synthesis/document/document.h"
#include "synthesis/mechanism/cam/cam.h"
#include "synthesis/mechanism/possible_values.h"
#include "synthesis/problem/reader.h"
#include "synthesis/program/quantity_value.h"
#include "synthesis/solve/solve.h"
#include "synthesis/verify/rebuilt.h"
#include "tests/degree.h"
#include "tests/long_form.h"
#include "tests/verify/documents.h"

namespace mechwright {

namespace {

using namespace test;

struct Random {
    std::mt19937_64 bits{7};
    double between(double low, double high) {
        return low + (high - low) * std::ldexp(static_cast<double>(bits() >> 11), -53);
    }
    template <class T, std::size_t N>
    const T& one_of(const std::array<T, N>& all) {
        return all[static_cast<std::size_t>(between(0, N)) % N];
    }
};

constexpr std::array laws{"parabolic",
                          "harmonic",
                          "double-harmonic",
                          "cycloidal",
                          "modified-trapezoid",
                          "modified-sine",
                          "modified-constant-velocity",
                          "3-4-5",
                          "4-5-6-7",
                          "kloomok-muffley"};

std::string random_cam(Random& random, const char* follower, bool oscillating) {
    const auto number = [](double x) { return std::to_string(x); };
    const double a = random.between(70, 120), b = random.between(10, 60), c = random.between(70, 120);
    const std::string lift = number(oscillating ? random.between(5, 15) : random.between(5, 20));
    const auto moving = [&](const char* kind, double angle) {
        const bool polynomial = random.between(0, 1) < 0.2, spline = !polynomial && random.between(0, 1) < 0.15;
        if (spline)
            return std::string("[[segment]]\nkind = \"") + kind + "\"\nangle = " + number(angle) + "\nlift = " + lift +
                   "\nlaw = \"spline\"\nshape = [" + number((kind[1] == 'i' ? 0.2 : 0.8) * std::stod(lift)) + ", " +
                   number((kind[1] == 'i' ? 0.8 : 0.2) * std::stod(lift)) + "]\n";
        return std::string("[[segment]]\nkind = \"") + kind + "\"\nangle = " + number(angle) + "\nlift = " + lift +
               "\nlaw = \"" + (polynomial ? "polynomial" : random.one_of(laws)) + "\"\n" +
               (polynomial ? "start = [0, 0]\nend = [0, 0, 0]\nshape = [" + number(random.between(-0.5, 0.5)) + "]\n"
                           : "");
    };
    const auto dwell = [&](double angle) { return "[[segment]]\nkind = \"dwell\"\nangle = " + number(angle) + "\n"; };
    std::string text =
        std::string("schema = 1\nmechanism = \"cam\"\n[cam]\nfollower = \"") + follower + "\"\nmotion = \"" +
        (oscillating ? "oscillating" : "translating") + "\"\nrotation = \"" +
        (random.between(0, 1) < 0.5 ? "cw" : "ccw") + "\"\n" + moving("rise", a) + dwell(b) + moving("return", c) +
        dwell(360 - std::stod(number(a)) - std::stod(number(b)) - std::stod(number(c))) + "[dimensions]\n";
    const bool flat = std::string(follower) == "flat";
    const double size = flat ? random.between(90, 150) : random.between(40, 80);
    text += std::string(flat ? "base-radius = " : "prime-radius = ") + number(size) + "\n";
    if (oscillating) text += "pivot-distance = " + number((flat ? 1.6 : 1.5) * size) + "\n";
    if (oscillating && flat) text += "face-offset = " + number(random.between(-5, 10)) + "\n";
    if (oscillating && !flat) text += "arm-length = " + number(1.2 * size) + "\n";
    if (!flat && !oscillating) text += "offset = " + number(random.between(-0.2, 0.2) * size) + "\n";
    if (std::string(follower) == "roller") text += "roller-radius = " + number(random.between(1, 6)) + "\n";
    if (!oscillating) {
        text +=
            "spring-rate = 8\nprecompression = 40\nweight = 7\nload = 20\nguide-length = 60\noverhang = "
            "30\nstem-diameter = "
            "12\n";
        text += "[units]\nmass = \"t\"\n[dynamics]\nmass = 0.001\nspeed = 300\nfriction = 0.1\n";
    }
    return text;
}

Problem problem_of(const std::string& text) {
    const ReadProblem read = parse_problem(text, "cam.toml");
    for (const Message& m : read.messages)
        ADD_FAILURE() << to_string(m) << "\n" << text;
    return read.problem;
}

}  // namespace

TEST(CamsAgain, RandomCamsMeasureTheSame) {
    Random random;
    const int rounds = cases_to_try(4, 12);
    int compared = 0;
    for (int round = 0; round < rounds; ++round)
        for (const char* follower : {"knife", "roller", "flat"})
            for (const bool oscillating : {false, true}) {
                const std::string text = random_cam(random, follower, oscillating);
                const Problem problem = problem_of(text);
                const Result result = solve(problem, {});
                const Json json = document(problem, result);
                ASSERT_TRUE(json.contains("quantities")) << text;
                compared += static_cast<int>(json["quantities"].size());
                for (const auto& [name, value] : json["quantities"].items())
                    EXPECT_GE(value.get<double>(), possible_values(name).least) << name << "\n" << text;
                for (const Check& check : result.verification)
                    EXPECT_TRUE(check.passed || check.name == "the cam is not undercut")
                        << check.name << ": " << check.detail << "\n"
                        << text;
            }
    EXPECT_GT(compared, rounds * 6 * 14);
}

/// A face that swings, on a cam that turns clockwise: with a pivot distance of 100 the base radius makes the start
/// angle.
std::string swinging_face(const std::string& dimensions, double lift, double rise) {
    const auto number = [](double x) { return std::to_string(x); };
    return "schema = 1\nmechanism = \"cam\"\n[cam]\nfollower = \"flat\"\nmotion = \"oscillating\"\nrotation = \"cw\"\n"
           "[[segment]]\nkind = \"rise\"\nangle = " +
           number(rise) + "\nlift = " + number(lift) +
           "\nlaw = \"cycloidal\"\n[[segment]]\nkind = \"dwell\"\nangle = 40\n[[segment]]\nkind = \"return\"\nangle = "
           "80\n"
           "lift = " +
           number(lift) + "\nlaw = \"3-4-5\"\n[[segment]]\nkind = \"dwell\"\nangle = " + number(240 - rise) +
           "\n[dimensions]\n" + dimensions;
}

std::string face_starting_at(double degrees) {
    return "base-radius = " + std::to_string(100 * std::sin(degrees * degree)) + "\npivot-distance = 100\n";
}

// Where start angle and lift together pass a right angle the contact passes over the pivot: all else of such a cam is
// sound.
TEST(CamsAgain, AFaceWhoseContactPassesItsPivotIsNotDriven) {
    for (const auto& [start, driven] : {std::pair{67.9, true}, {68.1, false}, {79.0, false}}) {
        const Problem problem = problem_of(swinging_face(face_starting_at(start), 22, 100));
        const Result result = solve(problem, {});
        EXPECT_EQ(result.status, driven ? Status::solved : Status::infeasible) << start;
        EXPECT_EQ(result.best->feasible, driven) << start;
        const Json json = document(problem, result);
        Json as_solved = json;
        as_solved["status"] = "solved";
        const std::string checks = told(verify(as_solved));
        EXPECT_EQ(failures(as_solved).empty(), driven) << checks;
        EXPECT_NE(checks.find("least lever of the contact about the pivot " + std::string(driven ? "" : "-")),
                  std::string::npos)
            << checks;
        EXPECT_TRUE(all_passed(verify(json))) << told(verify(json));
        EXPECT_EQ(json.contains("warnings"), !driven);
        if (driven) continue;
        const std::string warning = json["warnings"][0]["name"];
        EXPECT_EQ(
            warning.find("there is no such cam: at cam angle 100 deg the contact passes over the follower's pivot"), 0)
            << warning;
        EXPECT_EQ(json["warnings"][0]["impossible"], true);
        Json bad = json;
        bad["warnings"][0].erase("impossible");
        EXPECT_FALSE(all_passed(verify(bad)));
    }
}

// A rise of 60 deg in 40 turns the face faster than the cam turns, and the other way round: there is no envelope, and
// what is measured of the contact on both sides of infinity means nothing.
TEST(CamsAgain, AFaceThatTurnsWithTheCamHasNoContact) {
    for (const auto& [rise, touches] : {std::pair{160.0, true}, {40.0, false}}) {
        const Problem problem = problem_of(swinging_face(face_starting_at(25), 60, rise));
        const Result result = solve(problem, {});
        const Json json = document(problem, result);
        for (const char* name : {"pressure-angle-rise", "pressure-angle-return", "pressure-angle-max",
                                 "profile-radius-min", "undercut-margin", "face-length", "cam-size"})
            EXPECT_EQ(json["quantities"].contains(name), touches) << name;
        for (const char* name : {"base-radius", "start-angle", "velocity-max", "acceleration-max"})
            EXPECT_TRUE(json["quantities"].contains(name)) << name;
        EXPECT_TRUE(all_passed(verify(json))) << told(verify(json));
        if (touches) continue;
        const std::string warning = json["warnings"][0]["name"];
        EXPECT_EQ(
            warning,
            "there is no such cam: at cam angle 20 deg the face turns with the cam, not against it, and no cam can "
            "guide it; a greater angle or less lift of that segment would help");
        Json bad = json;
        bad["quantities"]["cam-size"] = 100;
        EXPECT_FALSE(all_passed(verify(bad)));
    }
}

TEST(CamsAgain, SearchesKeepTheContactOnOneSideOfThePivot) {
    const Problem problem = problem_of(
        swinging_face("base-radius = { min = 5, max = 100 }\npivot-distance = { min = 20, max = 150 }\n"
                      "face-offset = { min = -10, max = 10 }\n[[require]]\nquantity = \"profile-radius-min\"\nmin = 5\n"
                      "[objective]\nminimize = \"face-length\"\n[solver]\nstarts = 8\n",
                      22, 100));
    const Result result = solve(problem, {});
    ASSERT_EQ(result.status, Status::solved);
    EXPECT_TRUE(result.verified()) << told(result.verification);
    const auto start = quantity_value(
        problem, static_cast<std::size_t>(find_quantity(*problem.mechanism, "start-angle")), result.best->design);
    EXPECT_LT(*start / degree, 68);
}

TEST(CamDocument, IsSpoiltByAnotherLawRotationOrTable) {
    Random random;
    const Problem problem = problem_of(random_cam(random, "roller", true));
    const Json good = document(problem, solve(problem, {}));
    ASSERT_TRUE(failures(good).empty()) << told(verify(good));
    Json json = good;
    json["design"]["laws"][0] = json["design"]["laws"][0] == "harmonic" ? "cycloidal" : "harmonic";
    EXPECT_FALSE(failures(json).empty());
    json = good;
    json["design"]["rotation"] = json["design"]["rotation"] == "cw" ? "ccw" : "cw";
    EXPECT_FALSE(failures(json).empty());
    json = good;
    json["design"]["angle-1"] = json["design"]["angle-1"].get<double>() + 1;
    EXPECT_FALSE(failures(json).empty());
    for (const char* member : {"laws", "rotation"}) {
        json = good;
        json["design"].erase(member);
        EXPECT_NE(told(verify(json)).find(member), std::string::npos) << told(verify(json));
    }
    json = good;
    json.erase("cam");
    EXPECT_NE(told(verify(json)).find("cam"), std::string::npos);
}

TEST(CamDocument, NeverThrowsWhateverItsMembersAre) {
    Random random;
    const Problem problem = problem_of(random_cam(random, "flat", true));
    Json json = document(problem, solve(problem, {}));
    json["quantities"] = {{"base-radius", json["quantities"]["base-radius"]}};
    EXPECT_GT(verified_with_members_replaced(json), cases_to_try(90, 300));
    const Problem tabled = problem_of(
        "schema = 1\nmechanism = \"cam\"\n[cam]\nfollower = \"knife\"\n[dimensions]\nprime-radius = "
        "40\n[[segment]]\nkind = "
        "\"cycle\"\npoints = [[0, 0], [90, 5], [180, 9], [270, 4]]\n");
    json = document(tabled, solve(tabled, {}));
    EXPECT_TRUE(failures(json).empty()) << told(verify(json));
    json["quantities"] = {{"prime-radius", 40}};
    EXPECT_GT(verified_with_members_replaced(json), cases_to_try(30, 100));
}

}  // namespace mechwright

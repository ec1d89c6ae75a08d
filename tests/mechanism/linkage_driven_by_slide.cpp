// Targets of linkages that a slide drives, a cylinder between two links: a body that it tips, against the law of
// cosines, and the bucket of an excavator, against intersected circles.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>
#include <random>
#include <string>
#include <vector>

#include "synthesis/program/program.h"
#include "tests/checked.h"
#include "tests/known_optima/solved.h"
#include "tests/mechanism/linkage_texts.h"
#include "tests/replaced.h"

namespace mechwright {

namespace {

using Json = nlohmann::ordered_json;
using testing::expect_verified;
using testing::first_error;
using testing::is_refused;
using testing::Solved;

/// A body that a cylinder from A tips about D, 2000 apart; T is on the body, as B is.
std::string tipped(const std::string& dimensions, const std::string& targets, const std::string& drive = "") {
    return "schema = 1\nmechanism = \"linkage\"\n[dimensions]\n" + dimensions + R"(
[links]
frame  = { A = [0, 0], D = [2000, 0] }
body   = { D = [0, 0], B = ["-reach", 0], T = ["-arm", 0] }
barrel = { A = [0, 0] }
rod    = { B = [0, 0] }
[[slide]]
name = "length"
link = "rod"
on = "barrel"
point = "A"
direction = 0
[drive]
slide = "length"
)" + (drive.empty() ? "min = 1200\nmax = 2000\n" : drive) +
           R"([assembly]
B = { side = "left", from = "A", to = "D" }
[solver]
starts = 8
)" + targets;
}

constexpr double foot_of_cylinder = 2000;

/// The direction of the body from D by the law of cosines.
Vector<double> direction_of_body(double reach, double length) {
    const double at_d = std::acos((foot_of_cylinder * foot_of_cylinder + reach * reach - length * length) /
                                  (2 * foot_of_cylinder * reach));
    return {std::cos(std::numbers::pi - at_d), std::sin(std::numbers::pi - at_d)};
}

Vector<double> tipped_point(double reach, double arm, double length) {
    const Vector<double> along = direction_of_body(reach, length);
    return {foot_of_cylinder + arm * along.x, arm * along.y};
}

constexpr std::array<double, 4> tipping_lengths{1250, 1450, 1650, 1900};

std::string list_of(const std::vector<Vector<double>>& points) {
    std::string text;
    for (const Vector<double>& p : points)
        text += fmt::format("{}[{:.17g}, {:.17g}]", text.empty() ? "" : ", ", p.x, p.y);
    return "[" + text + "]";
}

std::vector<Vector<double>> tipped_points(double reach, double arm, double dead) {
    std::vector<Vector<double>> points;
    for (const double length : tipping_lengths)
        points.push_back(tipped_point(reach, arm, dead + length));
    return points;
}

/// The least mean square distance of the point from targets by a scan over the reach, the arm by least squares.
double least_by_scan(const std::vector<Vector<double>>& targets) {
    double least = 1e30;
    for (int i = 0; i <= 200000; ++i) {
        const double reach = 1100 + 500.0 * i / 200000;
        double along = 0, square = 0;
        for (std::size_t k = 0; k < targets.size(); ++k) {
            const Vector<double> away = targets[k] - Vector<double>{foot_of_cylinder, 0};
            along += dot(direction_of_body(reach, tipping_lengths[k]), away) / 4;
            square += dot(away, away) / 4;
        }
        least = std::min(least, square - along * along);
    }
    return std::sqrt(least);
}

const std::string free_body = "reach = { min = 1100, max = 1600 }\narm = { min = 1000, max = 2500 }\n";
const std::string timed_by_lengths =
    "[path]\npoint = \"T\"\ntiming = \"prescribed\"\ncrank_angles = [1250, 1450, 1650, 1900]\n";
const std::string least_rms = "[objective]\nminimize = \"path-rms\"\n";

Json document_of_slide(const Solved& s) { return document(s.problem, s.result); }

}  // namespace

TEST(DrivenBySlide, PrescribedDisplacementsAreMetAsWellAsCanBe) {
    std::vector<Vector<double>> targets = tipped_points(1300, 1800, 0);
    targets[1].x += 40;
    targets[2].y -= 30;
    const Solved s =
        testing::solved(tipped(free_body, timed_by_lengths + "points = " + list_of(targets) + "\n" + least_rms));
    ASSERT_EQ(s.result.status, Status::solved);
    EXPECT_NEAR(s.value("path-rms"), least_by_scan(targets), 1e-6);
    EXPECT_EQ(s.result.best->design.path_angles, (std::vector<double>{1250, 1450, 1650, 1900}));
    expect_verified(document_of_slide(s));
}

/// What a cylinder is long at no stroke is found with the rest, in whichever unit a file is written.
TEST(DrivenBySlide, TheDeadLengthIsADimension) {
    std::string text =
        tipped(free_body, "[path]\npoint = \"T\"\ntiming = \"prescribed\"\ncrank-start = { min = -100, max = 100 }\n" +
                              std::string("crank_angles = [1250, 1450, 1650, 1900]\npoints = ") +
                              list_of(tipped_points(1300, 1800, 37)) + "\n" + least_rms);
    const Solved s = testing::solved(text);
    ASSERT_EQ(s.result.status, Status::solved);
    EXPECT_LT(s.value("path-rms"), 1e-6);
    EXPECT_NEAR(s.dimension("reach"), 1300, 1e-5);
    EXPECT_NEAR(s.dimension("arm"), 1800, 1e-5);
    EXPECT_NEAR(s.dimension("crank-start"), 37, 1e-5);
    const Json document = document_of_slide(s);
    expect_verified(document);
    for (const char* changed :
         {"/path/crank_angles/1", "/path/prescribed_angles/2", "/design/crank-start", "/path/reached/0/0"}) {
        Json other = document;
        auto& number = other[Json::json_pointer(changed)];
        number = number.get<double>() + 0.01;
        EXPECT_TRUE(is_refused(other)) << changed;
    }
    // Beyond a stop that is not the file's: nothing is met there.
    Json stopped = document;
    ASSERT_TRUE(stopped.dump().find("1200") != std::string::npos);
    std::string beyond = stopped.dump();
    beyond.replace(beyond.find("\"min\":1200"), 10, "\"min\":1300");
    EXPECT_TRUE(is_refused(Json::parse(beyond)));
}

/// At any displacements the distances are those from a circle about D: the best radius is the mean distance.
TEST(DrivenBySlide, FreePlacesAreOnTheStroke) {
    std::vector<Vector<double>> targets = tipped_points(1300, 1800, 0);
    targets[1].x += 40;
    targets[2].y -= 30;
    double mean = 0, square = 0;
    for (const Vector<double>& target : targets) {
        const double away = std::hypot(target.x - foot_of_cylinder, target.y);
        mean += away / 4;
        square += away * away / 4;
    }
    const std::string arm_alone = "reach = 1300\narm = { min = 1000, max = 2500 }\n";
    for (const char* timing : {"free", "none"}) {
        const Solved s =
            testing::solved(tipped(arm_alone, fmt::format("[path]\npoint = \"T\"\ntiming = \"{}\"\npoints = ", timing) +
                                                  list_of(targets) + "\n" + least_rms),
                            "auto", 1, 2, 1);
        ASSERT_EQ(s.result.status, Status::solved) << timing;
        EXPECT_NEAR(s.value("path-rms"), std::sqrt(square - mean * mean), 1e-6) << timing;
        EXPECT_NEAR(s.dimension("arm"), mean, 1e-4) << timing;
        for (const double at : s.result.best->design.path_angles)
            EXPECT_TRUE(at >= 1200 && at <= 2000) << at;
        const Json document = document_of_slide(s);
        expect_verified(document);
        Json other = document;
        auto& number = other["path"]["crank_angles"][1];
        number = number.get<double>() + 5;
        EXPECT_TRUE(is_refused(other)) << timing;
    }
    // What lies beyond the stroke counts by an end of it, exactly: the first and the last.
    const std::vector<Vector<double>> wide{{450, 900}, {700, 1250}, {1000, 1480}, {1500, 1700}};
    const auto along = [&](std::size_t i) { return wide[i] - Vector<double>{foot_of_cylinder, 0}; };
    const double arm = (dot(direction_of_body(1300, 1200), along(0)) + dot(direction_of_body(1300, 2000), along(3)) +
                        std::hypot(along(1).x, along(1).y) + std::hypot(along(2).x, along(2).y)) /
                       4;
    const Solved s = testing::solved(
        tipped(arm_alone, "[path]\npoint = \"T\"\npoints = " + list_of(wide) + "\n" + least_rms), "auto", 1, 2, 1);
    ASSERT_EQ(s.result.status, Status::solved);
    EXPECT_NEAR(s.dimension("arm"), arm, 1e-4);
    EXPECT_EQ(s.result.best->design.path_angles.front(), 1200);
    EXPECT_EQ(s.result.best->design.path_angles.back(), 2000);
    expect_verified(document_of_slide(s));
}

/// Derivatives of all rows and of the objective, by displacements, too, against differences.
TEST(DrivenBySlide, SlopesOfProgramsAreThoseOfDifferences) {
    const std::string points = "points = " + list_of(tipped_points(1300, 1800, 0)) + "\n";
    const std::string signal =
        "[signals]\nheight = { y = \"T\" }\n[[require]]\nquantity = \"height.mean\"\nmin = 100\n";
    for (const std::string& target :
         {"[motion]\nfrom = \"first-target\"\nto = \"last-target\"\nbefore = 10\nafter = 20\n" + signal +
              "[path]\npoint = \"T\"\n" + points + least_rms,
          timed_by_lengths + "crank-start = { min = -100, max = 100 }\n" + points + least_rms,
          "[arc]\npoint = \"T\"\nstart = { min = 1250, max = 1300 }\nrange = { min = 500, max = 600 }\n" +
              std::string("[objective]\nminimize = \"arc-deviation\"\n"),
          "[signals]\ntip = { angle = \"body\" }\n[function]\nsignal = \"tip\"\nexpression = \"x^2\"\nx = [1, 2]\n" +
              std::string("input = { start = { min = 1250, max = 1300 }, range = 500 }\n"
                          "output = { start = { min = -60, max = 0 }, range = 30 }\n"
                          "[objective]\nminimize = \"function-rms\"\n")}) {
        const ReadProblem read = testing::read_without_fault(tipped(free_body, target));
        ASSERT_TRUE(read.ok());
        const Program program = build_program(read.problem, variants(read.problem).front());
        Eigen::VectorXd x(static_cast<Eigen::Index>(program.size()));
        for (Eigen::Index i = 0; i < x.size(); ++i) {
            const Variable& v = program.variables[static_cast<std::size_t>(i)];
            const double low = std::isfinite(v.lower) ? v.lower : 0, high = std::isfinite(v.upper) ? v.upper : 1;
            x[i] = low + (high - low) * (0.3 + 0.4 * static_cast<double>(i) / static_cast<double>(x.size()));
        }
        ProgramValues values, above, below;
        evaluate(program, x, true, values);
        ASSERT_TRUE(values.assembled) << target;
        for (Eigen::Index i = 0; i < x.size(); ++i) {
            constexpr double h = 1e-6;
            Eigen::VectorXd other = x;
            other[i] += h;
            evaluate(program, other, false, above);
            other[i] -= 2 * h;
            evaluate(program, other, false, below);
            EXPECT_NEAR(values.gradient[i], (above.objective - below.objective) / (2 * h), 1e-6)
                << target << program.variables[static_cast<std::size_t>(i)].name;
            for (Eigen::Index r = 0; r < values.rows.size(); ++r)
                EXPECT_NEAR(values.jacobian(r, i), (above.rows[r] - below.rows[r]) / (2 * h), 1e-6)
                    << target << program.rows[static_cast<std::size_t>(r)].name << " by "
                    << program.variables[static_cast<std::size_t>(i)].name;
        }
    }
}

/// Over a stroke the point of a body that turns about D is on an arc about D, as far as the body turns.
TEST(DrivenBySlide, ArcsAndFunctionsAreOverDisplacements) {
    const auto angle_at = [](double length) {
        const Vector<double> along = direction_of_body(1300, length);
        return std::atan2(along.y, along.x) * 180 / std::numbers::pi;
    };
    const Solved arc = testing::solved(
        tipped("reach = 1300\narm = 1800\n",
               "[arc]\npoint = \"T\"\nstart = 1250\nrange = 600\n[objective]\nminimize = \"arc-deviation\"\n"));
    ASSERT_EQ(arc.result.status, Status::solved);
    EXPECT_LT(arc.value("arc-deviation"), 1e-6);
    EXPECT_NEAR(std::abs(arc.value("arc-angle")) * 180 / std::numbers::pi, std::abs(angle_at(1850) - angle_at(1250)),
                1e-6);
    expect_verified(document_of_slide(arc));

    // The body is to turn in proportion to the stroke: the greatest error by a scan.
    const double start = angle_at(1250) - 180, range = angle_at(1850) - angle_at(1250);
    double greatest = 0;
    for (int i = 0; i <= 100000; ++i)
        greatest = std::max(greatest, std::abs(angle_at(1250 + 0.006 * i) - 180 - start - range * i / 100000));
    const std::string text = tipped(
        "reach = 1300\narm = 1800\n",
        "[signals]\ntip = { angle = \"body\" }\n[function]\nsignal = \"tip\"\nexpression = \"x\"\nx = [0, 1]\n" +
            fmt::format("input = {{ start = 1250, range = 600 }}\noutput = {{ start = {:.17g}, range = {:.17g} }}\n",
                        start, range));
    const ReadProblem read = testing::read_without_fault(text);
    ASSERT_TRUE(read.ok());
    const Solution solution = evaluate_given(read.problem);
    const Json document = analysis_document(read.problem, solution);
    EXPECT_NEAR(document["quantities"]["function-max"].get<double>(), greatest, 1e-8);
    expect_verified(document);
}

namespace {

/// Where two circles meet, to the left of the way from the first to the second.
Vector<double> left_meet(const Vector<double>& p, double r, const Vector<double>& q, double s) {
    const Vector<double> way = q - p;
    const double d = std::hypot(way.x, way.y), x = (r * r - s * s + d * d) / (2 * d), y = std::sqrt(r * r - x * x);
    return p + (1 / d) * (x * way + y * Vector<double>{-way.y, way.x});
}

/// The direction of the shipped bucket's tip at a length of its cylinder, for an idler, a link, an ear and its angle.
double angle_of_bucket(const std::array<double, 4>& d, double length) {
    const Vector<double> b = left_meet({-1750, 420}, length, {-430, 60}, d[0]), c = left_meet(b, d[1], {0, 0}, d[2]);
    return std::atan2(c.y, c.x) - d[3];
}

}  // namespace

/// Poses of a bucket that there is are met again, at its displacements and at any.
TEST(DrivenBySlide, BodiesAreGuidedThroughPoses) {
    std::string file = testing::shipped("excavator-bucket.toml", "linkage"), poses;
    for (const double length : {1170, 1450, 1700}) {
        const double angle = angle_of_bucket({600, 640, 300, 110 * std::numbers::pi / 180}, length);
        poses += fmt::format("[{:.17g}, {:.17g}, {:.17g}], ", 1250 * std::cos(angle), 1250 * std::sin(angle),
                             angle * 180 / std::numbers::pi);
    }
    file.resize(file.find("[path]"));
    file = testing::replaced(testing::replaced(file, "{ min = 300, max = 700 }", "600"), "{ min = 300, max = 800 }",
                             "640");
    for (const char* timing : {"timing = \"prescribed\"\ncrank_angles = [1170, 1450, 1700]\n", "timing = \"free\"\n"}) {
        const Solved s = testing::solved(file + "[poses]\npoint = \"T\"\nlink = \"bucket\"\n" + timing + "poses = [" +
                                         poses + "]\n[objective]\nminimize = \"pose-rms\"\n");
        ASSERT_EQ(s.result.status, Status::solved) << timing;
        EXPECT_LT(s.value("pose-rms"), 1e-6) << timing;
        const Json found = document_of_slide(s);
        expect_verified(found);
        Json other = found;
        auto& number = other["poses"]["crank_angles"][2];
        number = number.get<double>() + 0.01;
        EXPECT_TRUE(is_refused(other)) << timing;
    }
}

/// The tip of the shipped bucket by two intersected circles; no design of a scan is better than the one that is found.
TEST(DrivenBySlide, AnExcavatorsBucketCurlsEvenly) {
    const std::array<double, 6> lengths{1150, 1270, 1390, 1510, 1630, 1750};
    const auto square_sum = [&](const std::array<double, 4>& d) {
        double sum = 0;
        for (std::size_t i = 0; i < lengths.size(); ++i) {
            const double angle = angle_of_bucket(d, lengths[i]), asked = (20 - 30.0 * static_cast<double>(i)) / 180;
            const Vector<double> tip{1250 * std::cos(angle), 1250 * std::sin(angle)};
            const Vector<double> away = tip - Vector<double>{std::round(1250 * std::cos(asked * std::numbers::pi)),
                                                             std::round(1250 * std::sin(asked * std::numbers::pi))};
            sum += dot(away, away);
        }
        return sum;
    };
    const Solved s = testing::solved(testing::shipped("excavator-bucket.toml", "linkage"));
    ASSERT_EQ(s.result.status, Status::solved);
    const std::array<double, 4> best{s.dimension("idler"), s.dimension("link"), s.dimension("ear"),
                                     s.dimension("ear-angle")};
    EXPECT_NEAR(s.value("path-rms"), std::sqrt(square_sum(best) / 6), 1e-8);
    std::mt19937_64 random(3);
    const std::array<double, 4> low{300, 300, 250, std::numbers::pi / 3}, high{700, 800, 600, 8 * std::numbers::pi / 9};
    int closed = 0;
    for (int i = 0; i < 100000; ++i) {
        // Over all ranges, then closer and closer around the best.
        std::array<double, 4> d;
        const double around = i % 2 == 0 ? 1 : std::pow(10, -1 - 3.0 * i / 100000);
        for (std::size_t k = 0; k < 4; ++k) {
            const double width = around * (high[k] - low[k]), from = i % 2 == 0 ? low[k] : best[k] - width / 2;
            d[k] = std::clamp(std::uniform_real_distribution<>(from, from + width)(random), low[k], high[k]);
        }
        const double sum = square_sum(d);
        if (std::isnan(sum)) continue;
        ++closed;
        EXPECT_GE(sum, square_sum(best) * (1 - 1e-9));
    }
    EXPECT_GT(closed, 50000);
    expect_verified(document_of_slide(s));
}

TEST(DrivenBySlide, WhatCannotBeIsSaidWithARemedy) {
    const std::string points = "points = " + list_of(tipped_points(1300, 1800, 0)) + "\n";
    const auto error_of = [&](const std::string& target) { return first_error(tipped(free_body, target)); };
    EXPECT_EQ(error_of("[path]\npoint = \"T\"\nclosed = true\n" + points),
              "the linkage is driven by a slide, which goes to and fro and never round: leave 'closed' out");
    EXPECT_EQ(error_of("[arc]\npoint = \"T\"\nstart = 1250\nrange = 600\nfull_turn = true\n"),
              "the linkage is driven by a slide, which goes to and fro and never round: leave 'full_turn' out");
    EXPECT_EQ(
        error_of("[path]\npoint = \"T\"\ntiming = \"prescribed\"\ncrank_angles = [1100, 1450, 1650, 1900]\n" + points),
        "the displacement 1100 is not on the stroke of the slide that drives, which goes from 1200 to 2000: give "
        "displacements between its stops, or other stops");
    EXPECT_EQ(
        error_of("[arc]\npoint = \"T\"\nstart = 1250\nrange = 800\n"),
        "the range from 1250 to 2050 is not on the stroke of the slide that drives, which goes from 1200 to 2000: "
        "keep it between the stops, or give other stops");
    EXPECT_EQ(
        error_of("[path]\npoint = \"T\"\ntiming = \"prescribed\"\ncrank_angles = [1250, 1650, 1450, 1900]\n" + points),
        "crank angle 3 (1450) breaks the order: crank_angles must all rise or all fall");
}

}  // namespace mechwright

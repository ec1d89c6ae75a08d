// mechwright profile: tables and drawings of a cam's curves, read again by a reader of their own.

#include <cmath>
#include <numbers>

#include "analysis/geometry/arc_fit.h"
#include "tests/command_line/problems.h"
#include "tests/command_line/program.h"
#include "tests/report/temporary_folder.h"

namespace mechwright::testing {
namespace {

const std::string cam = R"(schema = 1
mechanism = "cam"

[cam]
follower = "roller"

[[segment]]
kind = "rise"
angle = 100
lift = 20
law = "modified-sine"

[[segment]]
kind = "dwell"
angle = 60

[[segment]]
kind = "return"
angle = 120
lift = 20
law = "cycloidal"

[[segment]]
kind = "dwell"
angle = 80

[dimensions]
prime-radius = 40
offset = 5
roller-radius = 8
)";

using Polyline = std::vector<ArcVertex>;

/// The polylines of a drawing by layer, read as pairs of a group code and a value.
std::map<std::string, Polyline> read_drawing(const std::string& text) {
    std::istringstream lines(text);
    std::map<std::string, Polyline> layers;
    std::string code, value, layer, entity;
    while (std::getline(lines, code) && std::getline(lines, value)) {
        const int group = std::stoi(code);
        if (group == 0) {
            entity = value;
        } else if (group == 8) {
            layer = value;
            if (entity == "VERTEX") layers[layer].push_back({{0, 0}, 0});
        } else if (entity == "VERTEX" && group == 10) {
            layers[layer].back().at.x = std::stod(value);
        } else if (entity == "VERTEX" && group == 20) {
            layers[layer].back().at.y = std::stod(value);
        } else if (entity == "VERTEX" && group == 42) {
            layers[layer].back().bulge = std::stod(value);
        }
    }
    EXPECT_EQ(value, "EOF");
    return layers;
}

/// Distance of a point from an arc, its ends included, by the arc's centre.
double distance(const ArcVertex& a, const Vector<double>& b, const Vector<double>& p) {
    const double dx = b.x - a.at.x, dy = b.y - a.at.y, chord = std::hypot(dx, dy);
    const double to_ends = std::min(std::hypot(p.x - a.at.x, p.y - a.at.y), std::hypot(p.x - b.x, p.y - b.y));
    if (chord == 0) return to_ends;
    const double angle = 4 * std::atan(a.bulge);
    if (std::abs(angle) < 1e-9) {
        const double t = ((p.x - a.at.x) * dx + (p.y - a.at.y) * dy) / (chord * chord);
        return t < 0 || t > 1 ? to_ends : std::abs((p.x - a.at.x) * dy - (p.y - a.at.y) * dx) / chord;
    }
    const double radius = chord / (2 * std::sin(std::abs(angle) / 2)), sign = angle > 0 ? 1 : -1;
    const double height =
        radius * std::cos(angle / 2);  // of the centre over the chord, to the left of a turn to the left
    const double cx = 0.5 * (a.at.x + b.x) - sign * height * dy / chord,
                 cy = 0.5 * (a.at.y + b.y) + sign * height * dx / chord;
    const double from = std::atan2(a.at.y - cy, a.at.x - cx), at = std::atan2(p.y - cy, p.x - cx);
    double along = std::remainder(sign * (at - from), 2 * std::numbers::pi);
    if (along < 0) along += 2 * std::numbers::pi;
    return along > std::abs(angle) ? to_ends : std::abs(std::hypot(p.x - cx, p.y - cy) - radius);
}

/// The greatest distance of points of a table from a polyline.
double greatest_distance(const Polyline& polyline, const std::vector<Vector<double>>& points) {
    double greatest = 0;
    for (const auto& p : points) {
        double least = 1e300;
        for (std::size_t i = 0; i < polyline.size(); ++i)
            least = std::min(least, distance(polyline[i], polyline[i + 1 == polyline.size() ? 0 : i + 1].at, p));
        greatest = std::max(greatest, least);
    }
    return greatest;
}

std::vector<Vector<double>> column_pair(const std::string& csv, std::size_t first) {
    std::istringstream lines(csv);
    std::string line;
    std::getline(lines, line);
    std::vector<Vector<double>> points;
    while (std::getline(lines, line)) {
        std::istringstream cells(line);
        std::string cell;
        std::vector<double> row;
        while (std::getline(cells, cell, ','))
            row.push_back(std::stod(cell));
        points.push_back({row.at(first), row.at(first + 1)});
    }
    return points;
}

TEST(Profile, DrawingsStayWithinTheirTolerance) {
    const TemporaryFolder folder;
    const std::string file = folder.write("cam.toml", cam);
    const Outcome table = run({"profile", "--cutter", "6", "--steps", "20000", file});
    ASSERT_EQ(table.exit_code, 0) << table.err;
    std::size_t before = 1000000;
    for (const auto& [tolerance, text] : {std::pair{1e-4, "0.0001"}, {1e-2, "0.01"}}) {
        const Outcome outcome = run({"profile", "--dxf", "--cutter", "6", "--tolerance", text, file});
        ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
        auto layers = read_drawing(outcome.out);
        ASSERT_EQ(layers.size(), 3u);
        EXPECT_LE(greatest_distance(layers["PROFILE"], column_pair(table.out, 1)), tolerance);
        EXPECT_LE(greatest_distance(layers["PITCH"], column_pair(table.out, 3)), tolerance);
        EXPECT_LE(greatest_distance(layers["CUTTER"], column_pair(table.out, 5)), tolerance);
        // A dwell is one arc; the rest takes few, and fewer for a wider tolerance.
        EXPECT_LT(layers["PROFILE"].size(), tolerance < 1e-3 ? 70u : 20u);
        EXPECT_LT(layers["PROFILE"].size(), before);
        before = layers["PROFILE"].size();
    }
}

TEST(Profile, CurvesLieSideBySide) {
    const TemporaryFolder folder;
    const Outcome table = run({"profile", "--cutter", "6", "--steps", "90", folder.write("cam.toml", cam)});
    const auto profile = column_pair(table.out, 1), pitch = column_pair(table.out, 3),
               cutter = column_pair(table.out, 5);
    ASSERT_EQ(profile.size(), 91u);
    for (std::size_t i = 0; i < profile.size(); ++i) {
        EXPECT_NEAR(std::hypot(pitch[i].x - profile[i].x, pitch[i].y - profile[i].y), 8, 1e-12);
        EXPECT_NEAR(std::hypot(cutter[i].x - profile[i].x, cutter[i].y - profile[i].y), 6, 1e-12);
    }
}

TEST(Profile, ReadsResultsToo) {
    const TemporaryFolder folder;
    const std::string file = folder.write("cam.toml", cam), out = folder.path.string() + "/out";
    ASSERT_EQ(run({"solve", "--quiet", "--out", out, file}).exit_code, 0);
    const Outcome from_result = run({"profile", out + "/cam.json"});
    EXPECT_EQ(from_result.exit_code, 0) << from_result.err;
    const auto stated = column_pair(from_result.out, 1), known = column_pair(run({"profile", file}).out, 1);
    ASSERT_EQ(stated.size(), known.size());
    for (std::size_t i = 0; i < known.size(); ++i)
        EXPECT_LE(std::hypot(stated[i].x - known[i].x, stated[i].y - known[i].y), 1e-12);
}

std::string contour_cam(const std::string& follower, const std::string& contour, const std::string& dimensions) {
    return "schema = 1\nmechanism = \"cam\"\n[cam]\nfollower = \"" + follower + "\"\ncontour = \"" + contour +
           "\"\n[dimensions]\n" + dimensions;
}

// An eccentric is a circle: of radius base radius + eccentricity, about a point that far from the shaft.
TEST(Profile, OfAnEccentricIsACircle) {
    const TemporaryFolder folder;
    const std::string file =
        folder.write("a.toml", contour_cam("flat", "eccentric", "base-radius = 37\ncentre-distance = 38\n"));
    const auto points = column_pair(run({"profile", file}).out, 1);
    ASSERT_EQ(points.size(), 361u);
    for (const Vector<double>& p : points)
        EXPECT_NEAR(std::hypot(p.x, p.y + 38), 75, 1e-12);
    auto layers = read_drawing(run({"profile", "--dxf", file}).out);
    EXPECT_LE(greatest_distance(layers["PROFILE"], points), 1e-3);
    EXPECT_LE(layers["PROFILE"].size(), 8u);
}

// A tangent cam: base circle, nose circle, and the two lines that touch both: their normals lie at 60 deg to the axis,
// whose cosine is the difference of the radii over the distance of the centres.
TEST(Profile, OfATangentCamIsTwoCirclesAndTwoLines) {
    const TemporaryFolder folder;
    const std::string file = folder.write(
        "a.toml", contour_cam("roller", "tangent",
                              "base-radius = 25\nnose-radius = 10\ncentre-distance = 30\nroller-radius = 20\n"));
    const auto points = column_pair(run({"profile", "--steps", "720", file}).out, 1);
    ASSERT_EQ(points.size(), 721u);
    const auto farther = [](const Vector<double>& a, const Vector<double>& b) {
        return std::hypot(a.x, a.y) < std::hypot(b.x, b.y);
    };
    const Vector<double> top = *std::max_element(points.begin(), points.end(), farther);
    EXPECT_NEAR(std::hypot(top.x, top.y), 40, 1e-12);
    const Vector<double> axis{top.x / 40, top.y / 40};
    int on_base = 0, on_nose = 0, on_lines = 0;
    for (const Vector<double>& p : points) {
        const double along = p.x * axis.x + p.y * axis.y, across = std::abs(p.x * axis.y - p.y * axis.x);
        const bool base = std::abs(std::hypot(p.x, p.y) - 25) < 1e-11;
        const bool nose = std::abs(std::hypot(along - 30, across) - 10) < 1e-11;
        const bool line = std::abs(0.5 * along + std::sqrt(0.75) * across - 25) < 1e-11;
        EXPECT_TRUE(base || nose || line) << p.x << " " << p.y;
        on_base += base;
        on_nose += nose;
        on_lines += line;
    }
    EXPECT_GT(std::min({on_base, on_nose, on_lines}), 20);
    auto layers = read_drawing(run({"profile", "--dxf", file}).out);
    EXPECT_LE(greatest_distance(layers["PROFILE"], points), 1e-3);
}

// Textbook example 6-2: the pitch curve has a hollow radius of 28.11367 mm at least, the profile a roller radius more.
TEST(Profile, NamesTheLeastHollowRadius) {
    const TemporaryFolder folder;
    const std::string text = R"(schema = 1
mechanism = "cam"
[cam]
follower = "roller"
[[segment]]
kind = "rise"
angle = 30
lift = 60
law = "cycloidal"
[[segment]]
kind = "dwell"
angle = 45
[[segment]]
kind = "return"
angle = 70
lift = 60
law = "cycloidal"
[[segment]]
kind = "dwell"
angle = 215
[dimensions]
prime-radius = 150
roller-radius = 25
)";
    expect_has(run({"profile", "--cutter", "100", folder.write("a.toml", text)}).err, "must be at most 53.1137");
}

TEST(Profile, RefusesWhatHasNone) {
    const TemporaryFolder folder;
    const Outcome four_bar = run({"profile", folder.write("a.toml", given())});
    EXPECT_EQ(four_bar.exit_code, 3);
    expect_has(four_bar.err, "a four-bar has no profile");
    std::string open = cam;
    open.replace(open.find("= 40"), 4, "= { min = 30, max = 50 }");
    expect_has(run({"profile", folder.write("open.toml", open)}).err, "solve it with --out");
    EXPECT_EQ(run({"profile", folder.write("x.json", "{}")}).exit_code, 3);
    EXPECT_EQ(run({"profile", folder.path.string() + "/missing.json"}).exit_code, 6);
    EXPECT_EQ(run({"profile", "--cutter", "-1", folder.write("cam.toml", cam)}).exit_code, 2);
    std::string hollow = cam;  // the rise in 40 deg
    hollow.replace(hollow.find("angle = 100"), 11, "angle = 40 ");
    hollow.replace(hollow.find("angle = 80"), 10, "angle = 140");
    const Outcome cutter = run({"profile", "--cutter", "1000", folder.write("hollow.toml", hollow)});
    EXPECT_EQ(cutter.exit_code, 4);
    expect_has(cutter.err, "the cutter is too large by");
    // The least hollow radius that the message names is allowed, a little more is not.
    const std::size_t at = cutter.err.find("at most ") + 8;
    const double limit = std::stod(cutter.err.substr(at));
    EXPECT_EQ(
        run({"profile", "--cutter", std::to_string(limit * (1 - 1e-4)), folder.write("h.toml", hollow)}).exit_code, 0);
    EXPECT_EQ(
        run({"profile", "--cutter", std::to_string(limit * (1 + 1e-4)), folder.write("h.toml", hollow)}).exit_code, 4);
}

}  // namespace
}  // namespace mechwright::testing

#include "synthesis/report/cam_profile.h"

#include <fmt/format.h>

#include <boost/math/tools/minima.hpp>
#include <cmath>
#include <limits>
#include <numbers>

#include "analysis/geometry/arc_fit.h"
#include "synthesis/mechanism/cam/cam.h"
#include "synthesis/report/csv_text.h"

namespace mechwright {

namespace {

constexpr double turn = 2 * std::numbers::pi;

/// What the motion table says of one cam angle.
struct Row {
    std::vector<double> values;
    const FinishedCam* cam;

    Row(const FinishedCam& of, double cam_angle) : values(of.mechanism->motion_columns.size()), cam(&of) {
        of.mechanism->motion_row(of.motion, of.dimensions, cam_angle, values);
    }
    double at(std::string_view column) const {
        const auto columns = cam->mechanism->motion_columns;
        return values[static_cast<std::size_t>(std::find(columns.begin(), columns.end(), column) - columns.begin())];
    }
    Vector<double> profile(double offset) const {
        return Vector<double>{at("profile-x"), at("profile-y")} +
               offset * Vector<double>{at("normal-x"), at("normal-y")};
    }
};

double roller_radius(const FinishedCam& cam) {
    const int index = find_dimension(*cam.mechanism, "roller-radius");
    return index < 0 ? 0 : cam.dimensions[static_cast<std::size_t>(index)];
}

/// Cam angles at which curves may have corners of their curvature: ends of segments and of their pieces.
std::vector<double> corners(const FinishedCam& cam) {
    std::vector<double> angles{0};
    cam_corners(*cam.mechanism, cam.motion, cam.dimensions, angles);
    angles.push_back(turn);
    std::sort(angles.begin(), angles.end());
    constexpr double close = 1e-9;
    std::vector<double> distinct;
    for (const double angle : angles)
        if (distinct.empty() || angle - distinct.back() > close) distinct.push_back(angle);
    distinct.back() = turn;
    return distinct;
}

std::string polyline(const std::string& layer, const std::vector<ArcVertex>& vertices) {
    std::string text = fmt::format("  0\nPOLYLINE\n  8\n{}\n 66\n1\n 70\n1\n 10\n0.0\n 20\n0.0\n 30\n0.0\n", layer);
    for (const ArcVertex& v : vertices)
        text +=
            fmt::format("  0\nVERTEX\n  8\n{}\n 10\n{}\n 20\n{}\n 30\n0.0\n 42\n{}\n", layer, v.at.x, v.at.y, v.bulge);
    return text + fmt::format("  0\nSEQEND\n  8\n{}\n", layer);
}

}  // namespace

std::vector<CutPath> cut_paths(const FinishedCam& cam, double cutter_radius) {
    std::vector<CutPath> paths{{"PROFILE", 0}};
    if (const double roller = roller_radius(cam); roller > 0) paths.push_back({"PITCH", roller});
    if (cutter_radius > 0) paths.push_back({"CUTTER", cutter_radius});
    return paths;
}

double least_hollow_radius(const FinishedCam& cam) {
    // The curvature of the profile, continued through straight places, where the radius is not.
    const auto bend = [&](double cam_angle) { return 1 / Row(cam, cam_angle).at("profile-radius"); };
    const std::vector<double> ends = corners(cam);
    constexpr int steps = 64;
    double least = 0;
    for (std::size_t i = 1; i < ends.size(); ++i) {
        // Within the piece: at its ends the table has the values of a neighbour.
        const double inset = 1e-9 * (ends[i] - ends[i - 1]);
        const double from = ends[i - 1] + inset, step = (ends[i] - ends[i - 1] - 2 * inset) / steps;
        for (int k = 0; k <= steps; ++k) {
            const double at = bend(from + k * step);
            least = std::min(least, at);
            if (k == 0 || k == steps || at > bend(from + (k - 1) * step) || at > bend(from + (k + 1) * step)) continue;
            constexpr int bits = 24;  // of the place; the curvature there has twice as many
            least = std::min(
                least,
                boost::math::tools::brent_find_minima(bend, from + (k - 1) * step, from + (k + 1) * step, bits).second);
        }
    }
    return least < 0 ? -1 / least : std::numeric_limits<double>::infinity();
}

std::string profile_csv(const FinishedCam& cam, double cutter_radius, int steps) {
    const auto paths = cut_paths(cam, cutter_radius);
    const auto name = [](const CutPath& path) {
        return path.layer == "PROFILE" ? "profile" : path.layer == "PITCH" ? "pitch" : "cutter";
    };
    std::string text = "cam-angle [deg]";
    for (const CutPath& path : paths)
        text += fmt::format(",{}-x [{}],{}-y [{}]", name(path), cam.length, name(path), cam.length);
    text += '\n';
    for (int i = 0; i <= steps; ++i) {
        const Row row(cam, turn * i / steps);
        text += csv_number(360.0 * i / steps);
        for (const CutPath& path : paths) {
            const Vector<double> p = row.profile(path.offset);
            text += "," + csv_number(p.x) + "," + csv_number(p.y);
        }
        text += '\n';
    }
    return text;
}

std::string profile_dxf(const FinishedCam& cam, double cutter_radius, double tolerance) {
    std::string text =
        "  0\nSECTION\n  2\nHEADER\n  9\n$ACADVER\n  1\nAC1009\n  0\nENDSEC\n  0\nSECTION\n  2\nENTITIES\n";
    const std::vector<double> ends = corners(cam);
    for (const CutPath& path : cut_paths(cam, cutter_radius)) {
        const auto curve = [&](double cam_angle) { return Row(cam, cam_angle).profile(path.offset); };
        std::vector<ArcVertex> vertices;
        for (std::size_t i = 1; i < ends.size(); ++i)
            fit_arcs(curve, ends[i - 1], ends[i], tolerance, vertices);
        text += polyline(path.layer, vertices);
    }
    return text + "  0\nENDSEC\n  0\nEOF\n";
}

}  // namespace mechwright

#include "synthesis/report/csv/cut_profile.h"

#include <fmt/format.h>

#include <boost/math/tools/minima.hpp>
#include <cmath>
#include <limits>
#include <numbers>

#include "synthesis/mechanism/drawing/motion_row.h"
#include "synthesis/report/csv/csv_text.h"
#include "synthesis/report/drawing/dxf.h"

namespace mechwright {

namespace {

constexpr double full_turn = 2 * std::numbers::pi;

}  // namespace

std::vector<CutPath> cut_paths(const FinishedDesign& design, double cutter_radius) {
    std::vector<CutPath> paths{{"PROFILE", 0}};
    if (const double roller = design.mechanism->profile->roller_radius(design); roller > 0)
        paths.push_back({"PITCH", roller});
    if (cutter_radius > 0) paths.push_back({"CUTTER", cutter_radius});
    return paths;
}

double least_hollow_radius(const FinishedDesign& design) {
    // The curvature of the profile, continued through straight places, where the radius is not.
    const auto bend = [&](double crank_angle) { return 1 / MotionRow(design, crank_angle)["profile-radius"]; };
    const std::vector<double> ends = design.mechanism->profile->corners(design);
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

std::string profile_csv(const FinishedDesign& design, double cutter_radius, int steps) {
    const auto paths = cut_paths(design, cutter_radius);
    const auto name = [](const CutPath& path) {
        return path.layer == "PROFILE" ? "profile" : path.layer == "PITCH" ? "pitch" : "cutter";
    };
    std::string text = "cam-angle [deg]";
    for (const CutPath& path : paths)
        text += fmt::format(",{}-x [{}],{}-y [{}]", name(path), design.units.length, name(path), design.units.length);
    text += '\n';
    for (int i = 0; i <= steps; ++i) {
        const MotionRow row(design, full_turn * i / steps);
        text += csv_number(360.0 * i / steps);
        for (const CutPath& path : paths) {
            const Vector<double> p = row.vector("profile") + path.offset * row.vector("normal");
            text += "," + csv_number(p.x) + "," + csv_number(p.y);
        }
        text += '\n';
    }
    return text;
}

std::string profile_dxf(const FinishedDesign& design, double cutter_radius, double tolerance) {
    DxfDrawing drawing;
    drawing.unit = design.units.length;
    for (const CutPath& path : cut_paths(design, cutter_radius))
        drawing.curves.push_back({path.layer, design.mechanism->profile->curve(design, path.offset, tolerance), true});
    return dxf_text(drawing);
}

}  // namespace mechwright

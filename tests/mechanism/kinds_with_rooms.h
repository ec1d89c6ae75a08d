#pragma once
/// \file
/// A design of each built-in kind that is a linkage, for tests of rooms and regions: its text, and its points by the
/// kind's own drawing.

#include <array>
#include <string>
#include <vector>

#include "synthesis/report/drawing/scene.h"
#include "tests/mechanism/linkage_scans.h"

namespace mechwright::linkage_scans {

inline std::string text_of_kind(const std::string& kind, const std::string& dimensions) {
    return "schema = 1\nmechanism = \"" + kind + "\"\n[dimensions]\n" + dimensions + "\n";
}

struct KindWithRooms {
    std::string kind;
    std::string dimensions;

    std::string text() const { return text_of_kind(kind, dimensions); }
};

inline const std::vector<KindWithRooms> kinds_with_rooms{
    {"four-bar",
     "ground = 5\ncrank = 2\ncoupler = 4.5\nrocker = 4\npoint-along = 2.5\npoint-across = 3\norigin-x = 1\norigin-y = "
     "-2\ntilt = 20\nassembly = \"crossed\""},
    {"slider-crank",
     "crank = 2\nrod = 5\noffset = 0.7\npoint-along = 2.5\npoint-across = 1.5\norigin-x = 1\norigin-y = -2\ntilt = "
     "-35"},
    {"crank-shaper", "centre-distance = 5\ncrank = 2\nlever = 9\nrod = 6\nram-distance = 8.6"},
    {"whitworth", "centre-distance = 2\ncrank = 4\narm = 3\nrod = 8\nslide-angle = 75"},
    {"drag-link",
     "ground = 2\ncrank = 4\ncoupler = 4.5\nfollower = 5\narm = 3\narm-angle = 40\nrod = 9\nslide-angle = 20\n"
     "slide-offset = 0.3"}};

/// A point of one of its bodies.
struct PointOfBody {
    std::size_t body;
    Vector<double> at;
};

/// All points of its links, in the order of the outlines of `outlines_of`.
inline std::vector<PointOfBody> points_of(const FinishedDesign& d) {
    const std::string& kind = d.mechanism->name;
    const Vector<double> point{d["point-along"], d["point-across"]}, pin{d["crank"], 0};
    if (kind == "four-bar") return {{0, {0, 0}}, {0, pin}, {1, {d["coupler"], 0}}, {2, {0, 0}}, {1, point}};
    if (kind == "slider-crank") return {{0, {0, 0}}, {0, pin}, {1, {d["rod"], 0}}, {1, point}};
    if (kind == "drag-link") {
        const double arm = d["arm"], angle = d["arm-angle"];
        return {{0, {0, 0}},
                {0, pin},
                {1, {d["coupler"], 0}},
                {2, {0, 0}},
                {2, {arm * std::cos(angle), arm * std::sin(angle)}},
                {3, {d["rod"], 0}}};
    }
    const double arm = kind == "whitworth" ? -d["arm"] : d["lever"];
    return {{0, {0, 0}}, {0, pin}, {2, {0, 0}}, {2, {arm, 0}}, {3, {d["rod"], 0}}};
}

/// The outlines of its links by these points, pivots among them.
inline std::vector<std::vector<std::size_t>> outlines_of(const std::string& kind) {
    if (kind == "four-bar") return {{0, 1}, {1, 2, 4}, {2, 3}};
    if (kind == "slider-crank") return {{0, 1}, {1, 2, 3}};
    if (kind == "drag-link") return {{0, 1}, {1, 2}, {2, 3, 4}, {4, 5}};
    return {{0, 1}, {2, 3}, {3, 4}};
}

/// Where they are in poses that are spread over its motion.
inline std::vector<Places> poses_of(const FinishedDesign& design, int steps) {
    const std::vector<PointOfBody> points = points_of(design);
    std::vector<BodyPlace> bodies(design.mechanism->drawing->bodies(design, 0, 1).size());
    std::vector<Places> poses;
    for (int i = 0; i <= steps; ++i) {
        const double at = design.motion.from + (design.motion.to - design.motion.from) * i / steps;
        if (!place_bodies(design, at, design.motion.assembly, bodies)) continue;
        poses.emplace_back();
        for (const PointOfBody& point : points)
            poses.back().push_back(in_drawing(bodies[point.body], point.at));
    }
    return poses;
}

}  // namespace mechwright::linkage_scans

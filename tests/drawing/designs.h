#pragma once
/// \file
/// Mechanisms to be drawn in tests.

#include <gtest/gtest.h>

#include <string>

#include "synthesis/problem/reader.h"
#include "synthesis/program/assess.h"
#include "synthesis/report/drawing/finished.h"
#include "synthesis/solve/solve.h"

namespace mechwright::testing {

/// The design of a problem that leaves nothing open.
inline FinishedDesign given(const std::string& text) {
    const ReadProblem read = parse_problem(text, "given.toml");
    for (const Message& message : read.messages)
        ADD_FAILURE() << to_string(message);
    return finished_design(read.problem, evaluate_given(read.problem).design);
}

inline std::string four_bar_text(const std::string& assembly) {
    return R"(schema = 1
mechanism = "four-bar"
[dimensions]
ground = 100.0
crank = 34.0
coupler = 93.0
rocker = 70.0
point-along = 40.0
point-across = 25.0
origin-x = -20.0
origin-y = 15.0
tilt = 12.0
assembly = ")" +
           assembly + "\"\n";
}

inline const std::string slider_crank_text = R"(schema = 1
mechanism = "slider-crank"
[dimensions]
crank = 40.0
rod = 130.0
offset = 15.0
)";

inline const std::string crank_shaper_text = R"(schema = 1
mechanism = "crank-shaper"
[dimensions]
centre-distance = 100.0
crank = 40.0
lever = 180.0
rod = 90.0
ram-distance = 170.0
)";

inline const std::string whitworth_text = R"(schema = 1
mechanism = "whitworth"
[dimensions]
centre-distance = 30.0
crank = 80.0
arm = 50.0
rod = 200.0
slide-angle = 90.0
)";

inline const std::string drag_link_text = R"(schema = 1
mechanism = "drag-link"
[dimensions]
ground = 30.0
crank = 60.0
coupler = 70.0
follower = 75.0
arm = 50.0
arm-angle = 20.0
rod = 200.0
slide-angle = 60.0
slide-offset = 10.0
assembly = "open"
)";

inline std::string cam_motion(const std::string& rotation, const std::string& lift) {
    return "rotation = \"" + rotation + R"("
[[segment]]
kind = "rise"
angle = 120
lift = )" + lift +
           R"(
law = "cycloidal"
[[segment]]
kind = "dwell"
angle = 60
[[segment]]
kind = "return"
angle = 180
law = "3-4-5"
lift = )" + lift +
           "\n";
}

inline std::string roller_text(const std::string& motion, const std::string& rotation) {
    const bool translating = motion == "translating";
    return "schema = 1\nmechanism = \"cam\"\n[dimensions]\nprime-radius = 40.0\nroller-radius = 8.0\n" +
           std::string(translating ? "offset = 6.0\n" : "pivot-distance = 80.0\narm-length = 70.0\n") +
           "[cam]\nfollower = \"roller\"\nmotion = \"" + motion + "\"\n" +
           cam_motion(rotation, translating ? "20.0" : "15.0");
}

inline std::string flat_text(const std::string& motion, const std::string& rotation) {
    const bool translating = motion == "translating";
    return "schema = 1\nmechanism = \"cam\"\n[dimensions]\nbase-radius = 45.0\n" +
           std::string(translating ? "" : "pivot-distance = 120.0\nface-offset = 5.0\n") +
           "[cam]\nfollower = \"flat\"\nmotion = \"" + motion + "\"\n" +
           cam_motion(rotation, translating ? "12.0" : "8.0");
}

}  // namespace mechwright::testing

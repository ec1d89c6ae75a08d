#pragma once
/// \file
/// Six-bars with a guided point.

#include <gtest/gtest.h>

#include <algorithm>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "synthesis/mechanism/linkage/model.h"
#include "synthesis/problem/reader.h"
#include "synthesis/program/program.h"

namespace mechwright::testing {

/// Six-bars with a rod E-G whose other end G-F hangs on the rocker (Watt's first kind), on the frame
/// (Stephenson's third) or between crank and rocker (Stephenson's first), in frames of their links as nobody chooses
/// them.
inline Problem six_bar_with_point(const std::string& e_on, const std::string& f_on, const std::string& p_on) {
    const auto on = [](const std::string& own, const std::string& link, const char* pin) {
        return own == link ? std::string(", ") + pin : std::string();
    };
    const char* e = R"(E = ["e-x", "e-y"])";
    const char* p = R"(P = ["p-x", "p-y"])";
    const char* f = R"(F = { length = "f", angle = "f-angle" })";
    std::string text = "schema = 1\nmechanism = \"linkage\"\n[dimensions]\n";
    for (const char* name : {"ground", "crank", "coupler", "rocker", "rod", "last", "f"})
        text += std::string(name) + " = { min = 5, max = 400 }\n";
    for (const char* name : {"e-x", "e-y", "p-x", "p-y"})
        text += std::string(name) + " = { min = -400, max = 400 }\n";
    text += R"(f-angle = { min = -180, max = 180 }
[placement]
origin-x = { min = -400, max = 400 }
origin-y = { min = -400, max = 400 }
tilt = { min = -180, max = 180 }
[links]
)";
    text += "frame = { A = [3, -2], D = [\"ground\", -2]" + on(f_on, "frame", f) + " }\n";
    text += "crank = { A = [0, 0], B = { length = \"crank\", angle = -35 }" + on(e_on, "crank", e) + " }\n";
    text += "coupler = { B = [0, 0], C = [0, \"coupler\"]" + on(e_on, "coupler", e) + on(p_on, "coupler", p) + " }\n";
    text += "rocker = { D = [0, 0], C = [\"rocker\", 0]" + on(f_on, "rocker", f) + on(p_on, "rocker", p) + " }\n";
    text += "rod = { E = [0, 0], G = [\"rod\", 0]" + on(p_on, "rod", p) + " }";
    text += R"(
last = { F = [0, 0], G = ["last", 0] }
[drive]
link = "crank"
[assembly]
C = { side = "either", from = "B", to = "D" }
G = { side = "either", from = "F", to = "E" }
[path]
point = "P"
timing = "free"
points = [[0, 0], [1, 0], [2, 1]]
[objective]
minimize = "path-rms"
)";
    ReadProblem read = parse_problem(text, "six-bar.toml");
    for (const Message& message : read.messages)
        ADD_FAILURE() << to_string(message);
    return std::move(read.problem);
}

inline Problem six_bar_with_point_on_rod(const std::string& e_on, const std::string& f_on) {
    return six_bar_with_point(e_on, f_on, "rod");
}

inline const LinkageModel& model_in(const Problem& problem) { return linkage_of(problem.mechanism->model.data()); }

/// Those of a six-bar that assembles over a wide range; others are 0.
inline std::vector<double> some_dimensions(const Problem& problem) {
    std::vector<double> all;
    const std::vector<std::pair<std::string, double>> known{
        {"ground", 100}, {"crank", 30},     {"coupler", 90}, {"rocker", 70},  {"rod", 95},
        {"last", 100},   {"f", 60},         {"e-x", 35},     {"e-y", 50},     {"p-x", 40},
        {"p-y", -25},    {"f-angle", -1.2}, {"origin-x", 5}, {"origin-y", 7}, {"tilt", 0.3}};
    for (const Dimension& dimension : problem.mechanism->dimensions) {
        const auto at = std::find_if(known.begin(), known.end(),
                                     [&](const auto& one) { return dimension.name.ends_with(one.first); });
        all.push_back(at == known.end() ? 0 : at->second);
    }
    return all;
}

inline std::vector<bool> all_free(const Problem& problem) {
    return std::vector<bool>(problem.mechanism->dimensions.size(), true);
}

/// The guided point in the drawing; nothing where the linkage does not assemble.
inline std::optional<Vector<double>> drawn_point(const Problem& problem, const std::vector<double>& dimensions,
                                                 std::size_t assembly, double input) {
    PathMiss miss{};
    miss_of_point(*problem.mechanism, problem.mechanism->form(assembly), dimensions, input, {0, 0}, miss);
    if (!(miss.margin >= 0)) return {};
    return Vector<double>{-miss.miss.x, -miss.miss.y};
}

}  // namespace mechwright::testing

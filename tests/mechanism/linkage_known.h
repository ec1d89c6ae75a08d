#pragma once
/// \file
/// Shipped linkages against numbers that no code of ours made: closed forms, and positions, speeds and extremes
/// computed apart by intersecting circles in fifty digits (mpmath).

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>
#include <numbers>
#include <sstream>
#include <string>
#include <vector>

#include "synthesis/document/document.h"
#include "synthesis/problem/reader.h"
#include "synthesis/program/assess.h"

namespace mechwright::known_linkages {

inline constexpr double one_degree = std::numbers::pi / 180;

struct KnownQuantity {
    std::string name;
    double value;
};

inline std::string shipped_text(const std::string& linkage) {
    std::ifstream in(MECHWRIGHT_SOURCE_DIR "/problems/linkage/" + linkage + ".toml");
    std::ostringstream text;
    text << in.rdbuf();
    return text.str();
}

/// What a shipped linkage says of quantities, in the file's units.
inline nlohmann::ordered_json shipped_quantities(const std::string& linkage, const std::vector<KnownQuantity>& asked) {
    std::string text = shipped_text(linkage);
    for (const KnownQuantity& quantity : asked)
        text += "\n[[require]]\nquantity = \"" + quantity.name + "\"\nmin = -1e9\n";
    const ReadProblem read = parse_problem(text, linkage + ".toml");
    for (const Message& message : read.messages)
        ADD_FAILURE() << to_string(message);
    if (!read.ok()) return {};
    const Solution solution = evaluate_given(read.problem);
    EXPECT_TRUE(solution.feasible) << linkage;
    return analysis_document(read.problem, solution)["quantities"];
}

/// To a tolerance that is relative to the size of what is measured.
inline void expect_known(const std::string& linkage, const std::vector<KnownQuantity>& known, double size,
                         double tolerance = 1e-14) {
    const nlohmann::ordered_json quantities = shipped_quantities(linkage, known);
    for (const auto& [name, value] : known) {
        ASSERT_TRUE(quantities.contains(name)) << name;
        EXPECT_NEAR(quantities[name].get<double>(), value, tolerance * size) << linkage << ": " << name;
    }
}

/// A quantity at a crank angle.
inline std::string at(const std::string& signal, double angle) {
    std::ostringstream name;
    name << signal << ".at(" << angle << ")";
    return name.str();
}

/// Radians of crank and degrees of the file.
constexpr double degrees(double radians) { return radians / one_degree; }

}  // namespace mechwright::known_linkages

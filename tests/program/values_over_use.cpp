// Quantities over a range of use against the same over the crank range that it is, and over the whole motion against
// those of problems without any range.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <string>

#include "synthesis/mechanism/whole_quantities.h"
#include "synthesis/program/assess.h"
#include "synthesis/program/quantity_value.h"
#include "tests/program/derivatives.h"

namespace mechwright::testing {

namespace {

constexpr const char* with_use = "[motion]\nfrom = \"first-target\"\nto = \"last-target\"\nbefore = 5\nafter = 10\n";

/// What a problem without one says of the quantity, by its name.
std::optional<double> value_in(const Problem& problem, const Design& design, std::string_view name) {
    return quantity_value(problem, static_cast<std::size_t>(find_quantity(*problem.mechanism, name)), design);
}

/// A mechanism whose targets are met from the crank angle 20 deg on.
void expect_alike(const std::string& mechanism, const std::string& path) {
    for (const bool falls : {false, true}) {
        const std::string timed =
            mechanism + path + (falls ? "crank_angles = [40, 10, 0]\n" : "crank_angles = [0, 10, 40]\n");
        const Problem used = problem_of(timed + with_use), whole = problem_of(timed);
        const Problem given = problem_of(timed + "[motion]\ncrank_range = " + (falls ? "[10, 65]\n" : "[15, 70]\n"));
        const Design design = evaluate_given(used).design;
        int compared = 0;
        for (std::size_t i = 0; i < used.mechanism->quantities.size(); ++i) {
            const Quantity& quantity = used.mechanism->quantities[i];
            const std::optional<double> value = quantity_value(used, i, design);
            const std::optional<double> same =
                value_in(quantity.whole ? whole : given, design, without_whole(quantity.name));
            ASSERT_EQ(value.has_value(), same.has_value()) << quantity.name;
            if (!value) continue;
            EXPECT_NEAR(*value, *same, 1e-12 * (1 + std::abs(*same))) << quantity.name;
            ++compared;
        }
        EXPECT_GT(compared, 10);
    }
}

constexpr const char* points = "[path]\ntiming = \"prescribed\"\npoints = [[2, 2.5], [1.5, 2.7], [1, 2.6]]\n";

}  // namespace

TEST(ValuesOverUse, AreThoseOverItsCrankAnglesOfFourBars) {
    for (const char* lengths :
         {"ground = 4\ncrank = 1.5\ncoupler = 3.5\nrocker = 3\n", "ground = 5\ncrank = 3\ncoupler = 3.5\nrocker = 4\n"})
        expect_alike(
            "schema = 1\nmechanism = \"four-bar\"\n[dimensions]\npoint-along = 2\npoint-across = 1.2\n"
            "crank-start = 20\n" +
                std::string(lengths),
            points);
}

TEST(ValuesOverUse, AreThoseOverItsCrankAnglesOfSliderCranks) {
    expect_alike(
        "schema = 1\nmechanism = \"slider-crank\"\n[dimensions]\ncrank = 1\nrod = 3\noffset = 0.4\n"
        "point-along = 2\ncrank-start = 20\n",
        points);
}

TEST(ValuesOverUse, AreThoseOverItsCrankAnglesOfLinkages) {
    expect_alike(
        "schema = 1\nmechanism = \"linkage\"\n[links]\nframe = { A = [0, 0], D = [4, 0] }\n"
        "crank = { A = [0, 0], B = [1.5, 0] }\ncoupler = { B = [0, 0], C = [3.5, 0], P = [2, 1.2] }\n"
        "rocker = { D = [0, 0], C = [3, 0] }\n[drive]\nlink = \"crank\"\n[signals]\n"
        "swing = { angle = \"rocker\" }\n",
        std::string(points) + "point = \"P\"\ncrank-start = 20\n");
}

}  // namespace mechwright::testing

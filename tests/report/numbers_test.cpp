#include "synthesis/report/text/numbers.h"

#include <gtest/gtest.h>

#include "tests/report/examples.h"

namespace mechwright {
namespace {

using namespace testing;

TEST(RoundedText, KeepsWhatStandsBeforeThePoint) {
    EXPECT_EQ(rounded_text(45.008219, 4), "45.01");
    EXPECT_EQ(rounded_text(106233.4, 4), "106233");
    EXPECT_EQ(rounded_text(-1179.31, 4), "-1179");
    EXPECT_EQ(rounded_text(2.5e9, 4), "2.5e+09");
    EXPECT_EQ(rounded_text(0.000172684, 4), "0.0001727");
    EXPECT_EQ(rounded_text(0, 4), "0");
}

Design with_dimensions(std::vector<double> dimensions) { return {std::move(dimensions), 0, {}}; }

TEST(QuantityText, RoundingIsZeroByTheScaleOfItsQuantity) {
    const Problem problem = problem_of(crank_rocker_text);
    const Design design = crank_rocker_solution().design,
                 small = with_dimensions({1e-10, 4e-11, 9e-11, 8e-11, 0, 0, 0, 0, 0});
    const auto shown = [&](double value, Unit unit, const Design& d) {
        return quantity_text(value, unit, problem, d, 4);
    };
    EXPECT_EQ(shown(7e-15, Unit::length, design), "0");
    EXPECT_EQ(shown(7e-15, Unit::length, small), "7e-15");
    EXPECT_EQ(shown(-7e-15, Unit::none, design), "0");
    EXPECT_EQ(shown(1e-9, Unit::area, design), "0");
    EXPECT_EQ(shown(7e-15, Unit::force, design), "7e-15");  // a design does not say how great its forces are
    EXPECT_EQ(shown(3.141592653589793 / 3, Unit::angle, design), "60");
    EXPECT_EQ(quantity_with_unit(1e-13, Unit::angle, problem, design, 4), "0 deg");
}

TEST(DimensionTexts, AreAsFineAsTheLongestLengthAsksFor) {
    const Problem problem = problem_of(crank_rocker_text);
    const auto shown = [&](std::vector<double> dimensions, int digits = 4) {
        auto texts = dimension_texts(problem, with_dimensions(std::move(dimensions)), digits);
        texts.resize(4);
        return texts;
    };
    using Texts = std::vector<std::string>;
    EXPECT_EQ(shown({100, 34.099741, 93.00375, 69.847371, 0, 0, 0, 0, 0}),
              (Texts{"100.00", "34.10", "93.00", "69.85"}));
    EXPECT_EQ(shown({100, 34.099741, 93.00375, 69.847371, 0, 0, 0, 0, 0}, 8),
              (Texts{"100.000000", "34.099741", "93.003750", "69.847371"}));
    EXPECT_EQ(shown({100, 30, 95, 65, 0, 0, 0, 0, 0}), (Texts{"100", "30", "95", "65"}));
    EXPECT_EQ(shown({100, 30.5, 95, 65, 0, 0, 0, 0, 0}), (Texts{"100.0", "30.5", "95.0", "65.0"}));
    EXPECT_EQ(shown({100, 0.0123456, 95, 65, 0, 0, 0, 0, 0}), (Texts{"100", "0.012", "95", "65"}));
    EXPECT_EQ(shown({123456, 7.8, 123456, 65, 0, 0, 0, 0, 0}), (Texts{"123456", "7.8", "123456", "65"}));
    EXPECT_EQ(shown({1e20, 1e19, 1e20, 1e20, 0, 0, 0, 0, 0}), (Texts{"1e+20", "1e+19", "1e+20", "1e+20"}));
}

}  // namespace
}  // namespace mechwright

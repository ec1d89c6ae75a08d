// Units in the tables of a page.

#include "synthesis/report/page/tables.h"

#include <gtest/gtest.h>

namespace mechwright {
namespace {

std::string tables_of_cam(const std::string& first_dimension) {
    return tables_of(nlohmann::ordered_json::parse(
        R"({"problem": {"mechanism": "cam"}, "units": {"length": "mm", "angle": "deg"}, "design": {"prime-radius": 34.5, ")" +
        first_dimension + R"(": 92.5, "roller-radius": 5, "lift-1": 25}, "quantities": {"velocity-max": 0.375}})"));
}

/// Cams of all kinds are called cam: what a lift is follows from the other dimensions.
TEST(Tables, ShowTheLiftOfAnOscillatingFollowerAsAnAngle) {
    const std::string oscillating = tables_of_cam("pivot-distance"), translating = tables_of_cam("offset");
    EXPECT_NE(oscillating.find(table_row({"lift-1", "25", "deg", ""})), std::string::npos) << oscillating;
    EXPECT_NE(translating.find(table_row({"lift-1", "25", "mm", ""})), std::string::npos) << translating;
    EXPECT_NE(oscillating.find(table_row({"prime-radius", "34.5", "mm", ""})), std::string::npos) << oscillating;
}

}  // namespace
}  // namespace mechwright

// Every problem in problems/cam: solved and verified, or proven impossible where its name says so.

#include <algorithm>
#include <filesystem>

#include "tests/known_optima/solved.h"

namespace mechwright {

namespace {

using testing::shipped;
using testing::solved;

std::vector<std::string> names_of_problems() {
    std::vector<std::string> names;
    for (const auto& entry : std::filesystem::directory_iterator(MECHWRIGHT_SOURCE_DIR "/problems/cam"))
        names.push_back(entry.path().stem().string());
    std::sort(names.begin(), names.end());
    return names;
}

class ShippedCam : public ::testing::TestWithParam<std::string> {};

TEST_P(ShippedCam, IsSolvedAndVerified) {
    const auto s = solved(shipped(GetParam() + ".toml", "cam"));
    if (GetParam() == "not-possible") {
        EXPECT_EQ(s.result.status, Status::infeasible);
        return;
    }
    EXPECT_EQ(s.result.status, Status::solved);
    EXPECT_TRUE(s.result.verified());
}

INSTANTIATE_TEST_SUITE_P(Shipped, ShippedCam, ::testing::ValuesIn(names_of_problems()), [](const auto& test) {
    std::string name = test.param;
    std::replace(name.begin(), name.end(), '-', '_');
    return name;
});

TEST(ShippedCams, AreAtLeastTwelve) { EXPECT_GE(names_of_problems().size(), 12u); }

/// Hessians that were not a number made Ipopt read memory that it had not written: what it found depended on what other
/// threads had left there.
TEST(ShippedCams, AreFoundByIpoptFromEveryStartOnAnyNumberOfThreads) {
    for (const std::string name : {"valve-from-lift.toml", "composed-motion.toml"}) {
        const auto one = solved(shipped(name, "cam"), "ipopt", 1, 1);
        EXPECT_EQ(one.result.search.hits, one.result.search.starts) << name;
        const auto three = solved(shipped(name, "cam"), "ipopt", 1, 3);
        EXPECT_EQ(one.result.search.evaluations, three.result.search.evaluations) << name;
        EXPECT_EQ(one.result.best->design.dimensions, three.result.best->design.dimensions) << name;
    }
}

}  // namespace

}  // namespace mechwright

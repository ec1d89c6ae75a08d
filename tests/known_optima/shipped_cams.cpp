// Every problem in problems/cam: solved and verified, or proven impossible where its name says so.

#include <filesystem>

#include "tests/known_optima/solved.h"

namespace mechwright {

namespace {

using testing::shipped;
using testing::solved;

TEST(ShippedCams, AreSolvedAndVerified) {
    int count = 0;
    for (const auto& entry : std::filesystem::directory_iterator(MECHWRIGHT_SOURCE_DIR "/problems/cam")) {
        const std::string name = entry.path().filename().string();
        const auto s = solved(shipped(name, "cam"));
        ++count;
        if (name == "not-possible.toml") {
            EXPECT_EQ(s.result.status, Status::infeasible);
            continue;
        }
        EXPECT_EQ(s.result.status, Status::solved) << name;
        EXPECT_TRUE(s.result.verified()) << name;
    }
    EXPECT_GE(count, 12);
}

}  // namespace

}  // namespace mechwright

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

// What a file says about one mechanism only: its settings, and dimensions that make it another mechanism.

#include "tests/problem/problem_text.h"

namespace mechwright::test {

namespace {

/// Lines 1 to 9; what is added starts in line 10.
std::string drive(const std::string& mechanism, const std::string& centre_distance, const std::string& crank) {
    const bool shaper = mechanism == "crank-shaper";
    return "schema = 1\nmechanism = \"" + mechanism + "\"\n[dimensions]\ncentre-distance = " + centre_distance +
           "\ncrank = " + crank + (shaper ? "\nlever = 200\n" : "\narm = 50\n") + "rod = 150\n" +
           (shaper ? "ram-distance = 180\n" : "slide-angle = 90\n") + "\n";
}

ReadProblem read_share(const std::string& share) {
    return read(drive("crank-shaper", "100", "50") + "[quick-return]\nworking-share = " + share + "\n");
}

}  // namespace

TEST(WorkingShare, IsReadAndHasAPreset) {
    const ReadProblem some = read_share("0.75");
    EXPECT_TRUE(accepted(some));
    EXPECT_EQ(some.problem.settings[0], 0.75);
    const ReadProblem none = read(drive("crank-shaper", "100", "50"));
    EXPECT_TRUE(accepted(none));
    EXPECT_EQ(none.problem.settings[0], 0.6);
}

TEST(WorkingShare, LiesBetweenNoneAndAllOfTheStroke) {
    for (const char* share : {"0", "1", "1.5", "-0.1"})
        EXPECT_TRUE(only_says(read_share(share), "p.toml:11:17",
                              {"'working-share' in [quick-return]", "greater than 0", "less than 1", share}));
    EXPECT_TRUE(only_says(read_share("nan"), "p.toml:11:17", {"working-share", "finite"}));
    EXPECT_TRUE(only_says(read_share("\"half\""), "p.toml:11:17", {"working-share", "a number", "a string"}));
    EXPECT_TRUE(accepted(read_share("1e-6")));
}

TEST(WorkingShare, UnknownKeysBesideItAreErrorsWithTheNearestName) {
    EXPECT_TRUE(only_says(read(drive("whitworth", "50", "100") + "[quick-return]\nworking_share = 0.5\n"),
                          "p.toml:11:1", {"'working_share' in [quick-return]", "'working-share'"}));
}

TEST(WorkingShare, OfAMechanismWithoutARamIsAnError) {
    EXPECT_TRUE(
        only_says(read(valid + "[quick-return]\nworking-share = 0.5\n"), "p.toml:8:2", {"four-bar", "[quick-return]"}));
}

TEST(SlottedDrives, ACrankShaperWithTooLongACrankIsAWhitworthDrive) {
    for (const auto& [distance, crank] :
         {std::pair{"100", "120"}, {"100", "100"}, {"{ min = 50, max = 100 }", "{ min = 100, max = 200 }"}})
        EXPECT_TRUE(
            only_says(read(drive("crank-shaper", distance, crank)), "p.toml:5:9", {"shorter", "\"whitworth\""}));
    EXPECT_TRUE(accepted(read(drive("crank-shaper", "100", "{ min = 50, max = 150 }"))));
}

TEST(SlottedDrives, AWhitworthDriveWithTooShortACrankIsACrankShaper) {
    for (const auto& [distance, crank] :
         {std::pair{"100", "60"}, {"100", "100"}, {"{ min = 100, max = 150 }", "{ min = 50, max = 100 }"}})
        EXPECT_TRUE(only_says(read(drive("whitworth", distance, crank)), "p.toml:5:9", {"longer", "\"crank-shaper\""}));
    EXPECT_TRUE(accepted(read(drive("whitworth", "100", "{ min = 50, max = 150 }"))));
}

TEST(SlottedDrives, TheAdviceComesWithAllOtherErrors) {
    const ReadProblem all =
        read(drive("crank-shaper", "100", "120") + "[quick-return]\nworking-share = 2\n[objective]\nminimise = 1\n");
    EXPECT_TRUE(says(all, "p.toml:5:9", {"whitworth"}));
    EXPECT_TRUE(says(all, "p.toml:11:17", {"working-share"}));
    EXPECT_TRUE(says(all, "p.toml:13:1", {"minimise"}));
}

}  // namespace mechwright::test

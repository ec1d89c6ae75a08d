// Problem files of cams: the follower, the segments of the motion, and what can be wrong with them.

#include "synthesis/mechanism/cam/cam.h"

#include "tests/problem/problem_text.h"

namespace mechwright::test {

namespace {

/// Lines: 1 schema, 2 mechanism, 3 [cam], 4 follower, 5 [dimensions], 6 prime-radius or base-radius, 7 roller-radius or
/// blank; the segments start in line 8, four lines each with a law, three without.
std::string cam(const std::string& segments, const std::string& follower = "roller", const std::string& radius = "40",
                const std::string& more = "") {
    return "schema = 1\nmechanism = \"cam\"\n[cam]\nfollower = \"" + follower + "\"\n[dimensions]\n" +
           (follower == "flat" ? "base-radius = " : "prime-radius = ") + radius + "\n" +
           (follower == "roller" ? "roller-radius = 5" : "") + more + "\n" + segments;
}

std::string moving(const std::string& kind, const std::string& angle, const std::string& lift,
                   const std::string& law = "\"cycloidal\"") {
    return "[[segment]]\nkind = \"" + kind + "\"\nangle = " + angle + "\nlift = " + lift + "\nlaw = " + law + "\n";
}

std::string dwell(const std::string& angle) { return "[[segment]]\nkind = \"dwell\"\nangle = " + angle + "\n"; }

const std::string closed = moving("rise", "90", "20") + dwell("90") + moving("return", "180", "20");

std::string table(const std::string& points) { return "[[segment]]\nkind = \"cycle\"\npoints = [" + points + "]\n"; }

}  // namespace

TEST(Cam, IsReadWithItsMotion) {
    const ReadProblem read_cam = read(cam(closed));
    EXPECT_TRUE(accepted(read_cam));
    const Problem& p = read_cam.problem;
    ASSERT_TRUE(program_of(*p.mechanism));
    ASSERT_EQ(program_of(*p.mechanism)->segments.size(), 3u);
    EXPECT_EQ(program_of(*p.mechanism)->segments[2].kind, mechwright::cam::SegmentKind::fall);
    EXPECT_NEAR(p.dimensions[cam_angle_dimension(*p.mechanism, 2)].min, 3.141592653589793, 1e-15);
    EXPECT_EQ(p.dimensions[cam_lift_dimension(*p.mechanism, 0)].min, 20);
    EXPECT_TRUE(p.requirements.empty());
}

TEST(Cam, HasTheDimensionsOfItsFollower) {
    for (const char* follower : {"knife", "roller", "flat"})
        EXPECT_TRUE(accepted(read(cam(closed, follower)))) << follower;
    EXPECT_TRUE(
        only_says(read(cam(closed, "knife", "40", "roller-radius = 5")), "p.toml:7:17", {"knife edge", "\"roller\""}));
    EXPECT_TRUE(says(read(cam(closed, "flat", "40", "offset = 5")), "p.toml:7:1", {"unknown key 'offset'"}));
    EXPECT_TRUE(
        only_says(read(cam(closed, "ball")), "p.toml:4:12", {"unknown follower 'ball'", "knife, roller, flat"}));
    // The rest of the file is read by the follower that is meant.
    const auto misspelt = read(cam(closed, "rolle", "40", "roller-radus = 5"));
    EXPECT_TRUE(says(misspelt, "p.toml:4:12", {"unknown follower 'rolle'", "did you mean 'roller'"}));
    EXPECT_TRUE(says(misspelt, "p.toml:7:1", {"unknown key 'roller-radus'", "did you mean 'roller-radius'"}));
    EXPECT_TRUE(only_says(read(cam(closed, "roller", "40", "\noffset = 45")), "p.toml:8:10",
                          {"offset is larger than the prime-radius, by 5"}));
}

TEST(Cam, NeedsItsSections) {
    EXPECT_TRUE(says(read("schema = 1\nmechanism = \"cam\"\n[dimensions]\nprime-radius = 1\n"), "p.toml:1:1",
                     {"[cam] is missing"}));
    EXPECT_TRUE(says(read(cam("")), "p.toml:1:1", {"[[segment]]"}));
    EXPECT_TRUE(only_says(read(valid + "[cam]\nfollower = \"flat\"\n"), "p.toml:8:2", {"four-bar", "'cam'"}));
}

TEST(CamMotion, MakesUpAFullTurn) {
    EXPECT_TRUE(only_says(read(cam(moving("rise", "90", "20") + moving("return", "180", "20"))), "p.toml:8:1",
                          {"270 deg", "90 deg short of a full turn"}));
    EXPECT_TRUE(only_says(read(cam(moving("rise", "190", "20") + moving("return", "180", "20"))), "p.toml:8:1",
                          {"370 deg", "10 deg more than a full turn"}));
    EXPECT_TRUE(only_says(read(cam(moving("rise", "{ min = 10, max = 90 }", "20") + moving("return", "180", "20"))),
                          "p.toml:8:1", {"at most 270 deg"}));
}

TEST(CamMotion, ReturnsToWhereItBegan) {
    EXPECT_TRUE(only_says(read(cam(moving("rise", "180", "20") + moving("return", "180", "15"))), "p.toml:13:1",
                          {"do not add up to zero", "5 from where it began"}));
    EXPECT_TRUE(only_says(read(cam(moving("return", "180", "20") + moving("rise", "180", "20"))), "p.toml:8:1",
                          {"20 below the lowest position"}));
}

TEST(CamMotion, HasPositiveAnglesAndLifts) {
    EXPECT_TRUE(says(read(cam(moving("rise", "-90", "20") + dwell("270") + moving("return", "180", "20"))),
                     "p.toml:10:9", {"'angle' in segment 1", "greater than 0", "-90"}));
    EXPECT_TRUE(says(read(cam(moving("rise", "180", "0") + moving("return", "180", "20"))), "p.toml:11:8",
                     {"'lift' in segment 1", "greater than 0"}));
}

TEST(CamMotion, MayHaveFreeAnglesAndLifts) {
    const ReadProblem free =
        read(cam(moving("rise", "{ min = 60, max = 180 }", "{ min = 5, max = 20 }") + dwell("{ min = 10, max = 200 }") +
                 moving("return", "120", "{ min = 5, max = 20 }")));
    EXPECT_TRUE(accepted(free));
    ASSERT_EQ(free.problem.requirements.size(), 2u);  // that the turn and the lift close
    EXPECT_NEAR(*free.problem.requirements[0].equal, 6.283185307179586, 1e-15);
    EXPECT_EQ(*free.problem.requirements[1].equal, 0);
}

TEST(CamLaw, IsNamedAsProblemFilesOrVdiDo) {
    EXPECT_TRUE(only_says(read(cam(moving("rise", "180", "20", "\"cycloidle\"") + moving("return", "180", "20"))),
                          "p.toml:12:7", {"unknown law 'cycloidle'", "did you mean 'cycloidal'"}));
    for (const char* name : {"inclined-sine", "mcv50", "5th-degree-polynomial", "simple-harmonic"})
        EXPECT_TRUE(accepted(
            read(cam(moving("rise", "180", "20", "\"" + std::string(name) + "\"") + moving("return", "180", "20")))))
            << name;
}

TEST(CamLaw, MayBeAListToChooseFrom) {
    const ReadProblem two = read(cam(moving("rise", "180", "20", "[\"cycloidal\", \"3-4-5\"]") +
                                     moving("return", "180", "20", "[\"harmonic\", \"3-4-5\", \"4-5-6-7\"]")));
    EXPECT_TRUE(accepted(two));
    EXPECT_EQ(two.problem.assemblies.size(), 6u);
    EXPECT_TRUE(says(read(cam(moving("rise", "180", "20", "[]") + moving("return", "180", "20"))), "p.toml:12:7",
                     {"empty list"}));
}

TEST(CamLaw, OnlyPolynomialsHaveEnds) {
    EXPECT_TRUE(accepted(
        read(cam(moving("rise", "180", "20", "\"polynomial\"\nstart = [0, 0]\nend = [0, { min = -9, max = 0 }]") +
                 moving("return", "180", "20")))));
    EXPECT_TRUE(only_says(
        read(cam(moving("rise", "180", "20", "\"harmonic\"\nstart = [0, 0]") + moving("return", "180", "20"))),
        "p.toml:13:1", {"'start' in segment 1", "law = \"polynomial\""}));
    EXPECT_TRUE(says(
        read(cam(moving("rise", "180", "20", "\"polynomial\"\nstart = [0, 0, 0, 0]") + moving("return", "180", "20"))),
        "p.toml:13:9", {"4 entries", "3 at most"}));
}

TEST(CamLaw, EndsOfPolynomialsHaveTheKindsOfVdi) {
    const auto polynomial = [](const std::string& ends) {
        return read(cam(moving("rise", "180", "20", "\"polynomial\"\n" + ends) + moving("return", "180", "20")));
    };
    EXPECT_TRUE(accepted(polynomial("start = \"R\"")));
    EXPECT_EQ(program_of(*polynomial("start = \"R\"").problem.mechanism)->segments[0].start_count, 2u);
    EXPECT_EQ(program_of(*polynomial("").problem.mechanism)->segments[0].end_count, 2u);
    const ReadProblem moved = polynomial("end = { velocity = 3, jerk = { min = -1, max = 1 } }");
    EXPECT_TRUE(accepted(moved));
    EXPECT_EQ(program_of(*moved.problem.mechanism)->segments[0].end_count, 3u);
    EXPECT_EQ(moved.problem.dimensions[cam_coefficient_dimension(*moved.problem.mechanism, 2)].min, 3);
    EXPECT_EQ(moved.problem.dimensions[cam_coefficient_dimension(*moved.problem.mechanism, 4)].max, 1);
    EXPECT_TRUE(only_says(polynomial("start = \"G\""), "p.toml:13:9", {"kind G", "start = { velocity = ... }"}));
    EXPECT_TRUE(only_says(polynomial("start = \"X\""), "p.toml:13:9", {"unknown kind of end 'X'"}));
    EXPECT_TRUE(only_says(polynomial("end = { speed = 3 }"), "p.toml:13:9", {"'speed'", "end of segment 1"}));
    EXPECT_TRUE(only_says(polynomial("end = 3"), "p.toml:13:7", {"list of numbers"}));
}

TEST(CamTable, IsPeriodic) {
    EXPECT_TRUE(accepted(read(cam(table("[0, 0], [90, 5], [180, 9], [270, 4], [360, 0]")))));
    EXPECT_TRUE(accepted(read(cam(table("[0, 0], [90, 5], [180, 9], [270, 4]")))));
    EXPECT_TRUE(only_says(read(cam(table("[0, 0], [90, 5], [180, 9], [270, 4], [360, 0.5]"))), "p.toml:10:48",
                          {"not periodic", "0.5 away"}));
    EXPECT_TRUE(only_says(read(cam(table("[0, 0], [90, 5], [80, 9], [270, 4]"))), "p.toml:10:28", {"does not rise"}));
    EXPECT_TRUE(only_says(read(cam(table("[0, 0], [90, 5], [180, -9], [270, 4]"))), "p.toml:10:28", {"negative"}));
    EXPECT_TRUE(only_says(read(cam(table("[0, 0], [90, 5], [180, 9], [370, 4]"))), "p.toml:10:38", {"370", "outside"}));
    EXPECT_TRUE(
        says(read(cam(table("[0, 0], [90, 5], [180, 9], [270, 4]") + dwell("90"))), "p.toml:8:1", {"the only one"}));
}

TEST(CamContour, HasCirclesThatMeet) {
    const auto contour = [](const std::string& kind, const std::string& follower, const std::string& dimensions) {
        return read("schema = 1\nmechanism = \"cam\"\n[cam]\nfollower = \"" + follower + "\"\ncontour = \"" + kind +
                    "\"\n[dimensions]\nbase-radius = 25\n" + dimensions);
    };
    EXPECT_TRUE(accepted(contour("tangent", "roller", "nose-radius = 10\ncentre-distance = 30\nroller-radius = 20\n")));
    EXPECT_TRUE(
        accepted(contour("circular-arc", "flat", "nose-radius = 2.5\ncentre-distance = 32.5\nflank-radius = 69\n")));
    EXPECT_TRUE(accepted(contour("eccentric", "roller", "centre-distance = 10\nroller-radius = 20\n")));
    EXPECT_TRUE(only_says(contour("tangent", "flat", ""), "p.toml:4:12", {"straight flanks", "\"roller\""}));
    EXPECT_TRUE(only_says(contour("tangent", "roller", "nose-radius = 10\ncentre-distance = 12\nroller-radius = 20\n"),
                          "p.toml:9:19", {"does not stand out", "by 3"}));
    EXPECT_TRUE(
        only_says(contour("circular-arc", "flat", "nose-radius = 10\ncentre-distance = 30\nflank-radius = 30\n"),
                  "p.toml:10:16", {"do not reach the nose", "by 5"}));
    EXPECT_TRUE(says(contour("eccentric", "flat", "centre-distance = 10\n[[segment]]\nkind = \"dwell\"\nangle = 360\n"),
                     "p.toml:9:3", {"follows from the contour"}));
}

TEST(CamDynamics, AreSettingsOfTranslatingFollowers) {
    const std::string with_units = closed + "[units]\nmass = \"kg\"\n";
    EXPECT_TRUE(accepted(read(cam(with_units + "[dynamics]\nmass = 0.5\nspeed = 200\nfriction = 0\n"))));
    // 0.5 kg is 0.0005 of the mass that goes with N and mm.
    const ReadProblem kilograms = read(cam(with_units + "[dynamics]\nmass = 0.5\n"));
    ASSERT_TRUE(accepted(kilograms));
    EXPECT_DOUBLE_EQ(kilograms.problem.settings[0], 0.0005);
    EXPECT_EQ(kilograms.problem.units.force, "N");
    EXPECT_TRUE(says(read(cam(closed + "[dynamics]\nmass = 0.5\n")), "p.toml:22:8", {"warning", "kg"}));
    EXPECT_TRUE(says(read(cam(closed + "[units]\nmass = \"kg\"\nlength = \"furlong\"\n")), "p.toml:22:8",
                     {"'kg'", "mm, cm, m, in or ft", "furlong"}));
    EXPECT_TRUE(says(read(cam(closed + "[units]\nforce = \"dyn\"\n")), "p.toml:22:9", {"'dyn'", "lbf"}));
    EXPECT_TRUE(says(read(cam(closed + "[dynamics]\nmass = -0.5\n")), "p.toml:22:8",
                     {"'mass' in [dynamics]", "greater than 0"}));
    EXPECT_TRUE(
        says(read(cam(closed + "[dynamics]\nfriction = 1.5\n")), "p.toml:22:12", {"'friction'", "less than 1"}));
}

TEST(Cam, ReportsAllErrorsAtOnce) {
    const ReadProblem all = read(cam(moving("climb", "90", "20") + moving("return", "-5", "x")));
    EXPECT_FALSE(all.ok());
    EXPECT_TRUE(says(read(cam(moving("climb", "90", "20") + moving("return", "-5", "1"))), "p.toml:9:8",
                     {"unknown kind of segment 'climb'", "rise, return, dwell, cycle"}));
    EXPECT_TRUE(says(read(cam(moving("climb", "90", "20") + moving("return", "-5", "1"))), "p.toml:15:9",
                     {"'angle' in segment 2"}));
}

TEST(Cam, TakesSoManySegmentsNumbersAndLawsAndNoMore) {
    std::string many;
    for (int i = 0; i < 13; ++i)
        many += moving(i % 2 == 0 ? "rise" : "return", "20", "5");
    EXPECT_TRUE(only_says(read(cam(many)), "p.toml:8:1", {"13 segments are too many", "12"}));
    const auto spline = [](const std::string& kind) {
        return moving(kind, "90", "20", "\"spline\"") + "shape = [1, 1, 1, 1, 1, 1]\n";
    };
    EXPECT_TRUE(says(read(cam(spline("rise") + spline("return") + spline("rise") + spline("return"))), "p.toml:25:22",
                     {"more than 16 numbers together"}));
    std::string choices;
    for (int i = 0; i < 8; ++i)
        choices += moving(i % 2 == 0 ? "rise" : "return", "45", "5", R"(["harmonic", "cycloidal", "3-4-5"])");
    EXPECT_TRUE(only_says(read(cam(choices)), "p.toml:8:1", {"6561 combinations"}));
}

TEST(Cam, SegmentsAreSectionsThatSayWhatTheyNeed) {
    const std::string head = "schema = 1\nmechanism = \"cam\"\nsegment = 5\n[cam]\nfollower = \"knife\"\n";
    EXPECT_TRUE(says(read(head), "p.toml:3:11", {"each headed [[segment]] in double brackets"}));
    EXPECT_TRUE(
        only_says(read(cam(moving("rise", "90", "20") + dwell("90") + "lift = 3\n" + moving("return", "180", "20"))),
                  "p.toml:16:1", {"a dwell has none"}));
    EXPECT_TRUE(
        says(read(cam(moving("rise", "180", "20", "\"spline\"") + "shape = 1\n" + moving("return", "180", "20"))),
             "p.toml:13:9", {"a list of numbers or ranges"}));
    EXPECT_TRUE(
        says(read(cam(moving("rise", "180", "20", "\"polynomial\"") + "end = \"U\"\n" + moving("return", "180", "20"))),
             "p.toml:13:7", {"an end of kind U needs its acceleration: write end = { acceleration = ... }"}));
}

TEST(Cam, IsJudgedOverItsFullTurn) {
    EXPECT_TRUE(
        says(read(cam(closed + "[motion]\ncrank_range = [0, 90]\n")), "p.toml:22:15", {"leave crank_range out"}));
}

}  // namespace mechwright::test

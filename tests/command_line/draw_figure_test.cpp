// mechwright draw --figure

#include "tests/command_line/program.h"
#include "tests/report/temporary_folder.h"

namespace mechwright::testing {
namespace {

TEST(DrawFigure, IsOfAMechanismByItsNameOrByAProblem) {
    const Outcome named = run({"draw", "--figure", "four-bar"});
    EXPECT_EQ(named.exit_code, 0) << named.err;
    for (const char* part : {"<svg", ">input-start<", ">body-angle<", ">point-across<", ">A0<", ">rocker<"})
        expect_has(named.out, part);
    const Outcome of_problem = run({"draw", "--figure", MECHWRIGHT_SOURCE_DIR "/problems/four-bar/crank-rocker.toml"});
    EXPECT_EQ(of_problem.exit_code, 0) << of_problem.err;
    for (const char* part : {">rocker<", ">point-across<", ">tilt<"})
        expect_has(of_problem.out, part);
    // What no target brings is not there.
    for (const char* part : {">input-start<", ">line-angle<"})
        expect_has_not(of_problem.out, part);
}

TEST(DrawFigure, IsOfALinkageOfAFile) {
    const Outcome outcome = run({"draw", "--figure", MECHWRIGHT_SOURCE_DIR "/problems/linkage/landing-gear.toml"});
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    for (const char* part : {">brace-x<", ">hold<", ">leg<", ">W<"})
        expect_has(outcome.out, part);
}

TEST(DrawFigure, IsWrittenAsOtherDrawingsAre) {
    const TemporaryFolder folder;
    for (const char* name : {"figure.svg", "figure.png", "figure.pdf"}) {
        const Outcome outcome = run({"draw", "--figure", "cam", "--out", folder / name});
        EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
        EXPECT_GT(content_of(folder / name).size(), 1000u);
    }
}

TEST(DrawFigure, IsOneBelowTheOtherWhereThereIsNoRoom) {
    const Outcome narrow = run({"draw", "--figure", "four-bar", "--width", "100"});
    EXPECT_EQ(narrow.exit_code, 0) << narrow.err;
    expect_has(narrow.out, "width=\"380\"");
}

TEST(DrawFigure, SaysWhatIsWrong) {
    const Outcome unknown = run({"draw", "--figure", "four-bra"});
    EXPECT_EQ(unknown.exit_code, 2);
    expect_has(unknown.err, "did you mean 'four-bar'?");
    const Outcome both = run({"draw", "--figure", "cam", "--skeleton"});
    EXPECT_EQ(both.exit_code, 2);
    expect_has(both.err, "--figure is of a mechanism");
}

}  // namespace
}  // namespace mechwright::testing

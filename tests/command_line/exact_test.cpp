// Options of the exact method: all solutions as a table, start systems from files.

#include "tests/command_line/program.h"
#include "tests/report/temporary_folder.h"

namespace mechwright::testing {
namespace {

const std::string three_and_four = MECHWRIGHT_SOURCE_DIR "/problems/exact/three-poses-four-points.toml";

TEST(Exact, AllSolutionsAreWrittenAsATable) {
    const TemporaryFolder folder;
    const std::string out = folder / "out";
    const Outcome outcome = run({"solve", "--all", "--csv", "--out", out, three_and_four});
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    expect_has(outcome.err, "three-poses-four-points.solutions.csv");
    const std::string table = content_of(out + "/three-poses-four-points.solutions.csv");
    expect_has(table, "number,defect,objective,ground [mm],crank [mm]");
    expect_has(table, "body-angle [deg],assembly,crank-angle-1 [deg]");
    // The header, and both dyads of each of the 22 real pairs as the crank's.
    EXPECT_EQ(std::count(table.begin(), table.end(), '\n'), 1 + 2 * 22);
    expect_has(table, "\n1,,");
    expect_has(table, "branch: it has to be taken apart");
    const Outcome fewer = run({"solve", "--csv", "--out", folder / "other", three_and_four});
    expect_has_not(fewer.err, "solutions.csv");
}

TEST(Exact, FourPosesHaveTheirBurmesterCurvesAsATable) {
    const TemporaryFolder folder;
    const std::string out = folder / "out";
    const Outcome outcome =
        run({"solve", "--csv", "--out", out, MECHWRIGHT_SOURCE_DIR "/problems/exact/four-poses.toml"});
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    expect_has(outcome.err, "four-poses.csv and ");
    const std::string table = content_of(out + "/four-poses.burmester.csv");
    expect_has(table, "stretch,fixed-x [mm],fixed-y [mm],moving-x [mm],moving-y [mm]\n1,");
    EXPECT_GT(std::count(table.begin(), table.end(), '\n'), 100);
}

TEST(Exact, BeginsWithAGivenStartSystem) {
    const TemporaryFolder folder;
    const Outcome made = run({"start-system", "3-poses-4-points", "--seed", "7", "--quiet"});
    ASSERT_EQ(made.exit_code, 0) << made.err;
    const std::string start = folder.write("start.txt", made.out);
    const Outcome outcome = run({"solve", "--start-system", start, three_and_four});
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    expect_has(outcome.out, "22 real");

    std::string other = made.out;
    other.replace(other.find("version 1"), 9, "version 2");
    const Outcome version = run({"solve", "--start-system", folder.write("other.txt", other), three_and_four});
    EXPECT_EQ(version.exit_code, 3);
    expect_has(version.err, "another version");
    expect_has(version.err, "mechwright start-system makes one anew");
    const Outcome half = run(
        {"solve", "--start-system", folder.write("half.txt", made.out.substr(0, made.out.size() / 2)), three_and_four});
    EXPECT_EQ(half.exit_code, 3);
    expect_has(half.err, "it is damaged");
    EXPECT_EQ(run({"solve", "--start-system", folder / "none.txt", three_and_four}).exit_code, 6);
    const Outcome unknown = run({"start-system", "ten-point"});
    EXPECT_EQ(unknown.exit_code, 2);
    expect_has(unknown.err, "4-poses-2-points");
}

}  // namespace
}  // namespace mechwright::testing

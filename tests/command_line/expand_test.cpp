// mechwright expand, and the instant centres of analyse and draw.

#include <nlohmann/json.hpp>

#include "tests/command_line/program.h"
#include "tests/report/temporary_folder.h"

namespace mechwright::testing {
namespace {

const std::string shipped_problems = MECHWRIGHT_SOURCE_DIR "/problems/";

TEST(Expand, PrintsAProblemThatTheProgramReads) {
    const TemporaryFolder folder;
    const Outcome expanded = run({"expand", shipped_problems + "four-bar/crank-rocker.toml"});
    EXPECT_EQ(expanded.exit_code, 0);
    EXPECT_EQ(expanded.err, "");
    const std::string file = folder.write("linkage.toml", expanded.out);
    const Outcome checked = run({"check", file});
    EXPECT_EQ(checked.exit_code, 0);
    EXPECT_EQ(checked.err, "");
    const Outcome again = run({"expand", file});
    EXPECT_EQ(again.exit_code, 3);
    expect_has(again.err, "this is a linkage already");
}

TEST(Expand, PutsInTheDesignOfAResult) {
    const TemporaryFolder folder;
    const std::string problem = shipped_problems + "quick-return/drag-link-given.toml";
    const std::string result = folder.write("result.json", run({"solve", "--quiet", "--json", problem}).out);
    const Outcome given = run({"expand", problem, "--result", result});
    EXPECT_EQ(given.exit_code, 0);
    expect_has(given.out, "side = \"left\"");
    EXPECT_EQ(run({"expand", problem, "--starts"}).exit_code, 2);
    EXPECT_EQ(run({"expand", problem, "--result", folder / "missing.json"}).exit_code, 6);
    EXPECT_EQ(run({"expand", problem, "--result", problem}).exit_code, 3);
    EXPECT_EQ(run({"expand", folder / "missing.toml"}).exit_code, 6);
}

TEST(Expand, NamesWhatItCannotCarry) {
    const std::string problem = shipped_problems + "quick-return/uniform-speed-whitworth.toml";
    const Outcome refused = run({"expand", problem});
    EXPECT_EQ(refused.exit_code, 3);
    EXPECT_EQ(refused.out, "");
    expect_has(refused.err, problem + ":31:12: a linkage has no 'speed-variation'");
}

TEST(InstantCentres, AreListedAndDrawn) {
    const std::string problem = shipped_problems + "quick-return/drag-link-given.toml";
    const Outcome listed = run({"analyse", problem, "--instant-centres", "--at", "90"});
    EXPECT_EQ(listed.exit_code, 0);
    expect_has(listed.out, "Instant centres at 90: 15");
    expect_has(listed.out, "frame, ram         at infinity in the direction 90 deg");
    const auto json = nlohmann::json::parse(run({"analyse", problem, "--instant-centres", "--at", "90", "--json"}).out);
    EXPECT_EQ(json["instant-centres"].size(), 15u);
    EXPECT_EQ(json["instant-centres"][2]["links"], nlohmann::json::array({"crank", "coupler"}));
    EXPECT_NEAR(json["instant-centres"][2]["at"][1].get<double>(), 100, 1e-12);
    const Outcome drawn = run({"draw", problem, "--instant-centres", "--at", "90"});
    EXPECT_EQ(drawn.exit_code, 0);
    expect_has(drawn.out, ">frame, rod</text>");
    EXPECT_EQ(run({"analyse", problem, "--at", "90"}).exit_code, 2);
    EXPECT_EQ(run({"analyse", problem, "--instant-centres", "--at", "x"}).exit_code, 2);
    EXPECT_EQ(run({"analyse", shipped_problems + "cam/eccentric.toml", "--instant-centres"}).exit_code, 3);
}

}  // namespace
}  // namespace mechwright::testing

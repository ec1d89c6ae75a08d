// mechwright compare

#include "tests/command_line/problems.h"
#include "tests/command_line/program.h"
#include "tests/report/temporary_folder.h"

namespace mechwright::testing {
namespace {

using Json = nlohmann::ordered_json;

/// The same task for two mechanisms, each solved in no time.
const std::string shaper = R"(schema = 1
mechanism = "crank-shaper"

[dimensions]
centre-distance = 300
crank           = { min = 50, max = 290 }
lever           = { min = 100, max = 600 }
rod             = 150
ram-distance    = { min = 100, max = 600 }

[[require]]
quantity = "time-ratio"
equal    = 2

[[require]]
quantity = "stroke"
equal    = 200

[objective]
minimize = "speed-variation"
)";

const std::string whitworth = R"(schema = 1
mechanism = "whitworth"

[dimensions]
centre-distance = 100
crank           = { min = 105, max = 600 }
arm             = { min = 50, max = 300 }
rod             = 500
slide-angle     = { min = -180, max = 180 }

[[require]]
quantity = "time-ratio"
equal    = 2

[[require]]
quantity = "stroke"
equal    = 200

[objective]
minimize = "speed-variation"
)";

struct TwoDrives {
    TemporaryFolder folder;
    std::string a = folder.write("whitworth.toml", whitworth);
    std::string b = folder.write("shaper.toml", shaper);
};

TEST(Compare, PrintsOneTableBestFirst) {
    const TwoDrives files;
    const Outcome outcome = run({"compare", files.a, files.b});
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    for (const char* part : {"mechanism", "objective", "size", "worst", "time", "stroke", "speed", "variation"})
        expect_has(outcome.out, part);
    EXPECT_LT(outcome.out.find("crank-shaper"), outcome.out.find("whitworth")) << outcome.out;
    expect_has(outcome.out, "Best: shaper, minimize speed-variation = 0.1618");
    expect_has_not(outcome.err, "differ");
}

TEST(Compare, JsonIsAListOfAllValuesAndResults) {
    const TwoDrives files;
    const Outcome outcome = run({"compare", "--json", files.a, files.b});
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    const Json json = parsed(outcome.out);
    ASSERT_TRUE(json.is_array());
    ASSERT_EQ(json.size(), 2u);
    EXPECT_EQ(json[0]["file"], files.b);
    EXPECT_EQ(json[1]["mechanism"], "whitworth");
    for (const Json& row : json) {
        EXPECT_EQ(row["status"], "solved");
        EXPECT_NEAR(row["time-ratio"], 2, 1e-8);
        EXPECT_NEAR(row["stroke"], 200, 1e-6);
        EXPECT_EQ(row["objective"], row["speed-variation"]);
        EXPECT_EQ(row["result"]["verification"]["passed"], true);
        EXPECT_EQ(row["result"]["quantities"]["total-length"], row["total-length"]);
    }
    EXPECT_LT(json[0]["objective"], json[1]["objective"]);
}

TEST(Compare, CsvHasARowForEachFile) {
    const TwoDrives files;
    const Outcome outcome = run({"compare", "--csv", files.a, files.b});
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    std::istringstream lines(outcome.out);
    std::string heading, first, second, more;
    std::getline(lines, heading);
    std::getline(lines, first);
    std::getline(lines, second);
    EXPECT_EQ(heading,
              "file,mechanism,status,objective,total-length,transmission-angle-worst,time-ratio,stroke,"
              "speed-variation,cam-size,pressure-angle-max");
    EXPECT_EQ(first.rfind(files.b + ",crank-shaper,solved,0.1617", 0), 0u) << first;
    EXPECT_EQ(second.rfind(files.a + ",whitworth,solved,", 0), 0u) << second;
    EXPECT_FALSE(std::getline(lines, more)) << more;
    EXPECT_EQ(run({"compare", "--csv", "--json", files.a, files.b}).exit_code, 2);
}

/// A long search that is stopped has the better design by then.
TEST(Compare, DesignsOfStoppedSearchesCount) {
    const TemporaryFolder folder;
    const std::string power =
        "[function]\nexpression = \"x^1.5\"\nx = [1, 4]\ninput = { start = 210, range = 90 }\n"
        "output = { start = 270, range = 90 }\n[objective]\nminimize = \"function-max\"\n";
    const std::string given = folder.write(
        "given.toml",
        "schema = 1\nmechanism = \"four-bar\"\n[dimensions]\nground = 5\ncrank = 9\ncoupler = 14.5\nrocker = 11.5\n" +
            power);
    const std::string searched = folder.write(
        "searched.toml",
        "schema = 1\nmechanism = \"four-bar\"\n[dimensions]\nground = 5\ncrank = { min = 2, max = 20 }\ncoupler = { "
        "min = 2, max = 30 }\nrocker = { min = 2, max = 30 }\n" +
            power + "[solver]\nmethod = \"slsqp\"\nstarts = 100000\n");
    const Outcome outcome = run({"compare", given, searched, "--time-limit", "1"});
    EXPECT_EQ(outcome.exit_code, 5) << outcome.err;
    expect_has(outcome.out, "searched was stopped at a limit: its design is the best so far.");
    expect_has(outcome.out, "Best: searched, minimize function-max = ");
    const Json json = parsed(run({"compare", "--json", given, searched, "--time-limit", "1"}).out);
    EXPECT_EQ(json[0]["status"], "limit");
    EXPECT_LT(json[0]["objective"], json[1]["objective"]);
}

TEST(Compare, NeedsTwoFiles) {
    const TwoDrives files;
    for (const std::vector<std::string>& arguments :
         {std::vector<std::string>{"compare"}, std::vector<std::string>{"compare", files.a}}) {
        const Outcome outcome = run(arguments);
        EXPECT_EQ(outcome.exit_code, 2);
        EXPECT_EQ(outcome.out, "");
        EXPECT_NE(outcome.err, "");
    }
}

TEST(Compare, SaysWhatIsAskedDifferently) {
    const TwoDrives files;
    std::string other = shaper;
    other.replace(other.find("= 200"), 5, "= 150");
    const std::string c = files.folder.write("other.toml", other);
    const Outcome outcome = run({"compare", files.a, c});
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    expect_has(outcome.err, "The tasks differ: ");
    expect_has(outcome.err, "stroke = 150 mm");
    expect_has(outcome.err, "stroke = 200 mm");
    expect_has_not(run({"compare", "--quiet", files.a, c}).err, "differ");
}

TEST(Compare, AFourBarHasOnlyWhatItHas) {
    const TemporaryFolder folder;
    const std::string a = folder.write("a.toml", crank_rocker());
    const std::string b = folder.write("b.toml", whitworth);
    const Outcome outcome = run({"compare", a, b});
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    expect_has(outcome.out, "four-bar");
    expect_has_not(outcome.out, "Best:");  // two objectives
    const Json json = parsed(run({"compare", "--json", a, b}).out);
    EXPECT_FALSE(json[0].contains("stroke"));
    EXPECT_TRUE(json[1].contains("stroke"));
}

TEST(Compare, ADesignThatCannotBeStandsBelowTheOthers) {
    const TemporaryFolder folder;
    const std::string bad = folder.write("bad.toml", impossible);
    const std::string good = folder.write("good.toml", crank_rocker());
    const Outcome outcome = run({"compare", bad, good});
    EXPECT_EQ(outcome.exit_code, 4) << outcome.err;
    EXPECT_LT(outcome.out.find("good"), outcome.out.find("bad")) << outcome.out;
    expect_has(outcome.out, "infeasible");
}

TEST(Compare, AnInvalidFileDoesNotHideTheOthers) {
    const TwoDrives files;
    const std::string invalid = files.folder.write("invalid.toml", "schema = 1\n");
    const Outcome outcome = run({"compare", invalid, files.a, files.b});
    EXPECT_EQ(outcome.exit_code, 3);
    expect_has(outcome.err, invalid);
    expect_has(outcome.out, "crank-shaper");
    const Outcome nothing = run({"compare", invalid, files.folder.path.string() + "/missing.toml"});
    EXPECT_EQ(nothing.out, "");
    EXPECT_EQ(nothing.exit_code, 6) << nothing.err;
}

TEST(Compare, WritesResultsToo) {
    const TwoDrives files;
    const std::string out = files.folder.path.string() + "/out";
    EXPECT_EQ(run({"compare", "--out", out, files.a, files.b}).exit_code, 0);
    const Outcome checked = run({"verify", out + "/shaper.json", out + "/whitworth.json"});
    EXPECT_EQ(checked.exit_code, 0) << checked.out << checked.err;
}

}  // namespace
}  // namespace mechwright::testing

// mechwright quantities, mechwright methods, mechwright schema

#include "tests/command_line/problems.h"
#include "tests/command_line/program.h"
#include "tests/report/temporary_folder.h"

namespace mechwright::testing {
namespace {

TEST(Quantities, AreListedWithUnitAndMeaning) {
    const Outcome all = run({"quantities"});
    EXPECT_EQ(all.exit_code, 0);
    EXPECT_EQ(all.err, "");
    for (const char* part :
         {"four-bar: ", "  time-ratio                number  ", "  swing                     angle   ",
          "  total-length              length  ", "  path-sse                  area    "})
        expect_has(all.out, part);
    std::istringstream lines(all.out);
    for (std::string line; std::getline(lines, line);)
        EXPECT_LE(line.size(), 80u) << line;
    const Outcome one = run({"quantities", "four-bar"});
    EXPECT_EQ(one.exit_code, 0);
    expect_has(all.out, one.out);
}

TEST(Quantities, AreListedByAWordAndForPrograms) {
    const Outcome strokes = run({"quantities", "--about", "stroke"});
    EXPECT_EQ(strokes.exit_code, 0) << strokes.err;
    for (const char* part : {"crank-shaper: ", "  stroke  ", "  time-ratio "})
        expect_has(strokes.out, part);
    EXPECT_EQ(strokes.out.find("total-length"), std::string::npos);
    EXPECT_EQ(strokes.out.find("cam: "), std::string::npos);
    const auto json = parsed(run({"quantities", "whitworth", "--about", "stroke", "--json"}).out);
    ASSERT_EQ(json.size(), 1);
    EXPECT_EQ(json[0]["mechanism"], "whitworth");
    for (const auto& quantity : json[0]["quantities"])
        EXPECT_NE(quantity.dump().find("stroke"), std::string::npos) << quantity;
    const auto all = parsed(run({"quantities", "whitworth", "--json"}).out);
    EXPECT_GT(all[0]["quantities"].size(), json[0]["quantities"].size());
    const Outcome none = run({"quantities", "four-bar", "--about", "flavour"});
    EXPECT_EQ(none.exit_code, 2);
    EXPECT_EQ(none.out, "");
    expect_has(none.err, "'flavour'");
}

TEST(Quantities, OfAnUnknownMechanism) {
    const Outcome outcome = run({"quantities", "for-bar"});
    EXPECT_EQ(outcome.exit_code, 2);
    EXPECT_EQ(outcome.out, "");
    expect_has(outcome.err, "unknown mechanism 'for-bar'; did you mean 'four-bar'?");
}

TEST(Quantities, OfAFileAreWhatItCanAskFor) {
    const Outcome six_bar = run({"quantities", shipped_file("linkage/dwell-six-bar.toml")});
    EXPECT_EQ(six_bar.exit_code, 0) << six_bar.err;
    for (const char* part : {"  swing-angle.range         angle ", "  transmission-angle-worst  angle ",
                             "  NAME.at(60)", "  NAME.speed.greatest"})
        expect_has(six_bar.out, part);
    std::istringstream lines(six_bar.out);
    for (std::string line; std::getline(lines, line);)
        EXPECT_LE(line.size(), 80u) << line;
    expect_has(run({"quantities", shipped_file("linkage/six-bar-timed-points.toml")}).out,
               "  path-rms                  length");
    EXPECT_NE(run({"quantities", "no-such-file.toml"}).exit_code, 0);
    const Outcome kind = run({"quantities", "linkage"});
    EXPECT_EQ(kind.exit_code, 2);
    expect_has(kind.err, "mechwright quantities FILE");
}

TEST(Methods, AreListed) {
    const Outcome outcome = run({"methods"});
    EXPECT_EQ(outcome.exit_code, 0);
    EXPECT_EQ(outcome.out.rfind("auto", 0), 0u) << outcome.out;
    expect_has(outcome.out, "slsqp");
}

TEST(Methods, OfAProblemSayWhyTheyDoNotApply) {
    const TemporaryFolder folder;
    const Outcome of_path = run({"methods", folder.write("path.toml", long_search())});
    EXPECT_EQ(of_path.exit_code, 0);
    expect_has(of_path.out, "slsqp             applies");
    expect_has(of_path.out, "closed-form       no       ");
    const Outcome of_crank_rocker = run({"methods", folder.write("a.toml", crank_rocker())});
    expect_has(of_crank_rocker.out, "auto              applies");
    EXPECT_EQ(run({"methods", folder / "missing.toml"}).exit_code, 6);
    EXPECT_EQ(run({"methods", folder.write("bad.toml", "schema = 1\n")}).exit_code, 3);
}

TEST(Methods, AFileThatNamesNoneOfThemCanStillAskForThem) {
    const TemporaryFolder folder;
    const std::string file = folder.write("a.toml", crank_rocker("[solver]\nmethod = \"magic\"\n"));
    EXPECT_EQ(run({"methods", file}).exit_code, 0);
}

TEST(Schemas, AreThoseOfProblemsAndResults) {
    for (const std::string document : {"problem", "result"}) {
        const Outcome outcome = run({"schema", document});
        EXPECT_EQ(outcome.exit_code, 0);
        EXPECT_EQ(outcome.err, "");
        expect_has(outcome.out, "\"title\": \"mechwright " + document + "\"");
    }
    const Outcome unknown = run({"schema", "study"});
    EXPECT_EQ(unknown.exit_code, 2);
    EXPECT_EQ(unknown.out, "");
    expect_has(unknown.err, "there is no schema of 'study'; there are those of problem and result");
}

}  // namespace
}  // namespace mechwright::testing

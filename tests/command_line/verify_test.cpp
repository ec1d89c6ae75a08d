// mechwright verify

#include "tests/command_line/problems.h"
#include "tests/command_line/program.h"
#include "tests/report/temporary_folder.h"

namespace mechwright::testing {
namespace {

using Json = nlohmann::ordered_json;

/// The document of a solved problem.
Json solved(const TemporaryFolder& folder) {
    return parsed(run({"solve", "--json", folder.write("a.toml", crank_rocker())}).out);
}

TEST(Verify, PrintsEachCheck) {
    const TemporaryFolder folder;
    const std::string file = folder.write("a.json", solved(folder).dump());
    const Outcome outcome = run({"verify", file});
    EXPECT_EQ(outcome.exit_code, 0) << outcome.out;
    EXPECT_EQ(outcome.err, "");
    EXPECT_EQ(outcome.out.rfind(file + ": verified, all ", 0), 0u) << outcome.out;
    expect_has(outcome.out, "\n  passed  ");
    expect_has_not(outcome.out, "FAILED");
    EXPECT_EQ(run({"verify", "--quiet", file}).out, "");
}

TEST(Verify, ATamperedDesignEndsWithSeven) {
    const TemporaryFolder folder;
    Json json = solved(folder);
    const std::string good = folder.write("good.json", json.dump());
    json["design"]["crank"] = json["design"]["crank"].get<double>() * 1.01;
    const std::string bad = folder.write("bad.json", json.dump());
    const Outcome outcome = run({"verify", good, bad});
    EXPECT_EQ(outcome.exit_code, 7);
    expect_has(outcome.out, good + ": verified");
    expect_has(outcome.out, bad + ": NOT verified");
    expect_has(outcome.out, "  FAILED  ");
    const Outcome quiet = run({"verify", "--quiet", good, bad});
    expect_has_not(quiet.out, "passed  ");
    expect_has(quiet.out, "FAILED");
}

TEST(Verify, AListIsVerifiedOneByOne) {
    const TemporaryFolder folder;
    Json good = solved(folder);
    Json bad = good;
    bad["design"]["rocker"] = 81.0;
    const std::string file = folder.write("list.json", Json::array({good, bad}).dump());
    const Outcome outcome = run({"verify", file});
    EXPECT_EQ(outcome.exit_code, 7);
    expect_has(outcome.out, "(1 of 2): verified");
    expect_has(outcome.out, "(2 of 2): NOT verified");
}

TEST(Verify, SaysWhetherAResultAnswersAProblem) {
    const TemporaryFolder folder;
    const std::string file = folder.write("a.json", solved(folder).dump());
    const std::string same = folder.write("same.toml", "# the same in other words\n" + crank_rocker());
    EXPECT_EQ(run({"verify", file, "--problem", same}).exit_code, 0);
    std::string text = crank_rocker();
    text.replace(text.find("ground"), 6, "ground-x");
    EXPECT_EQ(run({"verify", file, "--problem", folder.write("wrong.toml", text)}).exit_code, 3);
    text = crank_rocker();
    const std::size_t title = text.find("title");
    text = title == std::string::npos
               ? text + "[solver]\ntolerance = 1e-3\n"
               : text.substr(0, title) + "title = \"other\"\n" + text.substr(text.find('\n', title) + 1);
    const Outcome other = run({"verify", file, "--problem", folder.write("other.toml", text)});
    EXPECT_EQ(other.exit_code, 7) << other.out;
    expect_has(other.out, "FAILED  answers ");
}

TEST(Verify, AnInfeasibleResultThatSaysSoPasses) {
    const TemporaryFolder folder;
    const Outcome outcome = run({"solve", "--json", folder.write("a.toml", impossible)});
    ASSERT_EQ(outcome.exit_code, 4);
    EXPECT_EQ(run({"verify", folder.write("a.json", outcome.out)}).exit_code, 0);
}

TEST(Verify, WhatIsNotAResultEndsWithThree) {
    const TemporaryFolder folder;
    Json newer = solved(folder);
    newer["schema"] = 2;
    const std::string huge_number = R"({"schema": 1e400})";
    for (const std::string& text :
         {std::string(), std::string("nonsense"), std::string("{"), std::string("{}"), std::string("null"),
          std::string("\"text\""), std::string("1"), std::string("[1]"), std::string(R"({"schema": 1})"),
          std::string(R"({"schema": "1", "problem": {}})"), std::string("\0\xff\xfe", 3), newer.dump(), huge_number,
          std::string(100000, '['), crank_rocker()}) {
        const Outcome outcome = run({"verify", folder.write("a.json", text)});
        EXPECT_EQ(outcome.exit_code, 3) << text.substr(0, 100);
        EXPECT_EQ(outcome.out, "");
        expect_has(outcome.err, "not a result document");
    }
}

TEST(Verify, AResultWithoutItsDesignIsNotVerified) {
    const TemporaryFolder folder;
    Json json = solved(folder);
    json.erase("design");
    const Outcome outcome = run({"verify", folder.write("a.json", json.dump())});
    EXPECT_EQ(outcome.exit_code, 7) << outcome.out;
}

TEST(Verify, WhatCannotBeReadEndsWithSix) {
    const TemporaryFolder folder;
    for (const std::string& file : {folder / "missing.json", folder.path.string()}) {
        const Outcome outcome = run({"verify", file});
        EXPECT_EQ(outcome.exit_code, 6);
        expect_has(outcome.err, file);
    }
    const std::string good = folder.write("good.json", solved(folder).dump());
    EXPECT_EQ(run({"verify", folder / "missing.json", good, folder.write("bad.json", "{}")}).exit_code, 6);
}

TEST(Verify, TextOfTheDocumentCannotCommandTheTerminal) {
    const TemporaryFolder folder;
    Json json = solved(folder);
    json["requirements"][0]["quantity"] = "\x1b[2J";
    const Outcome outcome = run({"verify", folder.write("a.json", json.dump())});
    EXPECT_NE(outcome.exit_code, 0);
    expect_has_not(outcome.out + outcome.err, "\x1b");
}

TEST(Verify, DocumentsThatAreTooLargeAreNotRead) {
    const TemporaryFolder folder;
    const std::string file = folder.write("a.json", "{");
    std::filesystem::resize_file(file, std::uintmax_t{1} << 40);
    const Outcome outcome = run({"verify", file});
    EXPECT_EQ(outcome.exit_code, 6);
    expect_has(outcome.err, "larger than 64 MB");
}

}  // namespace
}  // namespace mechwright::testing

// Result documents of the drives, made by analysing given designs, and what verification says of spoilt ones.

#include <gtest/gtest.h>

#include "synthesis/document/document.h"
#include "synthesis/problem/reader.h"
#include "synthesis/solve/solve.h"
#include "tests/long_form.h"
#include "tests/verify/documents.h"

namespace mechwright {

namespace {

using namespace test;

struct Drive {
    const char* mechanism;
    const char* dimensions;
};

constexpr Drive drives[] = {
    {"slider-crank", "crank = 40\nrod = 120\noffset = 25\n"},
    {"crank-shaper", "centre-distance = 300\ncrank = 150\nlever = 200\nrod = 150\nram-distance = 190\n"},
    {"whitworth", "centre-distance = 100\ncrank = 150\narm = 80\nrod = 300\nslide-angle = 70\n"},
    {"drag-link",
     "ground = 30\ncrank = 60\ncoupler = 70\nfollower = 80\narm = 60\narm-angle = 10\nrod = 200\nslide-angle = "
     "30\nslide-offset = 5\n"},
};

/// The result of a problem in which everything is given and nothing is asked.
Json analysed(const Drive& drive, const std::string& more = "") {
    const ReadProblem read = parse_problem(
        "schema = 1\nmechanism = \"" + std::string(drive.mechanism) + "\"\n[dimensions]\n" + drive.dimensions + more,
        "given.toml");
    for (const Message& m : read.messages)
        ADD_FAILURE() << to_string(m);
    return document(read.problem, solve(read.problem, {}));
}

TEST(RamDocument, OfEveryDriveIsConfirmed) {
    for (const Drive& drive : drives) {
        const Json json = analysed(drive, "[quick-return]\nworking-share = 0.5\n");
        EXPECT_EQ(json["status"], "solved") << drive.mechanism;
        EXPECT_EQ(json["settings"]["working-share"], 0.5);
        EXPECT_TRUE(json["quantities"].contains("speed-variation")) << json.dump(1);
        EXPECT_TRUE(failures(json).empty()) << drive.mechanism << "\n" << told(verify(json));
    }
}

TEST(RamDocument, OfAnotherWorkingShareIsNot) {
    for (const Drive& drive : drives) {
        Json json = analysed(drive, "[quick-return]\nworking-share = 0.5\n");
        json["settings"]["working-share"] = 0.50001;
        EXPECT_FALSE(failures(json).empty()) << drive.mechanism;
        json.erase("settings");  // then the preset holds
        EXPECT_FALSE(failures(json).empty()) << drive.mechanism;
    }
}

TEST(RamDocument, OfAChangedQuantityIsNot) {
    for (const Drive& drive : drives) {
        const Json good = analysed(drive);
        for (const auto& [name, value] : good["quantities"].items()) {
            Json json = good;
            json["quantities"][name] = value.get<double>() * (1 + 1e-6) + 1e-6;
            EXPECT_FALSE(failures(json).empty()) << drive.mechanism << ": " << name;
        }
    }
}

TEST(RamDocument, WithASettingThatCannotBeIsRefused) {
    for (const Json& share : {Json(0), Json(1), Json(-3), Json("0.6"), Json(), Json(1e308), Json::array({0.5})}) {
        Json json = analysed(drives[1]);
        json["settings"]["working-share"] = share;
        const auto checks = verify(json);
        ASSERT_EQ(checks.size(), 1u) << told(checks);
        EXPECT_FALSE(checks[0].passed);
        EXPECT_NE(checks[0].detail.find("working-share"), std::string::npos) << checks[0].detail;
    }
    Json json = analysed(drives[1]);
    json["settings"]["idle-share"] = 0.5;
    EXPECT_NE(told(verify(json)).find("idle-share"), std::string::npos) << told(verify(json));
}

/// The document with one quantity alone, the cheapest, and the first of its checks: each of the others takes its time.
Json briefly_analysed(const Drive& drive) {
    Json json = analysed(drive);
    json["quantities"] = {{"link-ratio", json["quantities"]["link-ratio"]}};
    Json& checks = json["verification"]["checks"];
    checks = Json::array({checks[0]});
    return json;
}

TEST(RamDocument, NeverThrowsWhateverItsMembersAre) {
    Json json = briefly_analysed(drives[0]);
    EXPECT_GT(verified_with_members_replaced(json), cases_to_try(30, 100));
    EXPECT_TRUE(failures(json).empty());
}

TEST(RamDocument, NeverThrowsWhateverTheMostDimensionsAre) {
    Json json = briefly_analysed(drives[3]);
    // The drives have all other members in common.
    for (const char* member : {"dimensions", "design"})
        EXPECT_GT(verified_with_members_replaced(json, json[member]), cases_to_try(27, 90));
    EXPECT_TRUE(failures(json).empty());
}

}  // namespace

}  // namespace mechwright

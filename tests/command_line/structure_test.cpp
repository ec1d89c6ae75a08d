// mechwright structure

#include <cmath>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <numbers>

#include "tests/command_line/program.h"
#include "tests/report/temporary_folder.h"
#include "tests/triad.h"

namespace mechwright::testing {
namespace {

std::string shipped_linkage(const std::string& name) {
    return std::string(MECHWRIGHT_SOURCE_DIR "/problems/linkage/") + name + ".toml";
}

TEST(Structure, TellsJointsMobilityGroupsAndAssemblies) {
    const Outcome outcome = run({"structure", shipped_linkage("jansen-leg")});
    EXPECT_EQ(outcome.exit_code, 0);
    EXPECT_EQ(outcome.err, "");
    for (const char* part : {"Jansen's leg", "links      8:", "pin O (frame, upper, lower)", "1 by rank, 1 by count",
                             "angle of crank against frame", "closed at Y, right of X to O", "reads b, j, m",
                             "Assemblies at the crank angle 90: 8", "as in the file", "T (30.3109, -82.5894)"})
        expect_has(outcome.out, part);
    std::istringstream lines(outcome.out);
    for (std::string line; std::getline(lines, line);)
        EXPECT_LE(line.size(), 80u) << line;
}

TEST(Structure, TellsProgramsTheSame) {
    const Outcome outcome = run({"structure", shipped_linkage("peaucellier"), "--json", "--at", "60"});
    EXPECT_EQ(outcome.exit_code, 0);
    const auto json = nlohmann::json::parse(outcome.out);
    EXPECT_EQ(json["links"].size(), 8u);
    EXPECT_EQ(json["mobility"]["mobility"], 1);
    EXPECT_EQ(json["groups"][3]["closed-at"], "Q");
    EXPECT_EQ(json["groups"][3]["side"], (nlohmann::json{{"side", "left"}, {"from", "U"}, {"to", "V"}}));
    EXPECT_EQ(json["groups"][0]["dimensions"], nlohmann::json::array({"arm"}));
    EXPECT_NEAR(json["crank"].get<double>(), 60, 1e-12);
    int as_in_file = 0;
    for (const auto& one : json["assemblies"]) {
        if (!one["as-in-file"].get<bool>()) continue;
        ++as_in_file;
        EXPECT_NEAR(one["points"]["Q"][0].get<double>(), 2.5, 1e-13);
        EXPECT_NEAR(one["points"]["Q"][1].get<double>(), 1.4433756729740644, 1e-13);
    }
    EXPECT_EQ(as_in_file, 1);
}

/// Of each segment the angle, and the lift unless it is a dwell.
TEST(Structure, TellsHowDrivesMove) {
    const auto drives =
        nlohmann::json::parse(run({"structure", shipped_linkage("pick-and-place"), "--json"}).out)["drives"];
    ASSERT_EQ(drives.size(), 2u);
    EXPECT_FALSE(drives[0].contains("segments"));
    EXPECT_FALSE(drives[1].contains("ratio"));
    double turn = 0, height = 0;
    for (const auto& segment : drives[1]["segments"]) {
        turn += segment["angle"].get<double>();
        EXPECT_EQ(segment.contains("lift"), segment["kind"] != "dwell");
        if (segment["kind"] != "dwell") height += segment["lift"].get<double>() * (segment["kind"] == "rise" ? 1 : -1);
        EXPECT_TRUE(segment["kind"] != "rise" || segment["lift"] == 30);
    }
    EXPECT_NEAR(turn, 360, 1e-11);
    EXPECT_NEAR(height, 0, 1e-11);
}

TEST(Structure, ExplainsWhatIsRedundantAndWhatIsNoDyad) {
    const Outcome redundant = run({"structure", shipped_linkage("parallelogram")});
    EXPECT_EQ(redundant.exit_code, 0);
    expect_has(redundant.out,
               "mobility   1 with these dimensions, 0 for almost all others, 0 by count;\n           redundant: third");
    expect_has(redundant.out, "coupler  kept parallel to frame by redundant links");
    expect_has(redundant.out, "redundant: it fits between its pins");

    const TemporaryFolder folder;
    const std::string triad = folder.write(
        "triad.toml",
        "schema = 1\nmechanism = \"linkage\"\n[links]\nframe = { A = [0, 0], D = [4, 0], G = [2, 5] }\n"
        "crank = { G = [0, 0], H = [1, 0] }\none = { A = [0, 0], P = [3, 0] }\ntwo = { D = [0, 0], Q = [3, 0] }\n"
        "three = { H = [0, 0], R = [3, 0] }\nplate = { P = [0, 0], Q = [2, 0], R = [1, 1] }\n[drive]\nlink = "
        "\"crank\"\n");
    const Outcome larger = run({"structure", triad});
    EXPECT_EQ(larger.exit_code, 0) << larger.err;
    expect_has(larger.out, "larger group  one, two, three, plate");
    expect_has(larger.out, "one, two, three, plate  ");
    expect_has(larger.out, " assemblies\n");
    expect_has(larger.out, "one+two+three+plate is a larger group");
    expect_has_not(larger.out, "as in the file");
    std::ofstream(triad, std::ios::app) << "[assembly]\n\"one+two+three+plate\" = { group = \"one+two+three+plate\", "
                                           "index = 2 }\n";
    const auto assemblies = nlohmann::json::parse(run({"structure", triad, "--json"}).out)["assemblies"];
    ASSERT_EQ(assemblies.size(), 2u);
    EXPECT_EQ(assemblies[0]["as-in-file"], false);
    EXPECT_EQ(assemblies[1]["as-in-file"], true);
}

/// Its longest and shortest links together are longer than the others: the crank turns until the dyad is folded, where
/// |BD| = 120 - 90, and both sides of the dyad are one circuit.
TEST(Structure, TellsCircuitsBranchesAndWhatEndsThem) {
    const TemporaryFolder folder;
    const std::string file =
        folder.write("rocking.toml",
                     "schema = 1\nmechanism = \"linkage\"\n[links]\n"
                     "frame = { A = [0, 0], D = [100, 0] }\ncrank = { A = [0, 0], B = [85, 0] }\n"
                     "coupler = { B = [0, 0], C = [90, 0] }\nrocker = { D = [0, 0], C = [120, 0] }\n"
                     "[drive]\nlink = \"crank\"\n");
    const auto circuits = nlohmann::json::parse(run({"structure", file, "--json"}).out)["circuits"];
    ASSERT_EQ(circuits.size(), 1u);
    ASSERT_EQ(circuits[0]["branches"].size(), 2u);
    const double end = std::acos((85. * 85 + 100 * 100 - 30 * 30) / (2 * 85 * 100)) * 180 / std::numbers::pi;
    for (const auto& branch : circuits[0]["branches"]) {
        EXPECT_NEAR(branch["from"].get<double>(), end, 1e-11);
        EXPECT_NEAR(branch["to"].get<double>(), 360 - end, 1e-11);
        EXPECT_EQ(branch["from-end"], "where the dyad closed at 'C' is folded");
        EXPECT_EQ(branch["to-end"], "where the dyad closed at 'C' is folded");
        EXPECT_FALSE(branch["whole"].get<bool>());
    }
    EXPECT_EQ(circuits[0]["branches"][0]["sides"]["C"], "left");
    EXPECT_EQ(circuits[0]["branches"][1]["sides"]["C"], "right");
    expect_has(run({"structure", file}).out, "Circuits: 1\n  1.1  C left; crank angle 16.");
    expect_has(run({"structure", shipped_linkage("stopped-slider")}).out, "at the stop 'max' of slide 'block'");
    expect_has(run({"structure", shipped_linkage("scissors-ram")}).out, "Assemblies at the displacement 625: 4");
}

TEST(Structure, SaysWhatIsWrong) {
    const TemporaryFolder folder;
    EXPECT_EQ(run({"structure", folder / "missing.toml"}).exit_code, 6);
    EXPECT_EQ(run({"structure", shipped_linkage("peaucellier"), "--at", "x"}).exit_code, 2);
    const Outcome loose = run({"structure", folder.write("loose.toml",
                                                         "schema = 1\nmechanism = \"linkage\"\n[links]\n"
                                                         "frame = { A = [0, 0] }\n"
                                                         "crank = { A = [0, 0], B = [1, 0] }\n"
                                                         "rod = { B = [0, 0], C = [1, 0] }\n"
                                                         "[drive]\nlink = \"crank\"\n")});
    EXPECT_EQ(loose.exit_code, 3);
    EXPECT_EQ(loose.out, "");
    expect_has(loose.err,
               "loose.toml:3:1: the linkage has mobility 2 (3 x 2 moving links - 2 x 2 pins = 2) and 1 drive; "
               "with the drives at rest 'rod' still moves. Add 1 drive");
    const Outcome other = run({"structure", MECHWRIGHT_SOURCE_DIR "/problems/four-bar/crank-rocker.toml"});
    EXPECT_EQ(other.exit_code, 3);
    expect_has(other.err, "linkage");
}

TEST(Structure, IsWhatOtherCommandsNameForALinkageThatTheyCannotPlace) {
    const TemporaryFolder folder;
    const std::string file = folder.write("triad.toml", testing::triad_text);
    EXPECT_EQ(run({"structure", file}).exit_code, 0);
    for (const char* command : {"check", "analyse", "solve", "draw", "methods"}) {
        const Outcome outcome = run({command, file});
        EXPECT_EQ(outcome.exit_code, 3) << command;
        EXPECT_EQ(outcome.out, "") << command;
        expect_has(outcome.err, "mechwright structure");
    }
}

}  // namespace
}  // namespace mechwright::testing

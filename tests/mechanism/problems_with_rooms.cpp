// Problems of built-in kinds with rooms and regions: solved, verified, refused where they are tampered with, and what
// is said of those that are wrong.

#include <fstream>
#include <iterator>

#include "synthesis/problem/linkage/of_kinds/expand.h"
#include "synthesis/solve/solve.h"
#include "tests/mechanism/kinds_with_rooms.h"

namespace mechwright::linkage_scans {

namespace {

std::string shipped_with(const std::string& name) {
    std::ifstream in(MECHWRIGHT_SOURCE_DIR "/problems/" + name + ".toml");
    return {std::istreambuf_iterator<char>(in), {}};
}

std::string shipped_wiper() { return shipped_with("four-bar/wiper-beside-column"); }

/// The box is as high as crank and rocker are long, so that the crank is what the cowl leaves to it.
TEST(ProblemsWithRooms, AreSolvedWhereRoomAndRegionBind) {
    ReadProblem read = testing::read_without_fault(shipped_wiper());
    ASSERT_TRUE(read.ok());
    read.problem.solver.starts = 6;
    const Json document = mechwright::document(read.problem, solve(read.problem, {}));
    EXPECT_EQ(document["status"], "solved");
    EXPECT_NEAR(value_in(document, "drive.height"), 101, 1e-6);
    EXPECT_NEAR(value_in(document, "column.margin"), 8, 1e-6);
    EXPECT_NEAR(document["design"]["crank"].get<double>(), 41, 1e-6);
    EXPECT_NEAR(document["objective"]["value"].get<double>(), 23.041066, 1e-5);
    EXPECT_EQ(document["requirements"].size(), 3u);
    EXPECT_EQ(document["region"][0]["name"], "column");
    EXPECT_FALSE(document.contains("linkage"));
    expect_verified(document);
}

/// Branch and bound knows nothing of rooms: it does not call an answer the best where one of them binds.
TEST(ProblemsWithRooms, AreNotProvedByBoundsThatDoNotKnowThem) {
    const auto solved = [](double width) {
        ReadProblem read = testing::read_without_fault(
            shipped_with("function/power") +
            "[[room]]\nname = \"box\"\n[[require]]\nquantity = \"box.width\"\nmax = " + std::to_string(width) + "\n");
        read.problem.solver.starts = 8;
        return mechwright::document(read.problem, solve(read.problem, {}));
    };
    const Json wide = solved(25), narrow = solved(23);
    EXPECT_TRUE(wide["search"]["complete"].get<bool>());
    EXPECT_NEAR(wide["objective"]["value"].get<double>(), 0.610531, 1e-6);
    EXPECT_FALSE(narrow["search"]["complete"].get<bool>());
    EXPECT_NEAR(narrow["objective"]["value"].get<double>(), 0.769270, 1e-5);
    EXPECT_LE(narrow["search"].value("bound", 0.0), narrow["objective"]["value"].get<double>());
    EXPECT_NEAR(value_in(narrow, "box.width"), 23, 1e-7);
    expect_verified(wide);
    expect_verified(narrow);
}

TEST(ProblemsWithRooms, AreRefusedWhereDocumentsAreChanged) {
    const Json document = analysed_room(kinds_with_rooms[0].text() + R"(
[[room]]
name = "all"
direction = 10
[[region]]
name = "post"
keep = "out"
of = ["coupler", "D"]
circle = { centre = [20, 9], radius = 1 }
)")
                              .document;
    expect_verified(document);
    expect_refused_if_off(document, {"all.width", "all.height", "all.area", "post.margin"});
    const auto expect_refused = [&](const auto& change) {
        Json changed = document;
        change(changed);
        EXPECT_TRUE(is_refused(changed)) << changed["room"] << changed["region"];
    };
    expect_refused([](Json& json) { json["room"][0]["of"] = "pivots"; });
    expect_refused([](Json& json) { json["room"][0]["direction"] = 11; });
    expect_refused([](Json& json) { json["room"][0]["name"] = "any"; });
    expect_refused([](Json& json) { json.erase("region"); });
    expect_refused([](Json& json) { json["region"][0]["circle"]["radius"] = 1.01; });
    expect_refused([](Json& json) { json["region"][0]["circle"] = nullptr; });
    expect_refused([](Json& json) { json["region"] = 3; });
    expect_refused([](Json& json) { json["units"]["angle"] = "rad"; });
}

TEST(ProblemsWithRooms, SayWhatIsWrong) {
    const std::string four_bar = text_of_kind("four-bar", "ground = 5\ncrank = 2\ncoupler = 4.5\nrocker = 4");
    const auto expect_error = [&](const std::string& part, const std::string& begins) {
        const std::string error = testing::first_error(four_bar + part);
        EXPECT_EQ(error.substr(0, begins.size()), begins) << error;
    };
    const std::string room = "[[room]]\nname = \"all\"\n";
    expect_error(
        room + "of = [\"follower\"]\n",
        "'of' in [[room]] number 1: there is no link and no point 'follower'; known are frame, crank, coupler, "
        "rocker, A, D, B, C, P");
    expect_error(room + "of = [\"rokcer\"]\n",
                 "'of' in [[room]] number 1: there is no link and no point 'rokcer'; did you mean 'rocker'?");
    expect_error(room + room, "'all' is the name of another room or region");
    expect_error("[[room]]\nname = \"rocker-angle\"\n", "'rocker-angle' is a signal of the linkage that this");
    expect_error("[[room]]\nname = \"swing\"\n[[require]]\nquantity = \"swing.depth\"\nmax = 3\n", "unknown quantity");
    expect_error("[room]\nname = \"all\"\n", "'room' must be a list of tables: write [[room]]");
    expect_error("[[region]]\nname = \"post\"\nkeep = \"out\"\ncircle = { centre = [0, 0], radius = 0 }\n",
                 "'radius' in [circle] must be greater than 0");
    const ReadProblem cam = parse_problem(
        "schema = 1\nmechanism = \"cam\"\n[cam]\nfollower = \"flat\"\ncontour = \"eccentric\"\n" + room, "cam.toml");
    EXPECT_TRUE(std::any_of(cam.messages.begin(), cam.messages.end(), [](const Message& message) {
        return to_string(message).find("cam.toml:6:1: [[room]] is of links and joints, and a cam has none") !=
               std::string::npos;
    }));
}

TEST(ProblemsWithRooms, AreExpandedWordForWord) {
    const ExpandedProblem expanded = expand_problem(shipped_wiper(), "wiper.toml");
    ASSERT_TRUE(expanded.ok()) << to_string(expanded.messages.front());
    for (const char* part :
         {"[[room]]\nname = \"drive\"\n",
          "[[region]]\nname = \"column\"\nkeep = \"out\"\nof = [\"crank\", \"coupler\", \"rocker\"]\n"
          "circle = { centre = [160, 94], radius = 35 }\nmargin = 8\n",
          "[[require]]\nquantity = \"drive.height\"\nmax = 101\n"})
        EXPECT_NE(expanded.text.find(part), std::string::npos) << part << '\n' << expanded.text;
}

}  // namespace

}  // namespace mechwright::linkage_scans

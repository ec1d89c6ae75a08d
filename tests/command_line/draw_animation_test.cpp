// mechwright draw --animate

#include <cmath>
#include <sstream>

#include "tests/command_line/program.h"
#include "tests/report/temporary_folder.h"

namespace mechwright::testing {
namespace {

const std::string wiper = R"(schema = 1
mechanism = "four-bar"
[dimensions]
ground = 100
crank = 30
coupler = 90
rocker = 60
)";

/// The numbers of each animation of a kind, a list for each place.
std::vector<std::vector<std::vector<double>>> animations(const std::string& svg, const std::string& type) {
    std::vector<std::vector<std::vector<double>>> all;
    const std::string head = "type=\"" + type + "\"", values = "values=\"";
    for (std::size_t at = svg.find(head); at != std::string::npos; at = svg.find(head, at + 1)) {
        const std::size_t from = svg.find(values, at) + values.size();
        std::istringstream places(svg.substr(from, svg.find('"', from) - from));
        all.emplace_back();
        for (std::string place; std::getline(places, place, ';');) {
            std::istringstream numbers(place);
            all.back().emplace_back();
            for (double number; numbers >> number;)
                all.back().back().push_back(number);
        }
    }
    return all;
}

TEST(DrawAnimation, TurnsTheCrankOnceAndComesBack) {
    const TemporaryFolder folder;
    const std::string file = folder.write("four-bar.toml", wiper);
    const Outcome outcome = run({"draw", file, "--animate", "--seconds", "2.5"});
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    expect_has(outcome.out, "dur=\"2.5s\" repeatCount=\"indefinite\"");
    const auto turns = animations(outcome.out, "rotate"), shifts = animations(outcome.out, "translate");
    ASSERT_EQ(turns.size(), 3);
    ASSERT_EQ(shifts.size(), 3);
    const auto& crank = turns.front();
    ASSERT_EQ(crank.size(), 121);
    // Against the clock, evenly; in pixels that is negative.
    for (std::size_t i = 0; i < crank.size(); ++i)
        EXPECT_NEAR(crank[i][0] - crank[0][0], -3.0 * static_cast<double>(i), 2e-3);
    for (std::size_t b = 0; b < 3; ++b) {
        EXPECT_NEAR(shifts[b].front()[0], shifts[b].back()[0], 1e-9);
        EXPECT_NEAR(std::remainder(turns[b].front()[0] - turns[b].back()[0], 360), 0, 1e-9);
    }
    // The coupler stays on the crank pin: as far from the crank's pivot as the crank is long, in one scale.
    const auto& coupler = shifts[1];
    const auto radius = [&](std::size_t i) {
        return std::hypot(coupler[i][0] - shifts[0][i][0], coupler[i][1] - shifts[0][i][1]);
    };
    for (std::size_t i = 0; i < coupler.size(); ++i)
        EXPECT_NEAR(radius(i), radius(0), 0.02);
}

TEST(DrawAnimation, GoesForthAndBackWhereTheCrankDoesNotTurnFully) {
    const TemporaryFolder folder;
    std::string text = wiper;
    text.replace(text.find("crank = 30"), 10, "crank = 80");
    const Outcome outcome = run({"draw", folder.write("rocker.toml", text), "--animate"});
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    const auto crank = animations(outcome.out, "rotate").front();
    ASSERT_EQ(crank.size(), 241);
    for (std::size_t i = 0; i < 120; ++i)
        EXPECT_EQ(crank[i], crank[240 - i]);
    EXPECT_GT(std::abs(crank[120][0] - crank[0][0]), 30);
}

TEST(DrawAnimation, IsWrittenAsGif) {
    const TemporaryFolder folder;
    const std::string file = folder.write("four-bar.toml", wiper), gif = folder / "moving.gif";
    const Outcome outcome = run({"draw", file, "--animate", "--seconds", "0.4", "--width", "160", "--out", gif});
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    const std::string bytes = content_of(gif);
    ASSERT_TRUE(bytes.starts_with("GIF89a"));
    std::size_t pictures = 0;  // each has a block that says how long it is shown
    for (std::size_t at = bytes.find("\x21\xf9\x04"); at != std::string::npos; at = bytes.find("\x21\xf9\x04", at + 1))
        ++pictures;
    EXPECT_EQ(pictures, 8);
}

TEST(DrawAnimation, SaysWhatDoesNotGoTogether) {
    const TemporaryFolder folder;
    const std::string file = folder.write("four-bar.toml", wiper);
    for (const std::vector<std::string>& more : {std::vector<std::string>{"--animate", "--plots"},
                                                 {"--seconds", "3"},
                                                 {"--animate", "--seconds", "0"},
                                                 {"--out", folder / "a.gif"},
                                                 {"--animate", "--out", folder / "a.png"}}) {
        std::vector<std::string> command{"draw", file};
        command.insert(command.end(), more.begin(), more.end());
        EXPECT_EQ(run(command).exit_code, 2) << more.back();
    }
}

}  // namespace
}  // namespace mechwright::testing

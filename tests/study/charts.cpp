// Pictures of studies.

#include "synthesis/study/charts.h"

#include "synthesis/report/files/gnuplot.h"
#include "tests/study/studies.h"

namespace mechwright::testing {
namespace {

struct Drawn {
    TemporaryFolder folder;
    std::filesystem::path data;
    Problem problem;

    explicit Drawn(const std::string& text) : data(folder / "study.sqlite") {
        const std::string file = folder.write("study.toml", text);
        run_to_end(file, data);
        problem = prepared(file).base;
    }
};

std::string small_chart() {
    return changed(shipped("transmission-chart"), {{"count = 80", "count = 5"}, {"count = 125", "count = 7"}});
}

TEST(Charts, OfAGridHoldTheWholeGrid) {
    const Drawn study(small_chart());
    const auto charts = charts_of(study.problem);
    ASSERT_EQ(charts.size(), 1u);
    const auto scripts = chart_scripts(study.data, study.problem, charts[0]);
    ASSERT_EQ(scripts.size(), 1u);
    EXPECT_EQ(scripts[0].name, "best-transmission-angle");
    const std::string& script = scripts[0].script;
    EXPECT_NE(script.find("set xlabel 'swing, deg'"), std::string::npos);
    EXPECT_NE(script.find("set ylabel 'time-ratio'"), std::string::npos);
    // Every point once, and a blank line after each of the seven columns.
    const std::string grid = script.substr(script.find("$grid << END_OF_DATA\n") + 21);
    const std::string rows = grid.substr(0, grid.find("END_OF_DATA"));
    EXPECT_EQ(std::count(rows.begin(), rows.end(), '\n'), 35 + 7);
}

TEST(Charts, AreDrawnByGnuplot) {
    const Drawn study(small_chart());
    const auto scripts = chart_scripts(study.data, study.problem, charts_of(study.problem)[0]);
    const std::string svg = gnuplot_picture(scripts[0].script, {});
    EXPECT_EQ(svg.find("<?xml"), 0u);
    EXPECT_NE(svg.find("</svg>"), std::string::npos);
    EXPECT_NE(svg.find("swing, deg"), std::string::npos);
    EXPECT_EQ(gnuplot_picture(scripts[0].script, {.format = Picture::Format::png}).substr(1, 3), "PNG");
    EXPECT_THROW(gnuplot_picture("plot nothing at all\n", {}), ChartFault);
}

TEST(Charts, AreChosenWhereNoneIsAskedFor) {
    std::string text = small_chart();
    text.resize(text.find("[[study.chart]]"));
    const Drawn study(text);
    const auto charts = charts_of(study.problem);
    ASSERT_EQ(charts.size(), 1u);
    EXPECT_EQ(charts[0].kind, ChartKind::map);
    EXPECT_EQ(charts[0].value, "objective");
    EXPECT_EQ(charts[0].x, "require.swing.equal");
}

TEST(Charts, OfFamiliesHaveACurveForEachAndAPictureForEach) {
    const Drawn study(changed(shipped("prime-radius-nomogram"),
                              {{"{ from = 15, to = 180, count = 34 }", "[60, 90]"},
                               {"\"parabolic\", \"harmonic\", \"kloomok-muffley\", \"3-4-5\", ", ""},
                               {"[20, 25, 30, 35, 40, 45]", "[20, 30]"}}));
    const auto scripts = chart_scripts(study.data, study.problem, study.problem.study->charts[0]);
    ASSERT_EQ(scripts.size(), 2u);
    EXPECT_EQ(scripts[0].name, "prime-radius-constant-velocity");
    EXPECT_EQ(scripts[1].name, "prime-radius-cycloidal");
    EXPECT_NE(scripts[0].script.find("$curve1"), std::string::npos);
    EXPECT_EQ(scripts[0].script.find("$curve2"), std::string::npos);
    EXPECT_NE(scripts[0].script.find("pressure-angle-rise at most, deg"), std::string::npos);
}

TEST(Charts, OfFrontsLeaveOutWhatIsWorseInBoth) {
    const Drawn study(R"(schema = 1
mechanism = "four-bar"
[dimensions]
ground  = 100
crank   = 30
coupler = 90
rocker  = 70
[study]
"dimensions.crank" = [10, 20, 30, 40, 50]
[[study.chart]]
kind = "front"
x = "dimensions.crank"
y = "transmission-angle-worst"
maximize = ["transmission-angle-worst"]
)");
    // Short cranks transmit best: one design is better than all others in both.
    const auto scripts = chart_scripts(study.data, study.problem, study.problem.study->charts[0]);
    const std::string front = scripts.at(0).script.substr(scripts[0].script.find("$front <<"));
    EXPECT_EQ(front.find("$front << END_OF_DATA\n10 "), 0u);
    EXPECT_EQ(front.find("\n20 "), std::string::npos);
}

TEST(Charts, NameAColumnThatIsMissing) {
    const Drawn study(small_chart());
    StudyChart chart = charts_of(study.problem)[0];
    chart.value = "transmission-angle-wurst";
    try {
        chart_scripts(study.data, study.problem, chart);
        FAIL() << "no fault";
    } catch (const ChartFault& fault) {
        EXPECT_NE(std::string(fault.what()).find("'transmission-angle-worst'"), std::string::npos) << fault.what();
    }
    chart.value = "objective";
    chart.where = "objective > 1000";
    EXPECT_THROW(chart_scripts(study.data, study.problem, chart), ChartFault);
    chart.where = "objective >";
    EXPECT_THROW(chart_scripts(study.data, study.problem, chart), ChartFault);
}

TEST(Charts, HoldTextsThatGnuplotCannotTakeForCommands) {
    const TemporaryFolder folder;
    const std::string trap = folder / "trap";
    const Drawn study("title = \"a \\\" b's \\\\ `touch " + trap + "` \"\n" +
                      changed(shipped("transmission-chart"),
                              {{"title     = \"Best transmission angle over swing and time ratio\"\n", ""},
                               {"count = 80", "count = 3"},
                               {"count = 125", "count = 3"}}));
    const auto scripts = chart_scripts(study.data, study.problem, charts_of(study.problem)[0]);
    const std::string svg = gnuplot_picture(scripts[0].script, {});
    EXPECT_NE(svg.find("b's \\ `touch"), std::string::npos);
    EXPECT_FALSE(std::filesystem::exists(trap));
}

}  // namespace
}  // namespace mechwright::testing

// Studies against what is known of their points.

#include "synthesis/study/run.h"

#include <SQLiteCpp/SQLiteCpp.h>
#include <sys/stat.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "analysis/four_bar/best_crank_rocker.h"
#include "tests/study/studies.h"

namespace mechwright::testing {
namespace {

using Json = nlohmann::ordered_json;

/// The best transmission angle in degrees by the closed forms of both families.
double best_transmission(double swing_degrees, double time_ratio) {
    const double radians = std::numbers::pi / 180;
    double best = 0;
    for (const double ratio : {time_ratio, 1 / time_ratio}) {
        const double stroke = 2 * std::numbers::pi * ratio / (1 + ratio);
        const auto m = best_transmission_crank_rocker(swing_degrees * radians, stroke);
        if (!m) continue;
        const auto cosine = [&](double diagonal) {
            return (m->coupler * m->coupler + m->rocker * m->rocker - diagonal * diagonal) /
                   (2 * m->coupler * m->rocker);
        };
        const double least = std::acos(cosine(m->ground - m->crank)), most = std::acos(cosine(m->ground + m->crank));
        best = std::max(best, std::min(least, std::numbers::pi - most) / radians);
    }
    return best;
}

TEST(TransmissionChart, IsTheClosedFormAtEveryPoint) {
    const TemporaryFolder folder;
    const std::string file = folder.write(
        "chart.toml",
        changed(shipped("transmission-chart"), {{"count = 80", "count = 9"}, {"count = 125", "count = 21"}}));
    const Json rows = run_to_end(file, folder / "study.sqlite");
    ASSERT_EQ(rows.size(), 189u);
    for (const Json& row : rows) {
        EXPECT_EQ(row["status"], "solved");
        EXPECT_EQ(row["proved"], 1);
        EXPECT_NEAR(row["objective"], best_transmission(row["require.swing.equal"], row["require.time-ratio.equal"]),
                    1e-9);
    }
}

/// The same chart by searches, most of them from the neighbour's design alone: not one is worse.
TEST(TransmissionChart, IsTheSameBySearchesFromNeighbours) {
    const TemporaryFolder folder;
    const std::string file = folder.write(
        "chart.toml", changed(shipped("transmission-chart"), {{"count = 80", "count = 6"},
                                                              {"count = 125", "count = 48"},
                                                              {"[study]", "[solver]\nmethod = \"slsqp\"\n[study]"}}));
    const Json rows = run_to_end(file, folder / "study.sqlite");
    ASSERT_EQ(rows.size(), 288u);
    int from_neighbours = 0;
    for (const Json& row : rows) {
        from_neighbours += row["start"] == "neighbour";
        EXPECT_EQ(row["status"], "solved");
        EXPECT_NEAR(row["objective"], best_transmission(row["require.swing.equal"], row["require.time-ratio.equal"]),
                    1e-7);
    }
    EXPECT_GT(from_neighbours, 200);
    const StudyStanding standing = standing_of_study(folder / "study.sqlite");
    EXPECT_EQ(standing.done, 288u);
    EXPECT_GT(standing.both_ways, 10u);
}

TEST(PrimeRadiusNomogram, HasTheValuesOfTheClosedForms) {
    const TemporaryFolder folder;
    const std::string file = folder.write(
        "nomogram.toml",
        changed(shipped("prime-radius-nomogram"),
                {{"{ from = 15, to = 180, count = 34 }", "[45, 60, 90, 120]"}, {"[20, 25, 30, 35, 40, 45]", "[30]"}}));
    // Closed forms of R0/L at 30 deg (Theory of Machines, section 6, computed); at 45, 60, 90, 120 deg of rise.
    const std::map<std::string, std::vector<double>> known{
        {"constant-velocity", {2.205316, 1.653987, 1.102658, 0.826993}},
        {"parabolic", {3.910631, 2.807973, 1.705316, 1.153987}},
        {"harmonic", {3.000000, 2.145751, 1.302776, 0.891941}},
        {"kloomok-muffley", {3.453786, 2.483318, 1.521569, 1.049060}},
        {"3-4-5", {3.661465, 2.636484, 1.620065, 1.120165}},
        {"cycloidal", {3.933563, 2.838509, 1.750945, 1.214506}},
    };
    const Json rows = run_to_end(file, folder / "study.sqlite");
    ASSERT_EQ(rows.size(), 24u);
    for (std::size_t i = 0; i < rows.size(); ++i) {
        EXPECT_EQ(rows[i]["status"], "solved");
        EXPECT_NEAR(rows[i]["objective"], known.at(rows[i]["segment.rise.law"]).at(i % 4), 6e-7) << rows[i];
        EXPECT_EQ(rows[i]["segment.dwell.angle"], 240 - rows[i]["segment.rise.angle"].get<double>());
    }
}

/// What was read off the printed nomogram, and the exact values (computed): 30 deg, 30 deg and 25 deg were printed; for
/// the polynomial, which the nomogram sets equal to the harmonic law, 30 and 25 deg.
TEST(PrimeRadiusNomogram, CorrectsThePrintedReadings) {
    const TemporaryFolder folder;
    const std::string file = folder.write(
        "readings.toml", changed(shipped("prime-radius-nomogram"),
                                 {{"prime-radius  = { min = 0.001, max = 1000 }", "prime-radius = 3"},
                                  {"max      = 30", "max = 89"},
                                  {"\"require.pressure-angle-rise.max\" = [20, 25, 30, 35, 40, 45]",
                                   "\"dimensions.prime-radius\" = [3.846153846153846, 3.0303030303030303]"},
                                  {"{ from = 15, to = 180, count = 34 }", "[45]"}}));
    const std::map<std::string, std::vector<double>> known{
        {"cycloidal", {30.501777}}, {"harmonic", {24.856064, 29.782186}}, {"kloomok-muffley", {27.676610, 32.940515}}};
    std::map<std::string, std::vector<double>> angles;
    for (const Json& row : run_to_end(file, folder / "study.sqlite"))
        angles[row["segment.rise.law"]].push_back(row["pressure-angle-rise"]);
    for (const auto& [law, exact] : known)
        for (std::size_t i = 0; i < exact.size(); ++i)
            EXPECT_NEAR(angles[law].at(i), exact[i], 1e-6) << law;
}

TEST(DragLinkRatio, HasTheComputedRatios) {
    const TemporaryFolder folder;
    const std::string file = folder.write(
        "ratio.toml",
        changed(shipped("drag-link-ratio"), {{"{ from = 2, to = 48, count = 47 }", "[30]"},
                                             {"{ from = -180, to = 180, count = 73 }", "[0, 30, 60, 90]"}}));
    const std::vector<double> known{1.634781, 1.998294, 1.926842, 1.592018};
    const Json rows = run_to_end(file, folder / "study.sqlite");
    ASSERT_EQ(rows.size(), 4u);
    for (std::size_t i = 0; i < rows.size(); ++i)
        EXPECT_NEAR(rows[i]["time-ratio"], known[i], 6e-7);
}

TEST(UniformSpeed, HasTheKnownOptimaAtRatioTwo) {
    const TemporaryFolder folder;
    const std::string file = folder.write(
        "speed.toml", changed(shipped("uniform-speed"), {{"{ from = 1.2, to = 2.6, count = 29 }", "[2]"}}));
    const Json rows = run_to_end(file, folder / "study.sqlite");
    ASSERT_EQ(rows.size(), 3u);
    EXPECT_EQ(rows[1]["case"], "Whitworth");
    EXPECT_NEAR(rows[0]["objective"], 0.161770, 1e-6);
    EXPECT_NEAR(rows[1]["objective"], 0.161785, 1e-6);
    EXPECT_NEAR(rows[2]["objective"], 0.079615, 1e-6);
    EXPECT_TRUE(rows[0]["design.lever"].is_number());
    EXPECT_TRUE(rows[1]["design.lever"].is_null());
}

TEST(Statuses, StandInTheData) {
    const TemporaryFolder folder;
    const std::string file = folder.write("a.toml", R"(schema = 1
mechanism = "four-bar"
[dimensions]
ground  = 100
crank   = 30
coupler = 90
rocker  = 70
[[require]]
quantity = "transmission-angle-worst"
min = 40
[study]
"dimensions.crank"   = [30, 65, 300]
"dimensions.coupler" = [90, -90, 80]
)");
    std::vector<std::string> statuses;
    for (const Json& row : run_to_end(file, folder / "study.sqlite")) {
        statuses.push_back(row["status"]);
        if (row["status"] == "invalid") {
            EXPECT_NE(row["note"].get<std::string>().find("greater than 0"), std::string::npos);
        }
    }
    EXPECT_EQ(statuses, (std::vector<std::string>{"solved", "invalid", "solved", "infeasible", "invalid", "infeasible",
                                                  "not-assembled", "invalid", "not-assembled"}));
}

TEST(Data, HaveTheQuantitiesOfTheTargetsThatThereAre) {
    const TemporaryFolder folder;
    const auto has = [&](const std::string& target, std::string_view quantity) {
        const std::string file = folder.write(
            "a.toml",
            "schema = 1\nmechanism = \"four-bar\"\n[dimensions]\nground = 5\ncrank = { min = 1, max = 9 }\n"
            "coupler = { min = 1, max = 9 }\nrocker = { min = 1, max = 9 }\n" +
                target + "[study]\n\"dimensions.ground\" = [5, 6]\n");
        const auto names = prepared(file).columns.quantities;
        return std::find(names.begin(), names.end(), quantity) != names.end();
    };
    const std::string function =
        "[function]\nexpression = \"x^1.5\"\nx = [1, 4]\ninput = { start = 210, range = 90 }\n"
        "output = { start = 270, range = 90 }\n[objective]\nminimize = \"function-max\"\n";
    const std::string none = "[objective]\nmaximize = \"swing\"\n";
    for (const std::string& target : {function, none}) {
        EXPECT_EQ(has(target, "function-rms"), target == function);
        EXPECT_FALSE(has(target, "line-deviation"));
        EXPECT_FALSE(has(target, "path-rms"));
        EXPECT_TRUE(has(target, "link-ratio"));
    }
}

TEST(Data, AreTheSameForAnyNumberOfThreadsAndAfterAnyNumberOfStops) {
    const TemporaryFolder folder;
    const std::string file = folder.write(
        "chart.toml", changed(shipped("transmission-chart"), {{"count = 80", "count = 3"},
                                                              {"count = 125", "count = 40"},
                                                              {"[study]", "[solver]\nmethod = \"slsqp\"\n[study]"}}));
    const Json once = run_to_end(file, folder / "one.sqlite", 1);
    EXPECT_EQ(run_to_end(file, folder / "seven.sqlite", 7), once);

    const PreparedStudy study = prepared(file);
    for (int runs = 0;; ++runs) {
        ASSERT_LT(runs, 1000);
        StudyStore store(folder / "stopped.sqlite", study, false);
        std::atomic<bool> stop = false;
        StudyRunOptions options;
        options.jobs = 2;
        options.stop = &stop;
        options.progress = [&](std::uint64_t, std::uint64_t newly, std::uint64_t) { stop = newly >= 11; };
        const bool complete = run_study(study, store, options).complete;
        store.close();
        if (!complete) continue;
        EXPECT_GT(runs, 5);
        break;
    }
    EXPECT_EQ(rows_of(folder / "stopped.sqlite"), once);
}

/// A strand that was interrupted after its last point had turned out better without its neighbour's help, with a design
/// in it that such help spoilt: the optimum of a greater swing, which meets the requirement and is worse.
TEST(Data, OfPointsThatANeighbourMisledAreMadeGood) {
    const TemporaryFolder folder;
    const std::string file = folder.write("swing.toml", R"(schema = 1
mechanism = "four-bar"
[dimensions]
ground = 1
crank = { min = 0.05, max = 1 }
coupler = { min = 0.05, max = 5 }
rocker = { min = 0.05, max = 5 }
[[require]]
quantity = "swing"
min = 40
[[require]]
quantity = "time-ratio"
equal = 1.2
[objective]
maximize = "transmission-angle-worst"
[solver]
method = "slsqp"
[study]
"require.swing.min" = { from = 30, to = 60, count = 12 }
)");
    const std::filesystem::path data = folder / "study.sqlite";
    const Json once = run_to_end(file, data);
    ASSERT_EQ(once.size(), 12u);
    constexpr std::size_t misled = 2;  // not the last of its strand, which is solved both ways anyhow
    ASSERT_EQ(once[misled]["start"], "neighbour");
    ASSERT_GT(once[misled]["objective"], once[11]["objective"]);
    {
        SQLite::Database database(data, SQLite::OPEN_READWRITE);
        database.exec("UPDATE designs SET numbers = (SELECT numbers FROM designs WHERE point = 11) WHERE point = 2");
        database.exec("UPDATE points SET objective = (SELECT objective FROM points WHERE point = 11) WHERE point = 2");
        ASSERT_EQ(database.exec("UPDATE strands SET differed = 1, finished = 0 WHERE strand = 0"), 1);
        RowSums(database, summed::designs).put(2);
        RowSums(database, summed::points).put(2);
        RowSums(database, summed::strands).put(0);
    }
    const Json again = run_to_end(file, data);
    ASSERT_EQ(again.size(), 12u);
    for (std::size_t i = 0; i < 12; ++i)
        EXPECT_NEAR(again[i]["objective"], once[i]["objective"], 1e-7) << i;
    EXPECT_EQ(again[misled]["start"], "both");
    EXPECT_EQ(standing_of_study(data).differed, 1u);
}

TEST(Data, OfAnotherStudyAreNotMixed) {
    const TemporaryFolder folder;
    const std::string text = changed(shipped("drag-link-ratio"),
                                     {{"{ from = 2, to = 48, count = 47 }", "[30]"}, {"count = 73", "count = 3"}});
    run_to_end(folder.write("a.toml", text), folder / "study.sqlite");
    const PreparedStudy other = prepared(folder.write("a.toml", text + "# changed\n"));
    EXPECT_THROW(StudyStore(folder / "study.sqlite", other, false), StoreFault);
    folder.write("text.sqlite",
                 "this is no database, but it is long enough to be looked at as one, " + std::string(900, '.'));
    EXPECT_THROW(StudyStore(folder / "text.sqlite", other, false), StoreFault);
    EXPECT_THROW(rows_of(folder / "nothing.sqlite"), StoreFault);
    EXPECT_THROW(rows_of(folder / "study.sqlite", "SELECT * FORM points"), SqlFault);
    EXPECT_THROW(rows_of(folder / "study.sqlite", "DELETE FROM points"), SqlFault);
}

TEST(Data, GoOutByQueriesThatReadAlone) {
    const TemporaryFolder folder;
    const std::filesystem::path data = folder / "study.sqlite";
    run_to_end(folder.write("ratio.toml",
                            changed(shipped("drag-link-ratio"), {{"{ from = 2, to = 48, count = 47 }", "[30]"}})),
               data);
    const std::string before = content_of(data);
    for (const std::string& query :
         {"VACUUM INTO '" + (folder / "copy") + "'", "ATTACH '" + (folder / "copy") + "' AS other",
          std::string("PRAGMA journal_mode = WAL"), std::string("SELECT 1; SELECT 2"),
          std::string("SELECT 1; DROP TABLE points"), std::string("CREATE TABLE other (x)"), std::string("BEGIN")})
        EXPECT_THROW(rows_of(data, query), SqlFault) << query;
    EXPECT_EQ(rows_of(data, "SELECT count(*) AS n FROM points; -- all of them")[0]["n"], 73);
    EXPECT_EQ(content_of(data), before);
    EXPECT_EQ(count_files(folder.path), 2u);
    const bool whole = export_data(
        data, {"WITH RECURSIVE n(i) AS (SELECT 1 UNION ALL SELECT i + 1 FROM n) SELECT count(*) FROM n", 0.1},
        DataFormat::csv, [](std::string_view) { return true; });
    EXPECT_FALSE(whole);
}

/// SQLite believes what stands in its pages, whatever a disk has made of it.
TEST(Data, ThatAreDamagedAreNotBelieved) {
    const TemporaryFolder folder;
    const std::filesystem::path data = folder / "study.sqlite";
    const std::string problem = folder.write(
        "ratio.toml", changed(shipped("drag-link-ratio"), {{"{ from = 2, to = 48, count = 47 }", "[30]"}}));
    const Json rows = run_to_end(problem, data);
    const std::string whole = content_of(data);
    std::size_t refused = 0;
    for (std::size_t at = 100; at < whole.size(); at += 211) {
        std::string bytes = whole;
        bytes[at] = static_cast<char>(bytes[at] ^ 0x10);
        folder.write("study.sqlite", bytes);
        try {
            EXPECT_EQ(rows_of(data), rows) << at;  // a place that no row uses
            EXPECT_EQ(problem_text(data), content_of(problem)) << at;
        } catch (const StoreFault&) {
            ++refused;
        }
    }
    EXPECT_GT(refused, 20u);
}

TEST(Data, ThatAreAPipeAreNotWaitedFor) {
    const TemporaryFolder folder;
    const std::filesystem::path data = folder / "study.sqlite";
    ASSERT_EQ(::mkfifo(data.c_str(), 0600), 0);
    EXPECT_THROW(standing_of_study(data), StoreFault);
    EXPECT_THROW(StudyStore(data, prepared(shipped("drag-link-ratio")), false), StoreFault);
}

TEST(Data, CanBeSelectedBySql) {
    const TemporaryFolder folder;
    const std::string file = folder.write(
        "ratio.toml", changed(shipped("drag-link-ratio"), {{"{ from = 2, to = 48, count = 47 }", "[30]"}}));
    run_to_end(file, folder / "study.sqlite");
    const Json best =
        rows_of(folder / "study.sqlite",
                "SELECT \"dimensions.slide-angle\" AS slide, \"time-ratio\" FROM points ORDER BY 2 DESC LIMIT 1");
    ASSERT_EQ(best.size(), 1u);
    EXPECT_NEAR(best[0]["time-ratio"], 2.02, 0.01);
    EXPECT_EQ(best[0].size(), 2u);
}

}  // namespace
}  // namespace mechwright::testing

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "analysis/numbers/low_discrepancy.h"
#include "synthesis/bench/pages/markdown.h"
#include "synthesis/bench/profiles/runs.h"
#include "synthesis/bench/profiles/searches.h"
#include "synthesis/bench/profiles/success.h"
#include "synthesis/bench/sections.h"
#include "synthesis/bench/shipped.h"
#include "synthesis/bench/timing.h"
#include "synthesis/program/work_sharing.h"

namespace mechwright::bench {

namespace {

/// Whose optimum is known and not zero, of every kind of problem.
constexpr std::array<std::string_view, 8> chosen{"path/case-2",
                                                 "path/case-3",
                                                 "path/case-4",
                                                 "path/case-5",
                                                 "function/power",
                                                 "line/hoekens-180",
                                                 "quick-return/uniform-speed-crank-shaper",
                                                 "cam/roller-offset"};

/// A merit that a run is to come to: a part of the way from the start's to the optimum's, or of the optimum's alone.
struct Target {
    const char* name;
    double part;
    bool of_way;

    double merit(double start, double optimum) const {
        return optimum + part * (of_way ? start - optimum : std::abs(optimum));
    }
};

constexpr std::array<Target, 7> targets{{{"way 1e-1", 1e-1, true},
                                         {"way 1e-3", 1e-3, true},
                                         {"way 1e-5", 1e-5, true},
                                         {"way 1e-7", 1e-7, true},
                                         {"optimum 1e-2", 1e-2, false},
                                         {"optimum 1e-3", 1e-3, false},
                                         {"optimum 1e-6", 1e-6, false}}};

/// The merit where a seed's searches begin: that of the first drawn point at which the mechanism assembles.
double start_merit(const Arena& arena, std::uint64_t seed) {
    constexpr int most_tries = 1000;
    constexpr double assembled_below = 1e5;
    std::uint64_t state = mixed(seed);
    double merit = arena.merit(random_point(arena.known.program, state));
    for (int i = 0; i < most_tries && !(merit < assembled_below); ++i)
        merit = arena.merit(random_point(arena.known.program, state));
    return merit;
}

Row row_of(const Arena& arena, std::string_view search, std::uint64_t seed, const char* target, const Work& work) {
    return {search, seed, target, arena.known.program.size(), work.values, work.derivatives, work.hessians};
}

/// What the run took as a whole, and until each of the targets that it came to.
std::vector<Row> rows_of(const Arena& arena, const GlobalSearch& search, std::uint64_t seed) {
    const std::vector<Mark> marks = search.run(arena, seed);
    Work whole = marks.empty() ? Work{} : marks.back().work;
    if (whole.derivatives == 0) whole.values = arena.budget;
    std::vector<Row> rows{row_of(arena, search.name, seed, whole_run, whole)};
    const double start = start_merit(arena, seed);
    for (const Target& target : targets) {
        const double wanted = target.merit(start, arena.known.objective);
        const auto met = std::find_if(marks.begin(), marks.end(), [&](const Mark& m) { return m.merit <= wanted; });
        if (met != marks.end()) rows.push_back(row_of(arena, search.name, seed, target.name, met->work));
    }
    return rows;
}

/// What derivatives cost, in values.
Row costs(const Arena& arena) {
    const Program& program = arena.known.program;
    const Eigen::VectorXd& x = arena.known.x;
    const Eigen::VectorXd multipliers = Eigen::VectorXd::Ones(static_cast<Eigen::Index>(program.rows.size()));
    ProgramValues values;
    LagrangianHessian hessian;
    const auto evaluated = [&](bool derivatives) {
        return piece([&, derivatives](std::size_t) {
            evaluate(program, x, derivatives, values);
            return values.objective;
        });
    };
    const auto times = timed({evaluated(false), evaluated(true), piece([&](std::size_t) {
                                  lagrangian_hessian(program, x, 1, multipliers, hessian);
                                  return hessian.value(0, 0);
                              })},
                             5, 0.02);
    return {"",
            Cell(),
            cost_of_one,
            program.size(),
            1,
            times[1].median / times[0].median,
            times[2].median / times[0].median};
}

struct Chosen {
    std::string name;
    Problem problem;
    GlobalSearch search;
};

std::vector<Row> measured(const Chosen& c, const Effort& effort) {
    RunOptions options;
    options.jobs = effort.jobs;
    options.stop = effort.stop;
    const auto arena = arena_of(c.problem, effort.pick(5000L, 50000L), options);
    if (!arena) return {};
    const int seeds = effort.pick(5, 51);
    std::vector<std::vector<Row>> of_seed(static_cast<std::size_t>(seeds));
    share_work(seeds, effort.jobs, [&](int k) {
        if (!effort.stopped())
            of_seed[static_cast<std::size_t>(k)] = rows_of(*arena, c.search, static_cast<std::uint64_t>(k) + 1);
    });
    std::vector<Row> rows{costs(*arena)};
    for (auto& some : of_seed)
        std::move(some.begin(), some.end(), std::back_inserter(rows));
    for (Row& row : rows)
        row.insert(row.begin(), c.name);
    return rows;
}

std::vector<Measurement> data_profiles_measurements(const Effort& effort) {
    std::vector<Measurement> all;
    for (const std::string_view name : chosen) {
        const auto problem = shipped_problem(effort.problems, name);
        if (!problem) continue;
        for (const GlobalSearch& search : global_searches())
            if (search.applies(*problem))
                all.push_back(
                    {fmt::format("{}, {}", name, search.name),
                     [c = Chosen{std::string(name), *problem, search}](const Effort& e) { return measured(c, e); }});
    }
    return all;
}

std::string rate_text(const Runs& runs, const std::string& target) {
    const double all = static_cast<double>(runs.runs.size()), met = runs.successes(target);
    const Interval95 interval = wilson(met, all);
    return fmt::format("{:.0f} % ({:.0f} to {:.0f})", 100 * met / all, 100 * interval.lower, 100 * interval.upper);
}

std::string expected_text(const Runs& runs, const std::string& target) {
    const double expected = runs.expected_evaluations(target);
    return std::isfinite(expected) ? significant(expected, 3) : "never";
}

/// The search that others are compared with: the program's own for the problem, which comes first.
const Runs& baseline(const std::vector<Runs>& all, const std::string& problem) {
    return *std::find_if(all.begin(), all.end(), [&](const Runs& runs) { return runs.problem == problem; });
}

MarkdownTable expected_table(const std::vector<Runs>& all) {
    MarkdownTable table{
        {"problem", "search", "to 1 %", "to 1e-3", "to 1e-6", "seeds that come to 1e-6", "ratio at 1e-6"}, {}};
    for (const Runs& runs : all) {
        const double own = baseline(all, runs.problem).expected_evaluations("optimum 1e-6");
        const double expected = runs.expected_evaluations("optimum 1e-6");
        table.rows.push_back({runs.problem, runs.search, expected_text(runs, "optimum 1e-2"),
                              expected_text(runs, "optimum 1e-3"), expected_text(runs, "optimum 1e-6"),
                              rate_text(runs, "optimum 1e-6"),
                              std::isfinite(own) && std::isfinite(expected) ? ratio_text(expected / own) : ""});
    }
    return table;
}

/// The searches of all problems; the program's own for each is a curve of its own.
constexpr const char* own_search = "mechwright's choice";

/// Evaluations over variables + 1 until a target, of all seeds of all problems; infinite where it is not met.
std::vector<double> efforts(const std::vector<Runs>& all, const std::string& search, const std::string& target) {
    std::vector<double> efforts;
    for (const Runs& runs : all) {
        const bool own = &runs == &baseline(all, runs.problem);
        if (search == own_search ? !own : runs.search != search) continue;
        for (const Run& run : runs.runs) {
            const auto met = run.until.find(target);
            efforts.push_back(met == run.until.end() ? std::numeric_limits<double>::infinity()
                                                     : met->second / (runs.variables + 1));
        }
    }
    std::sort(efforts.begin(), efforts.end());
    return efforts;
}

std::vector<std::string> profiled(const std::vector<Runs>& all) {
    std::vector<std::string> names{own_search};
    const std::string only_for_paths(global_searches().front().name);
    for (const Runs& runs : all)
        if (runs.search != only_for_paths && std::find(names.begin(), names.end(), runs.search) == names.end())
            names.push_back(runs.search);
    return names;
}

double share_within(const std::vector<double>& efforts, double most) {
    const auto count = std::upper_bound(efforts.begin(), efforts.end(), most) - efforts.begin();
    return static_cast<double>(count) / static_cast<double>(efforts.size());
}

MarkdownTable profile_table(const std::vector<Runs>& all) {
    MarkdownTable table{{"search", "tau 1e-1", "1e-3", "1e-5", "1e-7", "1e-7 within 1000 (n + 1)"}, {}};
    for (const std::string& search : profiled(all)) {
        std::vector<std::string> line{search};
        std::vector<double> last;
        for (const Target& target : targets) {
            if (!target.of_way) continue;
            last = efforts(all, search, target.name);
            line.push_back(fmt::format("{:.0f} %", 100 * share_within(last, std::numeric_limits<double>::max())));
        }
        line.push_back(fmt::format("{:.0f} %", 100 * share_within(last, 1000)));
        table.rows.push_back(std::move(line));
    }
    return table;
}

std::string data_profiles_chapter(const Sheet& sheet) {
    const std::vector<Runs> all = runs_of(sheet);
    if (all.empty()) return {};
    std::string text = fmt::format(
        "Searches of {} problems from {} seeds each. All see the same program: an objective that violations are added "
        "to,\nten times the greatest. Counted are evaluations of it, every candidate that was screened included; one "
        "with "
        "its\ngradient and a Hessian count as many as they were measured to cost of the problem. Those of the searches "
        "with "
        "gradients\nare known after each start, or each round of them, only: what they reach within one counts as "
        "reached "
        "at its end.\nDifferential evolution (ten vectors a variable) and NLopt's CRS2 are given the kind of motion "
        "and the "
        "assembly that the\noptimum lies in, the others look for them.\n\nExpected evaluations to come within a part "
        "of the "
        "optimum: those of all seeds over the seeds that come there; with the\nrate of these, Wilson's interval of 95 "
        "%. "
        "The ratio is to the search that mechwright chooses for the problem, the first.\n\n",
        sheet.distinct("problem").size(), all.front().runs.size());
    text += to_markdown(expected_table(all));
    text +=
        "\nSeeds of all problems that come a part 1 - tau of the way from a drawn start to the optimum (More and "
        "Wild's data\nprofiles), whatever it takes, and within 1000 evaluations for each of n variables and one:\n\n";
    return text + to_markdown(profile_table(all));
}

Diagram profile(const std::vector<Runs>& all, const char* name, const char* target, const char* tau) {
    Diagram diagram{name,
                    fmt::format("Data profiles, tau = {}", tau),
                    "evaluations / (variables + 1)",
                    "share of the seeds of all problems",
                    true,
                    false,
                    Diagram::Joined::by_steps,
                    {}};
    for (const std::string& search : profiled(all)) {
        Curve curve{search, {}};
        const std::vector<double> sorted = efforts(all, search, target);
        for (std::size_t i = 0; i < sorted.size(); ++i)
            curve.points.emplace_back(sorted[i], static_cast<double>(i + 1) / static_cast<double>(sorted.size()));
        diagram.curves.push_back(std::move(curve));
    }
    return diagram;
}

std::vector<Diagram> data_profiles_diagrams(const Sheet& sheet) {
    const std::vector<Runs> all = runs_of(sheet);
    if (all.empty()) return {};
    return {profile(all, "data-profiles-3", "way 1e-3", "1e-3"), profile(all, "data-profiles-7", "way 1e-7", "1e-7")};
}

}  // namespace

Section data_profiles() {
    return {"data-profiles",
            "Whole searches: seeds that come to the optimum",
            {"measurement", "problem", "search", "seed", "target", "variables", "values", "gradients", "hessians"},
            data_profiles_measurements,
            data_profiles_chapter,
            data_profiles_diagrams};
}

}  // namespace mechwright::bench

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <map>

#include "synthesis/bench/pages/markdown.h"
#include "synthesis/bench/precision/local_methods.h"
#include "synthesis/bench/sections.h"
#include "synthesis/bench/shipped.h"
#include "synthesis/bench/timing.h"

namespace mechwright::bench {

namespace {

/// Of different kinds; the quick look is at these, and so are the diagrams.
constexpr std::array<std::string_view, 6> representative{
    "four-bar/crank-rocker", "path/case-2", "path/case-3", "function/power", "line/hoekens-180", "cam/roller-harmonic"};

/// A start counts as one that leads to the optimum if the tightest tolerance comes as close as this.
constexpr double arrives_within = 1e-6;
constexpr std::array<double, 3> targets{1e-3, 1e-6, 1e-9};
constexpr std::array<const char*, 3> target_names{"1e-3", "1e-6", "1e-9"};

std::vector<double> tolerances(const Effort& effort) {
    return effort.full ? std::vector{1e-2, 1e-4, 1e-6, 1e-8, 1e-10, 1e-12, 1e-14}
                       : std::vector{1e-2, 1e-6, 1e-10, 1e-14};
}

/// One search from one start.
struct Trial {
    double objective = unlimited;
    double violation = unlimited;
    double error = unlimited;
    long evaluations = 0;
    double seconds = 0;
};

Trial tried(const LocalCandidate& method, const Start& start, double tolerance) {
    LocalLimits limits;
    limits.tolerance = tolerance;
    const auto begin = std::chrono::steady_clock::now();
    const LocalOutcome outcome = method.run(*start.program, start.x, limits);
    Trial trial;
    trial.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    trial.evaluations = outcome.evaluations;
    if (outcome.x.size() == 0) return trial;
    ProgramValues values;
    evaluate(*start.program, outcome.x, false, values);
    if (!values.assembled) return trial;
    trial.objective = values.objective;
    trial.violation = violation(*start.program, outcome.x, values);
    return trial;
}

/// Everything that one method did: trials by tolerance, by start.
struct Swept {
    std::string_view method;
    std::vector<std::vector<Trial>> trials;
};

/// The starts that a method gets: all, but of one that takes long no more than it comes to in its time, and two at
/// least. With the tightest tolerance a search takes longest.
std::vector<Start> starts_in_time(const LocalCandidate& method, std::vector<Start> starts, const Effort& effort) {
    constexpr std::size_t least = 2;
    const double allowed = effort.pick(0.3, 1.5);
    double seconds = 0;
    std::size_t count = 0;
    while (count < starts.size() && (count < least || seconds < allowed) && !effort.stopped())
        seconds += tried(method, starts[count++], tolerances(effort).back()).seconds;
    starts.resize(count);
    return starts;
}

Swept swept(const LocalCandidate& method, const std::vector<Start>& all_starts, const Effort& effort) {
    const std::vector<Start> starts = starts_in_time(method, all_starts, effort);
    Swept all{method.name, {}};
    for (const double tolerance : tolerances(effort)) {
        std::vector<Trial>& trials = all.trials.emplace_back();
        for (const Start& start : starts)
            if (!effort.stopped()) trials.push_back(tried(method, start, tolerance));
    }
    return all;
}

/// Errors against the least objective that is feasible to rounding: the known one, or what a search found below it.
void judge(std::vector<Swept>& all, double known) {
    constexpr double feasible = 1e-13;
    const auto each = [&](const auto& visit) {
        for (Swept& some : all)
            for (auto& trials : some.trials)
                std::for_each(trials.begin(), trials.end(), visit);
    };
    each([&](const Trial& trial) {
        if (trial.violation <= feasible) known = std::min(known, trial.objective);
    });
    each([&](Trial& trial) { trial.error = error_of(trial.objective, trial.violation, known); });
}

double median(std::vector<double> values) {
    if (values.empty()) return std::nan("");
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}

Cell cell(double value) { return std::isfinite(value) ? Cell(value) : Cell(); }

/// How many starts came how close with a tolerance, what all of them took, and the medians of those that the method
/// brings to the optimum when its tolerance is the tightest.
Row row_of(const Swept& swept, const std::vector<Trial>& trials, double tolerance) {
    const std::vector<Trial>& tightest = swept.trials.back();
    std::array<int, targets.size()> within{};
    long evaluations = 0;
    double seconds = 0;
    std::vector<double> errors, evaluations_of_arrived, seconds_of_arrived;
    for (std::size_t i = 0; i < trials.size(); ++i) {
        const Trial& trial = trials[i];
        evaluations += trial.evaluations;
        seconds += trial.seconds;
        for (std::size_t t = 0; t < targets.size(); ++t)
            within[t] += trial.error <= targets[t];
        if (tightest[i].error > arrives_within) continue;
        errors.push_back(trial.error);
        evaluations_of_arrived.push_back(static_cast<double>(trial.evaluations));
        seconds_of_arrived.push_back(trial.seconds);
    }
    return {swept.method,
            tolerance,
            trials.size(),
            errors.size(),
            within[0],
            within[1],
            within[2],
            evaluations,
            seconds,
            cell(median(errors)),
            cell(median(evaluations_of_arrived)),
            cell(median(seconds_of_arrived))};
}

std::vector<Row> measured(const Problem& problem, const Effort& effort) {
    RunOptions options;
    options.jobs = effort.jobs;
    options.stop = effort.stop;
    const auto known = known_optimum(problem, options);
    if (!known) return {};
    std::vector<Program> programs;
    for (const Variant& variant : variants(problem))
        programs.push_back(build_program(problem, variant));
    const std::vector<Start> starts = first_starts(problem, programs, effort.pick(6, 12));
    std::vector<Swept> all;
    for (const LocalCandidate& method : local_candidates())
        if (method.applies(problem)) all.push_back(swept(method, starts, effort));
    if (effort.stopped()) return {};
    judge(all, known->objective);
    std::vector<Row> rows;
    for (const Swept& some : all)
        for (std::size_t k = 0; k < some.trials.size(); ++k)
            rows.push_back(row_of(some, some.trials[k], tolerances(effort)[k]));
    return rows;
}

/// Whether local searches can be measured on a problem: it asks for one best design, in no exact way.
bool measurable(const ShippedProblem& shipped) {
    const Problem& p = shipped.problem;
    return p.objective && p.solver.pareto == 0 && p.solver.method == "auto" && why_not_applicable("slsqp", p).empty();
}

std::vector<Measurement> work_precision_measurements(const Effort& effort) {
    std::vector<Measurement> all;
    for (ShippedProblem& shipped : shipped_problems(effort.problems)) {
        const bool chosen =
            std::find(representative.begin(), representative.end(), shipped.name) != representative.end();
        if (!measurable(shipped) || (!effort.full && !chosen)) continue;
        all.push_back(
            {shipped.name, [problem = std::move(shipped.problem)](const Effort& e) { return measured(problem, e); }});
    }
    return all;
}

/// What a start that comes within a target costs on the average, with the tolerance that makes it cheapest; starts that
/// do not come there are paid for too.
struct Cost {
    double evaluations = std::nan("");
    double seconds = std::nan("");
};

Cost cost(const Sheet& sheet, const std::vector<Row>& rows, const char* target) {
    Cost least;
    for (const Row& row : rows) {
        const double met = sheet.number(row, target);
        if (!(met > 0)) continue;
        const double evaluations = sheet.number(row, "evaluations") / met, seconds = sheet.number(row, "seconds") / met;
        if (!(least.evaluations <= evaluations)) least.evaluations = evaluations;
        if (!(least.seconds <= seconds)) least.seconds = seconds;
    }
    return least;
}

std::vector<Row> rows_of(const Sheet& sheet, const std::string& problem, const std::string& method) {
    std::vector<Row> rows = sheet.where("problem", problem);
    std::erase_if(rows, [&](const Row& row) { return sheet.text(row, "method") != method; });
    return rows;
}

/// The slowest method that comes within a target.
double slowest(const Sheet& sheet, const std::string& problem, const char* target) {
    double most = std::nan("");
    for (const std::string& method : sheet.distinct("method"))
        if (const double seconds = cost(sheet, rows_of(sheet, problem, method), target).seconds; !(seconds <= most))
            most = std::isnan(seconds) ? most : seconds;
    return most;
}

std::vector<std::string> line_of(const Sheet& sheet, const std::string& problem, const std::string& method) {
    const std::vector<Row> rows = rows_of(sheet, problem, method);
    std::vector<std::string> line{
        problem, method,
        fmt::format("{} of {}", sheet.number(rows.back(), "arrived"), sheet.number(rows.back(), "starts"))};
    for (const char* target : target_names) {
        const Cost c = cost(sheet, rows, target);
        line.push_back(std::isnan(c.seconds) ? "not met" : significant(c.evaluations, 3) + ", " + time_text(c.seconds));
    }
    line.push_back(ratio_text(slowest(sheet, problem, "1e-6") / cost(sheet, rows, "1e-6").seconds));
    return line;
}

bool is_representative(const std::string& problem) {
    return std::find(representative.begin(), representative.end(), problem) != representative.end();
}

MarkdownTable table_of(const Sheet& sheet) {
    MarkdownTable table{
        {"problem", "method", "starts that lead there", "to 1e-3", "to 1e-6", "to 1e-9", "against the slowest to 1e-6"},
        {}};
    for (const std::string& problem : sheet.distinct("problem"))
        for (const std::string& method : sheet.distinct("method"))
            if (is_representative(problem) && !rows_of(sheet, problem, method).empty())
                table.rows.push_back(line_of(sheet, problem, method));
    return table;
}

/// Of all problems: where a method arrives, and how far it is from the quickest there.
std::vector<std::string> summary_of(const Sheet& sheet, const std::string& method) {
    int asked = 0;
    std::array<int, target_names.size()> met{};
    double logarithms = 0;
    for (const std::string& problem : sheet.distinct("problem")) {
        const std::vector<Row> rows = rows_of(sheet, problem, method);
        if (rows.empty()) continue;
        ++asked;
        for (std::size_t t = 0; t < target_names.size(); ++t)
            met[t] += !std::isnan(cost(sheet, rows, target_names[t]).seconds);
        const double own = cost(sheet, rows, "1e-6").seconds;
        if (!std::isnan(own)) logarithms += std::log(slowest(sheet, problem, "1e-6") / own);
    }
    std::vector<std::string> line{method, std::to_string(asked)};
    for (const int count : met)
        line.push_back(std::to_string(count));
    line.push_back(met[1] > 0 ? ratio_text(std::exp(logarithms / met[1])) : "");
    return line;
}

std::string work_precision_chapter(const Sheet& sheet) {
    std::string text =
        "Local searches from the same starts, each with tolerances from 1e-2 to 1e-14. An error is that of the "
        "objective,\nrelative to the best that is known (absolute where that is 0), or the greatest violation if that "
        "is greater. What a\nstart costs that comes within an error: all evaluations and seconds of all starts, those "
        "that end elsewhere\nincluded, over the number of those that come there, at the tolerance where this is "
        "least. A method that takes long gets fewer of the starts.\n\n";
    text += to_markdown(table_of(sheet));
    MarkdownTable all{{"method", "problems", "come to 1e-3", "to 1e-6", "to 1e-9", "against the slowest to 1e-6, mean"},
                      {}};
    for (const std::string& method : sheet.distinct("method"))
        all.rows.push_back(summary_of(sheet, method));
    return text +
           fmt::format("\nOver the {} problems that were measured (the mean is the geometric one):\n\n",
                       sheet.distinct("problem").size()) +
           to_markdown(all);
}

/// Errors of less than a rounding are drawn as one.
constexpr double least_in_diagram = 1e-16;

std::vector<Diagram> work_precision_diagrams(const Sheet& sheet) {
    std::vector<Diagram> all;
    for (const std::string& problem : sheet.distinct("problem")) {
        if (!is_representative(problem)) continue;
        std::string name = "work-precision-" + problem;
        std::replace(name.begin(), name.end(), '/', '-');
        Diagram diagram{name,
                        "Work against error: " + problem,
                        "error reached (median of the starts that lead there)",
                        "evaluations",
                        true,
                        true,
                        Diagram::Joined::by_lines,
                        {}};
        for (const std::string& method : sheet.distinct("method")) {
            Curve curve{method, {}};
            for (const Row& row : rows_of(sheet, problem, method))
                curve.points.emplace_back(std::max(sheet.number(row, "error"), least_in_diagram),
                                          sheet.number(row, "evaluations of one"));
            if (!curve.points.empty()) diagram.curves.push_back(std::move(curve));
        }
        all.push_back(std::move(diagram));
    }
    return all;
}

}  // namespace

Section work_precision() {
    return {"work-precision",
            "Local methods: work against error",
            {"problem", "method", "tolerance", "starts", "arrived", "1e-3", "1e-6", "1e-9", "evaluations", "seconds",
             "error", "evaluations of one", "seconds of one"},
            work_precision_measurements,
            work_precision_chapter,
            work_precision_diagrams};
}

}  // namespace mechwright::bench

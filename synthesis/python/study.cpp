// Studies: run, and what they have come to.

#include <fmt/format.h>

#include <algorithm>
#include <thread>

#include "synthesis/python/arguments.h"
#include "synthesis/python/calls.h"
#include "synthesis/python/errors.h"
#include "synthesis/python/interruptible.h"
#include "synthesis/python/values.h"
#include "synthesis/report/drawing/raster.h"
#include "synthesis/report/files/gnuplot.h"
#include "synthesis/report/files/write_file.h"
#include "synthesis/solve/method_fault.h"
#include "synthesis/study/charts.h"
#include "synthesis/study/data.h"
#include "synthesis/study/folder.h"
#include "synthesis/study/prepare.h"
#include "synthesis/study/run.h"
#include "synthesis/study/tolerance.h"
#include "synthesis/study/tolerance_text.h"

namespace mechwright::python {

namespace {

namespace py = pybind11;
using Clock = std::chrono::steady_clock;

PreparedStudy prepared_of(const py::object& argument) {
    const ProblemText problem = problem_text_of(argument);
    PreparedOrNot outcome = problem.text ? prepare_study(*problem.text, problem.file) : prepare_study(problem.file);
    if (!outcome.ok) raise_problem_error(outcome.messages, outcome.unreadable);
    if (!problem.warned_of) warn(outcome.messages);
    if (const auto fault = solver_method_fault(outcome.prepared.base)) raise_problem_error({*fault}, false);
    return std::move(outcome.prepared);
}

StudyRunOptions run_options(const StudyOptions& options, const std::atomic<bool>& stop) {
    StudyRunOptions run;
    run.jobs = static_cast<int>(options.jobs.value_or(std::max(1U, std::thread::hardware_concurrency())));
    run.stop = &stop;
    if (options.time_limit)
        run.deadline = Clock::now() + std::chrono::duration_cast<Clock::duration>(
                                          std::chrono::duration<double>(std::min(*options.time_limit, 1e9)));
    return run;
}

/// Runs what is not done yet. Returns the tolerances as tables, where the study is about those and complete.
std::string run_in(const std::string& folder, const PreparedStudy& prepared, const StudyRunOptions& options) {
    if (const auto fault = prepare_folder(folder)) throw StoreFault(*fault);
    const FolderLock lock(folder);
    if (!lock.fault().empty()) throw StoreFault(lock.fault());
    StudyStore store(data_file(folder), prepared, false);
    const StudyRun run = run_study(prepared, store, options);
    store.close();
    if (!run.fault.empty()) throw StoreFault(run.fault);
    if (!run.complete || !run.design) return {};
    return tolerance_text(tolerance_report(prepared, *run.design, data_file(folder)));
}

}  // namespace

py::str study(const py::object& problem, const std::string& folder, const StudyOptions& options) {
    check_run(options.jobs, options.time_limit);
    const PreparedStudy prepared = prepared_of(problem);
    return text_of(interruptible(
        [&](const std::atomic<bool>& stop) { return run_in(folder, prepared, run_options(options, stop)); }));
}

py::dict study_standing(const std::string& folder) {
    const StudyStanding standing = standing_of_study(data_file(folder));
    py::dict statuses;
    for (const auto& [status, count] : standing.statuses)
        statuses[text_of(status)] = count;
    py::dict all;
    all["title"] = text_of(standing.title);
    all["points"] = standing.points;
    all["done"] = standing.done;
    all["complete"] = standing.done == standing.points;
    all["statuses"] = statuses;
    return all;
}

py::object study_data(const std::string& folder, const std::string& sql, double time_limit) {
    std::string text;
    const bool whole = export_data(data_file(folder), {sql, time_limit}, DataFormat::json, [&](std::string_view part) {
        text += part;
        return true;
    });
    if (!whole) throw py::value_error(fmt::format("sql: stopped after {:g} s; time_limit gives it more", time_limit));
    return python_of(nlohmann::ordered_json::parse(text), Lists::plain);
}

py::dict study_charts(const std::string& folder) {
    const std::filesystem::path data = data_file(folder);
    const Problem problem = parse_problem(mechwright::problem_text(data), "study.toml").problem;
    if (problem.mechanism == nullptr || !problem.study) throw StoreFault(data.string() + ": holds no study");
    py::dict pictures;
    for (const StudyChart& chart : charts_of(problem))
        for (const ChartScript& script : chart_scripts(data, problem, chart))
            pictures[text_of(script.name)] = text_of(svg_element(gnuplot_picture(script.script, {.fixed = true})));
    return pictures;
}

}  // namespace mechwright::python

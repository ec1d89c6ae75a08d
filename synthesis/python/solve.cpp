#include "synthesis/solve/solve.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <thread>

#include "synthesis/document/document.h"
#include "synthesis/python/arguments.h"
#include "synthesis/python/calls.h"
#include "synthesis/python/errors.h"
#include "synthesis/python/interruptible.h"
#include "synthesis/python/values.h"
#include "synthesis/report/text/comparison.h"
#include "synthesis/solve/method_fault.h"

namespace mechwright::python {

namespace {

namespace py = pybind11;

void check(const SolveOptions& options) {
    if (options.seed && *options.seed < 0) throw py::value_error(fmt::format("seed: {} is below 0", *options.seed));
    check_run(options.jobs, options.time_limit);
}

void take_over(const SolveOptions& options, SolverOptions& solver) {
    if (options.seed) solver.seed = static_cast<std::uint64_t>(*options.seed);
    if (options.time_limit) solver.time_limit = *options.time_limit;
    if (options.method) solver.method = *options.method;
}

/// Throws where the method of the arguments, or else that of the problem, cannot be used.
void check_method(const Problem& problem, const std::optional<std::string>& method) {
    if (!method) {
        if (const auto fault = solver_method_fault(problem)) raise_problem_error({*fault}, false);
    } else if (const std::string fault = method_fault(*method, problem); !fault.empty()) {
        refuse_problem(problem, fault);
    }
}

/// The problem of an argument with what the options say in its place.
Problem task_of(const py::object& argument, const SolveOptions& options) {
    Problem problem = problem_of(argument);
    check_method(problem, options.method);
    take_over(options, problem.solver);
    return problem;
}

Result solved(const Problem& problem, const SolveOptions& options) {
    return interruptible([&](const std::atomic<bool>& stop) {
        RunOptions run;
        run.jobs = static_cast<int>(options.jobs.value_or(std::max(1U, std::thread::hardware_concurrency())));
        run.stop = &stop;
        run.all = options.all;
        return mechwright::solve(problem, run);
    });
}

}  // namespace

void check_run(const std::optional<std::int64_t>& jobs, const std::optional<double>& time_limit) {
    constexpr std::int64_t most_jobs = 1024;
    if (jobs && (*jobs < 1 || *jobs > most_jobs))
        throw py::value_error(fmt::format("jobs: {} is not from 1 to {}", *jobs, most_jobs));
    if (time_limit && !(std::isfinite(*time_limit) && *time_limit > 0))
        throw py::value_error(fmt::format("time_limit: {} is not a number of seconds above 0", *time_limit));
}

py::object solve(const py::object& argument, const SolveOptions& options) {
    check(options);
    const Problem problem = task_of(argument, options);
    const Result result = solved(problem, options);
    nlohmann::ordered_json made;
    {
        const py::gil_scoped_release release;
        made = document(problem, result);
    }
    return python_of(made);
}

void check(const py::object& argument) { check_method(problem_of(argument), {}); }

py::dict compare(const py::list& problems, const SolveOptions& options) {
    check(options);
    if (problems.size() < 2) throw py::value_error("compare needs two problems or more");
    std::vector<Compared> all;
    for (const py::handle one : problems) {
        all.push_back({task_of(py::reinterpret_borrow<py::object>(one), options), {}});
        Problem& problem = all.back().problem;
        if (problem.file == name_of_dict) problem.file = fmt::format("problem {}", all.size());
    }
    for (Compared& one : all)
        one.result = solved(one.problem, options);
    py::dict comparison;
    comparison["differences"] = text_of(differences_of_tasks(all));
    const std::vector<Compared> rows = ranked(std::move(all));
    comparison["rows"] = python_of(comparison_json(rows));
    comparison["table"] = text_of(comparison_table(rows, {}));
    comparison["csv"] = text_of(comparison_csv(rows));
    return comparison;
}

}  // namespace mechwright::python

#include "synthesis/solve/solve.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <thread>

#include "synthesis/document/document.h"
#include "synthesis/python/arguments.h"
#include "synthesis/python/calls.h"
#include "synthesis/python/interruptible.h"
#include "synthesis/python/values.h"
#include "synthesis/solve/method_fault.h"

namespace mechwright::python {

namespace {

namespace py = pybind11;

constexpr std::int64_t most_jobs = 1024;

void check(const SolveOptions& options) {
    if (options.seed && *options.seed < 0) throw py::value_error(fmt::format("seed: {} is below 0", *options.seed));
    if (options.jobs && (*options.jobs < 1 || *options.jobs > most_jobs))
        throw py::value_error(fmt::format("jobs: {} is not from 1 to {}", *options.jobs, most_jobs));
    if (options.time_limit && !(std::isfinite(*options.time_limit) && *options.time_limit > 0))
        throw py::value_error(fmt::format("time_limit: {} is not a number of seconds above 0", *options.time_limit));
}

void take_over(const SolveOptions& options, SolverOptions& solver) {
    if (options.seed) solver.seed = static_cast<std::uint64_t>(*options.seed);
    if (options.time_limit) solver.time_limit = *options.time_limit;
    if (options.method) solver.method = *options.method;
}

/// Throws where the method of the arguments, or else that of the problem, cannot be used.
void check_method(const Problem& problem, const std::optional<std::string>& method) {
    if (!method) {
        if (const auto fault = solver_method_fault(problem)) refuse_problem(problem, fault->text);
    } else if (const std::string fault = method_fault(*method, problem); !fault.empty()) {
        refuse_problem(problem, fault);
    }
}

}  // namespace

py::object solve(const py::object& argument, const SolveOptions& options) {
    check(options);
    Problem problem = problem_of(argument);
    check_method(problem, options.method);
    take_over(options, problem.solver);
    const auto work = [&](const std::atomic<bool>& stop) {
        RunOptions run;
        run.jobs = static_cast<int>(options.jobs.value_or(std::max(1U, std::thread::hardware_concurrency())));
        run.stop = &stop;
        run.all = options.all;
        return document(problem, mechwright::solve(problem, run));
    };
    return python_of(interruptible(work));
}

}  // namespace mechwright::python

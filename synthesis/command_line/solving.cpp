#include "synthesis/command_line/solving.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <thread>

#include "synthesis/command_line/commands/start_system.h"
#include "synthesis/command_line/defect.h"
#include "synthesis/command_line/exit_code.h"
#include "synthesis/command_line/input.h"
#include "synthesis/command_line/interrupt.h"
#include "synthesis/command_line/options.h"
#include "synthesis/command_line/progress_line.h"
#include "synthesis/command_line/results.h"
#include "synthesis/document/document.h"
#include "synthesis/problem/units.h"
#include "synthesis/report/csv/burmester_table.h"
#include "synthesis/report/csv/motion_table.h"
#include "synthesis/report/csv/solutions_table.h"
#include "synthesis/report/json_text.h"
#include "synthesis/solve/method_fault.h"
#include "synthesis/solve/solve.h"

namespace mechwright {

namespace {

struct FileToSolve {
    Problem problem;
    std::string result_name;
    double reading;  ///< seconds
};

void take_over(const SolvingOptions& options, SolverOptions& solver) {
    if (options.seed) solver.seed = *options.seed;
    if (options.time_limit) solver.time_limit = *options.time_limit;
    if (!options.method.empty()) solver.method = options.method;
}

/// The problems of the files that can be solved; `code` becomes that of the others.
std::vector<FileToSolve> read_tasks(const SolvingOptions& options, Console& console, int& code) {
    const std::vector<std::string> names = result_names(options.files);
    std::vector<FileToSolve> tasks;
    for (std::size_t i = 0; i < options.files.size(); ++i) {
        Seconds reading = 0;
        std::optional<Timed> timed(std::in_place, &reading);
        ReadProblem read;
        int outcome = read_and_report(options.files[i], options.quiet, console, read);
        timed.reset();
        if (outcome == exit_code::solved && options.method.empty()) {
            outcome = report_method_fault(read.problem, console);
        } else if (outcome == exit_code::solved) {
            if (const std::string fault = method_fault(options.method, read.problem); !fault.empty()) {
                complain(console, "--method: " + options.files[i] + ": " + fault);
                outcome = exit_code::wrong_usage;
            }
        }
        code = exit_code::worse(code, outcome);
        if (outcome != exit_code::solved) continue;
        take_over(options, read.problem.solver);
        tasks.push_back({std::move(read.problem), names[i], reading});
    }
    return tasks;
}

std::string objective_unit(const Problem& problem) {
    if (!problem.objective || problem.objective->terms.size() != 1) return {};
    return unit_label(problem.mechanism->quantities[problem.objective->terms.front().quantity].unit, problem.units);
}

using StartSystem = std::optional<homotopy::StartSystem>;

Result solve_task(const FileToSolve& task, const SolvingOptions& options, const StartSystem& start,
                  const std::string& label, Console& console, SearchTrace* trace) {
    ProgressLine line{&console, label, objective_unit(task.problem)};
    RunOptions run;
    run.jobs = static_cast<int>(options.jobs.value_or(std::max(1U, std::thread::hardware_concurrency())));
    run.stop = &Interrupt::requested();
    run.all = options.all;
    run.trace = trace;
    run.start_system = start ? &*start : nullptr;
    if (!options.quiet && progress_wanted(console))
        run.progress = [&line](int done, int total, double best) { draw(line, done, total, best); };
    if (run.progress) run.bounding = [&line](double part, long boxes) { draw_bound(line, part, boxes); };
    Result result = solve(task.problem, run);
    erase(line);
    return result;
}

constexpr const char* motion_ending = ".csv";
constexpr const char* solutions_ending = ".solutions.csv";
constexpr const char* burmester_ending = ".burmester.csv";

/// What --csv asks for besides the document.
std::vector<ResultTable> tables_of(const Problem& problem, const Result& result, const SolvingOptions& options) {
    std::vector<ResultTable> tables;
    if (!options.csv) return tables;
    tables.push_back(
        {motion_ending, result.best ? motion_table(problem, result.best->design, static_cast<int>(default_table_steps))
                                    : motion_header(problem)});
    if (options.all) tables.push_back({solutions_ending, solutions_table(problem, result)});
    if (has_burmester_curves(problem)) tables.push_back({burmester_ending, burmester_table(problem)});
    return tables;
}

/// Writes the files of a result. Returns the exit code.
int keep(const FileToSolve& task, const Result& result, const std::string& document, const SolvingOptions& options,
         Console& console) {
    if (options.out.empty()) return exit_code::solved;
    const ResultText text{document, tables_of(task.problem, result, options)};
    if (const auto fault = write_result(options.out, task.result_name, text)) {
        complain(console, *fault);
        return exit_code::no_access;
    }
    if (!options.quiet) {
        const std::string path = (std::filesystem::path(options.out) / task.result_name).string();
        console.err << "wrote " << path << ".json";
        for (const ResultTable& table : text.tables)
            console.err << (&table == &text.tables.back() ? " and " : ", ") << path << table.ending;
        console.err << std::endl;
    }
    return exit_code::solved;
}

/// "5 problems: 3 solved, 2 infeasible"
std::string tally(const std::vector<Status>& outcomes, std::size_t not_run) {
    std::string text;
    for (const Status status :
         {Status::solved, Status::infeasible, Status::limit, Status::unverified, Status::interrupted})
        if (const auto count = std::count(outcomes.begin(), outcomes.end(), status))
            text += fmt::format("{}{} {}", text.empty() ? "" : ", ", count, name_of(status));
    if (not_run > 0) text += fmt::format("{}{} not solved", text.empty() ? "" : ", ", not_run);
    return text;
}

/// Solves one problem and hands out what came of it.
void carry_out(const FileToSolve& task, const std::string& label, const SolvingOptions& options,
               const StartSystem& start, Console& console, const TakeResult& take, SolvingRun& run) {
    SearchTrace trace;
    trace.reading = task.reading;
    SearchTrace* const kept_trace = options.explain ? &trace : nullptr;
    const Result result = solve_task(task, options, start, label, console, kept_trace);
    const nlohmann::ordered_json json = document(task.problem, result);
    const int kept = keep(task, result, json_text(json), options, console);
    take(task.problem, result, json, kept_trace);
    run.outcomes.push_back(result.status);
    run.written.push_back(task.result_name);
    run.code = exit_code::worse(run.code, exit_code::worse(kept, exit_code::of(result.status)));
}

/// A defect that one problem brings to light does not cost the others their results.
void carry_out_guarded(const FileToSolve& task, const std::string& label, const SolvingOptions& options,
                       const StartSystem& start, Console& console, const TakeResult& take, SolvingRun& run) {
    try {
        carry_out(task, label, options, start, console, take, run);
    } catch (...) {
        run.code = exit_code::worse(run.code, report_defect(console, task.problem.file));
    }
}

/// Makes the folder for the results ready before anything is computed. Returns the exit code.
int prepare(const std::vector<FileToSolve>& tasks, const SolvingOptions& options, Console& console) {
    if (options.out.empty() || tasks.empty()) return exit_code::solved;
    std::vector<std::string> names;
    for (const FileToSolve& task : tasks)
        names.push_back(task.result_name);
    const std::vector<std::string> endings{motion_ending, solutions_ending, burmester_ending};
    const auto fault = prepare_results(options.out, names, options.csv ? endings : std::vector<std::string>{});
    if (!fault) return exit_code::solved;
    complain(console, *fault);
    return exit_code::no_access;
}

}  // namespace

CLI::Option* add_solving_options(CLI::App& command, SolvingOptions& options) {
    command.add_option("FILE", options.files, "Problem files")->required()->option_text(" ");
    CLI::Option* out = command.add_option("--out", options.out, "Write results into this folder");
    out->type_name("DIR")->check(not_empty);
    command.add_flag("--json", options.json, "Print result documents alone");
    add_whole_number(command, "--seed", options.seed, 0, INT64_MAX, "Seed of the search; overrides the file's");
    add_whole_number(command, "--jobs", options.jobs, 1, 1024, "Threads (all); results do not depend on it");
    add_positive_number(command, "--time-limit", options.time_limit, "Seconds per problem; overrides the file's");
    command.add_option("--method", options.method, "Method; overrides the file's (see methods)")
        ->type_name("NAME")
        ->check(not_empty);
    add_digits(command, options.digits);
    command.add_flag("--quiet", options.quiet, "Nothing but errors on standard error");
    return out;
}

SolvingRun solve_files(const SolvingOptions& options, Console& console, const TakeResult& take) {
    SolvingRun run;
    if (!options.method.empty()) {
        if (const std::string fault = method_name_fault(options.method); !fault.empty()) {
            complain(console, "--method: " + fault);
            run.code = exit_code::wrong_usage;
            return run;
        }
    }
    StartSystem start;
    if (!options.start_system.empty()) {
        run.code = read_start_system(options.start_system, console, start);
        if (run.code != exit_code::solved) return run;
    }
    const std::vector<FileToSolve> tasks = read_tasks(options, console, run.code);
    if (run.code == exit_code::wrong_usage) return run;
    if (const int prepared = prepare(tasks, options, console); prepared != exit_code::solved) {
        run.code = prepared;
        return run;
    }

    const bool several = options.files.size() > 1;
    const Interrupt interrupt(!options.quiet && console.err_is_terminal);
    std::size_t started = 0;
    for (; started < tasks.size() && !Interrupt::requested(); ++started) {
        const std::string count = several ? fmt::format("[{}/{}] ", started + 1, tasks.size()) : "";
        carry_out_guarded(tasks[started], count + tasks[started].problem.file, options, start, console, take, run);
    }
    if (started < tasks.size()) run.code = exit_code::worse(run.code, exit_code::interrupted);
    if (several && !options.quiet)
        console.err << options.files.size()
                    << " problems: " << tally(run.outcomes, options.files.size() - run.outcomes.size()) << std::endl;
    return run;
}

}  // namespace mechwright

#include "synthesis/solve/solve.h"

#include <algorithm>
#include <chrono>
#include <stdexcept>
#include <utility>

#include "synthesis/document/document.h"
#include "synthesis/program/proof.h"
#include "synthesis/program/search_trace.h"
#include "synthesis/solve/choose.h"
#include "synthesis/solve/front.h"
#include "synthesis/solve/methods.h"
#include "synthesis/solve/why_infeasible.h"
#include "synthesis/verify/proofs/proof_checks.h"

namespace mechwright {

using Clock = std::chrono::steady_clock;

Result solve(const Problem& problem, const RunOptions& options) {
    const Clock::time_point begin = Clock::now();
    const auto budget = std::chrono::duration<double>(std::min(problem.solver.time_limit, 1e9));
    const Clock::time_point deadline = begin + std::chrono::duration_cast<Clock::duration>(budget);
    const RunEnd end{deadline, options.stop};

    Result result;
    Found found = find_designs(problem, options, end);
    result.search = found.report;
    bool feasible = !found.candidates.empty() && found.candidates.front().feasible;
    std::optional<Timed> verifying(std::in_place, seconds_of(options.trace, &SearchTrace::verification));
    if (found.report.solutions) {
        choose_all_verified(problem, found, end, result);
        feasible = result.best.has_value();
        found.infeasible = !feasible && leaves_none_out(found.report);
        if (options.all) result.excluded = std::move(found.excluded);
    } else if (feasible)
        choose_verified(problem, found, end, result);
    else if (!found.candidates.empty())
        result.best = std::move(found.candidates.front());

    verifying.reset();

    bool limited = false;
    if (!(feasible && result.verified()) && !found.infeasible)
        if (auto proof = why_infeasible(problem)) {
            result.search.proof = std::move(proof);
            result.verification.clear();
            result.alternatives.clear();
            if (result.best) result.best->feasible = false;
            found.infeasible = limited = true;
            feasible = found.stopped = false;
        }
    if (!feasible && !found.infeasible) result.search.proof.reset();

    const auto asked_to_stop = [&] { return options.stop && options.stop->load(); };
    if (feasible && problem.solver.pareto > 0) {
        RunOptions of_others = options;  // whose objectives are not this problem's
        of_others.trace = nullptr;
        result.front = front(problem, of_others, deadline, result.best->objective);
        found.stopped = found.stopped || asked_to_stop() || Clock::now() >= deadline;  // the front may have gaps
    }

    const bool interrupted = asked_to_stop();
    if (found.stopped)
        result.status = interrupted ? Status::interrupted : Status::limit;
    else if (!feasible)
        result.status = Status::infeasible;
    else
        result.status = result.verified() ? Status::solved : Status::unverified;
    if (result.status == Status::infeasible) {
        if (found.infeasible && found.report.solutions)
            result.note = found.excluded_note;
        else if (found.infeasible && (limited || !result.best))
            result.note = "proved: no design meets the requirements; " + result.search.proof->argument;
        else if (found.infeasible)
            result.note = "proved: no design meets the requirements; the best that can be had is shown";
        else if (result.best)
            result.note = "no design was found by a search that ran to its end; the least-violating one is shown";
        else
            result.note = found.note;
    }
    result.search.seconds = std::chrono::duration<double>(Clock::now() - begin).count();
    for (const Check& check : check_proof(document(problem, result)))
        if (!check.passed) throw std::logic_error("a proof does not hold: " + check.name + ": " + check.detail);
    return result;
}

}  // namespace mechwright

#include "synthesis/search/solve.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "synthesis/exact/closed_form.h"
#include "synthesis/exact/exact.h"
#include "synthesis/program/assess.h"
#include "synthesis/program/proof.h"
#include "synthesis/proof/known_limits.h"
#include "synthesis/proof/prove.h"
#include "synthesis/report/document.h"
#include "synthesis/search/front.h"
#include "synthesis/search/multistart.h"
#include "synthesis/search/nearby.h"
#include "synthesis/search/optima.h"
#include "synthesis/search/path_search.h"
#include "synthesis/verify/proof_checks.h"
#include "synthesis/verify/verify.h"

namespace mechwright {

namespace {

using Clock = std::chrono::steady_clock;

/// What a method leaves for verification: candidates in order of preference, and what it can say of its search.
struct Found {
    std::vector<Solution> candidates;
    SearchReport report;
    bool infeasible = false;  ///< proved
    bool stopped = false;
    std::string note;  ///< for the user, where there are no candidates
    std::vector<ExcludedDesign> excluded{};
    std::size_t most_tried = 16;           ///< candidates, until one passes verification
    std::vector<Check> checks_of_first{};  ///< of the first candidate, where it was verified before
    std::string excluded_note{};           ///< where every solution of an exact problem is known, and excluded
};

struct Method {
    std::string_view name;
    std::string_view meaning;
    std::string (*why_not)(const Problem&);
    Found (*run)(const Problem&, const RunOptions&, Clock::time_point deadline);
};

/// Best first.
void rank(const Problem& problem, std::vector<Solution>& all) {
    std::stable_sort(all.begin(), all.end(),
                     [&](const Solution& a, const Solution& b) { return preferred(problem, a, b); });
}

std::size_t design_variables(const Problem& problem) {
    return static_cast<std::size_t>(std::count_if(problem.dimensions.begin(), problem.dimensions.end(),
                                                  [](const DimensionRange& d) { return !d.fixed() && !d.tied(); }));
}

/// What no local search can do.
std::string why_no_search(const Problem& problem) {
    for (const Requirement& r : problem.requirements)
        if (problem.mechanism->quantities[r.quantity].path == PathMeasure::greatest && (r.min || r.equal))
            return "path-max can only be limited from above";
    return {};
}

Found closed_form(const Problem& problem, const RunOptions&, Clock::time_point) {
    Found found;
    found.report.method = "closed-form";
    const auto outcome = solve_in_closed_form(problem);
    if (!outcome) {
        found.note =
            "the ranges of the dimensions cut the optimum of the closed form off; the methods auto, slsqp and "
            "ipopt look for the best design within them";
        return found;
    }
    if (outcome->best) found.candidates.push_back(*outcome->best);
    found.infeasible = outcome->infeasible;
    found.report.proof = outcome->proof;
    found.report.local_optima = outcome->infeasible ? 0 : 1;
    found.report.missed_chance = 0;
    found.report.evaluations = 1;
    return found;
}

bool found_feasible(const Found& found) { return !found.candidates.empty() && found.candidates.front().feasible; }

/// The best design at the very optimum that its search ended near.
void settle_best(const Problem& problem, Found& found, const RunOptions& options, Clock::time_point deadline) {
    if (found.stopped || !problem.objective || !found_feasible(found) || found.report.complete()) return;
    LocalLimits limits;
    limits.deadline = deadline;
    limits.stop = options.stop;
    NearbyOptimum at = settled(problem, found.candidates.front().design, limits);
    found.report.evaluations += at.evaluations;
    found.stopped = !at.stationary && limits.reached();
    if (at.solution && preferred(problem, *at.solution, found.candidates.front()))
        found.candidates.front() = *std::move(at.solution);
}

Found search(std::string_view name, LocalMethod local, const Problem& problem, const RunOptions& options,
             Clock::time_point deadline) {
    Multistart m = multistart(problem, local, options, deadline);
    Found found{std::move(m.optima), m.report, false, m.stopped,
                "no kind of motion of this mechanism has all the quantities that the problem names"};
    found.report.method = name;
    settle_best(problem, found, options, deadline);
    return found;
}

Found with_slsqp(const Problem& problem, const RunOptions& options, Clock::time_point deadline) {
    Found found = search("slsqp", slsqp, problem, options, deadline);
    if (!found.stopped && found_feasible(found) && is_quickly_proved(problem))
        prove(problem, found.candidates.front(), found.report, options, deadline);
    return found;
}

Found with_ipopt(const Problem& problem, const RunOptions& options, Clock::time_point deadline) {
    return search("ipopt", ipopt, problem, options, deadline);
}

Found with_least_squares(const Problem& problem, const RunOptions& options, Clock::time_point deadline) {
    Multistart m = path_search(problem, options, deadline);
    Found found{std::move(m.optima), m.report, false, m.stopped,
                "no kind of motion of this mechanism has all the quantities that the problem names"};
    found.report.method = "least-squares";
    settle_best(problem, found, options, deadline);
    return found;
}

Found with_branch_and_bound(const Problem& problem, const RunOptions& options, Clock::time_point deadline) {
    Found found =
        problem.function ? with_slsqp(problem, options, deadline) : with_least_squares(problem, options, deadline);
    found.report.method = "branch-and-bound";
    if (found.stopped || !found_feasible(found) || found.report.complete()) return found;
    found.stopped = !prove(problem, found.candidates.front(), found.report, options, deadline);
    return found;
}

Found near_neighbour(const Problem& problem, const RunOptions& options, Clock::time_point deadline) {
    LocalLimits limits;
    limits.deadline = deadline;
    limits.stop = options.stop;
    Found found;
    found.report.method = "neighbour";
    found.report.starts = 1;
    found.note = "no design was found from that of a neighbour";
    const NearbyOptimum near = nearby(problem, *options.neighbour, limits);
    if (near.solution && near.stationary) found.candidates.push_back(*near.solution);
    found.report.local_optima = static_cast<int>(found.candidates.size());
    found.report.evaluations = near.evaluations;
    found.stopped = limits.reached();
    return found;
}

std::string why_no_least_squares(const Problem& problem) {
    const std::string why = why_no_path_search(problem);
    return why.empty() ? why_no_search(problem) : why;
}

/// Whether every solution is known and listed: singular ones are counted alone.
bool leaves_none_out(const SearchReport& report) {
    return report.complete() && report.solutions && report.solutions->singular == 0;
}

Found every_solution(const Problem& problem, const RunOptions& options, Clock::time_point deadline) {
    ExactDesigns designs = exact_designs(problem, options, {deadline, options.stop});
    Found found;
    found.candidates = std::move(designs.designs);
    found.excluded = std::move(designs.excluded);
    found.report.method = "exact";
    found.report.proof = designs.proof;
    found.report.solutions = designs.counts;
    found.report.starts = designs.starts;
    found.report.local_optima = designs.local_optima;
    found.report.missed_chance = designs.counts ? 0 : 1;
    found.report.evaluations = designs.evaluations;
    found.most_tried = std::max<std::size_t>(found.candidates.size(), 1);
    found.infeasible = found.candidates.empty() && leaves_none_out(found.report);
    found.stopped = designs.stopped;
    // Of a family the member that comes closest is shown where none has all that is asked for.
    if (!designs.counts && found.candidates.empty() && !found.excluded.empty() &&
        std::isfinite(found.excluded.front().solution.violation))
        found.candidates.push_back(found.excluded.front().solution);
    found.excluded_note = designs.note.empty()
                              ? "proved: nothing meets the targets without a defect; --all lists what does"
                              : "proved: " + designs.note;
    found.note = designs.note.empty() ? "every solution that was found has a defect: --all lists them" : designs.note;
    return found;
}

/// The one of two searches that found the better design, with the work of both.
Found better(const Problem& problem, Found first, Found second) {
    const bool second_is =
        !second.candidates.empty() &&
        (first.candidates.empty() || preferred(problem, second.candidates.front(), first.candidates.front()));
    Found& chosen = second_is ? second : first;
    chosen.report.evaluations = first.report.evaluations + second.report.evaluations;
    chosen.stopped = first.stopped || second.stopped;
    return std::move(chosen);
}

/// A design by itself as verification sees it.
std::vector<Check> checks_of(const Problem& problem, const Solution& solution) {
    Result alone;
    alone.status = Status::solved;
    alone.best = solution;
    return verify_design(document(problem, alone), Stated::everything);
}

Found automatic(const Problem& problem, const RunOptions& options, Clock::time_point deadline) {
    if (why_no_closed_form(problem).empty()) {
        Found found = closed_form(problem, options, deadline);
        if (found.report.complete() && found.infeasible) return found;
        if (found.report.complete()) found.checks_of_first = checks_of(problem, found.candidates.front());
        if (all_passed(found.checks_of_first)) return found;
    }
    if (problem.has_instant && why_not_exact(problem).empty()) return every_solution(problem, options, deadline);
    if (options.neighbour) return near_neighbour(problem, options, deadline);
    if (!why_no_path_search(problem).empty()) return with_slsqp(problem, options, deadline);
    Found found = with_least_squares(problem, options, deadline);
    // Where other things than the distances count, the best are not where least squares look first.
    if (found.stopped || found.report.complete() || least_squares_suffice(problem)) return found;
    if (least_squares_lead_on(problem) && found_feasible(found)) return found;
    return better(problem, std::move(found), with_slsqp(problem, options, deadline));
}

constexpr std::array<Method, 7> methods{{
    {"auto", "a closed form where one covers the problem, least-squares for a path, else slsqp", why_no_search,
     automatic},
    {"closed-form",
     "crank-rockers of given swing and time ratio, slider-cranks, crank shapers and Whitworth drives of given time "
     "ratio and stroke, with the best transmission angle; the smallest cams: the global optimum",
     why_no_closed_form, closed_form},
    {"exact",
     "mechanisms that meet their targets exactly, every one where there are finitely many: nine points of a path, "
     "poses and points, five poses or timed points, up to five points of a function, velocities of an instant; with "
     "fewer targets the best of the family",
     why_not_exact, every_solution},
    {"least-squares",
     "paths: candidates screened many at a time, Levenberg-Marquardt from the best; slsqp where limits are active",
     why_no_least_squares, with_least_squares},
    {"branch-and-bound",
     "timed paths and functions of least greatest error: the search, then a lower bound over all linkages, as close as "
     "it comes within the time limit",
     why_no_proof, with_branch_and_bound},
    {"slsqp",
     "sequential quadratic programming (NLopt) from many starts, exact gradients; Madsen's method for a least "
     "greatest value, Newton polish",
     why_no_search, with_slsqp},
    {"ipopt", "interior point (Ipopt) from many starts, exact Hessians; then as slsqp; one thread", why_no_search,
     with_ipopt},
}};

/// Whether local searches from many starts are what a method does: a neighbour's design can take their place.
bool is_search(const Method& method) {
    return method.run == with_slsqp || method.run == with_ipopt || method.run == with_least_squares;
}

const Method* find_method(std::string_view name) {
    const auto at = std::find_if(methods.begin(), methods.end(), [&](const Method& m) { return m.name == name; });
    return at == methods.end() ? nullptr : &*at;
}

/// By name, the first check that a design does not pass.
std::string defect_of(const std::vector<Check>& checks) {
    const auto failed = std::find_if(checks.begin(), checks.end(), [](const Check& c) { return !c.passed; });
    if (failed == checks.end()) return checks.empty() ? "it was not verified" : "";
    return failed->name + (failed->detail.empty() ? "" : ": " + failed->detail);
}

/// Which of the designs already taken (0: the best one) draws the curve of another.
std::optional<std::size_t> cognate_of(const Problem& problem, const Result& result, const Solution& other) {
    const auto draws_same_curve = problem.mechanism->draws_same_curve;
    if (!problem.path || draws_same_curve == nullptr) return std::nullopt;
    const auto is_cognate = [&](const Solution& known) {
        return draws_same_curve(known.design.dimensions, other.design.dimensions);
    };
    if (is_cognate(*result.best)) return 0;
    for (std::size_t i = 0; i < result.alternatives.size(); ++i)
        if (is_cognate(result.alternatives[i].solution)) return i + 1;
    return std::nullopt;
}

/// Whether a design is of no interest beside those already taken: in a flat valley searches end at many places.
bool is_known(const Problem& problem, const Result& result, const Solution& other) {
    constexpr double alike_within = 1e-2;
    const auto is_like = [&](const Solution& known) {
        return same_design(problem, known.design, other.design, alike_within);
    };
    return (result.best && is_like(*result.best)) ||
           std::any_of(result.alternatives.begin(), result.alternatives.end(),
                       [&](const VerifiedDesign& d) { return is_like(d.solution); });
}

/// The first candidate that passes verification becomes the design, the others alternatives, or are set aside with the
/// check that they do not pass; if none passes, the first is shown.
void choose_verified(const Problem& problem, Found& found, const RunEnd& end, Result& result) {
    const std::vector<Solution>& candidates = found.candidates;
    constexpr std::size_t most_alternatives = 10;
    auto proof = std::exchange(result.search.proof, nullptr);
    bool is_first = false;
    result.status = Status::solved;
    for (std::size_t i = 0; i < candidates.size() && candidates[i].feasible; ++i) {
        if ((!result.best && i >= found.most_tried) || (i > 0 && end.reached())) break;
        if (result.alternatives.size() + result.excluded.size() >= most_alternatives) break;
        if (is_known(problem, result, candidates[i])) continue;
        std::vector<Check> checks = i == 0 && !found.checks_of_first.empty() ? std::move(found.checks_of_first)
                                                                             : checks_of(problem, candidates[i]);
        if (!all_passed(checks)) {
            result.excluded.push_back({candidates[i], defect_of(checks)});
        } else if (result.best) {
            result.alternatives.push_back(
                {candidates[i], std::move(checks), cognate_of(problem, result, candidates[i])});
        } else {
            is_first = i == 0;
            result.best = candidates[i];
            result.verification = std::move(checks);
        }
    }
    if (!result.best) {
        result.best = candidates.front();
        result.verification = checks_of(problem, candidates.front());
        result.excluded.erase(result.excluded.begin());
    }
    // What a method proved of its best design does not hold for the next.
    if (is_first) result.search.proof = std::move(proof);
}

/// Every design that passes verification is one of the answers, the best first; what does not pass has a defect between
/// the points: of circuit, mostly. Where the run ends before all are verified, the best of those that were is the
/// answer.
void choose_all_verified(const Problem& problem, Found& found, const RunEnd& end, Result& result) {
    for (Solution& candidate : found.candidates) {
        if (&candidate != &found.candidates.front() && end.reached()) {
            found.stopped = true;
            found.report.proof = result.search.proof = nullptr;
            break;
        }
        std::vector<Check> checks = checks_of(problem, candidate);
        if (!all_passed(checks)) {
            found.excluded.push_back({std::move(candidate), defect_of(checks)});
            continue;
        }
        ++result.search.solutions->defect_free;
        if (result.best) {
            const auto cognate = cognate_of(problem, result, candidate);
            result.alternatives.push_back({std::move(candidate), std::move(checks), cognate});
        } else {
            result.best = std::move(candidate);
            result.verification = std::move(checks);
        }
    }
    result.search.local_optima = static_cast<int>(result.search.solutions->defect_free);
}

}  // namespace

bool all_passed(const std::vector<Check>& checks) {
    return !checks.empty() && std::all_of(checks.begin(), checks.end(), [](const Check& c) { return c.passed; });
}

bool Result::verified() const { return all_passed(verification); }

Result solve(const Problem& problem, const RunOptions& options) {
    const Clock::time_point begin = Clock::now();
    const auto budget = std::chrono::duration<double>(std::min(problem.solver.time_limit, 1e9));
    const Clock::time_point deadline = begin + std::chrono::duration_cast<Clock::duration>(budget);
    const RunEnd end{deadline, options.stop};
    const Method* method = find_method(problem.solver.method);

    Result result;
    Found found;
    if (design_variables(problem) == 0 && !(problem.path && !problem.path->prescribed_timing)) {
        for (const std::size_t assembly : problem.assemblies)
            found.candidates.push_back(evaluate_given(problem, assembly));
        rank(problem, found.candidates);
        found.report.method = "given";
        found.report.proof = proof_by("every dimension is given", GivenCertificate{});
        found.report.local_optima = 1;
        found.report.missed_chance = 0;
        found.report.evaluations = static_cast<long>(found.candidates.size());
        found.infeasible = !found.candidates.front().feasible;
    } else if (options.neighbour && is_search(*method)) {
        found = near_neighbour(problem, options, deadline);
    } else {
        found = method->run(problem, options, deadline);
    }
    result.search = found.report;
    bool feasible = !found.candidates.empty() && found.candidates.front().feasible;
    if (found.report.solutions) {
        choose_all_verified(problem, found, end, result);
        feasible = result.best.has_value();
        found.infeasible = !feasible && leaves_none_out(found.report);
        if (options.all) result.excluded = std::move(found.excluded);
    } else if (feasible)
        choose_verified(problem, found, end, result);
    else if (!found.candidates.empty())
        result.best = std::move(found.candidates.front());

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
        result.front = front(problem, options, deadline, result.best->objective);
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

std::vector<MethodDescription> all_methods() {
    std::vector<MethodDescription> all;
    for (const Method& m : methods)
        all.push_back({m.name, m.meaning});
    return all;
}

std::string why_not_applicable(std::string_view name, const Problem& problem) {
    const Method* method = find_method(name);
    return method ? method->why_not(problem) : "there is no method of this name";
}

Solution evaluate_given(const Problem& problem) { return evaluate_given(problem, problem.assemblies.front()); }

Solution evaluate_given(const Problem& problem, std::size_t assembly) {
    Design design;
    for (const DimensionRange& d : problem.dimensions)
        design.dimensions.push_back(d.min);
    design.assembly = assembly;
    if (problem.path && problem.path->prescribed_timing)
        for (const double angle : problem.path->crank_angles)
            design.path_angles.push_back(design.dimensions[problem.mechanism->path_roles.start] + angle);
    return assess(problem, std::move(design));
}

}  // namespace mechwright

#include "synthesis/solve/methods.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>
#include <utility>

#include "synthesis/exact/closed_form/closed_form.h"
#include "synthesis/exact/exact.h"
#include "synthesis/mechanism/input.h"
#include "synthesis/program/assess.h"
#include "synthesis/program/proof.h"
#include "synthesis/program/quantity_value.h"
#include "synthesis/program/search_trace.h"
#include "synthesis/program/zero_objective.h"
#include "synthesis/proof/prove.h"
#include "synthesis/search/compact.h"
#include "synthesis/search/multistart.h"
#include "synthesis/search/nearby.h"
#include "synthesis/search/optima.h"
#include "synthesis/search/path/path_objective.h"
#include "synthesis/search/path/path_search.h"
#include "synthesis/solve/discrete.h"
#include "synthesis/solve/parts.h"
#include "synthesis/solve/ranked.h"
#include "synthesis/solve/solve.h"

namespace mechwright {

namespace {

using Clock = std::chrono::steady_clock;

/// What no local search can do.
std::string why_no_search(const Problem& problem) {
    for (const Requirement& r : problem.requirements)
        if (problem.mechanism->quantities[r.quantity].path == PathMeasure::greatest && (r.min || r.equal))
            return problem.mechanism->quantities[r.quantity].name + " can only be limited from above";
    return {};
}

/// Whether no number is left to be found.
bool is_given(const Problem& problem) {
    return std::all_of(problem.dimensions.begin(), problem.dimensions.end(),
                       [](const DimensionRange& d) { return d.fixed() || d.tied(); }) &&
           !(problem.path && !problem.path->prescribed_timing);
}

Found given_designs(const Problem& problem) {
    Found found;
    for (const std::size_t assembly : problem.assemblies)
        found.candidates.push_back(evaluate_given(problem, assembly));
    std::stable_sort(found.candidates.begin(), found.candidates.end(),
                     [&](const Solution& a, const Solution& b) { return preferred(problem, a, b); });
    found.report.method = "given";
    found.report.proof = proof_by("every dimension is given", GivenCertificate{});
    found.report.local_optima = 1;
    found.report.missed_chance = 0;
    found.report.evaluations = static_cast<long>(found.candidates.size());
    found.infeasible = !found.candidates.front().feasible;
    return found;
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

/// In flat valleys the very optimum is far from where a search ended.
constexpr long most_evaluations_to_settle = 20000;

/// The best design at the very optimum that its search ended near, as far as that takes no more than the search did.
void settle_best(const Problem& problem, Found& found, const RunOptions& options, Clock::time_point deadline) {
    if (found.stopped || !problem.objective || !found_feasible(found) || found.report.complete()) return;
    const Timed searching(seconds_of(options.trace, &SearchTrace::searching));
    const Timed polishing(seconds_of(options.trace, &SearchTrace::polishing));
    LocalLimits limits;
    limits.deadline = deadline;
    limits.stop = options.stop;
    const long enough = std::min(found.report.evaluations, most_evaluations_to_settle);
    NearbyOptimum at = settled(problem, found.candidates.front().design, enough, limits);
    found.report.evaluations += at.evaluations;
    found.stopped = !at.stationary && limits.reached();
    if (at.solution && preferred(problem, *at.solution, found.candidates.front()))
        found.candidates.front() = *std::move(at.solution);
}

/// Whether designs would do whose motion ends at toggles or stops, if the file said over which range to judge them.
bool lacks_range(const Problem& problem) {
    const auto& families = problem.mechanism->families;
    return !problem.crank_range && !problem.path && !has_input_range(problem) &&
           std::any_of(families.begin(), families.end(), [](const Family& family) { return !family.full_turn; });
}

/// What is said where a search ends without any design.
std::string why_nothing_is_found(const Problem& problem, const SearchReport& report) {
    const std::string_view input = input_word(*problem.mechanism);
    if (report.drawn == 0 && lacks_range(problem))
        return fmt::format(
            "where the motion of a design ends at toggles or stops it is searched for over given {0}s alone: "
            "[motion] crank_range says over which ones",
            input);
    if (report.drawn == 0) return "no kind of motion of this mechanism has all the quantities that the problem names";
    if (report.assembled > 0) return "no search from the candidates that were drawn came to a design";
    if (lacks_range(problem))
        return fmt::format(
            "none of the candidates that were drawn turns fully: for part of a turn give the {}s in "
            "[motion] crank_range",
            input);
    return "none of the candidates that were drawn assembles";
}

Found search(std::string_view name, LocalMethod local, const Problem& problem, const RunOptions& options,
             Clock::time_point deadline) {
    Multistart m = multistart(problem, local, options, deadline);
    Found found{std::move(m.optima), m.report, false, m.stopped, why_nothing_is_found(problem, m.report)};
    found.report.method = name;
    settle_best(problem, found, options, deadline);
    return found;
}

Found with_slsqp(const Problem& problem, const RunOptions& options, Clock::time_point deadline) {
    Found found = search("slsqp", slsqp, problem, options, deadline);
    if (found.stopped || !found_feasible(found) || !is_quickly_proved(problem)) return found;
    const Timed timed(seconds_of(options.trace, &SearchTrace::proving));
    prove(problem, found.candidates.front(), found.report, options, deadline);
    return found;
}

Found with_ipopt(const Problem& problem, const RunOptions& options, Clock::time_point deadline) {
    return search("ipopt", ipopt, problem, options, deadline);
}

/// Puts designs among others, those that are preferred first, unless they are there already.
void add_designs(const Problem& problem, std::vector<Solution> more, std::vector<Solution>& all) {
    for (Solution& one : more) {
        if (std::any_of(all.begin(), all.end(),
                        [&](const Solution& s) { return same_optimum(problem, s.design, one.design); }))
            continue;
        const auto at =
            std::find_if(all.begin(), all.end(), [&](const Solution& s) { return preferred(problem, one, s); });
        all.insert(at, std::move(one));
    }
}

/// What a search from four-bars among the links of a linkage finds besides, which takes a small part of what was done:
/// that stays as it is unless this is better.
void search_about_parts(const Problem& problem, Found& found, const RunOptions& options, Clock::time_point deadline) {
    constexpr long work_per_work_about_parts = 8;  // and as much at most to settle what it finds
    constexpr double gained_where_settled = 0.1;   // hardly more; the objective is an error of the path
    if (found.stopped || found.report.complete()) return;
    Multistart m = path_search_about_parts(problem, quiet(options), deadline,
                                           found.report.evaluations / work_per_work_about_parts);
    if (m.report.evaluations == 0) return;
    Found about{std::move(m.optima), m.report, false, m.stopped, {}};
    const auto is_better = [&](double by) {
        if (about.candidates.empty() || found.candidates.empty()) return !about.candidates.empty();
        Solution best = found.candidates.front();
        best.objective *= by;
        return preferred(problem, about.candidates.front(), best);
    };
    if (is_better(1 + gained_where_settled)) settle_best(problem, about, options, deadline);
    add_work(found.report, about.report);
    found.stopped = about.stopped;
    if (is_better(1)) {
        found.report.hits = 1;
        found.report.proof = about.report.proof;
    }
    if (found.report.complete()) {
        // Beside a design that meets all points others that miss them are none to choose from.
        found.report.missed_chance = 0;
        found.candidates.clear();
    }
    add_designs(problem, std::move(about.candidates), found.candidates);
    found.report.local_optima = static_cast<int>(
        std::count_if(found.candidates.begin(), found.candidates.end(), [](const Solution& s) { return s.feasible; }));
}

Found with_least_squares(const Problem& problem, const RunOptions& options, Clock::time_point deadline) {
    Multistart m = path_search(problem, options, deadline);
    Found found{std::move(m.optima), m.report, false, m.stopped, why_nothing_is_found(problem, m.report)};
    found.report.method = "least-squares";
    settle_best(problem, found, options, deadline);
    search_about_parts(problem, found, options, deadline);
    if (!found.report.complete()) found.report.bound = bound_of_untimed_path(problem);
    return found;
}

Found with_branch_and_bound(const Problem& problem, const RunOptions& options, Clock::time_point deadline) {
    Found found =
        problem.function ? with_slsqp(problem, options, deadline) : with_least_squares(problem, options, deadline);
    found.report.method = "branch-and-bound";
    if (found.stopped || !found_feasible(found) || found.report.complete()) return found;
    const Timed timed(seconds_of(options.trace, &SearchTrace::proving));
    found.stopped = !prove(problem, found.candidates.front(), found.report, options, deadline);
    return found;
}

std::string why_no_least_squares(const Problem& problem) {
    const std::string why = why_no_path_search(problem);
    return why.empty() ? why_no_search(problem) : why;
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

Found automatic(const Problem& problem, const RunOptions& options, Clock::time_point deadline) {
    if (why_no_closed_form(problem).empty()) {
        Found found = closed_form(problem, options, deadline);
        if (found.report.complete() && found.infeasible) return found;
        const Timed timed(seconds_of(options.trace, &SearchTrace::verification));
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

constexpr std::array<Method, 7> every_method{{
    {"auto", "a closed form where one covers the problem, least-squares for a path, else slsqp", why_no_search,
     automatic},
    {"closed-form",
     "crank-rockers of given swing and time ratio, slider-cranks, crank shapers and Whitworth drives of given time "
     "ratio and stroke, with the best transmission angle; the smallest cams: the global optimum",
     why_no_closed_form, closed_form},
    {"exact",
     "mechanisms that meet their targets exactly, every one where there are finitely many: nine points of a path, "
     "eight of a slider-crank, poses and points, five poses or timed points, up to five points of a function, "
     "velocities of an instant; with fewer targets the best of the family",
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

}  // namespace

const Method* find_method(std::string_view name) {
    const auto at =
        std::find_if(every_method.begin(), every_method.end(), [&](const Method& m) { return m.name == name; });
    return at == every_method.end() ? nullptr : &*at;
}

bool is_search(const Method& method) {
    return method.run == with_slsqp || method.run == with_ipopt || method.run == with_least_squares;
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

namespace {

/// Where targets are met exactly by a family of designs, the most compact of those that are found comes first.
void choose_compact(const Problem& problem, Found& found, const Method& method, const RunOptions& options,
                    const RunEnd& end) {
    constexpr int starts = 4;  // several times as many searches: the family is known
    constexpr std::size_t most_kept = 8;
    if (!problem.path || found.report.solutions || !found_feasible(found) ||
        !is_at_zero(problem, found.candidates.front()))
        return;
    const std::size_t free = free_numbers(problem, found.candidates.front().design);
    auto along = along_family(problem, found.candidates.front().design);
    if (free == 0 || !along) return;
    along->solver.starts = std::min(along->solver.starts, starts);
    RunOptions of_family = quiet(options);
    of_family.trace = nullptr;
    Found compact = method.run(*along, of_family, end.deadline);
    if (compact.stopped) return;
    // Members that are drawn come near to limits, which the optimum is at where searches end.
    if (method.run == every_solution)
        compact = better(*along, std::move(compact), find_method("auto")->run(*along, of_family, end.deadline));
    if (compact.stopped) return;
    found.report.evaluations += compact.report.evaluations;
    LocalLimits limits;
    limits.deadline = end.deadline;
    limits.stop = options.stop;
    for (std::size_t i = 0; i < std::min(most_kept, compact.candidates.size()); ++i)
        found.candidates.push_back(
            met_exactly(problem, compact.candidates[i].design, limits, found.report.evaluations));
    const std::size_t total = along->objective->terms.front().quantity;
    const auto length_of = [&](const Solution& s) {
        return is_at_zero(problem, s) ? quantity_value(problem, total, s.design).value_or(unlimited) : unlimited;
    };
    std::stable_sort(found.candidates.begin(), found.candidates.end(), [&](const Solution& a, const Solution& b) {
        return length_of(a) != length_of(b) ? length_of(a) < length_of(b) : preferred(problem, a, b);
    });
    found.checks_of_first.clear();
    found.report.free_numbers = free;
}

}  // namespace

Found find_designs(const Problem& problem, const RunOptions& options, const RunEnd& end) {
    const Method* method = find_method(problem.solver.method);
    if (!problem.wishes.empty()) return ranked_designs(problem, options, end);
    if (is_given(problem)) return given_designs(problem);
    if (is_discrete(problem)) return discrete_designs(problem, options, end);
    if (options.neighbour && is_search(*method)) return near_neighbour(problem, options, end.deadline);
    Found found = method->run(problem, options, end.deadline);
    choose_compact(problem, found, *method, options, end);
    return found;
}

bool leaves_none_out(const SearchReport& report) {
    return report.complete() && report.solutions && report.solutions->singular == 0;
}

std::vector<MethodDescription> all_methods() {
    std::vector<MethodDescription> descriptions;
    for (const Method& m : every_method)
        descriptions.push_back({m.name, m.meaning});
    return descriptions;
}

std::string why_not_applicable(std::string_view name, const Problem& problem) {
    const Method* method = find_method(name);
    return method ? method->why_not(problem) : "there is no method of this name";
}

}  // namespace mechwright

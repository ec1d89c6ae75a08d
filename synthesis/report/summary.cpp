#include "synthesis/report/summary.h"

#include <fmt/format.h>

#include "synthesis/problem/text.h"
#include "synthesis/report/document.h"
#include "synthesis/report/path_values.h"
#include "synthesis/report/sections.h"
#include "synthesis/report/standing.h"
#include "synthesis/report/table.h"
#include "synthesis/report/units.h"

namespace mechwright {

namespace {

struct Headline {
    std::string word;
    std::string sentence;
    Emphasis emphasis;
};

Headline headline_of(const Result& result) {
    const bool feasible = result.best && result.best->feasible;
    const std::string so_far = feasible      ? "; this is the best design so far."
                               : result.best ? "; no design so far meets all requirements, this one comes closest."
                                             : "; no design was found so far.";
    switch (result.status) {
        case Status::solved:
            return {"Solved", "all requirements are met, and the design passed verification.", Emphasis::good};
        case Status::infeasible:
            if (result.search.complete)
                return {"Infeasible", "it is proven that no design meets all requirements.", Emphasis::bad};
            return {"Infeasible",
                    "no design that meets all requirements was found by a search that ran to its end. "
                    "That is not a proof that there is none.",
                    Emphasis::bad};
        case Status::limit: return {"Limit", "stopped before the search ended" + so_far, Emphasis::bad};
        case Status::unverified:
            return {"Unverified", "a design was found, but its verification failed. Do not use it before you know why.",
                    Emphasis::bad};
        case Status::interrupted: return {"Interrupted", "stopped on request" + so_far, Emphasis::bad};
    }
    return {};
}

std::string status_section(const Result& result, bool colour) {
    const Headline headline = headline_of(result);
    std::string text =
        "\n" + folded(emphasised(headline.word + ":", headline.emphasis, colour) + " ", headline.sentence);
    if (!result.note.empty()) text += folded("", reading::printable(result.note, 2000));
    return text;
}

/// What stands in the way of a design that is not feasible: the requirement that is missed by most.
std::string obstacle(const Problem& problem, const Solution& best) {
    const Motion motion = motion_of(problem, best.design);
    if (!(motion.from <= motion.to)) return "\nThe design below comes closest. It does not assemble.\n";
    const Requirement* worst = nullptr;
    double most = problem.solver.tolerance;
    for (const Requirement& requirement : problem.requirements) {
        const Standing standing = standing_of(problem, requirement, best.design);
        if (!standing.violation || *standing.violation <= most) continue;
        most = *standing.violation;
        worst = &requirement;
    }
    if (!worst)
        return "\n" +
               folded("", fmt::format("The design below comes closest; it violates a range or a condition of its "
                                      "motion by {} (relative).",
                                      number_text(best.violation, 3)));
    const Quantity& quantity = problem.mechanism->quantities[worst->quantity];
    const double value = *standing_of(problem, *worst, best.design).value;
    const bool too_low = worst->min && value < *worst->min;
    const double limit = worst->equal ? *worst->equal : too_low ? *worst->min : *worst->max;
    const auto shown = [&](double x) { return value_with_unit(x, quantity.unit, problem.units); };
    return "\n" +
           folded("", fmt::format("The design below comes closest. It fails most at {}, which has to be {}{} and "
                                  "is {}: off by {}.",
                                  quantity.name,
                                  worst->equal ? ""
                                  : too_low    ? "at least "
                                               : "at most ",
                                  shown(limit), shown(value), shown(std::abs(value - limit))));
}

std::string percent(double share) { return share < 0.001 ? "below 0.1%" : number_text(100 * share, 2) + "%"; }

std::string counted(long count, std::string_view one, std::string_view many) {
    return fmt::format("{} {}", count, count == 1 ? one : many);
}

std::string search_section(const SearchReport& search, bool colour) {
    std::string how;
    if (search.complete) {
        how = "complete: " + (search.argument.empty() ? "every solution was found" : search.argument) + ".";
    } else if (search.starts > 0) {
        how = counted(search.starts, "start", "starts") + ", " +
              counted(search.local_optima, "local optimum", "local optima");
        if (search.hits > 0) how += fmt::format("; {} ended at the best one", counted(search.hits, "start", "starts"));
        if (search.hits > 0 && search.missed_chance < 1)
            how += fmt::format("; estimated chance that a better one was missed: {}", percent(search.missed_chance));
        how += ".";
    }
    how += fmt::format(" {} in {} s.", counted(search.evaluations, "evaluation", "evaluations"),
                       number_text(search.seconds, 3));
    return "\n" + folded(emphasised("Search:", Emphasis::strong, colour) + " ", search.method + "; " + how);
}

std::string alternatives_section(const Problem& problem, const Result& result) {
    if (result.alternatives.empty()) return {};
    std::string text = counted(static_cast<long>(result.alternatives.size()), "other design", "other designs");
    if (problem.objective)
        text += fmt::format(", the next best with objective {}", number_text(result.alternatives.front().objective));
    return folded("Alternatives: ", text + " (see --json or --out).");
}

std::string motion_line(const Problem& problem, const Design& design) {
    const Motion motion = motion_of(problem, design);
    if (!(motion.from <= motion.to)) return "\nIt does not assemble at any crank angle.\n";
    if (motion.full_turn) return "\nThe crank turns fully.\n";
    return fmt::format("\nMotion: crank angles from {} to {}.\n",
                       value_with_unit(motion.from, Unit::angle, problem.units),
                       value_with_unit(motion.to, Unit::angle, problem.units));
}

}  // namespace

std::string summary(const Problem& problem, const Result& result, bool colour) {
    std::string text = title_section(problem, colour) + status_section(result, colour);
    if (result.best) {
        const Solution& best = *result.best;
        if (!best.feasible) text += obstacle(problem, best);
        text += design_section(problem, best.design, colour) + objective_section(problem, best, colour) +
                requirement_section(problem, best.design, colour) + path_section(problem, best.design, colour) +
                verification_section(result.verification, colour);
    }
    return text + search_section(result.search, colour) + alternatives_section(problem, result);
}

std::string analysis_summary(const Problem& problem, const Solution& solution, bool colour) {
    const Design& design = solution.design;
    return title_section(problem, colour) + design_section(problem, design, colour) + motion_line(problem, design) +
           quantity_section(problem, design, colour) + requirement_section(problem, design, colour) +
           path_section(problem, design, colour);
}

}  // namespace mechwright

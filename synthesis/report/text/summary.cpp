#include "synthesis/report/text/summary.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "synthesis/document/document.h"
#include "synthesis/mechanism/input.h"
#include "synthesis/problem/text.h"
#include "synthesis/problem/units.h"
#include "synthesis/program/assess.h"
#include "synthesis/program/proof.h"
#include "synthesis/program/quantity_value.h"
#include "synthesis/program/standing/singular.h"
#include "synthesis/program/standing/standing.h"
#include "synthesis/report/drawing/finished.h"
#include "synthesis/report/text/dwell_section.h"
#include "synthesis/report/text/error_sections.h"
#include "synthesis/report/text/sections.h"
#include "synthesis/report/text/table.h"
#include "synthesis/target/path/text.h"

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
                               : result.best ? "; no design so far meets all requirements."
                                             : "; no design was found so far.";
    switch (result.status) {
        case Status::solved:
            return {"Solved", "all requirements are met, and the design passed verification.", Emphasis::good};
        case Status::infeasible:
            if (result.search.complete())
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

std::string status_section(const Result& result, const TextStyle& style) {
    const Headline headline = headline_of(result);
    const std::string word = emphasised(headline.word + ":", headline.emphasis, style.colour);
    std::string text = '\n' + folded(word + " ", headline.sentence);
    const bool said_already = result.status == Status::infeasible && result.best;
    if (!result.note.empty() && !said_already) text += folded("", reading::printable(result.note, 2000));
    return text;
}

/// The requirement that a design misses by most; one whose quantity it does not even have comes first.
const Requirement* most_missed(const Problem& problem, const Design& design) {
    const Requirement* worst = nullptr;
    double most = problem.solver.tolerance;
    for (const Requirement& requirement : problem.requirements) {
        const Standing standing = standing_of(problem, requirement, design);
        if (!standing.violation) return &requirement;
        if (*standing.violation <= most) continue;
        most = *standing.violation;
        worst = &requirement;
    }
    return worst;
}

/// "swing, which has to be at least 70 deg and is 61 deg: off by 9 deg"
std::string how_missed(const Problem& problem, const Requirement& requirement, const Design& design, int digits) {
    const Quantity& quantity = problem.mechanism->quantities[requirement.quantity];
    const std::optional<double> value = standing_of(problem, requirement, design).value;
    if (!value) return fmt::format("{}, which is not defined for a motion like its", quantity.name);
    const bool too_low = requirement.min && *value < *requirement.min;
    const double limit = requirement.equal ? *requirement.equal : too_low ? *requirement.min : *requirement.max;
    const char* relation = requirement.equal ? "" : too_low ? "at least " : "at most ";
    const auto shown = [&](double x) {
        std::string text = quantity_with_unit(x, quantity.unit, problem, design, digits);
        std::replace(text.begin(), text.end(), ' ', tied_space);
        return text;
    };
    return fmt::format("{}, which has to be {}{} and is {}: off by {}", quantity.name, relation, shown(limit),
                       shown(*value), shown(std::abs(*value - limit)));
}

/// Whether a requirement is over all that the mechanism can do, while targets that are met in order use a part of it.
bool could_be_over_range_of_use(const Problem& problem, const Requirement& requirement) {
    const bool in_order = problem.path && !problem.path->closed && !problem.path->any_order;
    return in_order && problem.mechanism->input && problem.mechanism->quantities[requirement.quantity].of_motion &&
           !problem.crank_range && !problem.use && !has_input_range(problem);
}

/// What stands in the way of a design that is not feasible.
std::string obstacle(const Problem& problem, const Solution& best, int digits) {
    const Motion motion = motion_of(problem, best.design);
    std::string text = "The design below comes closest. ";
    if (!(motion.from <= motion.to))
        text += "It does not assemble.";
    else if (!assembles_over_range(problem, best.design))
        text += fmt::format("It does not assemble throughout the range of {}s.", input_word(*problem.mechanism));
    else if (const Requirement* worst = most_missed(problem, best.design)) {
        text += fmt::format("It fails most at {}.", how_missed(problem, *worst, best.design, digits));
        if (could_be_over_range_of_use(problem, *worst))
            text +=
                " That is over all of its motion: [motion] with from = \"first-target\" and to = \"last-target\" "
                "asks for it between the targets alone.";
    } else if (std::isfinite(best.violation))
        text += fmt::format("It leaves a range or a condition of its motion by {} (relative).",
                            number_text(best.violation, 3));
    return '\n' + folded("", text);
}

std::string percent(double share) {
    if (share < 0.001) return "below 0.1%";
    return share < 0.1 ? fmt::format("{:.1f}%", 100 * share) : fmt::format("{:.0f}%", 100 * share);
}

std::string duration_text(double seconds) {
    constexpr double millisecond = 0.001;
    if (seconds < millisecond) return fmt::format("less than a{}millisecond", tied_space);
    return fmt::format("{:.{}f}{}s", seconds, seconds < 10 ? 3 : 1, tied_space);
}

std::string counted(long count, std::string_view one, std::string_view many) {
    return fmt::format("{}{}{}", count, tied_space, count == 1 ? one : many);
}

/// Of the search among allowed values.
std::string discrete_text(const DiscreteReport& discrete, int digits) {
    std::string text =
        fmt::format(" Branch and bound over the allowed values, {}", counted(discrete.problems, "problem", "problems"));
    if (discrete.continuous)
        text +=
            fmt::format(": {} could be had with any values of the ranges", rounded_text(*discrete.continuous, digits));
    if (discrete.gap > 0)
        return text + fmt::format("; allowed values that were not looked at may be better by {}.",
                                  rounded_text(discrete.gap, digits));
    if (discrete.combinations > 0)
        return text + fmt::format("; all of their {} were looked at.",
                                  counted(discrete.combinations, "combination", "combinations"));
    if (discrete.left_out > 0)
        return text + fmt::format(
                          "; {} of them {} left out because no search found a design there, which proves "
                          "nothing.",
                          counted(discrete.left_out, "part", "parts"), discrete.left_out == 1 ? "was" : "were");
    return text + "; no allowed values are left that could be better, as far as these searches see.";
}

/// What a proof says, without the method's name before it: "closed form: ..." of closed-form.
std::string_view without_name(std::string_view argument, std::string name) {
    std::replace(name.begin(), name.end(), '-', ' ');
    return argument.starts_with(name + ": ") ? argument.substr(name.size() + 2) : argument;
}

/// Where searches began, unless that was at drawn candidates alone: ": 1 with the preferred values, 31 drawn; and at 6
/// near the ends of these".
std::string sources_text(const StartSources& from) {
    std::string text;
    const auto add = [&](long count, const char* which) {
        if (count > 0) text += fmt::format("{}{} {}", text.empty() ? ": " : ", ", count, which);
    };
    if (from.preferred > 0 || from.four_bars > 0) {
        add(from.preferred, "with the preferred values");
        add(from.drawn, "drawn");
        add(from.four_bars, "drawn about four-bars that follow the path by themselves");
    }
    if (from.nearby > 0)
        text += fmt::format("{} and at {} near the ends of these", text.empty() ? "" : ";", from.nearby);
    return text;
}

std::string search_section(const SearchReport& search, const TextStyle& style) {
    std::string how = search.method;
    if (search.proof) {
        how += fmt::format(", complete: {}.", without_name(search.proof->argument, search.method));
    } else if (search.starts > 0) {
        how += fmt::format(": {}, {}", counted(search.starts, "start", "starts"),
                           counted(search.local_optima, "local optimum", "local optima"));
        if (search.hits > 0) how += fmt::format("; {} ended at the best one", counted(search.hits, "start", "starts"));
        if (search.hits > 0 && search.starts > 1)
            how += fmt::format("; estimated chance that a better one was missed: {}", percent(search.missed_chance));
        how += '.';
    } else {
        how += '.';
    }
    if (search.drawn > 0)
        how += fmt::format(" {} drawn, {} of them assembled, searches began at {}{}.",
                           counted(search.drawn, "candidate", "candidates"), search.assembled, search.optimised,
                           sources_text(search.sources));
    if (search.free_numbers > 0)
        how += fmt::format(" A family of designs with {} does so; of those that were found the most compact is shown.",
                           counted(static_cast<long>(search.free_numbers), "free number", "free numbers"));
    if (search.discrete) how += discrete_text(*search.discrete, style.digits);
    if (search.solutions) {
        const SolutionCounts& n = *search.solutions;
        how += fmt::format(" {}, {} at infinity, {} singular; {} real",
                           counted(static_cast<long>(n.distinct), "distinct solution", "distinct solutions"),
                           n.at_infinity, n.singular, n.real);
        if (n.real > 0)
            how += fmt::format(", {} of them certified; {} of these as mechanisms without a defect",
                               n.certified == n.real ? "all" : std::to_string(n.certified), n.defect_free);
        how += '.';
    }
    if (search.bound && !search.complete())
        how += fmt::format(" No design has an objective below {}{}.", rounded_text(*search.bound, style.digits),
                           search.boxes > 0 ? fmt::format(": {} boxes were examined", search.boxes) : "");
    how += fmt::format(" {} in {}.", counted(search.evaluations, "evaluation", "evaluations"),
                       duration_text(search.seconds));
    return '\n' + folded(emphasised("Search:", Emphasis::strong, style.colour) + " ", how);
}

/// The solutions with a defect, a line for each.
std::string excluded_section(const Problem& problem, const Result& result, const TextStyle& style) {
    if (result.excluded.empty() || !result.search.solutions) return {};
    Table table{{Align::right, Align::right, Align::right, Align::right, Align::left}, {{}}};
    for (std::size_t i = 0; i < 4; ++i)
        table.rows.front().emplace_back(problem.mechanism->dimensions[i].name);
    table.rows.front().emplace_back("defect");
    for (const ExcludedDesign& excluded : result.excluded) {
        std::vector<std::string> row;
        const std::vector<std::string> values = dimension_texts(problem, excluded.solution.design, style.digits);
        row.assign(values.begin(), values.begin() + 4);
        row.push_back(excluded.defect.substr(0, excluded.defect.find(':')));
        table.rows.push_back(std::move(row));
    }
    return heading("Excluded", style) + to_text(table, 2);
}

/// The best of the other designs, with what an engineer chooses by, in the units of the design above.
std::string alternatives_table(const Problem& problem, const Result& result, int digits) {
    constexpr std::size_t most_shown = 5;
    const Mechanism& mechanism = *problem.mechanism;
    Table table{{Align::right, Align::point, Align::point, Align::point, Align::left, Align::left},
                {{"", "objective"}}};
    if (!problem.objective) table.rows.front().back().clear();
    std::vector<std::size_t> chosen_by;
    for (const auto& [name, head] :
         {std::pair("total-length", "total-length"), std::pair("transmission-angle-worst", "transmission")}) {
        const int q = find_quantity(mechanism, name);
        if (q < 0) return {};
        chosen_by.push_back(static_cast<std::size_t>(q));
        table.rows.front().emplace_back(head);
    }
    for (std::size_t i = 0; i < std::min(most_shown, result.alternatives.size()); ++i) {
        const Solution& solution = result.alternatives[i].solution;
        auto& row = table.rows.emplace_back();
        row = {std::to_string(i + 1), problem.objective ? objective_text(problem, solution, digits) : ""};
        for (const std::size_t q : chosen_by) {
            const auto value = quantity_value(problem, q, solution.design);
            const Unit unit = mechanism.quantities[q].unit;
            row.push_back(value ? quantity_text(*value, unit, problem, solution.design, digits) : "-");
        }
        row.push_back(mechanism.describe(mechanism.form(0), solution.design.dimensions));
        row.push_back(problem.assemblies.size() < 2 ? "" : mechanism.assemblies[solution.design.assembly]);
    }
    return to_text(table, 2);
}

std::string alternatives_section(const Problem& problem, const Result& result, int digits) {
    if (result.alternatives.empty()) return {};
    const auto cognates = std::count_if(result.alternatives.begin(), result.alternatives.end(),
                                        [](const VerifiedDesign& d) { return d.cognate_of.has_value(); });
    std::string text = counted(static_cast<long>(result.alternatives.size()), "other design", "other designs");
    if (problem.objective)
        text += fmt::format(", the next best with objective {}",
                            objective_text(problem, result.alternatives.front().solution, digits));
    if (cognates > 0)
        text += fmt::format("; {} of them {} of another", cognates, cognates == 1 ? "a cognate" : "cognates");
    return folded("Alternatives: ", text + " (see --json or --out).") + alternatives_table(problem, result, digits);
}

/// What a search found and verification does not pass: the best of it by name, above all where it is better than the
/// design.
std::string set_aside_section(const Problem& problem, const Result& result, int digits) {
    if (result.excluded.empty() || result.search.solutions) return {};
    const ExcludedDesign& first = result.excluded.front();
    std::string text =
        counted(static_cast<long>(result.excluded.size()), "design that is", "designs that are") + " no use";
    if (problem.objective) {
        const bool better = result.verified() && preferred(problem, first.solution, *result.best);
        text += fmt::format("; {} objective {}", better ? "one of them has the better" : "the first has the",
                            objective_text(problem, first.solution, digits));
    }
    return folded("Set aside: ", text + ", but it fails a check: " + first.defect + ".");
}

/// The front between two objectives, a line for each design.
std::string front_section(const Problem& problem, const Result& result, const TextStyle& style) {
    if (problem.solver.pareto == 0) return {};
    const auto& terms = problem.objective->terms;
    Table table{{Align::right, Align::point, Align::point}, {{""}}};
    for (const ObjectiveTerm& term : terms) {
        const Quantity& q = problem.mechanism->quantities[term.quantity];
        const std::string unit = unit_label(q.unit, problem.units);
        table.rows.front().push_back(std::string(q.name) + (unit.empty() ? "" : " (" + unit + ")"));
    }
    for (std::size_t i = 0; i < result.front.size(); ++i) {
        const Design& design = result.front[i].solution.design;
        table.rows.push_back({std::to_string(i + 1)});
        for (const ObjectiveTerm& term : terms) {
            const Unit unit = problem.mechanism->quantities[term.quantity].unit;
            const auto value = quantity_value(problem, term.quantity, design);
            table.rows.back().push_back(value ? quantity_text(*value, unit, problem, design, style.digits) : "-");
        }
    }
    return heading("Front", style) + to_text(table, 2) +
           folded("  ", counted(static_cast<long>(result.front.size()), "design, verified.",
                                "designs, each verified (see --json or --out)."));
}

/// The parts of a range of inputs over which a design assembles, their ends by halving; shorter ones than a sample is
/// from the next are not seen.
std::vector<Vector<double>> parts_that_assemble(const FinishedDesign& design, const Vector<double>& range) {
    constexpr int samples = 720, halvings = 50;
    const auto assembles = [&](double at) { return MotionRow(design, at).assembled(); };
    const auto sample = [&](int i) { return range.x + (range.y - range.x) * i / samples; };
    const auto end_between = [&](double inside, double outside) {
        for (int k = 0; k < halvings; ++k) {
            const double middle = 0.5 * (inside + outside);
            (assembles(middle) ? inside : outside) = middle;
        }
        return inside;
    };
    std::vector<Vector<double>> parts;
    bool before = false;
    for (int i = 0; i <= samples; ++i) {
        const bool here = assembles(sample(i));
        if (here && !before) parts.push_back({i == 0 ? sample(0) : end_between(sample(i), sample(i - 1)), sample(i)});
        if (here) parts.back().y = sample(i);
        if (before && !here) parts.back().y = end_between(sample(i - 1), sample(i));
        before = here;
    }
    return parts;
}

std::string motion_line(const Problem& problem, const Design& design, int digits) {
    const Motion motion = motion_of(problem, design);
    const std::string_view input = input_word(*problem.mechanism);
    const Unit unit = input_unit(*problem.mechanism);
    if (!(motion.from <= motion.to)) return fmt::format("\nIt does not assemble at any {}.\n", input);
    if (const std::string apart = where_it_comes_apart(problem, design, digits); !apart.empty())
        return '\n' + folded("", "I" + apart.substr(1) + '.');
    const auto found = circuit_of(problem, motion, design);
    const std::string where = found ? fmt::format(", on branch {} of circuit {}", found->branch, found->circuit) : "";
    if (motion.full_turn) return problem.mechanism->profile ? "" : fmt::format("\nThe crank turns fully{}.\n", where);
    const std::string range =
        fmt::format("{}s from {} to {}{}", input, quantity_with_unit(motion.from, unit, problem, design, digits),
                    quantity_with_unit(motion.to, unit, problem, design, digits), where);
    return problem.use ? '\n' + folded("", fmt::format("Range of use: {}; {}", range, words_of_use(problem)))
                       : fmt::format("\nMotion: {}.\n", range);
}

/// Where the design stands close to a singular position, or why there is none like it.
std::string warning_section(const Problem& problem, const Design& design) {
    std::string text;
    for (const SingularMargin& m : singular_margins(problem, design))
        text +=
            folded("Warning: ",
                   m.impossible ? to_text(m, problem.units) + "."
                                : fmt::format("close to a singular position, where the errors of manufacture decide "
                                              "what it does: {} (warned of below {:g}).",
                                              to_text(m, problem.units), singular_below));
    return text.empty() ? text : '\n' + text;
}

}  // namespace

std::string where_it_comes_apart(const Problem& problem, const Design& design, int digits) {
    if (assembles_over_range(problem, design)) return {};
    const Motion motion = motion_of(problem, design);
    if (!(motion.from <= motion.to)) return {};
    const std::string_view input = input_word(*problem.mechanism);
    const auto range = [&](const Vector<double>& over) {
        const Unit unit = input_unit(*problem.mechanism);
        return fmt::format("from {} to {}", quantity_with_unit(over.x, unit, problem, design, digits),
                           quantity_with_unit(over.y, unit, problem, design, digits));
    };
    const Vector<double> given{motion.from, motion.to};
    std::vector<Vector<double>> parts = parts_that_assemble(finished_design(problem, design), given);
    if (parts.empty()) {
        const Motion own = motion_of(*problem.mechanism, design.dimensions, design.assembly, nullptr);
        if (!own.full_turn && own.from <= own.to) parts.push_back({own.from, own.to});
    }
    std::string text = fmt::format("it does not assemble throughout the {}s {}", input, range(given));
    for (std::size_t i = 0; i < parts.size(); ++i)
        text += (i == 0 ? "; it does " : " and ") + range(parts[i]);
    return text;
}

std::string summary(const Problem& problem, const Result& result, const TextStyle& style) {
    std::string text = title_section(problem, style) + status_section(result, style);
    if (result.best) {
        const Solution& best = *result.best;
        if (!best.feasible) text += obstacle(problem, best, style.digits);
        text += design_section(problem, best.design, style) + wishes_section(problem, best, style) +
                objective_section(problem, best, style) +
                (problem.use ? motion_line(problem, best.design, style.digits) : "") +
                requirement_section(problem, best.design, style) + path_section(problem, best.design, style) +
                error_section(problem, best.design, style) + dwell_section(problem, best.design, style) +
                warning_section(problem, best.design) + verification_section(result.verification, style);
    }
    return text + front_section(problem, result, style) + excluded_section(problem, result, style) +
           search_section(result.search, style) + alternatives_section(problem, result, style.digits) +
           set_aside_section(problem, result, style.digits);
}

std::string analysis_summary(const Problem& problem, const Solution& solution, const TextStyle& style) {
    const Design& design = solution.design;
    return title_section(problem, style) + design_section(problem, design, style) +
           motion_line(problem, design, style.digits) + quantity_section(problem, design, style) +
           requirement_section(problem, design, style) + path_section(problem, design, style) +
           error_section(problem, design, style) + dwell_section(problem, design, style) +
           warning_section(problem, design);
}

}  // namespace mechwright

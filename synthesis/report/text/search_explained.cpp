#include "synthesis/report/text/search_explained.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "synthesis/program/assess.h"
#include "synthesis/report/text/sections.h"
#include "synthesis/report/text/table.h"
#include "synthesis/search/optima.h"

namespace mechwright {

namespace {

constexpr std::size_t most_rows = 12;

/// Searches with one end: a feasible optimum; or designs that are not feasible; or nothing that assembles.
struct Ends {
    std::vector<const SearchEnd*> searches;  ///< the best first

    const std::optional<Solution>& best() const { return searches.front()->solution; }
    bool optimum() const { return best() && best()->feasible; }
};

bool belongs(const Problem& problem, const Ends& ends, const SearchEnd& end) {
    const bool feasible = end.solution && end.solution->feasible;
    if (ends.optimum() && feasible) return same_optimum(problem, ends.best()->design, end.solution->design);
    return !ends.optimum() && !feasible && ends.best().has_value() == end.solution.has_value();
}

/// Best first; those without a design last.
std::vector<Ends> grouped(const Problem& problem, const std::vector<SearchEnd>& all) {
    std::vector<const SearchEnd*> sorted;
    for (const SearchEnd& end : all)
        sorted.push_back(&end);
    std::stable_sort(sorted.begin(), sorted.end(), [&](const SearchEnd* a, const SearchEnd* b) {
        return a->solution && (!b->solution || preferred(problem, *a->solution, *b->solution));
    });
    std::vector<Ends> groups;
    for (const SearchEnd* end : sorted) {
        const auto group =
            std::find_if(groups.begin(), groups.end(), [&](const Ends& ends) { return belongs(problem, ends, *end); });
        (group == groups.end() ? groups.emplace_back() : *group).searches.push_back(end);
    }
    return groups;
}

std::string name_of(const Problem& problem, const Result& result, const Ends& ends) {
    if (!ends.best()) return "nothing assembles";
    if (!ends.optimum()) return "not feasible";
    const bool chosen = result.best && same_optimum(problem, result.best->design, ends.best()->design);
    return chosen ? "the design" : "an optimum";
}

std::vector<std::string> row_of(const Problem& problem, const Result& result, const Ends& ends, int digits) {
    long evaluations = 0;
    double seconds = 0;
    for (const SearchEnd* end : ends.searches) {
        evaluations += end->evaluations;
        seconds += end->seconds;
    }
    const bool known = ends.best() && std::isfinite(ends.best()->violation);
    return {std::to_string(ends.searches.size()),
            name_of(problem, result, ends),
            known && problem.objective ? objective_text(problem, *ends.best(), digits) : "",
            known ? fmt::format("{:.1e}", ends.best()->violation) : "",
            std::to_string(evaluations),
            fmt::format("{:.3f} s", seconds)};
}

/// "slsqp: steps too small 28, slsqp: failed 4", the most frequent first.
std::string counted(const Ends& ends, std::string_view SearchEnd::*what) {
    std::map<std::string_view, int> counts;
    for (const SearchEnd* end : ends.searches)
        ++counts[end->*what];
    std::vector<std::pair<std::string_view, int>> sorted(counts.begin(), counts.end());
    std::stable_sort(sorted.begin(), sorted.end(), [](const auto& a, const auto& b) { return a.second > b.second; });
    std::string text;
    for (const auto& [word, count] : sorted)
        text += fmt::format("{}{} {}", text.empty() ? "" : ", ", word.empty() ? "not begun" : word, count);
    return text;
}

std::string ends_section(const Problem& problem, const Result& result, const SearchTrace& trace,
                         const TextStyle& style) {
    const std::vector<Ends> groups = grouped(problem, trace.ends);
    Table table{{Align::right, Align::left, Align::point, Align::right, Align::right, Align::right},
                {{"searches", "end", problem.objective ? "objective" : "", "violation", "evaluations", "time"}}};
    const std::size_t shown = std::min(groups.size(), most_rows);
    for (std::size_t i = 0; i < shown; ++i)
        table.rows.push_back(row_of(problem, result, groups[i], style.digits));
    std::string lines = to_text(table, 2), text;
    for (std::size_t i = 0, at = 0; i <= shown; ++i) {
        const std::size_t end = lines.find('\n', at) + 1;
        text += lines.substr(at, end - at);
        at = end;
        if (i > 0)
            text += folded("            ", fmt::format("{}; from {}", counted(groups[i - 1], &SearchEnd::verdict),
                                                       counted(groups[i - 1], &SearchEnd::from)));
    }
    if (groups.size() > shown) {
        std::size_t others = 0;
        for (std::size_t i = shown; i < groups.size(); ++i)
            others += groups[i].searches.size();
        text += fmt::format("  and {} more ends of {} searches\n", groups.size() - shown, others);
    }
    return heading("Ends of local searches", style) + text +
           folded("  ", "Objective and violation are evaluated again; what solvers say of themselves is only shown.");
}

std::string time_section(const Result& result, const SearchTrace& trace, const TextStyle& style) {
    Table table{{Align::left, Align::point}, {}};
    const auto add = [&](const char* what, double seconds) {
        table.rows.push_back({what, fmt::format("{:.4f} s", seconds)});
    };
    add("reading the file", trace.reading);
    add("screening starts", trace.screening);
    add("local searches", trace.searching - trace.polishing);
    add("polishing", trace.polishing);
    if (trace.proving > 0) add("proving", trace.proving);
    add("verification", trace.verification);
    add("from beginning to end", result.search.seconds);
    return heading("Time, of all threads together but for the last", style) + to_text(table, 2);
}

}  // namespace

std::string search_explained(const Problem& problem, const Result& result, const SearchTrace& trace,
                             const TextStyle& style) {
    if (trace.ends.empty())
        return heading("Starts", style) +
               folded("  ", fmt::format("None: the method {} has no local searches.", result.search.method)) +
               time_section(result, trace, style);
    std::string starts = fmt::format(
        "{} candidates drawn, of which {} assembled and were screened, {} starts optimised, {} searches "
        "taken to their end.",
        result.search.drawn, result.search.assembled, result.search.optimised, trace.ends.size());
    if (trace.cut_off > 0) starts += fmt::format(" {} cut off by the limit, or never begun.", trace.cut_off);
    return heading("Starts", style) + folded("  ", starts) + ends_section(problem, result, trace, style) +
           time_section(result, trace, style);
}

}  // namespace mechwright

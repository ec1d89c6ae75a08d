#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "synthesis/bench/agreement/answer.h"
#include "synthesis/bench/pages/markdown.h"
#include "synthesis/bench/sections.h"
#include "synthesis/bench/shipped.h"
#include "synthesis/document/document.h"

namespace mechwright::bench {

namespace {

Cell cell(double value) { return std::isfinite(value) ? Cell(value) : Cell(); }

/// Whether there is an optimum that a search can start near.
bool has_optimum(const Answer& answer) { return answer.kind == AnswerKind::optimum; }

bool is_local(std::string_view method) { return method == "slsqp" || method == "ipopt"; }

Row row_of(const Answer& answer, Cell apart, const std::optional<Return>& nearby, std::string_view alone) {
    const SearchReport& search = answer.result.search;
    const auto part = [&](std::size_t k) { return k < answer.numbers.size() ? cell(answer.numbers[k]) : Cell(); };
    return {answer.method,
            bench::name_of(answer.kind),
            mechwright::name_of(answer.result.status),
            answer.result.verified(),
            search.complete(),
            part(0),
            part(1),
            std::move(apart),
            nearby ? cell(nearby->away) : Cell(),
            nearby ? cell(nearby->difference) : Cell(),
            search.evaluations,
            search.starts,
            search.hits,
            search.seconds,
            alone};
}

/// A method that only starts near the answer of another.
Row row_of_nearby(const Problem& problem, const Answer& first, const std::string& method) {
    Row row(15);
    row[0] = method;
    const Return found = return_from_nearby(problem, first.result.best->design, method);
    row[8] = cell(found.away);
    row[9] = cell(found.difference);
    return row;
}

/// A method that searches by itself; and where its answer is another, from near the first.
Row row_of_search(const Problem& problem, const Answer& first, const std::string& method, const RunOptions& options) {
    const Answer other = answer_of(problem, method, options);
    const double apart = difference(first, other);
    std::optional<Return> nearby;
    if (!(apart <= agree_within) && has_optimum(first) && is_local(method))
        nearby = return_from_nearby(problem, first.result.best->design, method);
    return row_of(other, cell(apart), nearby, "");
}

/// The method that the file asks for, then the others. In a quick look Ipopt, which takes a thousand times as long for
/// a start as SLSQP does, only starts nearby.
std::vector<Row> compared(const Problem& problem, const Effort& effort) {
    RunOptions options;
    options.jobs = effort.jobs;
    options.stop = effort.stop;
    const Answer first = answer_of(problem, problem.solver.method, options);
    std::vector<Row> rows{row_of(first, Cell(), std::nullopt, why_alone(problem, first))};
    for (const std::string& method : methods_for(problem)) {
        if (method == first.method || first.method == "given" || effort.stopped()) continue;
        if (effort.full || method != "ipopt")
            rows.push_back(row_of_search(problem, first, method, options));
        else if (has_optimum(first))
            rows.push_back(row_of_nearby(problem, first, method));
    }
    return rows;
}

/// All problems, or every fifth in a quick look.
std::vector<Measurement> agreement_measurements(const Effort& effort) {
    std::vector<Measurement> all;
    std::vector<ShippedProblem> shipped = shipped_problems(effort.problems);
    for (std::size_t i = 0; i < shipped.size(); i += effort.pick<std::size_t>(5, 1))
        all.push_back({shipped[i].name,
                       [problem = std::move(shipped[i].problem)](const Effort& e) { return compared(problem, e); }});
    return all;
}

/// The answers to one problem, as the table has them.
struct Compared {
    std::string problem;
    Row first;
    std::vector<Row> same;       ///< found by a search of their own
    std::vector<Row> nearby;     ///< found again from nearby
    std::vector<Row> different;  ///< neither
};

Compared compared(const Sheet& sheet, const std::string& problem) {
    std::vector<Row> rows = sheet.where("problem", problem);
    Compared c{problem, rows.front(), {}, {}, {}};
    for (std::size_t i = 1; i < rows.size(); ++i) {
        if (sheet.number(rows[i], "difference") <= agree_within)
            c.same.push_back(rows[i]);
        else if (sheet.number(rows[i], "nearby") <= agree_within)
            c.nearby.push_back(rows[i]);
        else
            c.different.push_back(rows[i]);
    }
    return c;
}

std::string value_text(const Sheet& sheet, const Row& row) {
    const std::string answer = sheet.text(row, "answer");
    const double value = sheet.number(row, "value"), second = sheet.number(row, "second value");
    if (std::isnan(value)) return answer;
    std::string text = fmt::format("{:.10g}", value);
    if (!std::isnan(second)) text += fmt::format(" and {:.10g}", second);
    if (answer == "infeasible") return "infeasible, misses by " + text;
    return text + (sheet.cell(row, "proved") == Cell(true) ? ", proved" : "");
}

std::string method_text(const Sheet& sheet, const Row& row) {
    const double seconds = sheet.number(row, "seconds");
    return sheet.text(row, "method") + (std::isnan(seconds) ? "" : ", " + time_text(seconds));
}

/// The other methods, each with its time and how many times as long that is.
std::string others_text(const Sheet& sheet, const Compared& c) {
    std::vector<std::string> texts;
    for (const Row& row : c.same)
        texts.push_back(method_text(sheet, row) + " (" +
                        ratio_text(sheet.number(row, "seconds") / sheet.number(c.first, "seconds")) + ")");
    for (const Row& row : c.nearby)
        texts.push_back(fmt::format("{} from {:.0e} away", sheet.text(row, "method"), sheet.number(row, "away")));
    return fmt::format("{}", fmt::join(texts, "; "));
}

double greatest_difference(const Sheet& sheet, const Compared& c) {
    double most = 0;
    for (const Row& row : c.same)
        most = std::max(most, sheet.number(row, "difference"));
    for (const Row& row : c.nearby)
        most = std::max(most, sheet.number(row, "nearby"));
    return most;
}

std::string agreeing(const Sheet& sheet, const std::vector<Compared>& all) {
    MarkdownTable table{{"problem", "answer", "by", "the same by", "greatest difference"}, {}};
    for (const Compared& c : all)
        if (!c.same.empty() || !c.nearby.empty())
            table.rows.push_back({c.problem, value_text(sheet, c.first), method_text(sheet, c.first),
                                  others_text(sheet, c), significant(greatest_difference(sheet, c), 2)});
    return to_markdown(table);
}

/// How much worse an answer is, or what it is instead.
std::string instead(const Sheet& sheet, const Row& first, const Row& row) {
    const double apart = sheet.number(row, "difference");
    if (std::isnan(apart)) return sheet.text(row, "answer").empty() ? "" : sheet.text(row, "answer");
    if (sheet.text(row, "answer") != sheet.text(first, "answer")) return sheet.text(row, "answer");
    return fmt::format("{:.10g}, {} apart", sheet.number(row, "value"), significant(apart, 2));
}

std::string elsewhere(const Sheet& sheet, const std::vector<Compared>& all) {
    MarkdownTable table{{"problem", "answer", "by", "another answer", "of", "starts", "from nearby"}, {}};
    for (const Compared& c : all)
        for (const auto* rows : {&c.nearby, &c.different})
            for (const Row& row : *rows)
                if (!sheet.text(row, "answer").empty() || rows == &c.different)
                    table.rows.push_back({c.problem, value_text(sheet, c.first), sheet.text(c.first, "method"),
                                          instead(sheet, c.first, row), sheet.text(row, "method"),
                                          sheet.cell(row, "starts").is_null() ? "" : sheet.cell(row, "starts").dump(),
                                          significant(sheet.number(row, "nearby"), 2)});
    if (table.rows.empty()) return {};
    return "\nSearches that ended elsewhere, and how far from the optimum above they end when they start near it:\n\n" +
           to_markdown(table);
}

std::string alone(const Sheet& sheet, const std::vector<Compared>& all) {
    MarkdownTable table{{"problem", "answer", "by", "why no other"}, {}};
    for (const Compared& c : all)
        if (c.same.empty() && c.nearby.empty() && c.different.empty())
            table.rows.push_back(
                {c.problem, value_text(sheet, c.first), sheet.text(c.first, "method"), sheet.text(c.first, "alone")});
    if (table.rows.empty()) return {};
    return "\nProblems that one method answers:\n\n" + to_markdown(table);
}

std::string agreement_chapter(const Sheet& sheet) {
    std::vector<Compared> all;
    for (const std::string& problem : sheet.distinct("problem"))
        all.push_back(compared(sheet, problem));
    const auto count = [&](const auto& of) { return std::count_if(all.begin(), all.end(), of); };
    const auto by_search = count([](const Compared& c) { return !c.same.empty(); });
    const auto by_nearby = count([](const Compared& c) { return c.same.empty() && !c.nearby.empty(); });
    const auto differ =
        count([](const Compared& c) { return c.same.empty() && c.nearby.empty() && !c.different.empty(); });
    return fmt::format(
               "Every problem that comes with mechwright, by the method that its file asks for (auto, if none) and by "
               "others. Of {}\nproblems {} have the same answer, to 1e-8, by two methods that search for themselves; "
               "of "
               "{} more a second method comes\nback to the same optimum from a design up to a thousandth away in every "
               "variable; in {} no two methods agree; {} are\nanswered by one method. Differences are relative, of "
               "what is zero by "
               "rounding in the problem's size. A trade-off\nshows the ends of its front, a problem that cannot be "
               "solved "
               "how closely it can.\n\n",
               all.size(), by_search, by_nearby, differ,
               static_cast<std::ptrdiff_t>(all.size()) - by_search - by_nearby - differ) +
           agreeing(sheet, all) + elsewhere(sheet, all) + alone(sheet, all);
}

std::vector<Diagram> agreement_diagrams(const Sheet&) { return {}; }

}  // namespace

Section agreement() {
    return {"agreement",
            "The same optimum by two methods",
            {"problem", "method", "answer", "status", "verified", "proved", "value", "second value", "difference",
             "away", "nearby", "evaluations", "starts", "hits", "seconds", "alone"},
            agreement_measurements,
            agreement_chapter,
            agreement_diagrams};
}

}  // namespace mechwright::bench

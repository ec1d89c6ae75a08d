#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "synthesis/bench/pages/markdown.h"
#include "synthesis/bench/program_times.h"
#include "synthesis/bench/sections.h"
#include "synthesis/bench/shipped.h"

namespace mechwright::bench {

namespace {

/// What value and gradient together may take, in times of the value alone.
constexpr double aim = 4;
constexpr long most_instructions = 10'000;

/// The folder of a problem and its mechanism.
std::string kind_of(const ShippedProblem& p) {
    return fmt::format("{}, {}", p.name.substr(0, p.name.find('/')), p.problem.mechanism->name);
}

std::vector<Row> measure(const Effort& effort, const std::string& name, const std::string& kind) {
    const auto problem = shipped_problem(effort.problems, name);
    const auto at = problem ? program_point(*problem) : std::nullopt;
    if (!at) return {{kind, nullptr, nullptr, nullptr, nullptr, nullptr, nullptr, nullptr}};
    const auto timings = timed({values(*at), values_and_gradients(*at), differences(*at), hessians(*at)},
                               effort.pick(5, 9), effort.pick(0.03, 0.2));
    const auto instructions = instructions_of_values(*at, most_instructions);
    return {{kind, at->program.size(), at->program.rows.size(), timings[0].median, timings[1].median, timings[2].median,
             timings[3].median, instructions ? Cell(*instructions) : Cell()}};
}

std::vector<Measurement> gradients_measurements(const Effort& effort) {
    std::vector<Measurement> all;
    std::set<std::string> kinds;
    for (const ShippedProblem& p : shipped_problems(effort.problems)) {
        const std::string kind = kind_of(p);
        if (!kinds.insert(kind).second && !effort.full) continue;
        all.push_back({p.name, [name = p.name, kind](const Effort& e) { return measure(e, name, kind); }});
    }
    return all;
}

/// What was measured of one problem.
struct Cost {
    std::string problem, kind;
    double variables, value, gradient, differences, hessian, instructions;

    double ratio() const { return gradient / value; }
};

/// Those with a point to evaluate at, the dearest gradients first.
std::vector<Cost> costs(const Sheet& sheet) {
    std::vector<Cost> all;
    for (const Row& row : sheet.rows) {
        const auto number = [&](std::string_view column) { return sheet.number(row, column); };
        const Cost cost{
            sheet.text(row, "problem"), sheet.text(row, "kind"), number("variables"), number("value"),
            number("gradient"),         number("differences"),   number("hessian"),   number("instructions")};
        if (!std::isnan(cost.value)) all.push_back(cost);
    }
    std::ranges::stable_sort(all, std::ranges::greater{}, &Cost::ratio);
    return all;
}

template <class Function>
double median_of(const std::vector<Cost>& all, const Function& number) {
    std::vector<double> numbers;
    for (const Cost& cost : all)
        numbers.push_back(number(cost));
    return timing_of(std::move(numbers)).median;
}

/// "3", or "3 to 10".
std::string range_text(double least, double greatest) {
    return least == greatest ? whole_number(least) : whole_number(least) + " to " + whole_number(greatest);
}

MarkdownTable by_kind(const Sheet& sheet, const std::vector<Cost>& all) {
    MarkdownTable table{
        {"problems", "number", "variables", "value", "with gradient", "at worst", "by differences", "Hessian"}, {}};
    for (const std::string& kind : sheet.distinct("kind")) {
        std::vector<Cost> these;
        std::ranges::copy_if(all, std::back_inserter(these), [&](const Cost& c) { return c.kind == kind; });
        if (these.empty()) continue;
        const auto [least, greatest] = std::ranges::minmax(these, {}, &Cost::variables);
        const auto ratio = [&](double Cost::*time) {
            return ratio_text(median_of(these, [&](const Cost& c) { return c.*time / c.value; }));
        };
        table.rows.push_back({kind, std::to_string(these.size()), range_text(least.variables, greatest.variables),
                              time_text(median_of(these, [](const Cost& c) { return c.value; })),
                              ratio(&Cost::gradient), ratio_text(these.front().ratio()), ratio(&Cost::differences),
                              ratio(&Cost::hessian)});
    }
    return table;
}

MarkdownTable dearest(const std::vector<Cost>& all) {
    constexpr std::size_t most = 8;
    MarkdownTable table{{"problem", "variables", "value", "instructions", "with gradient", "ratio", "by differences"},
                        {}};
    for (const Cost& c : std::span(all).first(std::min(most, all.size())))
        table.rows.push_back({c.problem, whole_number(c.variables), time_text(c.value), whole_number(c.instructions),
                              time_text(c.gradient), ratio_text(c.ratio()), ratio_text(c.differences / c.value)});
    return table;
}

std::string gradients_chapter(const Sheet& sheet) {
    const std::vector<Cost> all = costs(sheet);
    std::string text =
        "The program of a problem at one point: the value of objective and constraints, in medians over the problems; "
        "and, in times of that, value with all exact first derivatives, the same by forward differences, and the "
        "Hessian of the Lagrangian.\n\n" +
        to_markdown(by_kind(sheet, all));
    if (all.empty()) return text;
    const auto within = std::ranges::count_if(all, [](const Cost& c) { return c.ratio() <= aim; });
    const auto dearer = std::ranges::count_if(all, [](const Cost& c) { return c.gradient > c.differences; });
    text += fmt::format(
        "\nThe aim is a value with its gradient in at most {} times the value alone. {} of {} problems meet it; the "
        "median is {}, the worst {} ({}). Differences are quicker than the exact gradient in {} of them. {} problems "
        "leave nothing to be designed, or do not assemble at the first starts.\n",
        aim, within, all.size(), ratio_text(median_of(all, [](const Cost& c) { return c.ratio(); })),
        ratio_text(all.front().ratio()), all.front().problem, dearer, sheet.rows.size() - all.size());
    text += fmt::format("\nThe dearest gradients (instructions of the value, where they are fewer than {}):\n\n{}",
                        most_instructions, to_markdown(dearest(all)));
    return text;
}

std::vector<Diagram> gradients_diagrams(const Sheet& sheet) {
    Diagram d;
    d.name = "gradients";
    d.title = "Value with derivatives over the value alone";
    d.x = "variables";
    d.y = "times the value alone";
    d.log_x = d.log_y = true;
    d.joined = Diagram::Joined::not_at_all;
    d.curves = {{"exact gradient", {}}, {"forward differences", {}}, {"Hessian", {}}};
    for (const Cost& c : costs(sheet)) {
        d.curves[0].points.emplace_back(c.variables, c.ratio());
        d.curves[1].points.emplace_back(c.variables, c.differences / c.value);
        d.curves[2].points.emplace_back(c.variables, c.hessian / c.value);
    }
    return {d};
}

}  // namespace

Section gradients() {
    return {"gradients",
            "Gradients: every problem that comes with mechwright",
            {"problem", "kind", "variables", "rows", "value", "gradient", "differences", "hessian", "instructions"},
            gradients_measurements,
            gradients_chapter,
            gradients_diagrams};
}

}  // namespace mechwright::bench

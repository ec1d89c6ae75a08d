#include "synthesis/study/dakota.h"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <optional>
#include <sstream>
#include <stdexcept>

#include "synthesis/document/document.h"
#include "synthesis/problem/study/varied_problem.h"
#include "synthesis/problem/units.h"
#include "synthesis/program/quantity_value.h"
#include "synthesis/report/csv/csv_text.h"
#include "synthesis/solve/solve.h"
#include "synthesis/study/tolerance.h"

namespace mechwright::dakota {

namespace {

constexpr int value_wanted = 1, gradient_wanted = 2, all_offered = 3;

/// Why an evaluation cannot be done, for the file of results.
struct Failure : std::runtime_error {
    using std::runtime_error::runtime_error;
};

struct Entry {
    std::string value;
    std::string label;
};

/// The lines of a file: a value and what it is.
class Entries {
public:
    explicit Entries(std::string_view text) : lines_{std::string(text)} {}

    std::optional<Entry> next() {
        std::string line;
        while (std::getline(lines_, line)) {
            ++number_;
            std::istringstream words(line);
            Entry entry;
            if (!(words >> entry.value)) continue;
            if (words >> entry.label) return entry;
            throw Failure(fmt::format("line {}: a value and its label are expected", number_));
        }
        return {};
    }

    Entry needed(std::string_view what) {
        if (auto entry = next()) return *std::move(entry);
        throw Failure(fmt::format("the file ends where {} is expected", what));
    }

    /// The entries that a line "3 functions" announces.
    std::size_t count_of(const Entry& entry, std::string_view label) const {
        constexpr std::size_t most = 1'000'000;
        std::size_t count = 0;
        const char* end = entry.value.data() + entry.value.size();
        const auto [stop, error] = std::from_chars(entry.value.data(), end, count);
        if (entry.label != label || error != std::errc{} || stop != end || count > most)
            throw Failure(fmt::format("line {}: a number of {} is expected", number_, label));
        return count;
    }

private:
    std::istringstream lines_;
    int number_ = 0;
};

/// "ASV_1:swing": "swing".
std::string after_colon(const std::string& label) {
    const std::size_t colon = label.find(':');
    return colon == label.npos ? label : label.substr(colon + 1);
}

Evaluation read_evaluation(Entries& in, const Entry& first) {
    Evaluation evaluation;
    const std::size_t variables = in.count_of(first, "variables");
    for (std::size_t i = 0; i < variables; ++i) {
        const Entry entry = in.needed("a variable");
        evaluation.variables.push_back({entry.label, entry.value});
    }
    const std::size_t functions = in.count_of(in.needed("the number of functions"), "functions");
    for (std::size_t i = 0; i < functions; ++i) {
        const Entry entry = in.needed("a response");
        evaluation.responses.push_back({after_colon(entry.label), std::atoi(entry.value.c_str())});
    }
    const std::size_t derivatives =
        in.count_of(in.needed("the number of derivative_variables"), "derivative_variables");
    for (std::size_t i = 0; i < derivatives; ++i) {
        const int number = std::atoi(in.needed("a derivative variable").value.c_str());
        if (number < 1 || static_cast<std::size_t>(number) > variables)
            throw Failure(fmt::format("derivative variable {} is none of the {} variables", number, variables));
        evaluation.derivative_variables.push_back(static_cast<std::size_t>(number) - 1);
    }
    const std::size_t components = in.count_of(in.needed("the number of analysis_components"), "analysis_components");
    for (std::size_t i = 0; i < components; ++i)
        in.needed("an analysis component");
    evaluation.id = in.needed("eval_id").value;
    return evaluation;
}

/// Puts a value as it is written: a whole number, a number or a word.
void put(VariedProblem& problem, const Variable& variable) {
    const char* end = variable.value.data() + variable.value.size();
    double number = 0;
    const auto [stop, error] = std::from_chars(variable.value.data(), end, number);
    const bool is_number = error == std::errc{} && stop == end;
    const bool whole = is_number && variable.value.find_first_not_of("+-0123456789") == std::string::npos;
    const std::string fault =
        whole       ? problem.put(variable.name, toml::value<std::int64_t>(static_cast<std::int64_t>(number)))
        : is_number ? problem.put(variable.name, toml::value<double>(number))
                    : problem.put(variable.name, toml::value<std::string>(variable.value));
    if (!fault.empty()) throw Failure(fault);
}

double value_of(const Problem& problem, const Solution& best, const std::string& name) {
    if (name == "violation") return best.violation;
    if (name == "objective" && problem.objective) return best.objective;
    const Mechanism& mechanism = *problem.mechanism;
    if (name.starts_with("design.")) {
        const int i = find_dimension(mechanism, name.substr(7));
        if (i < 0) throw Failure("there is no dimension '" + name.substr(7) + "'");
        const auto at = static_cast<std::size_t>(i);
        return in_file_unit(best.design.dimensions[at], unit_of(mechanism.dimensions[at].kind), problem.units);
    }
    const int i = find_quantity(mechanism, name);
    if (i < 0) throw Failure("there is no quantity '" + name + "'");
    const auto at = static_cast<std::size_t>(i);
    const auto value = quantity_value(problem, at, best.design);
    if (!value) throw Failure("'" + name + "' has no value for this design");
    return in_file_unit(*value, mechanism.quantities[at].unit, problem.units);
}

std::vector<double> gradient_of(const Problem& problem, const Solution& best, const std::string& name,
                                const Evaluation& evaluation) {
    const Mechanism& mechanism = *problem.mechanism;
    const int quantity = find_quantity(mechanism, name);
    const auto all =
        quantity < 0 ? std::nullopt : sensitivities(problem, static_cast<std::size_t>(quantity), best.design);
    if (!all) throw Failure("'" + name + "' has no gradient here");
    const Unit of = mechanism.quantities[static_cast<std::size_t>(quantity)].unit;
    std::vector<double> gradient;
    for (const std::size_t variable : evaluation.derivative_variables) {
        const std::string& path = evaluation.variables[variable].name;
        const int i = path.starts_with("dimensions.") ? find_dimension(mechanism, path.substr(11)) : -1;
        if (i < 0) throw Failure("there is no gradient with respect to '" + path + "': it is not a dimension");
        const auto at = static_cast<std::size_t>(i);
        gradient.push_back((*all)[at] * file_units_per_inner(of, problem.units) /
                           file_units_per_inner(unit_of(mechanism.dimensions[at].kind), problem.units));
    }
    return gradient;
}

/// The design of the problem with the values of an evaluation.
struct Solved {
    Problem problem;
    Result result;
};

Solved solved(const Evaluation& evaluation, std::string_view text, const std::string& file) {
    VariedProblem varied(text, file);
    for (const Variable& variable : evaluation.variables)
        put(varied, variable);
    ReadProblem read = varied.read();
    for (const Message& message : read.messages)
        if (!message.warning) throw Failure(message.text);
    Result result = solve(read.problem, {});
    // The requirements of a design that is given are for whoever drives to judge.
    if (!result.best || (result.status != Status::solved && result.search.method != "given"))
        throw Failure(fmt::format("{}: {}", name_of(result.status), result.note));
    return {std::move(read.problem), std::move(result)};
}

std::string written(const Evaluation& evaluation, const Solved& solved) {
    const Solution& best = *solved.result.best;
    std::string values, gradients;
    for (const Response& response : evaluation.responses) {
        if ((response.wanted & ~all_offered) != 0) throw Failure("Hessian matrices are not offered");
        if ((response.wanted & value_wanted) != 0)
            values += csv_number(value_of(solved.problem, best, response.name)) + " " + response.name + "\n";
        if ((response.wanted & gradient_wanted) == 0) continue;
        if (solved.result.search.method != "given")
            throw Failure("gradients are offered for designs whose dimensions are all given");
        gradients += "[";
        for (const double g : gradient_of(solved.problem, best, response.name, evaluation))
            gradients += " " + csv_number(g);
        gradients += " ]\n";
    }
    return values + gradients;
}

}  // namespace

ReadEvaluations read_parameters(std::string_view text) {
    ReadEvaluations read;
    try {
        Entries in(text);
        while (const auto first = in.next())
            read.evaluations.push_back(read_evaluation(in, *first));
        if (read.evaluations.empty()) read.fault = "the file is empty";
    } catch (const Failure& failure) {
        read.fault = failure.what();
    }
    return read;
}

std::string results_of(const Evaluation& evaluation, std::string_view text, const std::string& file) {
    try {
        return written(evaluation, solved(evaluation, text, file));
    } catch (const Failure& failure) {
        return fmt::format("FAIL\n{}\n", failure.what());
    }
}

std::string results_of(const std::vector<Evaluation>& evaluations, std::string_view text, const std::string& file) {
    std::string all;
    for (const Evaluation& evaluation : evaluations) {
        if (evaluations.size() > 1) all += "# " + evaluation.id + "\n";
        all += results_of(evaluation, text, file);
    }
    return all;
}

}  // namespace mechwright::dakota

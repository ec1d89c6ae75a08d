#include "synthesis/python/designs.h"

#include <fmt/format.h>

#include "synthesis/document/document.h"
#include "synthesis/program/assess.h"
#include "synthesis/program/left_open.h"

namespace mechwright::python {

namespace {

namespace py = pybind11;
using Json = nlohmann::ordered_json;

[[noreturn]] void refuse_alternative(std::int64_t alternative, const std::string& why) {
    throw py::value_error(fmt::format("alternative: {}: {}", alternative, why));
}

/// The document with an alternative in the place of its own design.
Json with_alternative(const ResultArgument& result, std::int64_t alternative) {
    const auto found = result.document.find("alternatives");
    const std::size_t count = found != result.document.end() && found->is_array() ? found->size() : 0;
    const auto index = static_cast<std::size_t>(alternative - 1);
    if (index >= count || !(*found)[index].is_object() || !(*found)[index].contains("design"))
        refuse_alternative(alternative, fmt::format("{} has {} alternatives", result.name, count));
    return with_other_design(result.document, (*found)[index]);
}

ShownDesign of_result(const py::object& argument, std::int64_t alternative) {
    ResultArgument result = result_of(argument);
    if (alternative > 0) result.document = with_alternative(result, alternative);
    FinishedOrNot finished = finished_design(result.document);
    if (!finished.defect.empty()) refuse_result(result.name, finished.defect);
    if (!finished.design.assembles()) refuse_result(result.name, "its design does not assemble at any crank angle");
    const Json& problem = result.document["problem"];
    const auto title = problem.find("title");
    const bool titled = title != problem.end() && title->is_string();
    return {std::move(finished.design), result.document, titled ? title->get<std::string>() : "", result.name};
}

ShownDesign of_problem(const py::object& argument) {
    const auto [problem, solution] = given_design(argument);
    FinishedDesign design = finished_design(problem, solution.design);
    if (!design.assembles()) refuse_problem(problem, "the mechanism does not assemble at any crank angle");
    return {std::move(design), analysis_document(problem, solution), problem.title, problem.file};
}

}  // namespace

GivenDesign given_design(const py::object& argument) {
    GivenDesign given{problem_of(argument), {}};
    if (const std::string why = why_not_analysable(given.problem); !why.empty()) refuse_problem(given.problem, why);
    const py::gil_scoped_release release;
    given.solution = evaluate_given(given.problem);
    return given;
}

ShownDesign shown_design(const py::object& argument, std::int64_t alternative) {
    if (alternative < 0) refuse_alternative(alternative, "they count from 1");
    if (is_result(argument)) return of_result(argument, alternative);
    if (alternative > 0) refuse_alternative(alternative, "a problem has none, but a result");
    return of_problem(argument);
}

}  // namespace mechwright::python

#include <fmt/format.h>
#include <pybind11/numpy.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "synthesis/document/claimed_problem.h"
#include "synthesis/document/document.h"
#include "synthesis/problem/units.h"
#include "synthesis/program/assess.h"
#include "synthesis/python/arguments.h"
#include "synthesis/python/calls.h"
#include "synthesis/python/designs.h"
#include "synthesis/python/values.h"
#include "synthesis/report/drawing/finished.h"

namespace mechwright::python {

namespace {

namespace py = pybind11;
using Json = nlohmann::ordered_json;

constexpr std::int64_t most_steps = 1'000'000;

/// A member of the document's problem that names it.
std::string text_member(const Json& document, const char* name) {
    const Json& problem = document["problem"];
    const auto found = problem.find(name);
    return found != problem.end() && found->is_string() ? found->get<std::string>() : std::string();
}

GivenDesign result_design(const py::object& argument) {
    const ResultArgument result = result_of(argument);
    const ReadClaim read = read_claim(result.document);
    if (!read.defect.empty()) refuse_result(result.name, read.defect);
    if (const std::string why = why_not_evaluable(read.claim); !why.empty()) refuse_result(result.name, why);
    const py::gil_scoped_release release;
    auto [problem, design] = claimed_design(read.claim);
    problem.file = text_member(result.document, "file");
    problem.sha256 = text_member(result.document, "sha256");
    problem.title = text_member(result.document, "title");
    Solution solution = assess(problem, std::move(design));
    return {std::move(problem), std::move(solution)};
}

using Column = py::array_t<double>;
using Shape = std::vector<py::ssize_t>;

/// Rows that the mechanism does not assemble for are NaN.
py::dict motion_arrays(const FinishedDesign& design, const std::vector<double>& angles, const Shape& shape) {
    const auto& names = design.mechanism->table.columns;
    std::vector<Column> columns;
    std::vector<double*> to;
    py::dict arrays;
    for (const std::string_view name : names) {
        columns.emplace_back(shape);
        to.push_back(columns.back().mutable_data());
        arrays[text_of(name)] = columns.back();
    }
    const py::gil_scoped_release release;
    for (std::size_t i = 0; i < angles.size(); ++i) {
        const MotionRow row(design, angles[i]);
        const bool known = std::isfinite(angles[i]) && row.assembled();
        for (std::size_t c = 0; c < names.size(); ++c)
            to[c][i] = known ? in_file_unit(design, row, c) : std::numeric_limits<double>::quiet_NaN();
    }
    return arrays;
}

/// At the crank angles that are asked for, in any shape.
py::dict motion_at(const FinishedDesign& design, const py::object& crank_angles) {
    const py::module_ numpy = py::module_::import("numpy");
    const py::array_t<double, py::array::c_style | py::array::forcecast> asked =
        numpy.attr("asarray")(crank_angles, py::arg("dtype") = "float64");
    std::vector<double> angles;
    for (py::ssize_t i = 0; i < asked.size(); ++i)
        angles.push_back(from_file_unit(asked.data()[i], input_unit(design), design.units));
    return motion_arrays(design, angles, Shape(asked.shape(), asked.shape() + asked.ndim()));
}

/// As the table of the command line: steps at which the mechanism does not assemble are left out.
py::dict motion_in_steps(const FinishedDesign& design, int steps) {
    std::vector<double> angles = even_angles(design, steps);
    std::erase_if(angles, [&](double angle) { return !MotionRow(design, angle).assembled(); });
    return motion_arrays(design, angles, {static_cast<py::ssize_t>(angles.size())});
}

}  // namespace

py::object analyse(const py::object& argument, const py::object& crank_angles, std::int64_t steps) {
    if (steps < 1 || steps > most_steps)
        throw py::value_error(fmt::format("steps: {} is not from 1 to {}", steps, most_steps));
    const GivenDesign subject = is_result(argument) ? result_design(argument) : given_design(argument);
    const FinishedDesign design = finished_design(subject.problem, subject.solution.design);
    py::dict analysis = python_of(analysis_document(subject.problem, subject.solution));
    analysis["motion"] =
        crank_angles.is_none() ? motion_in_steps(design, static_cast<int>(steps)) : motion_at(design, crank_angles);
    return analysis;
}

}  // namespace mechwright::python

/// \file
/// The compiled part of the Python package: what it sees of the functions in calls.h.

#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include "synthesis/document/versions.h"
#include "synthesis/program/number_memory.h"
#include "synthesis/python/calls.h"
#include "synthesis/python/errors.h"

namespace {

namespace py = pybind11;
namespace python = mechwright::python;

py::object solve(const py::object& problem, std::optional<std::string> method, std::optional<std::int64_t> seed,
                 std::optional<std::int64_t> jobs, std::optional<double> time_limit, bool all) {
    return python::solve(problem, {std::move(method), seed, jobs, time_limit, all});
}

py::dict compare(const py::list& problems, std::optional<std::string> method, std::optional<std::int64_t> seed,
                 std::optional<std::int64_t> jobs, std::optional<double> time_limit) {
    return python::compare(problems, {std::move(method), seed, jobs, time_limit});
}

py::str study(const py::object& problem, const std::string& folder, std::optional<std::int64_t> jobs,
              std::optional<double> time_limit) {
    return python::study(problem, folder, {jobs, time_limit});
}

py::bytes draw(const py::object& design, std::string format, std::optional<double> seconds, bool plots,
               std::int64_t alternative, std::int64_t width) {
    return python::draw(design, {std::move(format), seconds, plots, alternative, width});
}

template <py::bytes (*draw_sheet)(const py::object&, const python::SheetOptions&)>
py::bytes sheet(const py::object& problem, std::string format, std::optional<double> at, std::int64_t width) {
    return draw_sheet(problem, {std::move(format), at, width});
}

py::bytes export_design(const py::object& design, std::string format, std::optional<double> at,
                        std::optional<double> fineness, std::int64_t alternative, std::int64_t steps) {
    return python::export_design(design, {std::move(format), at, fineness, alternative, steps});
}

}  // namespace

PYBIND11_MODULE(_program, module) {
    mechwright::throw_where_numbers_get_no_memory();
    module.doc() = "The compiled part of mechwright.";
    module.attr("__version__") = mechwright::program_version();
    python::add_errors(module);
    module.def("solve", &solve);
    module.def("analyse", &python::analyse);
    module.def("verify", &python::verify);
    module.def("quantities", &python::quantities);
    module.def("compare", &compare);
    module.def("check", &python::check);
    module.def("read", &python::read);
    module.def("draw", &draw);
    module.def("draw_figure", &sheet<python::draw_figure>);
    module.def("draw_assemblies", &sheet<python::draw_assemblies>);
    module.def("draw_skeleton", &sheet<python::draw_skeleton>);
    module.def("export_design", &export_design);
    module.def("report_results", &python::report_results);
    module.def("report_study", &python::report_study);
    module.def("explain", &python::explain);
    module.def("study", &study);
    module.def("study_standing", &python::study_standing);
    module.def("study_data", &python::study_data);
    module.def("study_charts", &python::study_charts);
    module.def("plain", &python::plain);
    module.def("problem_keys", &python::problem_keys);
    module.def("problem_text", &python::problem_text);
    module.def("result_members", &python::result_members);
    module.def("read_result", &python::read_result);
    module.def("result_text", &python::result_text);
}

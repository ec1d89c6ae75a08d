/// \file
/// The compiled part of the Python package: what it sees of the functions in calls.h.

#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include "synthesis/document/versions.h"
#include "synthesis/python/calls.h"
#include "synthesis/python/errors.h"

namespace {

namespace py = pybind11;
namespace python = mechwright::python;

py::object solve(const py::object& problem, std::optional<std::string> method, std::optional<std::int64_t> seed,
                 std::optional<std::int64_t> jobs, std::optional<double> time_limit, bool all) {
    return python::solve(problem, {std::move(method), seed, jobs, time_limit, all});
}

}  // namespace

PYBIND11_MODULE(_program, module) {
    module.doc() = "The compiled part of mechwright.";
    module.attr("__version__") = mechwright::program_version();
    python::add_errors(module);
    module.def("solve", &solve);
    module.def("analyse", &python::analyse);
    module.def("verify", &python::verify);
    module.def("quantities", &python::quantities);
    module.def("check", &python::check);
    module.def("plain", &python::plain);
    module.def("problem_keys", &python::problem_keys);
    module.def("problem_text", &python::problem_text);
    module.def("result_members", &python::result_members);
    module.def("read_result", &python::read_result);
    module.def("result_text", &python::result_text);
    module.def("picture", &python::picture);
}

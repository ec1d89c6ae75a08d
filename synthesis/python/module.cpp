/// \file
/// The Python module: what Python sees of the functions in calls.h.

#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include "synthesis/document/versions.h"
#include "synthesis/python/calls.h"
#include "synthesis/python/errors.h"

namespace {

namespace py = pybind11;
namespace python = mechwright::python;

constexpr const char* module_doc =
    "Synthesis of planar mechanisms: linkages, quick-return drives and cams.\n\n"
    "Problems are dicts with the structure of a problem file, or paths of such files. Angles are degrees unless the\n"
    "problem's [units] say radians; lengths are never converted. Lists of numbers in results are NumPy arrays.";

constexpr const char* solve_doc =
    "Designs the mechanism that a problem asks for, and verifies it.\n\n"
    "problem     a dict with the keys and values of a problem file (dicts, lists, tuples, numbers, strings, NumPy\n"
    "            arrays and scalars), in which names of files are relative to the current folder; or the path of a\n"
    "            problem file\n"
    "method      takes the place of the problem's; so do seed (from 0 on) and time_limit (seconds)\n"
    "jobs        threads, 1 to 1024; by default all processors. The numbers do not depend on it.\n"
    "all         keeps the designs with defects that an exact method finds\n\n"
    "Returns the result document as a dict. Lists of numbers are arrays of float64, points of shape (n, 2), NaN where\n"
    "there is no number. That nothing was found is no exception: see its 'status'.\n\n"
    "Raises ProblemError for a problem that is not valid, or a method that does not apply; OSError for a file that\n"
    "cannot be read; TypeError and ValueError for a dict of what no file can hold; KeyboardInterrupt on Ctrl-C, which\n"
    "ends the search. Warns with ProblemWarning. Other threads of Python run on meanwhile, and may solve too.";

constexpr const char* analyse_doc =
    "Evaluates one mechanism.\n\n"
    "problem       a problem that leaves no dimension open (dict or path), or a result of solve (dict, or the path of\n"
    "              a file that ends in .json)\n"
    "crank_angles  an array of any shape, in the angle unit of the problem, counted from the ground link; by default\n"
    "              the ends of the motion and steps - 1 angles between them at which the mechanism assembles\n"
    "steps         1 to 1000000\n\n"
    "Returns a dict: units, design, quantities, requirements and what else the result document says of a design, and\n"
    "'motion', a dict of arrays of float64 by the names of the columns ('rocker-angle'), of the shape of crank_angles\n"
    "and in the problem's units. Where the mechanism does not assemble at a given crank angle they are NaN; where it\n"
    "assembles at none, the arrays are empty.\n\n"
    "Raises ProblemError, OSError, TypeError and ValueError as solve does; ValueError for what is not a result.";

constexpr const char* verify_doc =
    "Checks a result (dict, or path of a file) again from the document alone, independently of the optimiser, in "
    "fifty\n"
    "digits.\n\n"
    "Returns {'passed': bool, 'checks': [{'name', 'passed', 'detail'}, ...]}. Raises ValueError for what is not a\n"
    "result document, OSError for a file that cannot be read.";

constexpr const char* quantities_doc =
    "What can be required or optimised of a mechanism ('four-bar'): name -> {'unit', 'meaning'}. The unit is "
    "'number',\n"
    "'length', 'area', 'angle', 'force' or 'torque'. Raises ValueError for an unknown mechanism.";

}  // namespace

PYBIND11_MODULE(mechwright, module) {
    module.doc() = module_doc;
    module.attr("__version__") = mechwright::program_version();
    python::add_errors(module);
    const auto solve = [](const py::object& problem, std::optional<std::string> method,
                          std::optional<std::int64_t> seed, std::optional<std::int64_t> jobs,
                          std::optional<double> time_limit, bool all) {
        return python::solve(problem, {std::move(method), seed, jobs, time_limit, all});
    };
    module.def("solve", solve, solve_doc, py::arg("problem"), py::kw_only(), py::arg("method") = py::none(),
               py::arg("seed") = py::none(), py::arg("jobs") = py::none(), py::arg("time_limit") = py::none(),
               py::arg("all") = false);
    module.def("analyse", &python::analyse, analyse_doc, py::arg("problem"), py::kw_only(),
               py::arg("crank_angles") = py::none(), py::arg("steps") = 360);
    module.def("verify", &python::verify, verify_doc, py::arg("result"));
    module.def("quantities", &python::quantities, quantities_doc, py::arg("mechanism"));
}

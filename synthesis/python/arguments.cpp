#include "synthesis/python/arguments.h"

#include <pybind11/stl.h>

#include "synthesis/document/result_file.h"
#include "synthesis/problem/reader.h"
#include "synthesis/python/calls.h"
#include "synthesis/python/errors.h"
#include "synthesis/python/values.h"

namespace mechwright::python {

namespace {

namespace py = pybind11;

/// The bytes of a path; throws TypeError for what is neither a path nor a dict.
std::string path_of(const py::object& argument, const char* what) {
    if (!PyUnicode_Check(argument.ptr()) && !py::hasattr(argument, "__fspath__")) {
        const auto type = py::str(py::type::handle_of(argument).attr("__name__")).cast<std::string>();
        throw py::type_error(std::string("a ") + what + " is a dict, or a path (str or os.PathLike), not a " + type);
    }
    PyObject* bytes = nullptr;
    if (PyUnicode_FSConverter(argument.ptr(), &bytes) == 0) throw py::error_already_set();
    return py::reinterpret_steal<py::bytes>(bytes);
}

ReadProblem read_released(const std::string& file) {
    const py::gil_scoped_release release;
    return read_problem(file);
}

ReadJson read_json_released(const std::string& file) {
    const py::gil_scoped_release release;
    return read_result_file(file);
}

nlohmann::ordered_json read_document(const std::string& file) {
    ReadJson read = read_json_released(file);
    if (!read.fault.empty()) raise_error(read.unreadable ? PyExc_OSError : PyExc_ValueError, file + ": " + read.fault);
    return std::move(read.json);
}

ReadProblem parse_released(const std::string& text, const std::string& name) {
    const py::gil_scoped_release release;
    return parse_problem(text, name);
}

constexpr const char* result_for_problem =
    "a result, where a problem is wanted: solve takes the problem that the result is of "
    "(Problem.from_toml(result.problem.text), if it was a file); analyse, verify, draw, export and report take results";

[[noreturn]] void refuse_result_for_problem(const std::string& name) {
    raise_problem_error({Message{.file = name, .text = result_for_problem}}, false);
}

ReadProblem take(const py::dict& dict, const std::string& name) {
    if (is_result(dict)) refuse_result_for_problem(name);
    const nlohmann::ordered_json tables = json_of(dict, Absent::refused);
    const py::gil_scoped_release release;
    return take_problem(tables, name);
}

/// The path of a file of a problem: one with a result is refused.
std::string problem_path(const py::object& argument) {
    std::string file = path_of(argument, "problem");
    if (!file.ends_with(".json")) return file;
    const ReadJson json = read_json_released(file);
    if (json.fault.empty() && why_not_a_result(json.json).empty()) refuse_result_for_problem(file);
    return file;
}

/// The other way round: results name the mechanism elsewhere.
void refuse_if_problem(const py::dict& dict) {
    if (dict.contains("mechanism") && !dict.contains("problem"))
        refuse_result(name_of_dict, "it is a problem; give what solve returns for it");
}

ReadProblem read_argument(const py::object& argument) {
    if (py::isinstance<py::dict>(argument)) return take(argument, name_of_dict);
    if (!py::isinstance<py::tuple>(argument)) return read_released(problem_path(argument));
    const auto [content, file] = argument.cast<std::pair<py::object, py::object>>();
    const std::string name = path_of(file, "name");
    return py::isinstance<py::dict>(content) ? take(content, name) : parse_released(content.cast<std::string>(), name);
}

}  // namespace

Problem problem_of(const py::object& argument) {
    ReadProblem problem = read_argument(argument);
    if (problem.unreadable || !problem.ok()) raise_problem_error(problem.messages, problem.unreadable);
    warn(problem.messages);
    return std::move(problem.problem);
}

ReadLinkage linkage_of(const py::object& argument) {
    const bool named = py::isinstance<py::tuple>(argument);
    if (!named && !py::isinstance<py::dict>(argument)) {
        const std::string file = problem_path(argument);
        const py::gil_scoped_release release;
        return read_linkage(file);
    }
    const auto [content, file] = named ? argument.cast<std::pair<py::object, py::object>>()
                                       : std::pair<py::object, py::object>(argument, py::str(name_of_dict));
    const std::string name = path_of(file, "name");
    if (py::isinstance<py::dict>(content) && is_result(content)) refuse_result_for_problem(name);
    const auto text = (py::isinstance<py::dict>(content) ? problem_text(content) : content).cast<std::string>();
    const py::gil_scoped_release release;
    return parse_linkage(text, name);
}

ProblemText problem_text_of(const py::object& argument) {
    if (!py::isinstance<py::dict>(argument) && !py::isinstance<py::tuple>(argument))
        return {std::nullopt, problem_path(argument)};
    const auto [content, file] = py::isinstance<py::tuple>(argument)
                                     ? argument.cast<std::pair<py::object, py::object>>()
                                     : std::pair<py::object, py::object>(argument, py::str(name_of_dict));
    if (!py::isinstance<py::dict>(content)) return {content.cast<std::string>(), path_of(file, "name")};
    problem_of(argument);  // its messages name values of the dict, those about a text its lines
    return {problem_text(content).cast<std::string>(), path_of(file, "name"), true};
}

void refuse_problem(const Problem& problem, const std::string& text) {
    raise_problem_error({Message{.file = problem.file, .text = text}}, false);
}

bool is_result(const py::object& argument) {
    if (py::isinstance<py::dict>(argument)) {
        const auto dict = py::reinterpret_borrow<py::dict>(argument);
        return dict.contains("problem") && !dict.contains("mechanism");
    }
    return !py::isinstance<py::tuple>(argument) && path_of(argument, "problem or result").ends_with(".json");
}

ResultArgument result_of(const py::object& argument) {
    ResultArgument result{{}, name_of_dict};
    if (py::isinstance<py::dict>(argument)) {
        refuse_if_problem(argument);
        result.document = json_of(argument, Absent::null);
    } else {
        result.name = path_of(argument, "result");
        result.document = read_document(result.name);
    }
    if (const std::string why = why_not_a_result(result.document); !why.empty()) refuse_result(result.name, why);
    return result;
}

std::vector<ResultArgument> results_of(const py::object& argument) {
    if (py::isinstance<py::dict>(argument)) return {result_of(argument)};
    const std::string file = path_of(argument, "result");
    nlohmann::ordered_json document = read_document(file);
    std::vector<ResultArgument> results;
    for (auto& one : document.is_array() ? document : nlohmann::ordered_json::array({document})) {
        if (const std::string why = why_not_a_result(one); !why.empty()) refuse_result(file, why);
        results.push_back({std::move(one), file});
    }
    return results;
}

void refuse_result(const std::string& name, const std::string& why) {
    raise_error(PyExc_ValueError, name + ": not a result document: " + why);
}

}  // namespace mechwright::python

#include "synthesis/python/arguments.h"

#include "synthesis/document/result_file.h"
#include "synthesis/problem/reader.h"
#include "synthesis/python/errors.h"
#include "synthesis/python/problem_text.h"
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

ReadProblem parse_released(const std::string& text) {
    const py::gil_scoped_release release;
    return parse_problem(text, name_of_dict);
}

std::vector<PlacedMessage> in_file(const std::vector<Message>& messages) {
    std::vector<PlacedMessage> placed;
    for (const Message& message : messages)
        placed.push_back({message});
    return placed;
}

/// Messages about the dict itself name what they are about; those about files that it names keep their places.
std::vector<PlacedMessage> in_dict(const std::vector<Message>& messages, const ProblemText& text) {
    std::vector<PlacedMessage> placed;
    for (const Message& message : messages) {
        placed.push_back({message});
        if (message.file != name_of_dict) continue;
        placed.back().message.text = with_names(text, message.text);
        placed.back().in_file = false;
        placed.back().name = name_at(text, {message.line, message.column});
    }
    return placed;
}

Problem accepted(ReadProblem&& read, const std::vector<PlacedMessage>& messages) {
    if (read.unreadable || !read.ok()) raise_problem_error(messages, read.unreadable);
    warn(messages);
    return std::move(read.problem);
}

}  // namespace

Problem problem_of(const py::object& argument) {
    if (!py::isinstance<py::dict>(argument)) {
        ReadProblem read = read_released(path_of(argument, "problem"));
        const std::vector<PlacedMessage> messages = in_file(read.messages);
        return accepted(std::move(read), messages);
    }
    const ProblemText text = problem_text(json_of(argument, Absent::refused));
    ReadProblem read = parse_released(text.text);
    const std::vector<PlacedMessage> messages = in_dict(read.messages, text);
    return accepted(std::move(read), messages);
}

void refuse_problem(const Problem& problem, const std::string& text) {
    const Message message{.file = problem.file, .text = text};
    raise_problem_error({{message, problem.file != name_of_dict}}, false);
}

bool is_result(const py::object& argument) {
    if (py::isinstance<py::dict>(argument)) {
        const auto dict = py::reinterpret_borrow<py::dict>(argument);
        return dict.contains("problem") && !dict.contains("mechanism");
    }
    return path_of(argument, "problem or result").ends_with(".json");
}

ResultArgument result_of(const py::object& argument) {
    ResultArgument result{{}, name_of_dict};
    if (py::isinstance<py::dict>(argument)) {
        result.document = json_of(argument, Absent::null);
    } else {
        result.name = path_of(argument, "result");
        result.document = read_document(result.name);
    }
    if (const std::string why = why_not_a_result(result.document); !why.empty()) refuse_result(result.name, why);
    return result;
}

void refuse_result(const std::string& name, const std::string& why) {
    raise_error(PyExc_ValueError, name + ": not a result document: " + why);
}

}  // namespace mechwright::python

#include "synthesis/python/errors.h"

#include "synthesis/python/values.h"

namespace mechwright::python {

namespace {

namespace py = pybind11;

constexpr const char* problem_error_doc =
    "A problem that cannot be read or solved. str() gives every message, one to a line, as `mechwright check` prints\n"
    "them. The attribute `messages` is a list of dicts: file, line, column (from 1; None where the message is about "
    "the\n"
    "whole), name (for a problem given as a dict what the message is about, 'require[0].min'; else None), text and\n"
    "warning (bool).";

constexpr const char* problem_warning_doc = "What is odd about a problem that can be solved all the same.";

// Borrowed for as long as the interpreter runs: the module holds them.
PyObject* problem_error = nullptr;
PyObject* problem_warning = nullptr;

std::string line_of(const PlacedMessage& placed) {
    Message message = placed.message;
    if (!placed.in_file) {
        message.line = 0;
        if (!placed.name.empty()) message.file = placed.name;
    }
    return to_string(message);
}

std::string lines_of(const std::vector<PlacedMessage>& messages) {
    std::string lines;
    for (const PlacedMessage& message : messages)
        lines += (lines.empty() ? "" : "\n") + line_of(message);
    return lines;
}

py::dict dict_of(const PlacedMessage& placed) {
    const Message& message = placed.message;
    const bool at_line = placed.in_file && message.line > 0;
    py::dict dict;
    dict["file"] = text_of(message.file);
    dict["line"] = at_line ? py::object(py::int_(message.line)) : py::none();
    dict["column"] = at_line ? py::object(py::int_(message.column)) : py::none();
    dict["name"] = placed.in_file ? py::object(py::none()) : text_of(placed.name);
    dict["text"] = text_of(message.text);
    dict["warning"] = message.warning;
    return dict;
}

PyObject* add_class(py::module_& module, const char* name, const char* doc, PyObject* base) {
    const std::string full = std::string("mechwright.") + name;
    PyObject* made = PyErr_NewExceptionWithDoc(full.c_str(), doc, base, nullptr);
    if (made == nullptr) throw py::error_already_set();
    module.attr(name) = py::reinterpret_borrow<py::object>(made);
    return made;
}

}  // namespace

void add_errors(py::module_& module) {
    problem_error = add_class(module, "ProblemError", problem_error_doc, PyExc_ValueError);
    problem_warning = add_class(module, "ProblemWarning", problem_warning_doc, PyExc_UserWarning);
}

void raise_problem_error(const std::vector<PlacedMessage>& messages, bool unreadable) {
    const std::string lines = lines_of(messages);
    if (unreadable) raise_error(PyExc_OSError, lines);
    py::list all;
    for (const PlacedMessage& message : messages)
        all.append(dict_of(message));
    const py::object error = py::reinterpret_borrow<py::object>(problem_error)(text_of(lines));
    error.attr("messages") = all;
    PyErr_SetObject(problem_error, error.ptr());
    throw py::error_already_set();
}

void warn(const std::vector<PlacedMessage>& messages) {
    for (const PlacedMessage& message : messages)
        if (PyErr_WarnFormat(problem_warning, 1, "%U", text_of(line_of(message)).ptr()) != 0)
            throw py::error_already_set();
}

void raise_error(PyObject* type, const std::string& text) {
    PyErr_SetObject(type, text_of(text).ptr());
    throw py::error_already_set();
}

}  // namespace mechwright::python

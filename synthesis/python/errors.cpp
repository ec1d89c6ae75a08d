#include "synthesis/python/errors.h"

#include "synthesis/python/values.h"
#include "synthesis/report/files/gnuplot.h"
#include "synthesis/study/data.h"
#include "synthesis/study/store.h"

namespace mechwright::python {

namespace {

namespace py = pybind11;

constexpr const char* problem_error_doc =
    "A problem that cannot be read or solved. str() gives every message, one to a line, as `mechwright check` prints\n"
    "them. The attribute `messages` is a list of dicts: file, line and column (from 1; None where the message is "
    "about\n"
    "the whole or about a value), name (of a value of a dict, 'require[0].min'; else None), text and warning (bool).";

constexpr const char* problem_warning_doc = "What is odd about a problem that can be solved all the same.";

// Borrowed for as long as the interpreter runs: the module holds them.
PyObject* problem_error = nullptr;
PyObject* problem_warning = nullptr;

std::string lines_of(const std::vector<Message>& messages) {
    std::string lines;
    for (const Message& message : messages)
        lines += (lines.empty() ? "" : "\n") + to_string(message);
    return lines;
}

py::dict dict_of(const Message& message) {
    py::dict dict;
    dict["file"] = text_of(message.file);
    dict["line"] = message.line > 0 ? py::object(py::int_(message.line)) : py::none();
    dict["column"] = message.line > 0 ? py::object(py::int_(message.column)) : py::none();
    dict["name"] = message.name.empty() ? py::object(py::none()) : text_of(message.name);
    dict["text"] = text_of(message.text);
    dict["warning"] = message.warning;
    return dict;
}

/// How many of Python's frames, from the innermost on, are the package's own, and one.
int level_of_caller() {
    const py::object frame_at = py::module_::import("sys").attr("_getframe");
    int level = 1;
    for (py::object frame = frame_at(); !frame.is_none(); frame = frame.attr("f_back"), ++level)
        if (!py::str(frame.attr("f_globals")["__name__"]).cast<std::string>().starts_with("mechwright.")) break;
    return level;
}

PyObject* add_class(py::module_& module, const char* name, const char* doc, PyObject* base) {
    const std::string full = std::string("mechwright.") + name;
    PyObject* made = PyErr_NewExceptionWithDoc(full.c_str(), doc, base, nullptr);
    if (made == nullptr) throw py::error_already_set();
    module.attr(name) = py::reinterpret_borrow<py::object>(made);
    return made;
}

void set_error(PyObject* type, const char* text) { PyErr_SetObject(type, text_of(text).ptr()); }

void translate(std::exception_ptr thrown) {
    try {
        if (thrown) std::rethrow_exception(thrown);
    } catch (const ChartFault& fault) {
        set_error(PyExc_OSError, fault.what());
    } catch (const StoreFault& fault) {
        set_error(PyExc_OSError, fault.what());
    } catch (const SqlFault& fault) {
        set_error(PyExc_ValueError, fault.what());
    }
}

}  // namespace

void add_errors(py::module_& module) {
    py::register_local_exception_translator(translate);
    problem_error = add_class(module, "ProblemError", problem_error_doc, PyExc_ValueError);
    problem_warning = add_class(module, "ProblemWarning", problem_warning_doc, PyExc_UserWarning);
}

void raise_problem_error(const std::vector<Message>& messages, bool unreadable) {
    const std::string lines = lines_of(messages);
    if (unreadable) raise_error(PyExc_OSError, lines);
    py::list all;
    for (const Message& message : messages)
        all.append(dict_of(message));
    const py::object error = py::reinterpret_borrow<py::object>(problem_error)(text_of(lines));
    error.attr("messages") = all;
    PyErr_SetObject(problem_error, error.ptr());
    throw py::error_already_set();
}

void warn(const std::vector<Message>& messages) {
    for (const Message& message : messages)
        if (PyErr_WarnFormat(problem_warning, level_of_caller(), "%U", text_of(to_string(message)).ptr()) != 0)
            throw py::error_already_set();
}

void warn_of_less(const std::string& text) {
    if (PyErr_WarnFormat(PyExc_RuntimeWarning, level_of_caller(), "%U", text_of(text).ptr()) != 0)
        throw py::error_already_set();
}

void raise_error(PyObject* type, const std::string& text) {
    PyErr_SetObject(type, text_of(text).ptr());
    throw py::error_already_set();
}

}  // namespace mechwright::python

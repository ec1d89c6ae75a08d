#pragma once
/// \file
/// Messages about problems as Python's exceptions and warnings.

#include <pybind11/pybind11.h>

#include <string>
#include <vector>

#include "synthesis/problem/reader.h"

namespace mechwright::python {

/// Adds ProblemError and ProblemWarning to the module, and has the library's own exceptions thrown as Python's: OSError
/// for a program, a file or a folder that cannot be used, ValueError for SQL that is none.
void add_errors(pybind11::module_& module);

/// Throws ProblemError, or OSError where a file cannot be read, with all messages.
[[noreturn]] void raise_problem_error(const std::vector<Message>& messages, bool unreadable);

/// Warns at the line of Python that called the package. Throws where the caller has made errors of warnings.
void warn(const std::vector<Message>& messages);

/// Warns of what was done less well than asked for (RuntimeWarning).
void warn_of_less(const std::string& text);

/// Throws one of Python's own exceptions. The text may have names of files in it, and so bytes that are not UTF-8.
[[noreturn]] void raise_error(PyObject* type, const std::string& text);

}  // namespace mechwright::python

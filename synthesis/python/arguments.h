#pragma once
/// \file
/// Problems and results as Python gives them: as a dict, or as the path of a file; problems also as a pair of a dict or
/// a TOML text and the name of the file that it is to be taken for.

#include <pybind11/pybind11.h>

#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "synthesis/problem/linkage/linkage.h"
#include "synthesis/problem/problem.h"

namespace mechwright::python {

/// What a problem given as a dict is called where a file has its name.
inline constexpr const char* name_of_dict = "<dict>";

/// Reads and checks a problem; warns of what is odd. Throws ProblemError with all that is wrong, OSError where a file
/// cannot be read, TypeError or ValueError where the dict holds what no file can.
Problem problem_of(const pybind11::object& argument);

/// Reads a linkage from what names the mechanism "linkage", and does not say what is wrong with it. Throws OSError,
/// TypeError and ValueError as problem_of does.
ReadLinkage linkage_of(const pybind11::object& argument);

/// Throws ProblemError with one message about a problem.
[[noreturn]] void refuse_problem(const Problem& problem, const std::string& text);

struct ResultArgument {
    nlohmann::ordered_json document;
    std::string name;  ///< the file, or name_of_dict
};

/// Whether an argument is a result and no problem: a path that ends in ".json", or a dict that says of which problem it
/// is and names no mechanism of its own.
bool is_result(const pybind11::object& argument);

/// A document with the head of a result document. Throws ValueError where it is not one, OSError where the file cannot
/// be read.
ResultArgument result_of(const pybind11::object& argument);

/// The text of a problem, which for a dict is made, and the name of its file; of a path the name alone. Throws as
/// problem_of does for what is neither, and for a dict that is no problem.
struct ProblemText {
    std::optional<std::string> text;
    std::string file;
    bool warned_of = false;  ///< what is odd about it has been told
};
ProblemText problem_text_of(const pybind11::object& argument);

/// The results in a dict, or in a file, which may hold a list of them.
std::vector<ResultArgument> results_of(const pybind11::object& argument);

/// Throws ValueError: "NAME: not a result document: WHY".
[[noreturn]] void refuse_result(const std::string& name, const std::string& why);

}  // namespace mechwright::python

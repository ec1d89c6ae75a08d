#pragma once
/// \file
/// Designs as Python gives them: a problem that leaves nothing open, or a result.

#include "synthesis/program/result.h"
#include "synthesis/python/arguments.h"
#include "synthesis/report/drawing/finished.h"

namespace mechwright::python {

/// A problem and the one design of it, evaluated.
struct GivenDesign {
    Problem problem;
    Solution solution;
};

/// Throws ProblemError where something is left open.
GivenDesign given_design(const pybind11::object& problem);

/// A design to be shown, which assembles somewhere.
struct ShownDesign {
    FinishedDesign design;
    nlohmann::ordered_json document;  ///< of the result, or of the analysis of the problem
    std::string title;
    std::string name;  ///< of the file
};

/// `alternative` counts from 1 among the alternatives of a result; 0 is its own design. Throws ProblemError or
/// ValueError.
ShownDesign shown_design(const pybind11::object& argument, std::int64_t alternative);

}  // namespace mechwright::python

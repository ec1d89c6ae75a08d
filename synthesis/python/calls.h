#pragma once
/// \file
/// The functions of the module; their docstrings in module.cpp say what they do.

#include <pybind11/pybind11.h>

#include <cstdint>
#include <optional>
#include <string>

namespace mechwright::python {

struct SolveOptions {
    std::optional<std::string> method;
    std::optional<std::int64_t> seed;
    std::optional<std::int64_t> jobs;
    std::optional<double> time_limit;
    bool all = false;
};

pybind11::object solve(const pybind11::object& problem, const SolveOptions& options);
pybind11::object analyse(const pybind11::object& problem, const pybind11::object& crank_angles, std::int64_t steps);
pybind11::object verify(const pybind11::object& result);
pybind11::object quantities(const std::string& mechanism);

}  // namespace mechwright::python

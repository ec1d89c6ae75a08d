#pragma once
/// \file
/// The functions of the module; what they take, give and raise stands with the functions of the package that call them.

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

/// Problems and results are what arguments.h says.
pybind11::object solve(const pybind11::object& problem, const SolveOptions& options);
pybind11::object analyse(const pybind11::object& problem, const pybind11::object& crank_angles, std::int64_t steps);
pybind11::object verify(const pybind11::object& result);
pybind11::object quantities(const std::string& mechanism);

/// Raises and warns as solve does, and does nothing else.
void check(const pybind11::object& problem);

/// A dict with lists for arrays. With `nulls` it may hold None, which NaN becomes as well.
pybind11::object plain(const pybind11::dict& dict, bool nulls);

/// The keys that a problem can have.
pybind11::object problem_keys();

/// The TOML text of a problem in a dict.
pybind11::str problem_text(const pybind11::dict& problem);

/// The members that a result can have: whether each is a list of dicts.
pybind11::object result_members();

/// A result from a file.
pybind11::object read_result(const pybind11::object& file);

/// The text of a result in a file.
pybind11::str result_text(const pybind11::dict& result);

/// A picture of a result's design, as SVG. Throws ValueError where it has none that can be shown.
pybind11::str picture(const pybind11::object& result);

}  // namespace mechwright::python

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

struct StudyOptions {
    std::optional<std::int64_t> jobs;
    std::optional<double> time_limit;
};

struct DrawOptions {
    std::string format;             ///< "svg", "png", "pdf" or "gif"
    std::optional<double> seconds;  ///< of one round of a moving picture
    bool plots = false;
    std::int64_t alternative = 0;
    std::int64_t width = 640;
};

/// Of a picture of what is described, before it is a design.
struct SheetOptions {
    std::string format;        ///< "svg", "png" or "pdf"
    std::optional<double> at;  ///< of assemblies: the input, in the problem's unit
    std::int64_t width = 640;
};

struct ExportOptions {
    std::string format;
    std::optional<double> at;
    std::optional<double> fineness;
    std::int64_t alternative = 0;
    std::int64_t steps = 360;
};

/// Throws ValueError for what no run can have.
void check_run(const std::optional<std::int64_t>& jobs, const std::optional<double>& time_limit);

/// Problems and results are what arguments.h says.
pybind11::object solve(const pybind11::object& problem, const SolveOptions& options);
pybind11::object analyse(const pybind11::object& problem, const pybind11::object& crank_angles, std::int64_t steps);
pybind11::object verify(const pybind11::object& result);
pybind11::object quantities(const std::string& mechanism);

/// {rows, table, csv, differences}: designs side by side.
pybind11::dict compare(const pybind11::list& problems, const SolveOptions& options);

/// Raises and warns as solve does, and does nothing else.
void check(const pybind11::object& problem);

/// The same without a look at the method, which other sections may change yet.
void read(const pybind11::object& problem);

/// The bytes of a file: those of SolveSpace are not UTF-8.
pybind11::bytes draw(const pybind11::object& design, const DrawOptions& options);
pybind11::bytes draw_figure(const pybind11::object& problem, const SheetOptions& options);
pybind11::bytes draw_assemblies(const pybind11::object& problem, const SheetOptions& options);
pybind11::bytes draw_skeleton(const pybind11::object& problem, const SheetOptions& options);
pybind11::bytes export_design(const pybind11::object& design, const ExportOptions& options);

/// Pages of HTML.
pybind11::str report_results(const pybind11::list& results);
pybind11::str report_study(const std::string& folder, std::int64_t designs);

/// `mechanism` is empty for all.
pybind11::str explain(const std::string& name, const std::string& mechanism);

/// Runs what is not done yet; the data are in the folder. Returns the tolerances as tables, where it is about those.
pybind11::str study(const pybind11::object& problem, const std::string& folder, const StudyOptions& options);
pybind11::dict study_standing(const std::string& folder);
pybind11::object study_data(const std::string& folder, const std::string& sql, double time_limit);
pybind11::dict study_charts(const std::string& folder);

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

}  // namespace mechwright::python

// What is described, drawn before it is a design: figures of dimensions, assemblies of linkages, their links apart.

#include <fmt/format.h>

#include <array>
#include <filesystem>
#include <numbers>

#include "synthesis/problem/text.h"
#include "synthesis/python/arguments.h"
#include "synthesis/python/calls.h"
#include "synthesis/python/errors.h"
#include "synthesis/report/drawing/figure/figure.h"
#include "synthesis/report/drawing/figure/problem_figure.h"
#include "synthesis/report/drawing/linkage_sheets.h"
#include "synthesis/report/drawing/raster.h"
#include "synthesis/report/names.h"
#include "synthesis/report/structure/assemblies.h"

namespace mechwright::python {

namespace {

namespace py = pybind11;

void check_sheet(const SheetOptions& options) {
    constexpr std::array<std::string_view, 3> formats{"svg", "png", "pdf"};
    if (std::find(formats.begin(), formats.end(), options.format) == formats.end())
        throw py::value_error("out: it must end in .svg, .png or .pdf, not in " +
                              reading::quoted("." + options.format));
    if (options.width < 100 || options.width > 10'000)
        throw py::value_error(fmt::format("width: {} is not from 100 to 10000", options.width));
}

py::bytes in_format(std::string picture, const SheetOptions& options) {
    if (const auto format = raster_format_of("." + options.format)) {
        const py::gil_scoped_release release;
        picture = rasterised(picture, *format);
    }
    return picture;
}

/// The name of a mechanism where the argument is a str that names no file; empty otherwise.
std::string mechanism_name(const py::object& argument) {
    if (!py::isinstance<py::str>(argument)) return {};
    auto name = argument.cast<std::string>();
    std::error_code ignored;
    return std::filesystem::exists(name, ignored) ? std::string() : name;
}

std::string figure_of_name(const std::string& name, double width) {
    std::string picture = figure_picture(name, width);
    if (picture.empty())
        throw py::value_error(fmt::format("{} is neither a mechanism nor a file; {}", reading::quoted(name),
                                          reading::remedy(name, mechanism_names())));
    return picture;
}

[[noreturn]] void refuse(const Linkage& linkage, const std::string& why) {
    raise_problem_error({Message{.file = linkage.file, .text = why + "; skeleton=True draws its links apart"}}, false);
}

}  // namespace

py::bytes draw_figure(const py::object& problem, const SheetOptions& options) {
    check_sheet(options);
    const auto width = static_cast<double>(options.width);
    if (const std::string name = mechanism_name(problem); !name.empty())
        return in_format(figure_of_name(name, width), options);
    const Problem read = problem_of(problem);
    const std::vector<FigurePanel> panels = figure_of(read);
    if (panels.empty())
        refuse_problem(read, "it does not close with the middles of its ranges; skeleton=True draws its links apart");
    const std::string title = "Dimensions: " + (read.title.empty() ? read.file : read.title);
    return in_format(figure_picture(title, panels, width), options);
}

py::bytes draw_assemblies(const py::object& problem, const SheetOptions& options) {
    check_sheet(options);
    const ReadLinkage read = linkage_of(problem);
    if (read.unreadable || !read.ok()) raise_problem_error(read.messages, read.unreadable);
    warn(read.messages);
    const Linkage& linkage = read.linkage;
    if (linkage.structure.drives.empty()) refuse(linkage, "nothing drives this linkage");
    std::optional<double> at = options.at;
    if (at && linkage.units.degrees && !linkage.structure.drives.front().of_slide) *at *= std::numbers::pi / 180;
    const auto [master, assemblies] = assembled_at(linkage, at);
    if (assemblies.empty())
        refuse(linkage, std::string("the linkage does not close at ") + (at ? "this input" : "any input"));
    return in_format(assemblies_picture(linkage, assemblies, master, static_cast<double>(options.width)), options);
}

py::bytes draw_skeleton(const py::object& problem, const SheetOptions& options) {
    check_sheet(options);
    ReadLinkage read = linkage_of(problem);
    if (read.unreadable || !has_skeleton(read.linkage)) {
        if (read.messages.empty()) read.messages.push_back({.file = read.linkage.file, .text = "no links to be drawn"});
        raise_problem_error(read.messages, read.unreadable);
    }
    for (Message& message : read.messages)
        message.warning = true;
    warn(read.messages);
    return in_format(skeleton_picture(read.linkage, static_cast<double>(options.width)), options);
}

}  // namespace mechwright::python

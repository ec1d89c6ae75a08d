// Designs drawn, handed to other programs, and put on pages.

#include <fmt/format.h>

#include <algorithm>

#include "synthesis/problem/text.h"
#include "synthesis/python/calls.h"
#include "synthesis/python/designs.h"
#include "synthesis/python/errors.h"
#include "synthesis/python/values.h"
#include "synthesis/report/drawing/drawn.h"
#include "synthesis/report/drawing/exported.h"
#include "synthesis/report/drawing/raster.h"
#include "synthesis/report/files/gnuplot.h"
#include "synthesis/report/page/results_page.h"
#include "synthesis/report/text/explained.h"
#include "synthesis/study/folder.h"
#include "synthesis/study/study_page.h"

namespace mechwright::python {

namespace {

namespace py = pybind11;

void check_range(const char* name, std::int64_t value, std::int64_t least, std::int64_t most) {
    if (value < least || value > most)
        throw py::value_error(fmt::format("{}: {} is not from {} to {}", name, value, least, most));
}

void check_positive(const char* name, const std::optional<double>& value) {
    if (value && !(std::isfinite(*value) && *value > 0))
        throw py::value_error(fmt::format("{}: {} is not a number above 0", name, *value));
}

WantedPicture wanted_picture(const ShownDesign& shown, const DrawOptions& options) {
    WantedPicture wanted;
    wanted.picture.title = shown.title;
    wanted.picture.width = static_cast<double>(options.width);
    wanted.seconds = options.seconds;
    wanted.gif = options.format == "gif";
    wanted.plots = options.plots;
    if (options.format == "pdf") wanted.title_block_source = shown.name;
    return wanted;
}

void check(const DrawOptions& options) {
    constexpr std::array<std::string_view, 4> formats{"svg", "png", "pdf", "gif"};
    if (std::find(formats.begin(), formats.end(), options.format) == formats.end())
        throw py::value_error(fmt::format("out: it must end in .svg, .png, .pdf, or .gif with animate, not in {}",
                                          reading::quoted("." + options.format)));
    if (options.seconds && options.plots) throw py::value_error("plots: a moving picture is of a design alone");
    if (options.format == "gif" && !options.seconds) throw py::value_error("out: a .gif is for animate");
    if (options.seconds && (options.format == "png" || options.format == "pdf"))
        throw py::value_error("out: animate makes .svg or .gif");
    check_positive("seconds", options.seconds);
    check_range("width", options.width, 100, 10'000);
}

/// A page without plots for browsers without scripts, where gnuplot cannot draw them; that is warned of.
py::str text_of_page(Page page) {
    const auto text = [&] {
        const py::gil_scoped_release release;
        return page_text(page);
    };
    std::string fault;
    try {
        return text_of(text());
    } catch (const ChartFault& missing) {
        fault = missing.what();
    }
    warn_of_less(fault + "; the page has no plots for browsers without scripts");
    page.static_plots = false;
    return text_of(text());
}

}  // namespace

py::bytes draw(const py::object& design, const DrawOptions& options) {
    check(options);
    const ShownDesign shown = shown_design(design, options.alternative);
    std::string picture;
    {
        const py::gil_scoped_release release;
        picture = drawn(shown.design, shown.document, wanted_picture(shown, options));
        if (const auto format = raster_format_of("." + options.format)) picture = rasterised(picture, *format);
    }
    return picture;
}

py::bytes export_design(const py::object& design, const ExportOptions& options) {
    constexpr std::int64_t most_steps = 1'000'000;
    if (const std::string fault = export_format_fault(options.format); !fault.empty())
        throw py::value_error("format: " + fault);
    check_range("steps", options.steps, 1, most_steps);
    check_positive("fineness", options.fineness);
    const ShownDesign shown = shown_design(design, options.alternative);
    const ExportedPart part{options.at, options.fineness, static_cast<int>(options.steps)};
    Exported made;
    {
        const py::gil_scoped_release release;
        made = exported(shown.design, options.format, part);
    }
    if (!made.fault.empty()) throw py::value_error("at: " + made.fault);
    return made.text;
}

py::str report_results(const py::list& results) {
    NamedDocuments documents;
    for (const py::handle one : results)
        for (ResultArgument& result : results_of(py::reinterpret_borrow<py::object>(one)))
            documents.emplace_back(std::move(result.name), std::move(result.document));
    if (documents.empty()) throw py::value_error("there is no result to be reported on");
    return text_of_page(page_on_results(documents));
}

py::str report_study(const std::string& folder, std::int64_t designs) {
    check_range("designs", designs, 1, 100'000);
    return text_of_page(study_page(data_file(folder), static_cast<std::uint64_t>(designs)));
}

py::str explain(const std::string& name, const std::string& mechanism) {
    const Explained found = explained(name, mechanism, false);
    if (!found.fault.empty()) throw py::value_error(found.fault);
    return text_of(found.text);
}

}  // namespace mechwright::python

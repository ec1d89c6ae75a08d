#include "synthesis/report/drawing/raster.h"

#include <cerrno>
#include <system_error>

#include "synthesis/report/files/gnuplot.h"
#include "synthesis/report/files/run_program.h"

namespace mechwright {

std::optional<RasterFormat> raster_format_of(std::string_view file) {
    if (file.ends_with(".png")) return RasterFormat::png;
    if (file.ends_with(".pdf")) return RasterFormat::pdf;
    return std::nullopt;
}

std::string rasterised(const std::string& svg, RasterFormat format, int zoom) {
    std::vector<std::string> command{"rsvg-convert", "--format", format == RasterFormat::png ? "png" : "pdf"};
    if (format == RasterFormat::png) command.insert(command.end(), {"--zoom", std::to_string(zoom)});
    ProgramRun run = run_program(std::move(command), svg);
    if (run.error == ENOENT) throw ChartFault("there is no rsvg-convert: install it (Debian: librsvg2-bin)");
    if (run.error != 0) throw ChartFault("cannot run rsvg-convert: " + std::generic_category().message(run.error));
    if (!run.succeeded() || run.output.empty()) throw ChartFault("rsvg-convert could not draw; it says why above");
    return std::move(run.output);
}

std::string svg_element(const std::string& svg) {
    const std::size_t begin = svg.find("<svg");
    return begin == std::string::npos ? "" : svg.substr(begin);
}

}  // namespace mechwright

#include "synthesis/report/files/gnuplot.h"

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <system_error>

#include "synthesis/report/files/run_program.h"

namespace mechwright {

namespace {

std::string terminal(const Picture& picture) {
    if (picture.format == Picture::Format::svg)
        return fmt::format("set terminal svg size {},{} {} font 'sans-serif,13' background '#ffffff'", picture.width,
                           picture.height, picture.fixed ? "fixed" : "dynamic");
    if (picture.format == Picture::Format::gif)
        return fmt::format("set terminal gif animate delay {} loop 0 size {},{}",
                           std::max(1L, std::lround(100 * picture.delay)), picture.width, picture.height);
    // Pixels are smaller than the units of SVG.
    return fmt::format("set terminal pngcairo size {},{} font 'sans,13' fontscale 1.3", picture.width * 3 / 2,
                       picture.height * 3 / 2);
}

}  // namespace

std::string gnuplot_picture(const std::string& script, const Picture& picture) {
    const bool counts_pictures = picture.format == Picture::Format::gif;
    ProgramRun run = run_program({"gnuplot", "-e", terminal(picture), "-"}, script, counts_pictures);
    if (run.error == ENOENT) throw ChartFault("there is no gnuplot: install it (Debian: gnuplot-nox)");
    if (run.error != 0) throw ChartFault("cannot run gnuplot: " + std::generic_category().message(run.error));
    if (!run.succeeded() || run.output.empty())
        throw ChartFault(counts_pictures ? "gnuplot could not make a GIF of the pictures"
                                         : "gnuplot could not draw; it says why above");
    return std::move(run.output);
}

std::string gnuplot_text(std::string_view text) {
    std::string quoted = "'";
    for (const char c : text)
        if (static_cast<unsigned char>(c) >= 0x20) quoted += c == '\'' ? std::string("''") : std::string(1, c);
    return quoted + '\'';
}

}  // namespace mechwright

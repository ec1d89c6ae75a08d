#include "synthesis/command_line/progress_line.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "synthesis/report/text/table.h"

namespace mechwright {

namespace {

bool continues_character(char byte) { return (static_cast<unsigned char>(byte) & 0xc0) == 0x80; }

/// The whole text, or its beginning as far as it fits on the line: a line that wraps cannot be drawn over.
std::string cut(std::string text) {
    while (width_of(text) >= terminal_width) {
        while (continues_character(text.back()))
            text.pop_back();
        text.pop_back();
    }
    return text;
}

/// Draws what `text_of` makes of the seconds since the start, ten times a second at most.
template <class Text>
void redraw(ProgressLine& line, const Text& text_of) {
    using namespace std::chrono;
    const steady_clock::time_point now = steady_clock::now();
    if (line.width > 0 && now - line.drawn < milliseconds(100)) return;
    line.drawn = now;
    const std::string text = cut(text_of(duration<double>(now - line.started).count()));
    const std::size_t width = width_of(text);
    const std::size_t left_over = line.width > width ? line.width - width : 0;
    line.console->err << '\r' << text << std::string(left_over, ' ') << std::flush;
    line.width = std::max(width, std::size_t{1});
}

}  // namespace

void draw(ProgressLine& line, int done, int total, double best) {
    std::string value = std::isnan(best) ? "no design yet" : "best " + number_text(best, 6);
    if (!std::isnan(best) && !line.unit.empty()) value += " " + line.unit;
    redraw(line, [&](double seconds) {
        return fmt::format("{}/{} starts  {}  {:.1f} s  {}", done, total, value, seconds, line.label);
    });
}

void draw_bound(ProgressLine& line, double part, long boxes) {
    redraw(line, [&](double seconds) {
        return fmt::format("bound {:.0f}% of the best  {} boxes  {:.1f} s  {}", 100 * part, boxes, seconds, line.label);
    });
}

void draw_points(ProgressLine& line, std::uint64_t done, std::uint64_t newly, std::uint64_t total) {
    redraw(line, [&](double seconds) {
        const double rate = static_cast<double>(newly) / std::max(seconds, 1e-3);
        const std::string left =
            newly > 0 ? fmt::format("{:.0f} s left", static_cast<double>(total - done) / rate) : "time left not known";
        return fmt::format("{}/{} points  {:.4g} a second  {}  {}", done, total, rate, left, line.label);
    });
}

void draw_measurements(ProgressLine& line, int done, int total) {
    redraw(line, [&](double seconds) {
        return fmt::format("{}/{} measurements  {:.0f} s  {}", done, total, seconds, line.label);
    });
}

void erase(ProgressLine& line) {
    if (line.width == 0) return;
    line.console->err << '\r' << std::string(line.width, ' ') << '\r' << std::flush;
    line.width = 0;
}

}  // namespace mechwright

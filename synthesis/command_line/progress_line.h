#pragma once
/// \file
/// One line on a terminal that tells how far a run is, drawn over itself and gone at the end.

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <string>

#include "synthesis/command_line/console.h"

namespace mechwright {

struct ProgressLine {
    Console* console;
    std::string label;  ///< what is being solved
    std::string unit;   ///< of the objective
    std::chrono::steady_clock::time_point started = std::chrono::steady_clock::now();
    std::chrono::steady_clock::time_point drawn{};
    std::size_t width = 0;  ///< of what stands there now
};

/// Draws the line, but not more than ten times a second. `best` is NaN while there is no design.
void draw(ProgressLine& line, int done, int total, double best);

/// The same while a lower bound is raised: the part of the objective that it has reached, the boxes examined.
void draw_bound(ProgressLine& line, double part, long boxes);

/// The same for the points of a study: those done, those of them done since the line began, and all there are.
void draw_points(ProgressLine& line, std::uint64_t done, std::uint64_t newly, std::uint64_t total);

/// The same for measurements: those done, and all there are.
void draw_measurements(ProgressLine& line, int done, int total);

void erase(ProgressLine& line);

}  // namespace mechwright

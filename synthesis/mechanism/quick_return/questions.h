#pragma once
/// \file
/// What `mechwright new` asks for mechanisms that drive a ram.

#include "synthesis/mechanism/task.h"

namespace mechwright::quick_return {

inline Question stroke() { return {"stroke", "Stroke of the ram, mm", "200", Answer::number, 1e-3}; }

inline Question time_ratio(std::string_view preset, double least) {
    return {"time-ratio", "Time of the slow stroke over that of the fast one", preset, Answer::number, least, 5};
}

inline Question length_of(std::string_view name, std::string_view text, std::string_view preset) {
    return {name, text, preset, Answer::number, 1e-9};
}

}  // namespace mechwright::quick_return

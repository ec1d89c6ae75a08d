#pragma once
/// \file
/// What `mechwright new` asks for mechanisms that drive a ram.

#include <string_view>
#include <utility>
#include <vector>

#include "synthesis/mechanism/task.h"

namespace mechwright::quick_return {

inline Question stroke() { return {"stroke", "Stroke of the ram, mm", "200", Answer::number, 1e-3}; }

inline Question time_ratio(std::string_view preset, double least) {
    return {"time-ratio", "Time of the slow stroke over that of the fast one", preset, Answer::number, least, 5};
}

inline Question length_of(std::string_view name, std::string_view text, std::string_view preset) {
    return {name, text, preset, Answer::number, 1e-9};
}

/// The two tasks of each kind: a ram of given stroke and time ratio, and all dimensions known. `file` holds the problem
/// files, from the folder tasks of the kind.
struct RamTask {
    std::string_view meaning;
    std::vector<Question> questions;
    const char* file;
};

inline std::vector<Task> ram_tasks(std::string_view kind, RamTask with_stroke, RamTask given) {
    return {{kind, "stroke", with_stroke.meaning, std::move(with_stroke.questions), with_stroke.file},
            {kind, "given", given.meaning, std::move(given.questions), given.file}};
}

inline constexpr std::string_view uniform_while_working =
    "a ram of given stroke and time ratio, as uniform as possible while it works";
inline constexpr std::string_view all_known = "all dimensions known: what does it do";

}  // namespace mechwright::quick_return

#pragma once
/// \file
/// What `mechwright new` can begin with a mechanism: for each task its questions, and the file that the answers make.

#include <string_view>
#include <vector>

namespace mechwright {

/// What an answer must be.
enum class Answer {
    number,
    choice,      ///< one of some words
    expression,  ///< in x
    points,      ///< "x y; x y; ...", or poses with an angle
    segments     ///< "rise 120, dwell 60, ...": a full turn
};

struct Question {
    std::string_view name;    ///< for --set
    std::string_view text;    ///< what is asked, with the unit
    std::string_view preset;  ///< what Enter takes
    Answer kind = Answer::number;
    double least = -1e9;  ///< of a number, with `most`; least itself is allowed
    double most = 1e9;
    std::vector<std::string_view> choices{};  ///< of a choice
    std::size_t numbers = 2;                  ///< of each point
};

/// Its texts live as long as the program.
struct Task {
    std::string_view mechanism;
    std::string_view name;
    std::string_view meaning;
    std::vector<Question> questions;
    /// The problem file. @name@ stands for an answer, @name*3@ for three times the number; points and segments come as
    /// TOML.
    std::string_view text;
};

}  // namespace mechwright

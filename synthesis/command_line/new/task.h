#pragma once
/// \file
/// What `mechwright new` can begin: for each task of a mechanism its questions, and the file that the answers make.

#include <map>
#include <span>
#include <string>
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

/// By the names of the questions.
using Answers = std::map<std::string_view, std::string>;

struct Task {
    std::string_view mechanism;
    std::string_view name;
    std::string_view meaning;
    std::vector<Question> questions;
    /// The problem file. @name@ stands for an answer, @name*3@ for three times the number; points and segments come as
    /// TOML.
    std::string_view text;
};

/// Every task, those of one mechanism together.
std::span<const Task> tasks();

/// Those of one mechanism, each in a file of its own.
std::vector<Task> four_bar_tasks();
std::vector<Task> quick_return_tasks();
std::vector<Task> cam_tasks();

/// What is wrong with an answer by itself, and what would be right; empty if nothing is.
std::string fault_of(const Question& question, const std::string& answer);

/// The problem file. Precondition: an answer without fault for each question.
std::string problem_file(const Task& task, const Answers& answers);

}  // namespace mechwright

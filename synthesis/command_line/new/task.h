#pragma once
/// \file
/// The tasks of all mechanisms (synthesis/mechanism/task.h), and the files that answers make.

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "synthesis/mechanism/task.h"

namespace mechwright {

/// By the names of the questions.
using Answers = std::map<std::string_view, std::string>;

/// Every task, those of one mechanism together.
std::vector<Task> tasks();

/// What is wrong with an answer by itself, and what would be right; empty if nothing is.
std::string fault_of(const Question& question, const std::string& answer);

/// The problem file. Precondition: an answer without fault for each question.
std::string problem_file(const Task& task, const Answers& answers);

}  // namespace mechwright

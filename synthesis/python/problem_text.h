#pragma once
/// \file
/// A problem that is not in a file, as the text of one, so that the reader of problem files checks it.

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "synthesis/problem/messages.h"

namespace mechwright::python {

/// Where a key or value stands in the text, and what it is called there: "require[0].min".
struct Mark {
    reading::Place place;
    std::string name;
};

struct ProblemText {
    std::string text;         ///< TOML
    std::vector<Mark> marks;  ///< in the order of their places
};

/// Precondition: an object without null.
ProblemText problem_text(const nlohmann::ordered_json& problem);

/// A message's text with names in the place of lines: "... and the requirement in line 7" becomes "... and the
/// requirement require[0]".
std::string with_names(const ProblemText& text, const std::string& message);

/// The name of what a message is about; empty for the problem as a whole.
std::string name_at(const ProblemText& text, reading::Place place);

}  // namespace mechwright::python

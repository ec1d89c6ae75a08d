#pragma once
/// \file
/// From a problem file, or from its tables in memory, to a Problem or to every error in it.

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "synthesis/problem/problem.h"

namespace mechwright {

/// A message about a file, or about tables in memory. Line and column count from 1; 0 if the message is about the whole
/// or about a value in memory.
struct Message {
    std::string file;
    int line = 0;
    int column = 0;
    std::string text;  ///< what is wrong, and what would be right
    bool warning = false;
    std::string name{};  ///< of the value in memory that it is about: "require[0].min"
};

/// "file:line:column: text", as compilers write it ("warning: " before the text of a warning); with the name of a value
/// in memory "name: text".
std::string to_string(const Message& message);

/// A file that a problem file names.
struct NamedFile {
    std::string name;  ///< as written there
    std::string sha256;
};

struct ReadProblem {
    Problem problem;                     ///< complete only if ok()
    std::vector<Message> messages;       ///< errors and warnings in the order of their places
    bool unreadable = false;             ///< the file itself, or one it names, cannot be read (exit code 6)
    std::vector<NamedFile> named_files;  ///< that were read, in the order in which they are named

    bool ok() const;
};

/// Reads and checks a problem file and the files it names (relative to its folder).
ReadProblem read_problem(const std::string& file);

/// The same for a text that is already in memory; `file` is its name in messages and for the files it names.
ReadProblem parse_problem(std::string_view text, const std::string& file);

/// The same for what a problem file says as values in memory: an object with the keys of the file, of objects, lists,
/// strings, truth values and numbers (no null). Messages name values (`Message::name`). The problem's text is that of a
/// file that says the same.
ReadProblem take_problem(const nlohmann::ordered_json& tables, const std::string& file);

}  // namespace mechwright

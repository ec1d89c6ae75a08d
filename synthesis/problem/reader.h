#pragma once
/// \file
/// From a problem file to a Problem, or to every error in it.

#include <string>
#include <string_view>
#include <vector>

#include "synthesis/problem/problem.h"

namespace mechwright {

/// A message about a file. Line and column count from 1; 0 if the message is about the file as a whole.
struct Message {
    std::string file;
    int line = 0;
    int column = 0;
    std::string text;  ///< what is wrong, and what would be right
    bool warning = false;
};

/// "file:line:column: text", as compilers write it ("warning: " before the text of a warning).
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

}  // namespace mechwright

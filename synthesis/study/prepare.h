#pragma once
/// \file
/// A study made ready to run: the text of its file, its columns, and what tells it from any other.

#include <memory>
#include <string>
#include <vector>

#include "synthesis/problem/reader.h"
#include "synthesis/problem/study/study.h"

namespace mechwright {

/// What a file that a study reads may have at most.
constexpr std::size_t most_bytes_of_a_study = 64 << 20;

/// The columns of a study's data, in order after the number of the point.
struct StudyColumns {
    std::vector<std::string> given;       ///< paths of what is varied, then of what follows from it
    std::vector<std::string> dimensions;  ///< of all mechanisms in it
    std::vector<std::string> quantities;

    /// All of them, as the data name them.
    std::vector<std::string> names() const;
};

struct PreparedStudy {
    std::string text;  ///< of the problem file
    std::string file;
    Problem base;  ///< as the file itself says
    std::shared_ptr<const Study> study;
    StudyColumns columns;
    std::vector<std::string> named_files;  ///< that any point reads, as the file names them
    std::string fingerprint;               ///< SHA-256 of the text, the files that it names and the program's version
};

struct PreparedOrNot {
    PreparedStudy prepared;
    std::vector<Message> messages;
    bool unreadable = false;
    bool ok = false;
};

/// Reads a problem file that holds a study.
PreparedOrNot prepare_study(const std::string& file);

/// The same of the text of one; files that it names are relative to `file`.
PreparedOrNot prepare_study(const std::string& text, const std::string& file);

}  // namespace mechwright

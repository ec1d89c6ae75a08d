#pragma once
/// \file
/// Collects what is wrong with a file while it is read, and brings it into the order of its places.

#include <cstddef>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

#include "synthesis/problem/reader.h"

namespace mechwright::reading {

/// Line and column, counted from 1 in characters; in a table that has no text the node alone says where.
struct FilePlace {
    int line = 1;
    int column = 1;
    const void* node = nullptr;

    friend auto operator<=>(const FilePlace& a, const FilePlace& b) {
        return std::pair(a.line, a.column) <=> std::pair(b.line, b.column);
    }
    friend bool operator==(const FilePlace& a, const FilePlace& b) { return (a <=> b) == 0; }
};

/// What the nodes of a table that has no text are called, in the order in which they were made.
struct NodeNames {
    std::vector<std::string> names{};
    std::unordered_map<const void*, int> numbers{};  ///< of nodes: their indices among the names
};

struct Entry {
    FilePlace
        order;  ///< what the message is sorted by: its place in the problem file, or that of the other file's name
    Message message;
};

struct Messages {
    std::string file;         ///< the problem file
    bool unreadable = false;  ///< a file cannot be opened or read
    bool failed = false;      ///< there is an error among the messages
    std::vector<Entry> entries{};
    std::size_t left_out = 0;
    std::vector<NamedFile> named_files{};  ///< that were read
    const NodeNames* nodes = nullptr;      ///< of a table that has no text

    static constexpr std::size_t most_shown = 100;  ///< more than anyone reads at once
};

void add_error(Messages& messages, FilePlace place, std::string text);
void add_warning(Messages& messages, FilePlace place, std::string text);

/// Whether an error has been told at a place already.
bool has_error_at(const Messages& messages, FilePlace place);

/// How a message speaks of another place: "in line 7", or the name of the value that stands there.
std::string place_text(const Messages& messages, FilePlace place);

/// An error about the problem file as a whole.
void add_error(Messages& messages, std::string text);

/// An error in, or about (place 0:0), another file that is named at `named_at` in the problem file.
void add_error_elsewhere(Messages& messages, FilePlace named_at, const std::string& file, FilePlace place,
                         std::string text);

/// At most `most_shown` messages by their places, then one that says how many there are beyond.
std::vector<Message> sorted(Messages&& messages);

}  // namespace mechwright::reading

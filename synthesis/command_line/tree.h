#pragma once
/// \file
/// The commands with their options as plain values: what completion scripts and the manual page are made from.

#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace mechwright {

/// What can stand in a place of the command line.
struct Values {
    enum class Kind { unknown, words, files, folders };
    Kind kind = Kind::unknown;
    std::vector<std::string> names{};  ///< the words, or the endings of the files; none: any file
};

struct OptionNode {
    std::string short_name;  ///< "-h", or empty
    std::string name;        ///< "--out"
    std::string value;       ///< "DIR"; empty for a flag
    std::string help;
    Values values;
};

struct ArgumentNode {
    std::string name;  ///< "FILE"
    std::string help;
    bool required = false;
    bool repeated = false;
    Values values;
};

struct CommandNode {
    std::string name;
    std::vector<std::string> path;  ///< the commands above it and its own; empty for the program
    std::string help;
    std::vector<OptionNode> options;
    std::vector<ArgumentNode> arguments;
    std::vector<CommandNode> below;
};

/// The program with all commands that its help shows.
CommandNode tree_of(const CLI::App& program);

/// A node and all below it, itself first.
std::vector<const CommandNode*> all_nodes(const CommandNode& node);

}  // namespace mechwright

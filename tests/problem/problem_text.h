#pragma once
/// \file
/// A small valid problem to spoil, and what its reading says then.

#include <gtest/gtest.h>
#include <stdlib.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <initializer_list>
#include <string>
#include <string_view>

#include "synthesis/problem/reader.h"

namespace mechwright::test {

/// Its lines: 1 schema, 2 mechanism, 3 [dimensions], 4 ground, 5 crank, 6 coupler, 7 rocker. What is added starts in
/// line 8.
inline const std::string valid =
    "schema = 1\n"
    "mechanism = \"four-bar\"\n"
    "[dimensions]\n"
    "ground = 100.0\n"
    "crank = { min = 5, max = 60 }\n"
    "coupler = { min = 20, max = 300, start = 90 }\n"
    "rocker = { min = 20, max = 300 }\n";

/// The valid problem with one line in the place of another; "" leaves the line blank.
inline std::string with_line(int line, const std::string& text) {
    std::size_t begin = 0;
    for (int i = 1; i < line; ++i)
        begin = valid.find('\n', begin) + 1;
    std::string changed = valid;
    return changed.replace(begin, valid.find('\n', begin) - begin, text);
}

inline ReadProblem read(const std::string& text) { return parse_problem(text, "p.toml"); }

inline std::string all_messages(const ReadProblem& problem) {
    std::string all;
    for (const Message& message : problem.messages)
        all += to_string(message) + "\n";
    return all.empty() ? "no messages\n" : all;
}

inline bool has_words(const std::string& text, std::initializer_list<std::string_view> words) {
    return std::all_of(words.begin(), words.end(),
                       [&](std::string_view word) { return text.find(word) != std::string::npos; });
}

/// Whether a message stands at this place ("p.toml:5:9: ") and says all these words.
inline testing::AssertionResult says(const ReadProblem& problem, const std::string& place,
                                     std::initializer_list<std::string_view> words) {
    for (const Message& message : problem.messages) {
        const std::string text = to_string(message);
        if (text.starts_with(place + ": ") && has_words(text, words)) return testing::AssertionSuccess();
    }
    return testing::AssertionFailure() << "no such message at " << place << " among\n" << all_messages(problem);
}

/// The same, where it is an error and the only message.
inline testing::AssertionResult only_says(const ReadProblem& problem, const std::string& place,
                                          std::initializer_list<std::string_view> words) {
    if (problem.ok()) return testing::AssertionFailure() << "the problem is accepted";
    if (problem.messages.size() != 1)
        return testing::AssertionFailure() << "not one message but\n" << all_messages(problem);
    return says(problem, place, words);
}

inline testing::AssertionResult accepted(const ReadProblem& problem) {
    if (problem.messages.empty()) return testing::AssertionSuccess();
    return testing::AssertionFailure() << "not accepted without a word:\n" << all_messages(problem);
}

/// A folder that goes away with everything in it.
struct TemporaryFolder {
    std::string path;

    TemporaryFolder() {
        path = (std::filesystem::temp_directory_path() / "mechwright-XXXXXX").string();
        if (mkdtemp(path.data()) == nullptr) ADD_FAILURE() << "cannot make " << path;
    }
    ~TemporaryFolder() {
        std::error_code ignored;
        std::filesystem::remove_all(path, ignored);
    }
    TemporaryFolder(const TemporaryFolder&) = delete;
    TemporaryFolder& operator=(const TemporaryFolder&) = delete;

    std::string file(const std::string& name) const { return path + "/" + name; }

    std::string write(const std::string& name, std::string_view bytes) const {
        std::ofstream(file(name), std::ios::binary) << bytes;
        return file(name);
    }
};

}  // namespace mechwright::test

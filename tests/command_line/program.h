#pragma once
/// \file
/// Runs the program as a user does: as a process, with its own standard streams.

#include <gtest/gtest.h>
#include <sys/types.h>

#include <chrono>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace mechwright::testing {

struct Start {
    std::vector<std::string> arguments;
    std::string folder;  ///< the program is started in it; empty: in the test's
    std::vector<std::pair<std::string, std::string>> environment;  ///< set for the program; empty values are unset
    std::string in;                                                ///< what it reads on standard input, then the end
    bool in_on_terminal = false;              ///< standard input is a terminal, on which `in` is typed
    std::string out_to;                       ///< standard output goes to this file and not to the test
    bool out_closed = false;                  ///< there is no standard output
    bool out_on_terminal = false;             ///< standard output is a terminal; its text arrives in Outcome::out
    bool err_on_terminal = false;             ///< so is standard error
    std::optional<std::size_t> out_read;      ///< the test closes standard output after this many bytes
    std::optional<std::size_t> largest_file;  ///< no file can be longer, as on a full disk
    std::optional<std::size_t> most_memory;   ///< bytes of address space that it gets
};

struct Outcome {
    int exit_code = -1;  ///< or -1
    int killed_by = 0;   ///< the signal that ended it, or 0
    std::string out;
    std::string err;
};

/// A program that runs. Signals can be sent to it.
struct Running {
    pid_t id = -1;
    int in = -1;
    int out = -1;
    int err = -1;
    std::optional<std::size_t> out_read;
};

Running start(const Start& start);

/// Reads what it writes until it ends; a program that takes longer than nine minutes is killed.
Outcome finish(Running running);

Outcome run(const Start& how);
Outcome run(std::vector<std::string> arguments);

/// The text as JSON; a failure of the test if it is none.
nlohmann::ordered_json parsed(const std::string& text);

/// A result document, or a list of them, without what the clock says.
nlohmann::ordered_json without_times(nlohmann::ordered_json json);

void expect_has(const std::string& text, const std::string& part);
void expect_has_not(const std::string& text, const std::string& part);

}  // namespace mechwright::testing

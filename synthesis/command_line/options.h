#pragma once
/// \file
/// Options that take numbers: plain decimal ones in every locale, checked before anything runs.

#include <CLI/CLI.hpp>
#include <cstdint>
#include <optional>
#include <string>

#include "synthesis/command_line/console.h"
#include "synthesis/report/text/numbers.h"

namespace mechwright {

/// Steps of a table over the motion, where --steps does not say otherwise, and at most.
constexpr std::uint64_t default_table_steps = 360;
constexpr std::uint64_t most_table_steps = 1'000'000;

/// An option that takes a whole number from `least` to `most`.
CLI::Option* add_whole_number(CLI::App& command, const std::string& name, std::optional<std::uint64_t>& number,
                              std::uint64_t least, std::uint64_t most, const std::string& help);

/// An option that takes a finite number > 0.
CLI::Option* add_positive_number(CLI::App& command, const std::string& name, std::optional<double>& number,
                                 const std::string& help);

/// Adds --digits: of the numbers in a text for people.
CLI::Option* add_digits(CLI::App& command, std::optional<std::uint64_t>& digits);

/// How a text on standard output is shown: in colour where it can be, with the digits that were asked for.
TextStyle style_of(const Console& console, const std::optional<std::uint64_t>& digits);

/// The number that a text is, of no more than 1e9 either way; absent if it is none.
std::optional<double> decimal(const std::string& text);

/// A check for options whose text cannot be empty: what is wrong, or nothing.
std::string not_empty(const std::string& text);

}  // namespace mechwright

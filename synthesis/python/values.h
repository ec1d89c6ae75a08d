#pragma once
/// \file
/// Python values and JSON, each made from the other.

#include <pybind11/pybind11.h>

#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

namespace mechwright::python {

/// Text for Python; bytes that are not UTF-8 are replaced.
pybind11::str text_of(std::string_view text);

/// What becomes of None and of numbers that are not finite: a problem has no place for None and says itself what is
/// wrong with NaN; in a result both stand for a number that there is not.
enum class Absent { refused, null };

/// A dict of dicts, lists, tuples, NumPy arrays, numbers, truth values and strings. Throws TypeError or ValueError
/// ("require[0].min: ...") for anything else, for more than `deepest` levels, and for whole numbers beyond 64 bits.
nlohmann::ordered_json json_of(const pybind11::dict& dict, Absent absent);

/// What becomes of lists of numbers: arrays of doubles, or of two dimensions for lists of such lists of one length,
/// both with NaN for null; or lists.
enum class Lists { arrays, plain };

/// Objects become dicts.
pybind11::object python_of(const nlohmann::ordered_json& json, Lists lists = Lists::arrays);

}  // namespace mechwright::python

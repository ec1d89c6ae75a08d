#pragma once
/// \file
/// A problem file read again and again with some of its values changed.

#include <toml++/toml.h>

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "synthesis/problem/messages.h"
#include "synthesis/problem/study/study.h"

namespace mechwright {

/// The value of an axis at a point: a number of its range, or one of its list.
struct AxisValue {
    bool as_in_file = false;  ///< neither: what the file itself says
    double number = 0;        ///< of a range
    std::size_t index = 0;    ///< in a list
};

class VariedProblem {
public:
    /// `text` must be TOML; `file` as for parse_problem.
    VariedProblem(std::string_view text, std::string file);
    /// From a table that has no text.
    VariedProblem(const toml::table& table, std::string file);

    /// The problem with a value put at a path (value_path.h), until it is put there anew. Returns what is wrong with
    /// the path, or nothing.
    std::string put(std::string_view path, const toml::node& value);

    /// Gives every axis of a study its value. Returns what is wrong, or nothing.
    std::string put(const Study& study, std::span<const AxisValue> values);

    /// The problem as it now is; [study] is passed over. Messages about changed values have no place.
    ReadProblem read() const;

private:
    std::string put(const StudyAxis& axis, const AxisValue& value);
    std::string put_original(std::string_view path);

    std::string file_;
    toml::table original_;
    toml::table changed_;
    std::vector<std::string> paths_of_cases_;
};

/// The value of an axis as data and messages show it.
std::string label_of(const StudyAxis& axis, const AxisValue& value);

/// What a following value comes to.
double number_of(const FollowingValue& following, const Study& study, std::span<const AxisValue> values);

namespace reading {

/// Reads the first and the last point of a study: what is wrong there is wrong with the study.
void check_ends(VariedProblem&& varied, FilePlace study_place, const Study& study, Messages& messages);

}  // namespace reading

}  // namespace mechwright

#pragma once
/// \file
/// Problems written in C++: what a problem file says, by the same names. Lengths are in one unit of the caller's
/// choice, angles in radians. Every function throws std::invalid_argument, saying what would be right, for a name that
/// the mechanism does not have and for a number that cannot be meant.

#include <optional>
#include <string>
#include <string_view>

#include "synthesis/problem/problem.h"

namespace mechwright {

/// A problem of a mechanism with nothing said yet: dimensions that may be left out are 0, settings have their presets,
/// the assembly is the first. Cams are made by their files alone.
Problem problem_of(std::string_view mechanism);

/// A dimension that is given.
void fix(Problem& problem, std::string_view dimension, double value);

/// A dimension that is to be designed, min < max, with a preferred value between them if there is one.
void design_within(Problem& problem, std::string_view dimension, double min, double max,
                   std::optional<double> start = {});

/// One of some values, or the least value and whole steps more (step > 0, max - min at least that).
void choose_among(Problem& problem, std::string_view dimension, std::vector<double> choices);
void design_in_steps(Problem& problem, std::string_view dimension, double min, double max, double step);

/// The assembly by its name, or "either" for all.
void assemble(Problem& problem, std::string_view assembly);

/// What is required of a quantity: a value, or a least one, a greatest one or both.
void require_equal(Problem& problem, std::string_view quantity, double value);
void require_within(Problem& problem, std::string_view quantity, std::optional<double> min, std::optional<double> max);

/// What is to be as small or as great as can be; several are summed with their weights (> 0).
void minimize(Problem& problem, std::string_view quantity, double weight = 1);
void maximize(Problem& problem, std::string_view quantity, double weight = 1);

/// What comes before those: a design is as good in it as can be, or worse by `within` (>= 0, radians for angles) at
/// most. Several are wished for in the order of the calls.
void wish_least(Problem& problem, std::string_view quantity, double within = 0);
void wish_greatest(Problem& problem, std::string_view quantity, double within = 0);

/// A path of at least two points, all of one weight, in order at any crank angles; the members of `problem.path` say
/// more.
void follow_path(Problem& problem, std::vector<Vector<double>> points);

/// What a problem lacks before it can be solved, or why its ranges hold no mechanism; empty if nothing does.
std::string why_not_whole(const Problem& problem);

}  // namespace mechwright

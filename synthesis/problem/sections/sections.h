#pragma once
/// \file
/// One reader for each section of a problem file. Each fills its part of the problem, reports what is wrong, and does
/// nothing if its section is absent. What the mechanism decides is left out where the mechanism is unknown.

#include <optional>
#include <string_view>

#include "synthesis/problem/toml/section.h"
#include "synthesis/target/path/read_points.h"

namespace mechwright::reading {

/// An angle of the file in radians.
double to_radians(const Units& units, double angle);

/// A full turn in the file's unit, with room for the rounding of a written 2 pi.
double full_turn(const Units& units);

void read_units(Section& file, Problem& problem, Messages& messages);
void read_dimensions(Section& file, Problem& problem, Messages& messages);
/// The ranges of tied dimensions, once all dimensions and numbers of targets have been read.
void resolve_ties(const Section& file, Problem& problem, Messages& messages);
/// This, and whether any design of the mechanism lies in the ranges.
void conclude_dimensions(const Section& file, Problem& problem, Messages& messages);
void read_requirements(Section& file, Problem& problem, Messages& messages);
/// Reports quantities that have no value over a range of crank angles, where the file gives one: after everything that
/// is asked for.
void check_quantities_over_range(const Section& file, const Problem& problem, Messages& messages);
void read_objective(Section& file, Problem& problem, Messages& messages);
void read_path(Section& file, Problem& problem, Messages& messages);
/// The function to be generated; after [motion], whose crank range it sets where that is known and not given.
void read_function(Section& file, Problem& problem, Messages& messages);
/// The line or the arc that a guided point follows; after [motion] too.
void read_followed(Section& file, Problem& problem, Messages& messages);
/// A start and a range, as the two dimensions from `first` on.
void read_scale(Section& scale, std::size_t first, Problem& problem, Messages& messages);
/// The crank range that follows from the input range, where that is known and none is given.
void set_crank_range(Problem& problem);
/// The poses of a guided body: a path with directions.
void read_poses(Section& file, Problem& problem, Messages& messages);
/// Velocities and accelerations at one crank angle, as requirements; after those of [[require]].
void read_instant(Section& file, Problem& problem, Messages& messages);
void read_motion(Section& file, Problem& problem, Messages& messages);
/// That [motion] may have the keys of the range of use.
void accept_range_of_use(Section& motion);
/// The range of use, in [motion]: after the targets.
void read_range_of_use(Section& file, Problem& problem, Messages& messages);
/// The quantities that a file names, in the order of the sections that can.
std::vector<std::string> quantities_in(const toml::table& file);
/// Adds quantities over the whole motion to the mechanism of a file that judges designs over a part of it: where it has
/// a range of use, or where the crank turns fully beyond an input range, and it names such a quantity.
void add_whole_quantities(const toml::table& file, Problem& problem);
/// The sections that the mechanism's settings stand in.
void read_settings(Section& file, Problem& problem, Messages& messages);
void read_solver(Section& file, Problem& problem, Messages& messages);
/// That a front has two objectives: after these and [solver].
void check_front(const Section& file, const Problem& problem, Messages& messages);
/// [study]: after the mechanism and the dimensions.
void read_study(Section& file, Problem& problem, Messages& messages);

/// All sections of a problem file.
void read_problem_table(const toml::table& table, Problem& problem, Messages& messages);
/// What the messages of reading come to, at the end of reading.
void conclude(ReadProblem& read, Messages&& messages);

/// What is wrong with allowing multiples of a number alone in a range; empty if nothing is.
std::string round_fault(DimensionRange range, double multiple);

/// [solver] round: the lengths that are designed become multiples of it, but for those that have allowed values
/// already.
void round_lengths(const Section& file, Problem& problem, Messages& messages);

/// { min, max } with or without start and step, or { choices } with or without start, in the file's unit; `name` is
/// what it is of. What is wrong with it is reported.
std::optional<DimensionRange> to_range(const toml::table& table, std::string_view name, Messages& messages);

/// A number or a range of the file as a dimension, angles in radians.
std::optional<DimensionRange> to_dimension(const toml::node& node, const Dimension& dimension, const Units& units,
                                           Messages& messages);

/// The same, or a tie to other dimensions: { of = "crank", times = 2, plus = 3 }, or a sum "2 crank - rocker".
std::optional<DimensionRange> to_dimension_or_tie(const toml::node& node, std::size_t index, const Mechanism& mechanism,
                                                  const Units& units, Messages& messages);

/// Whether a dimension is no number of a target nor of a segment of a cam's motion.
bool stands_in_dimensions(const Dimension& dimension);
/// Where a dimension, or a number of a target's scales, stands in the file.
FilePlace place_of_dimension(const Section& file, std::string_view name);

/// A quantity of the mechanism by its name: its index. Path quantities are accepted only in files with a [path].
std::optional<std::size_t> to_quantity(const toml::node& node, std::string_view what, const Section& file,
                                       const Problem& problem, Messages& messages);

/// The points of a [path], from its list or the file it names.
PointList read_points(Section& path, const Problem& problem, Messages& messages);

}  // namespace mechwright::reading

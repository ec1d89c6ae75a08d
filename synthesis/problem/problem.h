#pragma once
/// \file
/// A problem file as plain values: angles in radians, lengths as in the file, quantities and dimensions as indices into
/// the registry of the mechanism. After reading, nothing else of the file is looked at.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <numbers>
#include <optional>
#include <string>
#include <vector>

#include "analysis/geometry/vector.h"
#include "synthesis/mechanism/affine.h"
#include "synthesis/mechanism/mechanism.h"

namespace mechwright {

struct Study;

inline constexpr std::size_t most_targets = 16;  ///< of a problem

struct Units {
    bool degrees = true;        ///< else radians
    std::string length = "mm";  ///< a label; lengths are never converted
    std::string force{};        ///< a label of forces, and with lengths of torques and rates; empty: none is known
    std::string mass{};         ///< of the file's masses; empty: one that goes with force, length and second
    double per_mass = 1;        ///< what the file's masses are times that one
};

/// One dimension: a fixed number, a range to be designed in, all of it or a few of its values, or a sum of multiples of
/// others.
struct DimensionRange {
    double min = 0;
    double max = 0;
    std::optional<double> start;
    bool named = false;  ///< stands in the file; else the default 0
    Affine tie{};        ///< of dimensions that are not tied; where it has terms the range follows from theirs
    std::vector<double> choices{};  ///< the values that it may have, ascending, from min to max; empty: any
    double step = 0;                ///< above 0: it is min or whole steps more, as max is

    bool fixed() const { return min == max && !tied(); }
    bool tied() const { return !tie.terms.empty(); }
    bool discrete() const { return !choices.empty() || step > 0; }
    /// For an angle: whether the range is a full turn or more.
    bool any_angle() const { return max - min >= 2 * std::numbers::pi * (1 - 1e-12); }
};

struct Requirement {
    std::size_t quantity = 0;  ///< index into Mechanism::quantities
    std::optional<double> equal;
    std::optional<double> min;
    std::optional<double> max;
};

struct ObjectiveTerm {
    std::size_t quantity = 0;
    bool maximize = false;
    double weight = 1;
};

/// One term; or several, summed with their weights; or several of one sense whose worst is optimised.
struct Objective {
    std::vector<ObjectiveTerm> terms;
    bool worst = false;  ///< reduce = "max": the largest of minimized, the least of maximized terms counts
};

/// An objective that comes before the problem's: designs are the best in it that can be had, or worse by no more than
/// `within`, in the quantity's unit, radians and not degrees.
struct Wish {
    ObjectiveTerm term{};
    double within = 0;
};

/// Points of a path that stand next to each other.
struct PointRange {
    std::size_t first = 0;
    std::size_t count = 0;

    std::size_t end() const { return first + count; }
};

/// One of several paths and poses of a problem.
struct PathPart {
    std::string name;
    double weight = 1;  ///< of its mean square in that of all
    PointRange points{};
    std::vector<double> weights{};  ///< of its points, as the file gives them
    bool closed = false;            ///< the crank turns fully
    bool guides_body = false;       ///< it has poses
    double body_length = 0;         ///< as of a target that stands alone
};

/// A path, or poses; or several of both, which are parts of one: their points stand next to each other.
struct PathTarget {
    std::vector<Vector<double>> points;
    bool prescribed_timing = false;
    bool any_order = false;            ///< each point counts by the nearest point of the curve, whatever their order
    std::vector<double> crank_angles;  ///< for prescribed timing: one per point, counted from crank-start; radians
    bool closed = false;               ///< the crank turns fully
    /// One per point, all 1 unless given. In a part they sum up to the weight of the part, so that the mean over all
    /// points is that of the parts.
    std::vector<double> weights;
    /// That a guided body faces at each point, radians; NaN where any does. Empty for a path.
    std::vector<double> directions;
    double body_length = 0;  ///< of a guided body: turning it by a small angle moves it by so much times that
    /// Where paths and poses have names, all of them, in the order of Mechanism::guided (target/path/read_parts.h).
    std::vector<PathPart> parts{};
    std::vector<std::size_t> part_of{};  ///< by point, where there are parts

    std::size_t targets() const { return parts.empty() ? 1 : parts.size(); }
    /// The number of the target that a point belongs to.
    std::size_t target_of(std::size_t point) const { return part_of.empty() ? 0 : part_of[point]; }
    /// The points of a target; of `every_target` all of them.
    PointRange points_of(std::size_t target) const {
        return parts.empty() || target == every_target ? PointRange{0, points.size()} : parts[target].points;
    }
    /// Whether a body is guided through a point, and the length of that.
    bool guides_body_at(std::size_t point) const {
        return parts.empty() ? guides_body() : parts[part_of[point]].guides_body;
    }
    double body_length_at(std::size_t point) const {
        return parts.empty() ? body_length : parts[part_of[point]].body_length;
    }
    bool guides_body() const { return !directions.empty(); }
    /// Whether a direction is asked for at a point.
    bool faces(std::size_t i) const { return guides_body() && !std::isnan(directions[i]); }
    /// How many points are poses.
    std::size_t poses() const {
        return static_cast<std::size_t>(
            std::count_if(directions.begin(), directions.end(), [](double d) { return !std::isnan(d); }));
    }
};

/// The range of use of a path or of poses: the stretch of the crank from the first target that is met to the last,
/// made longer at either end by these crank angles, in the order in which the targets are met; radians, >= 0.
struct RangeOfUse {
    double before = 0;
    double after = 0;
};

/// A line or an arc that the guided point follows over an input range of the crank.
struct FollowedTarget {
    Followed shape = Followed::line;
    bool full_turn = false;  ///< the crank has to turn fully
};

struct SolverOptions {
    std::string method = "auto";
    int starts = 32;
    std::uint64_t seed = 1;
    double time_limit = 60;  ///< seconds
    double tolerance = 1e-9;
    int pareto = 0;  ///< designs on the front between two objectives; 0: none is asked for
};

struct Problem {
    std::string file;    ///< as given on the command line
    std::string sha256;  ///< of the file's bytes
    std::string text;    ///< the file's bytes; empty where they name other files
    std::string title;
    std::shared_ptr<const Mechanism> mechanism;
    Units units;
    std::vector<DimensionRange> dimensions;  ///< in mechanism order, all of them
    std::vector<std::size_t> assemblies;     ///< those to be searched, indices into Mechanism::assemblies
    std::vector<Requirement> requirements;
    std::vector<Wish> wishes;  ///< in their order
    std::optional<Objective> objective;
    std::optional<PathTarget> path;
    std::optional<Vector<double>> crank_range;     ///< (from, to), radians
    std::optional<RangeOfUse> use;                 ///< over which designs are judged, where there is a path
    std::array<double, Setting::most> settings{};  ///< of the mechanism, in the order of Mechanism::settings
    std::shared_ptr<const FunctionTarget> function;
    std::optional<FollowedTarget> followed;
    /// Functions, lines and arcs that have names, in the order of Mechanism::over_input; `function` and `followed` are
    /// of one that has none.
    std::shared_ptr<const std::vector<AskedOverInput>> over_input;
    bool has_instant = false;  ///< velocities are asked for at the crank angle crank-start
    SolverOptions solver;
    std::optional<std::vector<std::size_t>> wanted;  ///< quantities that are reported and verified; all unless given
    std::shared_ptr<const Study> study;              ///< of problems that differ from this one in a few values
};

/// Whether something is asked over an input range, whose ends are dimensions.
inline bool has_input_range(const Problem& problem) {
    return problem.function != nullptr || problem.followed || problem.over_input != nullptr;
}

/// Whether the motion is that in which all targets are met, one of them over an input range; with a closed path it is a
/// full turn.
inline bool moves_over_targets(const Problem& problem) {
    return has_input_range(problem) && !(problem.path && problem.path->closed);
}

/// Whether that motion is of several targets, and not the input range of the only one.
inline bool covers_several(const Problem& problem) {
    return moves_over_targets(problem) && (problem.path || problem.over_input);
}

/// Whether designs are judged over a stretch of crank angles that depends on the design.
inline bool has_moving_ends(const Problem& problem) {
    return !problem.crank_range && (moves_over_targets(problem) || problem.use.has_value());
}

/// What a mechanism's point follows; none where it cannot.
inline const std::optional<FollowedShape>& followed_shape_of(const Mechanism& mechanism, const FollowedTarget& target) {
    return target.shape == Followed::line ? mechanism.line : mechanism.arc;
}

/// Whether a dimension is an angle that may take any value: its range is a full turn, and what is tied to it is the
/// same a turn later.
inline bool turns_freely(const Problem& problem, std::size_t dimension) {
    const auto is_alike = [&](const DimensionRange& range) {
        return std::all_of(range.tie.terms.begin(), range.tie.terms.end(), [&](const auto& term) {
            return term.first != dimension || term.second == std::round(term.second);
        });
    };
    return problem.mechanism->dimensions[dimension].kind == DimensionKind::angle &&
           problem.dimensions[dimension].any_angle() &&
           std::all_of(problem.dimensions.begin(), problem.dimensions.end(), is_alike);
}

inline bool is_discrete(const Problem& problem) {
    return std::any_of(problem.dimensions.begin(), problem.dimensions.end(),
                       [](const DimensionRange& range) { return range.discrete(); });
}

inline bool has_ties(const Problem& problem) {
    return std::any_of(problem.dimensions.begin(), problem.dimensions.end(),
                       [](const DimensionRange& range) { return range.tied(); });
}

}  // namespace mechwright

#pragma once
/// \file
/// What a result document claims, read from the JSON alone: names resolved by the registry, numbers as they stand there
/// (lengths and angles in the file's units). See synthesis/document/fields.h for the members.

#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "synthesis/problem/problem.h"

namespace mechwright {

/// What was given for a dimension: a range, or one number as both of its ends.
struct ClaimedRange {
    double min;
    double max;
    Affine tie{};                   ///< in the document's units; where it has terms the limits are not read
    std::vector<double> choices{};  ///< the values that it may have; empty: any of the range
    double step = 0;                ///< above 0: the least value or whole steps more

    bool tied() const { return !tie.terms.empty(); }
};

struct ClaimedRequirement {
    std::size_t quantity;
    std::optional<double> value;
    std::optional<double> equal;
    std::optional<double> min;
    std::optional<double> max;
    std::optional<double> violation;
    std::optional<bool> active;
};

struct ClaimedWish {
    std::size_t quantity;
    bool maximize;
    double within;
    std::optional<double> best;
    std::optional<double> limit;
    std::optional<double> value;
};

struct ClaimedTerm {
    std::size_t quantity;
    bool maximize;
    double weight;
    std::optional<double> value;
};

struct ClaimedObjective {
    std::vector<ClaimedTerm> terms;
    bool worst = false;  ///< the worst of the terms counts, else their weighted sum
    std::optional<double> value;
};

/// `points` has at least one entry; `weights` and, for prescribed timing, `prescribed_angles` one for each of them.
/// What the design reaches may be missing or of any length.
struct ClaimedPath {
    std::vector<Vector<double>> points;
    bool prescribed_timing = false;
    bool any_order = false;
    bool closed = false;
    std::vector<double> weights;
    std::vector<double> prescribed_angles;
    /// Of a guided body, one for each point, nothing where any will do; empty for a path.
    std::vector<std::optional<double>> directions;
    double body_length = 0;
    std::vector<Vector<double>> reached;
    std::vector<double> reached_directions;
    std::vector<double> crank_angles;
    std::vector<double> distances;
    /// As those of PathTarget, which `weights` go with. Lists are over the points of all; at those of paths beside
    /// poses directions say nothing.
    std::vector<PathPart> parts{};
    std::vector<std::size_t> part_of{};

    std::size_t target_of(std::size_t point) const { return part_of.empty() ? 0 : part_of[point]; }
    bool guides_body_at(std::size_t point) const {
        return parts.empty() ? !directions.empty() : parts[part_of[point]].guides_body;
    }
    double body_length_at(std::size_t point) const {
        return parts.empty() ? body_length : parts[part_of[point]].body_length;
    }
    PointRange points_of(std::size_t target) const {
        return parts.empty() || target == every_target ? PointRange{0, points.size()} : parts[target].points;
    }
    std::size_t targets() const { return parts.empty() ? 1 : parts.size(); }
};

struct Claim {
    std::shared_ptr<const Mechanism> mechanism;
    Units units;
    double tolerance = 1e-9;
    std::vector<std::optional<ClaimedRange>> given;  ///< by dimension
    std::vector<double> design;                      ///< by dimension; 0 where an optional one is left out
    std::size_t assembly = 0;
    std::optional<std::string> kind;
    std::optional<CircuitAndBranch> circuit;
    std::optional<Vector<double>> crank_range;
    std::optional<RangeOfUse> use;                 ///< in the file's unit
    std::optional<Vector<double>> used_angles;     ///< of the range of use
    std::array<double, Setting::most> settings{};  ///< presets where they are not stated
    std::shared_ptr<const FunctionTarget> function;
    std::optional<FollowedTarget> followed;
    std::shared_ptr<const std::vector<AskedOverInput>> over_input;  ///< as Problem::over_input
    bool has_instant = false;
    std::vector<ClaimedRequirement> requirements;
    std::vector<ClaimedWish> wishes;
    std::optional<ClaimedObjective> objective;
    std::vector<std::pair<std::size_t, double>> quantities;  ///< quantity and its value
    std::optional<ClaimedPath> path;
};

struct ReadClaim {
    Claim claim;
    std::string defect;  ///< why the document cannot be understood; empty if it can
};

/// Reads any JSON value; the first thing that is missing, of a wrong type or absurd makes the defect.
ReadClaim read_claim(const nlohmann::ordered_json& document);

}  // namespace mechwright

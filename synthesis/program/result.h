#pragma once
/// \file
/// What a method finds and what the user gets.

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "synthesis/problem/problem.h"

namespace mechwright {

/// A fully dimensioned mechanism. Lengths in the problem's unit, angles in radians.
struct Design {
    std::vector<double> dimensions;  ///< in mechanism order
    std::size_t assembly = 0;
    std::vector<double> path_angles;  ///< crank angle at each target point; empty without a path
};

/// What there is of a wish, in the quantity's unit.
struct MetWish {
    double best = 0;   ///< of designs that were found
    double limit = 0;  ///< the worst that is allowed for the sake of what comes after
};

/// A design with what it is worth, evaluated by us and not by the solver that proposed it.
struct Solution {
    Design design;
    double objective = 0;   ///< in the user's sense and unit; 0 without an objective
    double violation = 0;   ///< the largest relative violation of a requirement, range or condition of motion
    bool feasible = false;  ///< violation within the problem's tolerance
    /// All equalities, ranges and conditions of motion are met: of designs that are not feasible such ones show best
    /// how far the inequalities can be met.
    bool misses_inequalities_only = false;
    std::vector<MetWish> wished{};  ///< of each wish of its problem what was found before this design
};

enum class Status { solved, infeasible, limit, unverified, interrupted };

/// What became of all solutions of an exact problem.
struct SolutionCounts {
    std::size_t tracked = 0;   ///< paths to solutions that were followed, over the complex numbers
    std::size_t distinct = 0;  ///< regular solutions
    std::size_t at_infinity = 0;
    std::size_t singular = 0;
    std::size_t real = 0;         ///< of the distinct ones: each is three cognates
    std::size_t certified = 0;    ///< of the real ones: proven to exist, each alone in a small ball
    std::size_t defect_free = 0;  ///< designs that passed verification
};

/// See synthesis/program/proof.h.
struct Proof;

/// What branch and bound over the discrete dimensions did. Its bounds are the best designs that searches found, and as
/// sure as those are.
struct DiscreteReport {
    long problems = 0;                   ///< that were solved with ranges in place of allowed values
    std::optional<double> continuous{};  ///< the objective that the whole ranges allow
    double gap = 0;         ///< by how much, in the objective's unit, allowed values not looked at may be better
    long combinations = 0;  ///< of allowed values, where each of them was looked at and nothing else was to be found
    long left_out = 0;      ///< parts of the allowed values in which a search found no design and nothing proves that
};

/// How many local searches began at starts from where.
struct StartSources {
    long preferred = 0;  ///< the preferred values
    long drawn = 0;      ///< the ranges
    long four_bars = 0;  ///< drawn about four-bars among the links that follow the path by themselves
    long nearby = 0;     ///< near the ends of other searches

    StartSources& operator+=(const StartSources& more) {
        preferred += more.preferred;
        drawn += more.drawn;
        four_bars += more.four_bars;
        nearby += more.nearby;
        return *this;
    }
};

struct SearchReport {
    std::string method;
    std::shared_ptr<const Proof> proof{};  ///< that this is the whole answer; null where nothing is proven
    int starts = 0;                        ///< local searches run
    int local_optima = 0;                  ///< distinct feasible local optima found
    int hits = 0;                          ///< starts that ended at the best one
    double missed_chance = 1;              ///< estimated chance that a better local optimum was not seen
    long evaluations = 0;                  ///< of the program's functions, over all local searches
    double seconds = 0;
    long drawn = 0;                             ///< candidates for starts
    long assembled = 0;                         ///< of these they close where they have to, and were ranked
    long optimised = 0;                         ///< of these local searches began at them, most cut short
    StartSources sources{};                     ///< of those, and of searches near their ends
    std::optional<double> bound{};              ///< no design has a better objective than this
    long boxes = 0;                             ///< that were examined for it
    std::optional<SolutionCounts> solutions{};  ///< of an exact method
    std::optional<DiscreteReport> discrete{};   ///< where dimensions are discrete
    std::size_t free_numbers =
        0;  ///< of the family of designs that meet targets exactly, where the most compact is shown

    /// Whether the answer is proven.
    bool complete() const { return proof != nullptr; }
};

/// A design beside the best one, of a front or another local optimum, verified by itself.
struct VerifiedDesign {
    Solution solution;
    std::vector<Check> verification;
    /// Draws the same curve as the best design (0) or an alternative (counted from 1); nothing where none does.
    std::optional<std::size_t> cognate_of{};
};

/// A design that is no use as a mechanism, though it meets what the search looked at.
struct ExcludedDesign {
    Solution solution;
    std::string defect;
};

/// Whether there are checks, and none has failed.
bool all_passed(const std::vector<Check>& checks);

struct Result {
    Status status = Status::infeasible;
    std::optional<Solution> best;              ///< the least-violating one if not feasible
    std::vector<VerifiedDesign> alternatives;  ///< other local optima, best first
    /// Local optima that verification does not pass; by an exact method, solutions with a defect where they are asked
    /// for.
    std::vector<ExcludedDesign> excluded;
    std::vector<VerifiedDesign> front;  ///< where it was asked for
    std::vector<Check> verification;
    SearchReport search;
    std::string note;  ///< one sentence for the user where the status needs one

    bool verified() const;
};

}  // namespace mechwright

#pragma once
/// \file
/// The fit of a whole curve to a path in any order, as the search for it sees it: the arguments of the guided point, in
/// their ranges, and the targets. Everything is in the units of a program (program.h): lengths of order one, radians.

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <optional>
#include <vector>

#include "synthesis/mechanism/curve_fit.h"
#include "synthesis/program/program.h"

namespace mechwright {

using CurveArguments = std::array<double, most_curve_arguments>;

/// A kind of motion that designs may have in an assembly.
struct CurveKind {
    std::size_t assembly = 0;
    const std::vector<LinearCondition>* conditions = nullptr;  ///< of the lengths
};

struct CurveProblem {
    const std::vector<Program>* programs = nullptr;
    std::vector<std::vector<std::size_t>> rows;  ///< of each program: its requirements
    double weight_of_rows = 0;                   ///< of their squared violations, against those of distances
    const CurveFit* fit = nullptr;
    InstructionSet set = InstructionSet::baseline;
    std::size_t arguments = 0;
    std::size_t lengths = 0;  ///< the first of them; along, across, origin and tilt follow
    CurveArguments lower{};
    CurveArguments upper{};
    std::vector<CurveKind> kinds;
    GroupedTargets targets;
    std::vector<double> way{};    ///< where each target is along a way through all of them, from 0 to 1
    bool closed = false;          ///< that way goes back to where it began
    double weight = 0;            ///< of all targets
    double spread = 0;            ///< root mean square distance from their middle
    bool free_size = false;       ///< every length is free
    bool free_placement = false;  ///< origin and tilt are free

    bool is_free(std::size_t i) const { return lower[i] < upper[i]; }
    bool has_requirements() const {
        return std::any_of(rows.begin(), rows.end(), [](const auto& some) { return !some.empty(); });
    }
    /// Whether a design keeps from change points as far as it can be told from them (condition_margin), on whichever
    /// side: next to one the curve goes on as the root of what is left, and nobody makes links to such a part.
    bool keeps_from_borders(const CurveArguments& a) const;
    /// Whether lengths may belong to a design in this assembly.
    bool allows(std::size_t assembly, const CurveArguments& a) const;
};

/// What of a problem can be searched so: a path in any order with one target, whose points count by their distance
/// alone, of a mechanism that knows how (CurveFit), without ties; its requirements do not speak of the path, and leave
/// nothing open. `programs` are those of all variants of the problem, and outlive what is returned.
std::optional<CurveProblem> curve_problem(const std::vector<Program>& programs);

/// The first program of a kind of motion that allows these arguments; `programs.size()` where there is none.
std::size_t program_of(const std::vector<Program>& programs, const CurveArguments& arguments, std::size_t assembly);

/// The point of a program with these arguments; crank angles are 0.
Eigen::VectorXd point_with(const Program& program, const CurveArguments& arguments);

/// The arguments at a point of a program.
CurveArguments arguments_at(const Program& program, const Eigen::VectorXd& x);

/// Arguments brought into their ranges; the tilt by whole turns as far as it can.
CurveArguments within_ranges(const CurveProblem& problem, CurveArguments a);

}  // namespace mechwright

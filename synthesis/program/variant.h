#pragma once
/// \file
/// The discrete side of a problem. A problem is solved as several smooth programs, one for each variant: a family of
/// motions, an assembly, a direction in which the crank meets the points of an untimed path, and, where a condition
/// asks that *some* component of a quantity takes a value (an equality on a least value, say), the component that does.

#include <cstddef>
#include <string>
#include <vector>

#include "synthesis/problem/judged_motion.h"
#include "synthesis/problem/problem.h"

namespace mechwright {

struct Variant {
    std::size_t family = 0;
    std::size_t assembly = 0;
    int direction = 1;                 ///< of the crank along an untimed path: +1 counter-clockwise, -1 clockwise
    std::vector<std::size_t> choices;  ///< one per disjunction, in the order of `disjunctions`, or `no_component`

    bool operator==(const Variant&) const = default;
};

/// Where no component is chosen for a requirement it asks only for what all of them have to meet.
inline constexpr std::size_t no_component = static_cast<std::size_t>(-1);

/// Whether every quantity that the problem names has a value in this motion.
bool all_defined(const Problem& problem, const Motion& motion);

/// A condition that one component, not all of them, has to meet.
struct Disjunction {
    std::size_t quantity;
    std::size_t components;
    bool required;  ///< by a requirement; else it is of the objective
};

/// The disjunctions of a problem in a family: those of its requirements in order, then of its objective's terms.
std::vector<Disjunction> disjunctions(const Problem& problem, const Motion& motion);

/// Whether a requirement leaves open which component meets it.
bool is_disjunctive(const Quantity& quantity, const Requirement& requirement);
bool is_disjunctive(const Quantity& quantity, const ObjectiveTerm& term);

/// All variants, in a fixed order.
std::vector<Variant> variants(const Problem& problem);

/// What a variant is, for messages: "crank-rocker, open".
std::string name_of(const Problem& problem, const Variant& variant);

}  // namespace mechwright

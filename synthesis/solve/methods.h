#pragma once
/// \file
/// The methods by their names.

#include <chrono>
#include <string>
#include <string_view>

#include "synthesis/program/run_options.h"
#include "synthesis/solve/choose.h"

namespace mechwright {

struct Method {
    std::string_view name;
    std::string_view meaning;
    std::string (*why_not)(const Problem&);  ///< empty where the method can be used
    Found (*run)(const Problem&, const RunOptions&, std::chrono::steady_clock::time_point deadline);
};

/// Null where there is none of this name.
const Method* find_method(std::string_view name);

/// Whether local searches from many starts are what a method does: a neighbour's design can take their place.
bool is_search(const Method& method);

/// What local searches from a neighbour's design find. Precondition: the options have one.
Found near_neighbour(const Problem& problem, const RunOptions& options, std::chrono::steady_clock::time_point deadline);

/// What the problem's method finds, not yet verified; where all dimensions are given, these; where some are discrete,
/// what branch and bound finds by that method; where there are wishes, what is found in their order.
Found find_designs(const Problem& problem, const RunOptions& options, const RunEnd& end);

/// Whether every solution is known and listed: singular ones are counted alone.
bool leaves_none_out(const SearchReport& report);

}  // namespace mechwright

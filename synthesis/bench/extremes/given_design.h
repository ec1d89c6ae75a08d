#pragma once
/// \file
/// A mechanism that is given, with its motion, and its quantities as the optimisers and the verification know them.

#include <memory>
#include <string_view>

#include "synthesis/program/quantity_value.h"

namespace mechwright::bench {

struct GivenDesign {
    std::shared_ptr<const Problem> problem;  ///< of its kind
    Motion motion;
    std::vector<double> dimensions;

    GivenDesign(std::shared_ptr<const Problem> kind, std::vector<double> given);
    /// By the formulas that the optimisers use.
    double quantity(std::size_t index) const;
    /// In fifty digits, by the verification's.
    Digits50 quantity_again(std::size_t index) const;
};

/// Any problem of the kind, all dimensions given. Precondition: the text is a valid problem.
std::shared_ptr<const Problem> problem_of(std::string_view text);

/// The dimensions that a problem gives.
std::vector<double> dimensions_of(const Problem& problem);

/// Number i, in (0, 1), of mechanism k.
double random_number(std::size_t k, std::size_t i);

}  // namespace mechwright::bench

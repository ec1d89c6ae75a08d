#pragma once
/// \file
/// What many local searches ended at: the distinct optima among it, and what that says of those not seen.

#include <vector>

#include "synthesis/program/result.h"

namespace mechwright {

/// The expected share of searches that end at optima not yet seen, from how many there were and how many distinct
/// optima they ended at (Boender and Rinnooy Kan, Bayesian stopping rules for multistart global optimization methods,
/// Mathematical Programming 37, 1987).
double unseen_share(int searches, int optima);

/// The different values that searches which were run to their end came to. Searches that were given up half way tell
/// nothing of optima.
class SearchEnds {
public:
    /// Values that agree to this part of the known one are one end.
    explicit SearchEnds(double same_within) : same_within_(same_within) {}
    void add(double value);
    /// What is said by unseen_share.
    double unseen() const { return unseen_share(searches_, static_cast<int>(values_.size())); }

private:
    double same_within_;
    int searches_ = 0;
    std::vector<double> values_{};
};

/// Whether the dimensions of two designs agree to a part of the longest length, angles to that part of a radian.
bool same_design(const Problem& problem, const Design& a, const Design& b, double within);

/// Whether two ends of local searches are one optimum.
bool same_optimum(const Problem& problem, const Design& a, const Design& b);

/// Distinct optima in order of preference; equal ones keep the order in which they are given. Fills in the report how
/// many there are, how often the best was hit and, from `report.starts` and the different objectives, the estimated
/// chance that a better one was missed.
std::vector<Solution> distinct_optima(const Problem& problem, std::vector<const Solution*> all, SearchReport& report);

}  // namespace mechwright

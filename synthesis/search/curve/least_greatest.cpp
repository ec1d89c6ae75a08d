#include "synthesis/search/curve/least_greatest.h"

#include <algorithm>
#include <cmath>

namespace mechwright {

namespace {

/// So often are the weights made anew, and descents begun with them, each of so many evaluations.
constexpr int passes = 16;
constexpr int evaluations_of_pass = 30;
constexpr double gains_too_small = 1e-9;
/// No target counts less than this part of what it would among equals, so that none is forgotten.
constexpr double least_weight = 1e-4;

/// Squared distances of the targets from a design's curve. Empty: it does not assemble.
std::vector<double> squares_at(const CurveProblem& p, FittedCurve design, CurveWork& work) {
    std::vector<double> squares;
    if (!descend(p, design, 1, 0, work)) return squares;
    for (std::size_t i = 0; i < p.targets.count; ++i)
        squares.push_back(work.nearest.square[i / 8][i % 8]);
    return squares;
}

/// Each weight times its distance, all together what they were.
void weigh_anew(CurveProblem& p, const std::vector<double>& squares) {
    double sum = 0;
    for (std::size_t i = 0; i < squares.size(); ++i)
        sum += p.targets.weight[i / 8][i % 8] * std::sqrt(squares[i]);
    if (!(sum > 0)) return;
    const double even = p.weight / static_cast<double>(squares.size());
    for (std::size_t i = 0; i < squares.size(); ++i) {
        double& weight = p.targets.weight[i / 8][i % 8];
        weight = std::max(weight * std::sqrt(squares[i]) / sum * p.weight, least_weight * even);
    }
}

}  // namespace

std::optional<GreatestDistance> towards_least_greatest(const CurveProblem& problem, const FittedCurve& from,
                                                       CurveWork& work) {
    CurveProblem weighed = problem;
    GreatestDistance best;
    FittedCurve at = from;
    for (int pass = 0; pass <= passes; ++pass) {
        const std::vector<double> squares = squares_at(problem, at, work);
        if (squares.empty()) break;
        const double greatest = std::sqrt(*std::max_element(squares.begin(), squares.end()));
        if (greatest < best.distance) best = {at, greatest};
        weigh_anew(weighed, squares);
        if (!descend(weighed, at, evaluations_of_pass, gains_too_small, work)) break;
    }
    if (!(best.distance < unlimited) || !descend(problem, best.design, 1, 0, work)) return std::nullopt;
    return best;
}

}  // namespace mechwright

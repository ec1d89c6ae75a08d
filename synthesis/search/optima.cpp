#include "synthesis/search/optima.h"

#include <algorithm>
#include <cmath>

#include "synthesis/program/assess.h"

namespace mechwright {

namespace {

/// Designs whose dimensions agree to this part of the longest length are one optimum: searches in a flat valley end at
/// places along it.
constexpr double same_within = 1e-3;
/// Objectives that agree to this (or to this part of the problem's scale) are equally good.
constexpr double same_optimum_within = 1e-7;

bool is_as_good(const Solution& one, const Solution& other) {
    return std::abs(one.objective - other.objective) <= same_optimum_within * std::abs(other.objective);
}

/// How many different objectives the feasible ones of these optima have, which are in order of preference. Designs of
/// one family, along which the objective stays the same, are no sign that there are others.
int count_of_objectives(const std::vector<Solution>& optima) {
    int count = 0;
    const Solution* last = nullptr;
    for (const Solution& optimum : optima) {
        if (!optimum.feasible || (last != nullptr && is_as_good(optimum, *last))) continue;
        ++count;
        last = &optimum;
    }
    return count;
}

}  // namespace

double unseen_share(int searches, int optima) {
    const double n = searches;
    const double w = optima;
    if (searches < 2) return 1;
    return std::min(1.0, w * (w + 1) / (n * (n - 1)));
}

void SearchEnds::add(double value) {
    ++searches_;
    const bool known = std::any_of(values_.begin(), values_.end(),
                                   [&](double end) { return std::abs(value - end) <= same_within_ * end; });
    if (!known) values_.push_back(value);
}

bool same_design(const Problem& problem, const Design& a, const Design& b, double within) {
    if (a.assembly != b.assembly) return false;
    double size = 0;
    for (std::size_t i = 0; i < a.dimensions.size(); ++i)
        if (problem.mechanism->dimensions[i].kind == DimensionKind::length)
            size = std::max({size, a.dimensions[i], b.dimensions[i]});
    for (std::size_t i = 0; i < a.dimensions.size(); ++i) {
        const bool is_angle = problem.mechanism->dimensions[i].kind == DimensionKind::angle;
        const double difference = a.dimensions[i] - b.dimensions[i];
        if (is_angle ? std::abs(std::sin(difference / 2)) > within : std::abs(difference) > within * size) return false;
    }
    return true;
}

bool same_optimum(const Problem& problem, const Design& a, const Design& b) {
    return same_design(problem, a, b, same_within);
}

std::vector<Solution> distinct_optima(const Problem& problem, std::vector<const Solution*> all, SearchReport& report) {
    std::stable_sort(all.begin(), all.end(),
                     [&](const Solution* a, const Solution* b) { return preferred(problem, *a, *b); });
    std::vector<Solution> optima;
    for (const Solution* s : all) {
        const bool known = std::any_of(optima.begin(), optima.end(),
                                       [&](const Solution& o) { return same_optimum(problem, o.design, s->design); });
        if (!known) optima.push_back(*s);
        if (s->feasible && is_as_good(*s, optima.front())) ++report.hits;
    }
    report.local_optima =
        static_cast<int>(std::count_if(optima.begin(), optima.end(), [](const Solution& s) { return s.feasible; }));
    report.missed_chance = unseen_share(report.starts, count_of_objectives(optima));
    return optima;
}

}  // namespace mechwright

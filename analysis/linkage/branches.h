#pragma once
/// \file
/// All positions of a linkage at once: the travels of all its assemblies, which are its branches, and how these hang
/// together in circuits. Where a branch ends at the limit of a dyad both sides of that dyad meet, so that the linkage
/// can go over to the branch of the other side without being taken apart (Erdman and Sandor, Mechanism Design, vol. 1,
/// section 3.11, who tell the two apart so).

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <span>
#include <tuple>
#include <vector>

#include "analysis/linkage/travel.h"

namespace mechwright::linkage {

struct Branch {
    std::size_t assembly = 0;  ///< of those that were asked for
    Travel travel{};
    int circuit = 0;  ///< numbered from 1 by the least start of a branch, then by the assembly
    int branch = 0;   ///< in its circuit, the same
};

namespace detail {

/// The only choice by which two assemblies differ; none where there are more.
inline std::size_t only_difference(const std::vector<std::int8_t>& a, const std::vector<std::int8_t>& b) {
    std::size_t found = none;
    for (std::size_t i = 0; i < a.size(); ++i) {
        if (a[i] == b[i]) continue;
        if (found != none) return none;
        found = i;
    }
    return found;
}

/// Whether two branches that differ by the side of one dyad meet at an end: at its limit, at one input.
inline bool meet_at_limit(const Branch& a, const Branch& b, std::size_t margin, const Inputs& inputs) {
    constexpr double same_within = 1e-6;
    const double period = inputs.to - inputs.from;
    const auto same = [&](double x, const Limit& first, double y, const Limit& second) {
        if (first.margin != margin || second.margin != margin || first.inner != second.inner) return false;
        double apart = std::abs(x - y);
        if (inputs.cyclic) apart = std::abs(apart - period * std::round(apart / period));
        return apart < same_within;
    };
    return same(a.travel.from, a.travel.first, b.travel.from, b.travel.first) ||
           same(a.travel.to, a.travel.last, b.travel.to, b.travel.last);
}

/// Numbers circuits, whose branches have one representative, and the branches in them.
inline void number_branches(std::vector<Branch>& all, const std::vector<std::size_t>& circuit_of) {
    std::vector<std::size_t> order(all.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
        return std::tie(all[a].travel.from, all[a].assembly) < std::tie(all[b].travel.from, all[b].assembly);
    });
    std::vector<int> number(all.size(), 0), branches(all.size(), 0);
    int circuits = 0;
    for (const std::size_t i : order) {
        const std::size_t circuit = circuit_of[i];
        if (number[circuit] == 0) number[circuit] = ++circuits;
        all[i].circuit = number[circuit];
        all[i].branch = ++branches[circuit];
    }
    std::stable_sort(all.begin(), all.end(), [](const Branch& a, const Branch& b) {
        return std::tie(a.circuit, a.branch) < std::tie(b.circuit, b.branch);
    });
}

}  // namespace detail

/// The branches of these assemblies (sides of each), in the order of their numbers; of those alone that
/// keep(driven, travel) takes.
template <class Keep>
std::vector<Branch> branches_of(const Driven<double>& driven, std::span<const std::vector<std::int8_t>> assemblies,
                                const Inputs& inputs, const Keep& keep) {
    std::vector<Branch> all;
    Driven<double> moving = driven;
    for (std::size_t i = 0; i < assemblies.size(); ++i) {
        moving.sides = assemblies[i];
        for (const Travel& travel : travels(moving, inputs))
            if (keep(moving, travel)) all.push_back({i, travel});
    }
    std::vector<std::size_t> circuit_of(all.size());
    std::iota(circuit_of.begin(), circuit_of.end(), std::size_t{0});
    for (std::size_t a = 0; a < all.size(); ++a)
        for (std::size_t b = 0; b < a; ++b) {
            const std::size_t choice =
                detail::only_difference(assemblies[all[a].assembly], assemblies[all[b].assembly]);
            if (choice == none) continue;
            const auto step = std::find_if(driven.order.steps.begin(), driven.order.steps.end(),
                                           [&](const Step& one) { return one.choice == choice && one.margin != none; });
            if (!detail::meet_at_limit(all[a], all[b], step->margin, inputs)) continue;
            const std::size_t from = circuit_of[a], to = circuit_of[b];
            std::replace(circuit_of.begin(), circuit_of.end(), from, to);
        }
    detail::number_branches(all, circuit_of);
    return all;
}

inline std::vector<Branch> branches_of(const Driven<double>& driven,
                                       std::span<const std::vector<std::int8_t>> assemblies, const Inputs& inputs) {
    return branches_of(driven, assemblies, inputs, [](const Driven<double>&, const Travel&) { return true; });
}

}  // namespace mechwright::linkage

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

#include "analysis/linkage/motion/travel.h"

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

/// Calls use(x, limit, y, limit) for the ends, of the same sense, at which two branches end by dyads' limits at one
/// input.
template <class Use>
void for_common_ends(const Branch& a, const Branch& b, const Inputs& inputs, const Use& use) {
    constexpr double same_within = 1e-6;
    const double period = inputs.to - inputs.from;
    const auto compare = [&](double x, const Limit& first, double y, const Limit& second) {
        if (!first.is_singular() || !second.is_singular() || first.parallel || second.parallel) return;
        double apart = std::abs(x - y);
        if (inputs.cyclic) apart = std::abs(apart - period * std::round(apart / period));
        if (apart < same_within) use(x, first, y, second);
    };
    compare(a.travel.from, a.travel.first, b.travel.from, b.travel.first);
    compare(a.travel.to, a.travel.last, b.travel.to, b.travel.last);
}

/// Whether all links are in the same places at an end of each of two assemblies: where several dyads come to their
/// limits at once more than one side changes.
inline bool same_places(Driven<double>& moving, const std::vector<std::int8_t>& a, double x,
                        const std::vector<std::int8_t>& b, double y) {
    constexpr double same_within = 1e-6;
    const double size = size_of(moving);
    moving.shortfall = 1e-13 * size;
    moving.sides = a;
    if (!moving.place(x)) return false;
    const std::vector<LinkPlace<double>> first = moving.pose.links;
    moving.sides = b;
    if (!moving.place(y)) return false;
    for (std::size_t i = 0; i < first.size(); ++i) {
        const Vector<double> way = moving.pose.links[i].origin - first[i].origin,
                             turn = moving.pose.links[i].along - first[i].along;
        if (std::hypot(way.x, way.y) > same_within * size || std::hypot(turn.x, turn.y) > same_within) return false;
    }
    return true;
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
    KnownParts known;
    for (std::size_t i = 0; i < assemblies.size(); ++i) {
        moving.sides = assemblies[i];
        for (const Travel& travel : travels(moving, inputs, known))
            if (keep(moving, travel)) all.push_back({i, travel});
    }
    std::vector<std::size_t> circuit_of(all.size());
    std::iota(circuit_of.begin(), circuit_of.end(), std::size_t{0});
    for (std::size_t a = 0; a < all.size(); ++a)
        for (std::size_t b = 0; b < a; ++b) {
            const std::vector<std::int8_t>&first = assemblies[all[a].assembly], &second = assemblies[all[b].assembly];
            const std::size_t choice = detail::only_difference(first, second);
            bool meet = false;
            detail::for_common_ends(
                all[a], all[b], inputs, [&](double x, const Limit& at_x, double y, const Limit& at_y) {
                    const bool by_one_side = choice != none && at_x.margin == at_y.margin && at_x.inner == at_y.inner &&
                                             step_of(driven.order, at_x.margin).choice == choice;
                    meet = meet || by_one_side || detail::same_places(moving, first, x, second, y);
                });
            if (!meet) continue;
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

#pragma once
/// \file
/// Linkages as the bench places them: a point, by the steps that it needs.

#include <cstdint>
#include <span>
#include <vector>

#include "analysis/geometry/half_angle.h"
#include "analysis/linkage/placing/needed.h"
#include "analysis/linkage/placing/needed_place.h"
#include "analysis/linkage/structure/order.h"
#include "synthesis/bench/kernels/kernel_list.h"

namespace mechwright::bench {

/// A linkage driven by one crank, one of its points, and its dimensions.
struct PointOfLinkage {
    linkage::Structure structure;
    linkage::Order order;
    std::vector<double> numbers;
    std::vector<std::int8_t> sides;
    linkage::Needed needed;
};

/// The four-bar of the kernel "four-bar, coupler point" as links and joints, its assembly open.
PointOfLinkage four_bar_linkage(const std::array<double, CouplerPointKernel::size>& dimensions);

/// The point in any number type, its row of numbers made for this.
template <class T>
Vector<T> point_of(const PointOfLinkage& l, std::span<const T> numbers, const T& crank_angle) {
    std::vector<T> row(l.needed.size);
    linkage::set_design<T, T>(l.needed, numbers, l.sides, row);
    linkage::set_input<T>(l.needed, 0, crank_angle, row);
    linkage::place_needed<T>(l.needed, row);
    return {row[l.needed.point], row[l.needed.point + 1]};
}

/// Directions of crank angles, as many as fill lanes, and where a point is at them.
struct AngleBlock {
    static constexpr std::size_t count = 512;
    alignas(64) std::array<double, count> cosine, sine, half_cosine, half_sine;
    alignas(64) std::array<double, count> x, y;
};

/// The angles of a whole turn.
AngleBlock whole_turn();

}  // namespace mechwright::bench

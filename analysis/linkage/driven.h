#pragma once
/// \file
/// A linkage of given dimensions that one master input drives.

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "analysis/linkage/group_solver.h"
#include "analysis/linkage/place.h"
#include "analysis/linkage/steps.h"

namespace mechwright::linkage {

/// The input of a drive: ratio times the master's + phase.
struct DriveLaw {
    double ratio = 1;
    double phase = 0;
};

/// The inputs of all drives for one of the master.
template <class T>
void set_inputs(std::span<const DriveLaw> laws, const T& master, std::span<T> inputs) {
    for (std::size_t i = 0; i < laws.size(); ++i)
        inputs[i] = T(laws[i].ratio) * master + T(laws[i].phase);
}

template <class T>
class Driven {
public:
    const Order& order;
    std::vector<Sized<T>> sizes;
    std::vector<DriveLaw> laws;
    /// One for each choice: 1 or -1, and 0 where a dyad is to be placed exactly at its limit.
    std::vector<std::int8_t> sides;
    double shortfall = 0;  ///< as of Input
    Pose<T> pose;
    std::vector<GroupSolver<T>> groups;  ///< for each larger group of the order

    /// The order must outlive this, and larger groups need their ways (GroupSolver::way); drives without a law have the
    /// master's input.
    Driven(const Structure& s, const Order& steps, std::span<const T> numbers, std::span<const std::int8_t> on_sides,
           std::span<const DriveLaw> drive_laws = {})
        : order(steps),
          sizes(sizes_of(s, steps, numbers)),
          laws(drive_laws.begin(), drive_laws.end()),
          sides(on_sides.begin(), on_sides.end()),
          pose(empty_pose<T>(s, steps)),
          inputs_(s.drives.size(), T(0)) {
        laws.resize(s.drives.size());
        for (const LargerGroup& group : steps.larger)
            groups.emplace_back(s, group, numbers);
    }

    /// The same linkage, placed by other steps: those of its order as far as they go.
    Driven(const Driven& other, const Order& head)
        : order(head),
          sizes(other.sizes),
          laws(other.laws),
          sides(other.sides),
          shortfall(other.shortfall),
          pose(other.pose),
          groups(other.groups),
          inputs_(other.inputs_) {}

    /// Places all links into `pose`, or as far as to a margin; as linkage::place. `near` as of Input.
    bool place(const T& master, std::span<const double> near = {}, std::size_t last_margin = none) {
        set_inputs(master);
        return linkage::place<T>(order, sizes,
                                 {inputs_, sides, near, shortfall, last_margin, groups, detail::plain(master)}, pose);
    }
    /// The ways of the larger groups; those beyond the ones given have none.
    void set_ways(std::span<const std::shared_ptr<const Way>> ways) {
        for (std::size_t i = 0; i < groups.size() && i < ways.size(); ++i)
            groups[i].way = ways[i];
    }

    void set_inputs(const T& master) { linkage::set_inputs<T>(laws, master, inputs_); }
    std::span<const T> inputs() const { return inputs_; }

private:
    std::vector<T> inputs_;
};

/// The greatest length by which its dyads, pins and lines are described: what is small against it is rounding.
template <class T>
double size_of(const Driven<T>& driven) {
    double greatest = 0;
    const auto count = [&](const T& length) {
        greatest = std::max(greatest, std::abs(number_as<double>(value_of(length))));
    };
    for (std::size_t i = 0; i < driven.order.steps.size(); ++i) {
        const Step& step = driven.order.steps[i];
        if (step.margin == none && step.kind != Step::Kind::carried && step.kind != Step::Kind::pinned) continue;
        for (const Part<T>* part : {&driven.sizes[i].first, &driven.sizes[i].second})
            for (const T& length : {part->own.x, part->own.y, part->through.x, part->through.y, part->length})
                count(length);
    }
    return greatest;
}

}  // namespace mechwright::linkage

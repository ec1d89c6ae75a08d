#pragma once
/// \file
/// A linkage of given dimensions that one master input drives.

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <span>
#include <vector>

#include "analysis/linkage/groups/group_solver.h"
#include "analysis/linkage/motion/drive_motion.h"
#include "analysis/linkage/placing/place.h"
#include "analysis/linkage/structure/steps.h"

namespace mechwright::linkage {

/// The input of a drive: ratio times the master's + phase; or scale times the lift of a motion + phase, with what a
/// turn adds to that over a turn as its ratio. R is the type of its numbers.
template <class R>
struct DriveLawIn {
    R ratio{1};
    R phase{0};
    std::shared_ptr<const DriveMotion<R>> motion{};
    R scale{1};
};
using DriveLaw = DriveLawIn<double>;

/// No input: pieces of motions are those in which the master's own is.
inline constexpr double by_itself = std::numeric_limits<double>::quiet_NaN();

/// The input of a drive for one of the master, or its derivative by that: of a motion by the formula of the piece in
/// which an input `within` lies.
template <class T>
T input_by(const DriveLawIn<Constant<T>>& law, const T& master, double within = by_itself, bool slope = false) {
    using R = Constant<T>;
    if (law.motion) {
        const T lift = detail::motion_at(*law.motion, master,
                                         std::isnan(within) ? number_as<R>(value_of(master)) : R(within), slope);
        return slope ? T(T(law.scale) * lift) : T(T(law.scale) * lift + T(law.phase));
    }
    return slope ? T(law.ratio) : T(T(law.ratio) * master + T(law.phase));
}

/// The inputs of all drives for one of the master.
template <class T>
void set_inputs(std::span<const DriveLawIn<Constant<T>>> laws, const T& master, std::span<T> inputs,
                double within = by_itself) {
    for (std::size_t i = 0; i < laws.size(); ++i)
        inputs[i] = input_by(laws[i], master, within);
}

template <class T>
class Driven {
public:
    const Order& order;
    std::vector<Sized<T>> sizes;
    std::vector<DriveLawIn<Constant<T>>> laws;
    /// One for each choice: 1 or -1, and 0 where a dyad is to be placed exactly at its limit.
    std::vector<std::int8_t> sides;
    double shortfall = 0;       ///< as of Input
    double within = by_itself;  ///< an input in the pieces of motions by whose formulas drives follow (input_by)
    Pose<T> pose;
    std::vector<GroupSolver<T>> groups;  ///< for each larger group of the order

    /// The order must outlive this, and larger groups need their ways (GroupSolver::way); drives without a law have the
    /// master's input.
    Driven(const Structure& s, const Order& steps, std::span<const T> numbers, std::span<const std::int8_t> on_sides,
           std::span<const DriveLawIn<Constant<T>>> drive_laws = {})
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
          within(other.within),
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

    void set_inputs(const T& master) { linkage::set_inputs<T>(laws, master, inputs_, within); }
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

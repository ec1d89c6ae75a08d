#pragma once
/// \file
/// A linkage followed along its motion by the equations of its joints (loop.h), from one pose to the next.

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <optional>
#include <span>
#include <vector>

#include "synthesis/mechanism/linkage/again/loop.h"
#include "synthesis/mechanism/linkage/mechanism.h"

namespace mechwright {

template <class T>
class Follower {
public:
    Follower(const LinkageModel& model, std::vector<T> numbers)
        : model_(model),
          loop(model.structure, std::move(numbers)),
          laws_(laws_in<T>(model.drives)),
          inputs_(laws_.size()),
          speeds_(laws_.size()) {}

    /// Takes a pose that is nearly one at this input; false where none is next to it.
    bool start(const T& input, LoopPose<T> near) {
        linkage::set_inputs<T>(laws_, input, inputs_);
        sign_ = loop.solve(inputs_, near);
        if (sign_ == 0 || (heeds_stops && !loop.is_between_stops(inputs_, near))) return false;
        at = input;
        pose = std::move(near);
        return true;
    }

    /// Goes on to an input in one step, if the pose there lies where the velocities lead and is on the same branch; or,
    /// where branches `cross` in between, on either. Only from a pose.
    bool step(const T& to, bool cross = false) {
        constexpr double astray = 0.02;
        if (pose.turns.empty()) return false;
        LoopPose<T> speed;
        for (std::size_t i = 0; i < laws_.size(); ++i)
            speeds_[i] = linkage::input_by(laws_[i], at, linkage::by_itself, true);
        if (!loop.velocities(speeds_, pose, speed)) return false;
        LoopPose<T> next = pose;
        for (std::size_t i = 0; i < next.turns.size(); ++i) {
            next.origins[i] = next.origins[i] + (to - at) * speed.origins[i];
            next.turns[i] += (to - at) * speed.turns[i];
        }
        const LoopPose<T> predicted = next;
        linkage::set_inputs<T>(laws_, to, inputs_);
        const int sign = loop.solve(inputs_, next);
        if (sign == 0 || (sign != sign_ && !cross) || distance(predicted, next) > astray) return false;
        if (heeds_stops && !loop.is_between_stops(inputs_, next)) return false;
        sign_ = sign;
        at = to;
        pose = std::move(next);
        return true;
    }

    /// Goes on in steps of a degree, or shorter where needed, and calls `use(follower)` after each. Where it cannot go
    /// on by `least` on its branch it goes over a crossing, such as a parallelogram's change point. Returns whether it
    /// comes to the end; else it stands where there was no way on.
    template <class Use>
    bool follow(const T& end, double least, const Use& use) {
        using std::abs;
        constexpr double usual = std::numbers::pi / 180, crossing = 1e-3;
        constexpr double most_steps = 1e5;  // where nothing keeps them short
        const double unit = number_as<double>(this->unit());
        const double longest = std::max(usual * unit, number_as<double>(T(abs(T(end - at)))) / most_steps);
        double length = longest;
        while (at != end) {
            const T rest = end - at;
            const bool last = abs(rest) <= T(length);
            const T to = last ? end : T(at + (rest > T(0) ? T(length) : T(-length)));
            if (step(to)) {
                use(*this);
                length = std::min(longest, 2 * length);
            } else {
                length = std::min(length, number_as<double>(abs(rest))) / 2;
                if (length >= least * unit) continue;
                length = crossing * unit;
                if (!step(abs(rest) <= T(length) ? end : T(at + (rest > T(0) ? T(length) : T(-length))), true))
                    return false;
                use(*this);
            }
        }
        return true;
    }

    /// The change of the input that counts as much as a radian: of a driven slide the linkage's size.
    T unit() const { return model_.driven_by_slide() ? loop.size() : T(1); }

    /// How far two poses are apart: the greatest turn in radians, or way over the size.
    T distance(const LoopPose<T>& a, const LoopPose<T>& b) const {
        using std::abs;
        T greatest(0);
        for (std::size_t i = 0; i < a.turns.size(); ++i) {
            const Vector<T> way = a.origins[i] - b.origins[i];
            const T apart = hypotenuse(way.x, way.y) / loop.size(), turn = abs(T(a.turns[i] - b.turns[i]));
            if (!(apart <= greatest)) greatest = apart;
            if (!(turn <= greatest)) greatest = turn;
        }
        return greatest;
    }

private:
    const LinkageModel& model_;

public:
    Loop<T> loop;
    LoopPose<T> pose{};
    T at{0};
    bool heeds_stops = true;  ///< differences at a stop look beyond it

private:
    std::vector<linkage::DriveLawIn<T>> laws_;
    std::vector<T> inputs_, speeds_;
    int sign_ = 0;  ///< of the determinant on the branch that it follows
};

/// The pose of the dyads on their sides, nearly, at an input; none where they do not close.
std::optional<LoopPose<double>> pose_of_dyads(linkage::Driven<double>& moving, double input);

}  // namespace mechwright

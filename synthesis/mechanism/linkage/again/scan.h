#pragma once
/// \file
/// The motion of a linkage for verification, sampled in doubles by following it from one pose (follow.h).

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "synthesis/mechanism/linkage/again/series_signals.h"
#include "synthesis/mechanism/linkage/again/signals_again.h"

namespace mechwright {

/// A motion as it is sampled: inputs and poses in doubles.
class Scan {
public:
    Scan(const Motion& motion, std::span<const Digits50> dimensions)
        : model(linkage_of(motion.model)), motion_(motion), dimensions_(dimensions.begin(), dimensions.end()) {
        for (const Digits50& d : dimensions)
            rounded_.push_back(d.convert_to<double>());
        follow();
    }

    bool empty() const { return at.empty(); }
    /// The linkage near an input, in doubles; null where it has no pose there or is singular. Drives follow by the
    /// pieces of their motions in which an input `within` lies, or where that is not a number by the input's own.
    const SeriesSignals* look(double input, double within = linkage::by_itself) const {
        if (!follower_) {
            follower_.emplace(model, numbers_of(model, std::span<const double>(rounded_)));
            follower_->heeds_stops = false;
            series_.emplace(model, std::span<const double>(rounded_), poses.front().turns);
        }
        const std::size_t sample = nearest(input);
        if (at[sample] == input) return series_->develop(input, poses[sample], within) ? &*series_ : nullptr;
        constexpr double least = 1e-9;
        const auto pass = [](const auto&) {};
        const bool there = follower_->start(at[sample], poses[sample]) &&
                           (follower_->step(input) || follower_->follow(input, least, pass));
        return there && series_->develop(input, follower_->pose, within) ? &*series_ : nullptr;
    }
    /// In fifty digits, from a sample; where that is a limit and no pose is there within rounding, from the next one
    /// from which it goes on.
    SignalsAgain<Digits50> precise(std::size_t sample) const {
        SignalsAgain<Digits50> signals(model, std::span<const Digits50>(dimensions_), poses.front().turns);
        if (!full_turn()) {
            signals.first_input = from();
            signals.last_input = to();
        }
        const std::size_t middle = at.size() / 2;
        for (std::size_t i = sample; !signals.follower.start(at[i], pose_as<Digits50>(poses[i])) && i != middle;)
            i < middle ? ++i : --i;
        return signals;
    }
    /// The sample from which an input is reached: at a limit itself velocities lead anywhere.
    std::size_t nearest(double input) const {
        const auto next = static_cast<std::size_t>(std::lower_bound(at.begin(), at.end(), input) - at.begin());
        const std::size_t close = next == 0                                                      ? 0
                                  : next == at.size() || input - at[next - 1] < at[next] - input ? next - 1
                                                                                                 : next;
        return full_turn() || at.size() < 3 ? close : std::clamp<std::size_t>(close, 1, at.size() - 2);
    }

    const LinkageModel& model;
    std::vector<double> at;
    std::vector<LoopPose<double>> poses;

    /// The pose at an end of the motion, or where it ends by itself before it or a little after it.
    const SignalsAgain<Digits50>& at_end(bool last) const {
        std::optional<SignalsAgain<Digits50>>& known = ends_[last ? 1 : 0];
        if (!known) known.emplace(reached_end(last));
        return *known;
    }
    /// Where the motion ends: at a limit not where doubles say, but where the poses end.
    Digits50 exact_end(bool last) const {
        if (full_turn()) return last ? motion_.to : motion_.from;
        std::optional<Digits50>& known = exact_ends_[last ? 1 : 0];
        if (!known) {
            Follower<Digits50> follower = at_end(last).follower;
            if (!goes_on(last, follower)) creep(last, follower, little * follower.unit());
            known = follower.at;
        }
        return *known;
    }
    double from() const { return motion_.from; }
    double to() const { return motion_.to; }
    bool full_turn() const { return motion_.full_turn; }

private:
    static constexpr double little = 1e-9;  ///< of the unit of inputs

    SignalsAgain<Digits50> reached_end(bool last) const {
        SignalsAgain<Digits50> signals = precise(last ? at.size() - 1 : 0);
        if (!full_turn()) signals.inside.emplace(precise(nearest(last ? at.back() : at.front())).follower);
        reach_end(last, signals.follower);
        if (!full_turn()) (last ? signals.last_input : signals.first_input) = signals.follower.at;
        return signals;
    }
    /// Goes to an end of the motion from its last sample.
    void reach_end(bool last, Follower<Digits50>& follower) const {
        const Digits50 end = last ? motion_.to : motion_.from;
        if ((follower.at == end || follower.step(end)) && goes_on(last, follower)) return;
        creep(last, follower, little * follower.unit() + abs(end - follower.at));
    }
    static bool goes_on(bool last, Follower<Digits50> beyond) {
        return beyond.step(beyond.at + (last ? 1 : -1) * little * beyond.unit());
    }
    /// Goes as far as there are poses, by steps that are halved.
    static void creep(bool last, Follower<Digits50>& follower, const Digits50& far) {
        for (Digits50 step = far + little * follower.unit(); step > 1e-42 * follower.unit(); step /= 2)
            follower.step(follower.at + (last ? 1 : -1) * step);
    }
    /// From some input in both senses to the ends of the motion, as far as doubles come.
    void follow() {
        linkage::Driven<double> moving = driven(model, rounded_, motion_.assembly);
        Follower<double> follower(model, numbers_of(model, std::span<const double>(rounded_)));
        constexpr double golden = 0.38196601125010515, least = 1e-9;
        std::optional<LoopPose<double>> start;
        double input = 0;
        for (int i = 1; i <= 64 && !start; ++i) {
            input = motion_.from + (motion_.to - motion_.from) * std::fmod(i * golden, 1.0);
            start = pose_of_dyads(moving, model.input_of(input));
        }
        if (!start || !follower.start(input, *start)) return;
        const LoopPose<double> here = follower.pose;
        const auto keep = [&](const Follower<double>& f) {
            at.push_back(f.at);
            poses.push_back(f.pose);
        };
        follower.follow(motion_.from, least, keep);
        std::reverse(at.begin(), at.end());
        std::reverse(poses.begin(), poses.end());
        follower.start(input, here);
        keep(follower);
        follower.follow(motion_.to, least, keep);
    }

    Motion motion_;
    std::vector<Digits50> dimensions_;
    std::vector<double> rounded_;
    /// Once they have been asked for.
    mutable std::array<std::optional<SignalsAgain<Digits50>>, 2> ends_{};
    mutable std::array<std::optional<Digits50>, 2> exact_ends_{};
    mutable std::optional<Follower<double>> follower_{};
    mutable std::optional<SeriesSignals> series_{};
};

}  // namespace mechwright

#pragma once
/// \file
/// Signals of a linkage as power series of its input: a pose developed by the equations of its joints, each power from
/// those before it (Newton's method on series; Griewank and Walther, Evaluating Derivatives, section 13.4). In doubles:
/// what verification looks at before it measures in fifty digits by differences.

#include <cstddef>
#include <numbers>
#include <span>
#include <utility>
#include <vector>

#include "analysis/numbers/series.h"
#include "synthesis/mechanism/linkage/again/pose_signals.h"

namespace mechwright {

using InputSeries = Series<double, powers_of_input>;

/// A linkage of some dimensions near one of its poses.
class SeriesSignals {
public:
    /// `start_turns`: those of all links at the start of motion.
    SeriesSignals(const LinkageModel& model, std::span<const double> dimensions, std::vector<double> start_turns)
        : model_(model),
          laws_(laws_in<double>(model.drives)),
          inputs_(laws_.size()),
          plain_(model.structure, numbers_of(model, dimensions)),
          loop_(model.structure, numbers_of(model, dimensions)),
          standing_(model, std::span<const InputSeries>(series(dimensions)), std::move(start_turns)) {
        if (model.drives.front().speed) rate_ = *model.drives.front().speed * std::numbers::pi / 30;
    }

    /// Develops the pose of an input. Drives follow by the pieces of their motions in which an input `within` lies (its
    /// own where that is not a number). False where the equations are singular there.
    bool develop(double input, const LoopPose<double>& at, double within) {
        pose_ = pose_as<InputSeries>(at);
        linkage::set_inputs<InputSeries>(laws_, InputSeries::variable(input), inputs_, within);
        if (!plain_.factor(at, factors_, 0)) return false;
        step_.resize(factors_.size());
        for (std::size_t power = 1; power <= powers_of_input; ++power) {
            const std::vector<InputSeries> missed =
                loop_.residuals(inputs_, DirectedPose<InputSeries>(std::as_const(pose_)));
            for (std::size_t i = 0; i < step_.size(); ++i)
                step_[i] = missed[i].c[power];
            factors_.solve(step_);
            for (std::size_t link = 1; link < pose_.turns.size(); ++link) {
                pose_.origins[link].x.c[power] -= step_[3 * link - 3];
                pose_.origins[link].y.c[power] -= step_[3 * link - 2];
                pose_.turns[link].c[power] -= step_[3 * link - 1] / plain_.size();
            }
        }
        return true;
    }

    /// What follows from where the links are.
    PoseSignals<InputSeries> in_pose() const { return {model_, loop_, standing_, pose_}; }

    /// A signal, or its derivative of some order by the time, in which the input grows by its speed.
    InputSeries by_time(const linkage::Signal& signal, int order) const {
        InputSeries f = value(signal);
        for (int i = 0; i < order; ++i)
            f = rate_ * slope_of(f);
        return f;
    }
    /// The derivative of some order of a pin's place by the time.
    Vector<InputSeries> pin_by_time(std::size_t pin, int order) const {
        Vector<InputSeries> at = in_pose().in_drawing(pin);
        for (int i = 0; i < order; ++i)
            at = {rate_ * slope_of(at.x), rate_ * slope_of(at.y)};
        return at;
    }

    /// The vector whose size a signal is (linkage::is_size); of a curvature the velocity.
    Vector<InputSeries> vector(const linkage::Signal& s) const {
        using Kind = linkage::Signal::Kind;
        if (s.kind == Kind::distance) return in_pose().apart(s);
        return pin_by_time(s.of, s.kind == Kind::acceleration ? 2 : 1);
    }

private:
    template <class Numbers>
    static std::vector<InputSeries> series(const Numbers& numbers) {
        return {numbers.begin(), numbers.end()};
    }
    InputSeries value(const linkage::Signal& s) const {
        using Kind = linkage::Signal::Kind;
        if (s.kind == Kind::ratio) return value(model_.signals[s.of]) / value(model_.signals[s.to]);
        if (s.kind == Kind::sum) {
            InputSeries sum(0);
            for (const linkage::Signal::Term& term : s.terms)
                sum += term.factor * value(model_.signals[term.signal]);
            return sum;
        }
        if (s.kind != Kind::speed && s.kind != Kind::acceleration && s.kind != Kind::curvature)
            return in_pose().value(s);
        const Vector<InputSeries> by = vector(s);
        if (s.kind == Kind::curvature) return rate_ * curvature_again(by);
        return hypotenuse(by.x, by.y);
    }

    const LinkageModel& model_;
    std::vector<linkage::DriveLaw> laws_;
    std::vector<InputSeries> inputs_;
    Loop<double> plain_;
    Loop<InputSeries> loop_;
    Standing<InputSeries> standing_;
    LoopPose<InputSeries> pose_{};
    linkage::Factors factors_{};
    std::vector<double> step_{};
    double rate_ = 1;  ///< of the input, by time
};

}  // namespace mechwright

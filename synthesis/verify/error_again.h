#pragma once
/// \file
/// The error of a generated function, or the distance of a guided point from a line or an arc, over the input range:
/// in fifty digits, with its sign, by the measurements of verification; and where it is extreme, by sampling and golden
/// section, not by the zeros of a slope that designs are made with.

#include <memory>
#include <span>
#include <vector>

#include "synthesis/problem/input_tasks.h"
#include "synthesis/target/function/function_target.h"
#include "synthesis/verify/rebuilt.h"

namespace mechwright {

/// Where the error is extreme: an end of the range, a sample, or between.
struct ExtremeAgain {
    double share;  ///< of the input range
    Digits50 error;
};

struct ErrorAgain {
    /// Of one of the targets of the claim (`input_tasks`).
    ErrorAgain(const Rebuilt& design, const InputTask& task);

    /// Radians or lengths; NaN where the mechanism does not assemble. `dimensions` are those of the design, or close.
    Digits50 at(double share, std::span<const Digits50> dimensions) const;
    Digits50 at(double share) const { return at(share, design_->dimensions); }

    /// The part of the output's range that is asked for at a share of the input's; 0 of a line or an arc.
    double part(double share) const;

    /// In order along the range; of samples all of them. An angle that passes half a turn, from where it goes on as
    /// minus half a turn, is extreme just before; unless the mechanism counts on from the start of the range, as
    /// linkages do.
    std::vector<ExtremeAgain> extremes() const;

    /// An error and whole turns, where it is an angle: next to another error.
    Digits50 counted_on(const Digits50& error, const Digits50& other) const;

private:
    Digits50 of_function(double share, std::vector<Digits50> dimensions) const;
    Digits50 of_shape(double share, std::span<const Digits50> dimensions) const;
    /// Of what is asked at one sample, over a motion. `dimensions` have the scales that it is a share of.
    Digits50 of_sample(const FunctionTarget& sample, Motion motion, std::vector<Digits50> dimensions) const;
    /// Whether an angle is counted on beyond half a turn.
    bool goes_on() const;
    std::vector<ExtremeAgain> at_samples() const;
    double place_before_jump(double before, double after) const;

    const Rebuilt* design_;
    InputTask task_;
    const FunctionTarget* function_;  ///< null for a line or an arc
    std::shared_ptr<ExpressionValues> y_;
    double y_from_ = 0, height_ = 1;
    Digits50 shift_ = 0;  ///< of the output asked for, to tell signs
};

/// The places among extremes whose errors are as great as the greatest, to a millionth and to `equal_within`.
std::vector<ExtremeAgain> greatest_of(const std::vector<ExtremeAgain>& all, const Digits50& equal_within);

}  // namespace mechwright

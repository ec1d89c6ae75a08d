#pragma once
/// \file
/// Real numbers enclosed in balls: a middle of fifty digits and a radius that is never too small. Whatever numbers the
/// operands enclose, the result of an operation encloses that of the numbers.

#include <cmath>

#include "synthesis/mechanism/mechanism.h"

namespace mechwright::homotopy {

class Ball {
public:
    Ball() = default;
    explicit Ball(double value) : middle_(value) {}
    Ball(const Digits50& middle, double radius) : middle_(middle), radius_(radius) {}

    const Digits50& middle() const { return middle_; }
    double radius() const { return radius_; }
    /// The greatest absolute value in the ball, rounded up.
    double magnitude() const { return up(size_of(middle_) + radius_); }

    friend Ball operator+(const Ball& a, const Ball& b) {
        return rounded(a.middle_ + b.middle_, a.radius_ + b.radius_);
    }
    friend Ball operator-(const Ball& a, const Ball& b) {
        return rounded(a.middle_ - b.middle_, a.radius_ + b.radius_);
    }
    friend Ball operator-(const Ball& a) { return {-a.middle_, a.radius_}; }
    friend Ball operator*(const Ball& a, const Ball& b) {
        const double spread = size_of(a.middle_) * b.radius_ + size_of(b.middle_) * a.radius_ + a.radius_ * b.radius_;
        return rounded(a.middle_ * b.middle_, spread);
    }

private:
    /// A few roundings of double away from zero, and never zero for what is not; NaN stays.
    static double up(double value) { return value == 0 ? 0 : value * (1 + 1e-14) + 1e-300; }
    static double size_of(const Digits50& value) { return up(std::abs(value.convert_to<double>())); }
    /// Fifty digits round by less than this part.
    static Ball rounded(const Digits50& middle, double radius) {
        constexpr double unit = 1e-49;
        return {middle, up(radius + unit * size_of(middle))};
    }

    Digits50 middle_ = 0;
    double radius_ = 0;
};

}  // namespace mechwright::homotopy

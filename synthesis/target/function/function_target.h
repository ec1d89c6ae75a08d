#pragma once
/// \file
/// A function that a mechanism is to generate: its output follows y(x) while its input goes evenly through the range of
/// x. Both scales run from 0 at the start of the range to 1 at its end:
///
///     input = input-start + input-range share,  share = (x - from) / (to - from),
///     output = output-start + output-range part(share),  part = (y(x) - y(from)) / (y(to) - y(from)).

#include <memory>
#include <span>
#include <string>
#include <vector>

#include "analysis/geometry/vector.h"
#include "analysis/numbers/chebyshev.h"

namespace mechwright {

struct FunctionTarget {
    std::string expression;               ///< y of x; empty where samples are given
    std::vector<Vector<double>> samples;  ///< (x, y), x increasing; empty where an expression is given
    double from = 0;                      ///< of x
    double to = 1;
    std::vector<double> accuracy_points;  ///< of x, which an exact method meets; of samples it meets all

    // What follows from it, set by `complete`.
    std::vector<double> series;         ///< of an expression: part over 2 share - 1, in Chebyshev polynomials
    std::vector<Vector<double>> parts;  ///< of samples: (share, part)
};

/// A place of the range where the error is extreme: its ends, and where its slope vanishes.
struct ErrorExtreme {
    double share;
    double part;  ///< of samples; an expression has its own
    double error;
    bool stationary;
};

/// Why an expression cannot be read, or nothing.
std::string why_not_understood(const std::string& expression);

/// Sets what follows. Returns why the function cannot be generated, or nothing.
std::string complete(FunctionTarget& target);

/// The accuracy points as a function of samples: their shares and parts.
FunctionTarget at_accuracy_points(const FunctionTarget& target);

/// y of x by the expression itself, in double; for verification, which does not use the series.
struct ExpressionValues {
    explicit ExpressionValues(const std::string& expression);
    ~ExpressionValues();
    /// NaN where it is not defined.
    double operator()(double x);

private:
    struct Parser;
    std::unique_ptr<Parser> parser_;
};

/// The part of the output's way at a share of the input's, for an expression.
template <class T>
T part_at(const FunctionTarget& target, const T& share) {
    return chebyshev_value(std::span<const double>(target.series), T(T(2.0) * share - T(1.0)));
}

}  // namespace mechwright

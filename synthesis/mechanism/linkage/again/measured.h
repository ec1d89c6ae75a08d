#pragma once
/// \file
/// What verification measures of a linkage: one function of the input, along the motion as it is sampled (scan.h), its
/// extremes and its means.

#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <vector>

#include "synthesis/mechanism/linkage/again/scan.h"

namespace mechwright::again {

inline constexpr double missing = std::numeric_limits<double>::quiet_NaN();

/// One function of the input, looked at in doubles and measured in fifty digits.
struct Measured {
    const Scan& scan;
    std::function<double(SignalsAgain<double>&, double)> look;
    /// Its derivative of some order by the input; -1: its integral, where it is a derivative itself.
    std::function<Digits50(SignalsAgain<Digits50>&, int, const Digits50&)> measure;
    static constexpr double rounding_of_input = 1e-12;
    /// Inputs between which drives are on one piece of their motions each: differences look no farther.
    Vector<double> piece{-std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};

    /// The same on one piece.
    Measured on(const Vector<double>& part) const {
        Measured made = *this;
        made.piece = part;
        return made;
    }
    bool is_on_piece() const { return std::isfinite(piece.x); }
    double seen(double input, bool finely = false) const {
        SignalsAgain<double> signals = scan.plain(scan.nearest(input));
        keep_on_piece(signals);
        signals.finely = finely || is_on_piece();
        return look(signals, input);
    }
    SignalsAgain<Digits50> precise(double input) const {
        SignalsAgain<Digits50> signals = scan.precise(scan.nearest(input));
        keep_on_piece(signals);
        return signals;
    }
    Digits50 at(double input, int order = 0) const {
        // What is at an end of the piece but for rounding is looked at from inside.
        for (const double end : {piece.x, piece.y})
            if (std::abs(input - end) < rounding_of_input) input = end;
        if (input == scan.from() || input == scan.to()) {
            SignalsAgain<Digits50> end = scan.at_end(input == scan.to());
            keep_on_piece(end);
            return measure(end, order, end.follower.at);
        }
        SignalsAgain<Digits50> signals = precise(input);
        return measure(signals, order, input);
    }
    /// Between the exact ends of the motion, so close to one of them as it may be.
    Digits50 between(const std::array<Digits50, 2>& ends, const Digits50& input) const {
        SignalsAgain<Digits50> signals = scan.precise(scan.nearest(input.convert_to<double>()));
        if (!scan.full_turn()) {
            signals.first_input = ends[0];
            signals.last_input = ends[1];
        }
        keep_on_piece(signals);
        return measure(signals, 0, input);
    }

private:
    template <class T>
    void keep_on_piece(SignalsAgain<T>& signals) const {
        if (T(piece.x) > signals.first_input) signals.first_input = T(piece.x);
        if (T(piece.y) < signals.last_input) signals.last_input = T(piece.y);
    }
};

/// Parts of the motion as those between the breaks of drives' motions.
std::vector<Vector<double>> between_breaks(const Scan& scan, const std::vector<Vector<double>>& parts);
/// What is measured on each of the pieces of these parts; where no part has several, as it is.
std::vector<Measured> on_each(const Measured& f, const std::vector<Vector<double>>& parts,
                              const std::vector<Vector<double>>& pieces);

/// An extreme and its input; not a number where nothing was found.
struct Extreme {
    Digits50 at = 0;
    Digits50 value = missing;
};

/// The greatest value over parts of the motion, of f or, with a negative sign, of its negative.
Extreme extreme(const Measured& f, const std::vector<Vector<double>>& parts, double sign);

/// Something that a pose has, along the motion.
template <class OfPose>
Measured of_poses(const Scan& scan, const OfPose& of_pose) {
    const auto at = [of_pose]<class T>(SignalsAgain<T>& s, const T& x) {
        T value(missing);
        s.at_pose(x, [&](const LoopPose<T>& pose) { value = of_pose(s, pose); });
        return value;
    };
    return {scan, [at](SignalsAgain<double>& s, double x) { return at(s, x); },
            [at](SignalsAgain<Digits50>& s, int order, const Digits50& x) -> Digits50 {
                const Digits50 h = s.difference_step();
                if (order == 0) return at(s, x);
                const Digits50 before = at(s, Digits50(x - h)), after = at(s, Digits50(x + h));
                if (order == 1) return (after - before) / (2 * h);
                return (after - 2 * at(s, x) + before) / (h * h);
            }};
}

/// The least over the motion of something that a pose has.
template <class OfPose>
Digits50 least_of_poses(const Scan& scan, const OfPose& of_pose) {
    return extreme(of_poses(scan, of_pose), {{scan.from(), scan.to()}}, -1).value;
}

/// The mean over parts of the motion of a power of it, 1 or 2. Not a number where its integral does not settle.
Digits50 mean_power(const Measured& f, const std::vector<Vector<double>>& parts, int power);

/// The mean of a derivative: what its integral grows by, over the way.
Digits50 mean_of_derivative(const Measured& f, const std::vector<Vector<double>>& parts);

}  // namespace mechwright::again

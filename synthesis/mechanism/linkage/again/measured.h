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
    /// It is a series of the input.
    std::function<InputSeries(const SeriesSignals&)> look;
    /// Its derivative of some order by the input; -1: its integral, where it is a derivative itself.
    std::function<Digits50(SignalsAgain<Digits50>&, int, const Digits50&)> measure;
    /// Signals that are sizes of vectors by which it goes: where one vanishes it has a corner.
    std::vector<std::size_t> sizes{};
    /// Inputs between which it is analytic, where the motion has such pieces: differences look no farther.
    Vector<double> piece{-std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};

    /// The same on one piece.
    Measured on(const Vector<double>& part) const {
        Measured made = *this;
        made.piece = part;
        return made;
    }
    /// Whether an end of a piece may be such a corner, beside which doubles have few digits of derivatives.
    bool may_have_corner_at(double input) const {
        return !sizes.empty() && (scan.full_turn() || (input != scan.from() && input != scan.to()));
    }
    bool is_on_piece() const { return std::isfinite(piece.x); }
    /// As doubles see it; not a number where they see nothing.
    InputSeries seen(double input) const {
        const SeriesSignals* signals = scan.look(input, is_on_piece() ? 0.5 * (piece.x + piece.y) : linkage::by_itself);
        return signals == nullptr ? InputSeries(missing) : look(*signals);
    }
    SignalsAgain<Digits50> precise(double input) const {
        SignalsAgain<Digits50> signals = scan.precise(scan.nearest(input));
        keep_on_piece(signals);
        return signals;
    }
    Digits50 at(double input, int order = 0) const {
        if (input == scan.from() || input == scan.to()) {
            SignalsAgain<Digits50> end = scan.at_end(input == scan.to());
            keep_on_piece(end);
            return measure(end, order, end.follower.at);
        }
        SignalsAgain<Digits50> signals = precise(input);
        return measure(signals, order, input);
    }
    /// Between the exact ends of the motion, so close to one of them as it may be.
    Digits50 between(const std::array<Digits50, 2>& ends, const Digits50& input, int order = 0) const {
        SignalsAgain<Digits50> signals = scan.precise(scan.nearest(input.convert_to<double>()));
        if (!scan.full_turn()) {
            signals.first_input = ends[0];
            signals.last_input = ends[1];
        }
        keep_on_piece(signals);
        return measure(signals, order, input);
    }

private:
    void keep_on_piece(SignalsAgain<Digits50>& signals) const {
        if (!is_on_piece()) return;
        const bool whole = scan.full_turn();
        if (whole || piece.x != scan.from()) {
            signals.first_input = piece.x;
            signals.first_regular = true;
        }
        if (whole || piece.y != scan.to()) {
            signals.last_input = piece.y;
            signals.last_regular = true;
        }
    }
};

/// A derivative of a signal of the model by the time.
Measured measured(const Scan& scan, std::size_t signal, int derivative);
/// A stretch as parts of the motion: one, or two where it runs through the end of a full turn; none where it is not in
/// the motion. All of the motion where none is given.
std::vector<Vector<double>> parts_of(const Scan& scan, const std::optional<std::array<double, 2>>& stretch);

/// Whether what it goes by the sizes of vanishes at an input.
bool has_corner_at(const Measured& f, double input);
/// Parts of the motion as those between the breaks of drives' motions.
std::vector<Vector<double>> between_breaks(const Scan& scan, const std::vector<Vector<double>>& parts);
/// The same, and between the corners of what is measured.
std::vector<Vector<double>> between_corners(const Measured& f, const std::vector<Vector<double>>& parts);
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

/// Every extreme over parts of the motion that follow each other, the ends of these parts among them; of a cycle, which
/// is one part, the end is none.
std::vector<Extreme> every_extreme(const Measured& f, const std::vector<Vector<double>>& parts, bool is_cycle);

/// Something that a pose has, along the motion.
template <class OfPose>
Measured of_poses(const Scan& scan, const OfPose& of_pose) {
    return {
        scan, [of_pose](const SeriesSignals& s) { return of_pose(s.in_pose()); },
        [of_pose](SignalsAgain<Digits50>& s, int order, const Digits50& x) { return s.of_pose(of_pose, order, x); }};
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

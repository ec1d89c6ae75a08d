// Means of what is measured, by adaptive quadrature.

#include <algorithm>
#include <array>
#include <boost/math/quadrature/gauss_kronrod.hpp>
#include <cmath>
#include <numbers>
#include <vector>

#include "synthesis/mechanism/linkage/again/measured.h"

namespace mechwright::again {

namespace {

/// An integral, how far it may be off, and that of the integrand's size.
struct Integral {
    double value = 0, missed = 0, of_sizes = 0;
};

/// By one rule of Gauss and Kronrod. Over [-1, 1], where the library's error is that of the integral.
template <class Term>
Integral by_one_rule(const Term& term, double from, double to) {
    const double middle = (from + to) / 2, half = (to - from) / 2;
    Integral found;
    found.value = boost::math::quadrature::gauss_kronrod<double, 31>::integrate(
        [&](double t) { return half * term(middle + half * t); }, -1.0, 1.0, 0, 0.0, &found.missed, &found.of_sizes);
    return found;
}

/// By halves for so long as it may be off by more than is allowed, and as halves are left.
template <class Term>
Integral bisected(const Term& term, double from, double to, const Integral& whole, double allowed, int halves) {
    if (halves == 0 || !(whole.missed > allowed)) return whole;
    const double middle = (from + to) / 2;
    const Integral one = bisected(term, from, middle, by_one_rule(term, from, middle), allowed / 2, halves - 1),
                   two = bisected(term, middle, to, by_one_rule(term, middle, to), allowed / 2, halves - 1);
    return {one.value + two.value, one.missed + two.missed, one.of_sizes + two.of_sizes};
}

/// A power of what is measured over a part of the motion, as a function of [0, 1]. Ends are approached as the square of
/// the way, so that what has a root there is smooth: the way from them is exact, as rounding of the input itself would
/// be noise.
struct Term {
    const Measured& f;
    Vector<double> part;
    std::array<Digits50, 2> ends;  ///< of the motion
    int power;

    double operator()(double u) const {
        const double way = part.y - part.x, rest = 1 - u, passed = way * u * u * (3 - 2 * u),
                     left = way * rest * rest * (1 + 2 * u);
        // Beside a limit the rounding of doubles is much of the way from it, and what is left of a size beside a
        // corner.
        const double unit = f.scan.model.driven_by_slide() ? way : 1;
        const auto beside = [&](double end) {
            const bool of_motion = !f.scan.full_turn() && (end == f.scan.from() || end == f.scan.to());
            return unit * (of_motion ? 1e-3 : f.is_on_piece() && f.may_have_corner_at(end) ? 0.05 : 0);
        };
        double value;
        if (passed < beside(part.x))
            value =
                f.between(ends, (part.x == f.scan.from() ? ends[0] : Digits50(part.x)) + passed).convert_to<double>();
        else if (left < beside(part.y))
            value = f.between(ends, (part.y == f.scan.to() ? ends[1] : Digits50(part.y)) - left).convert_to<double>();
        else
            value = f.seen(part.x + passed).c[0];
        return (power == 2 ? value * value : value) * 6 * u * rest * way;
    }
};

/// A stretch of such a part.
struct Chunk {
    Term term;
    double first, last, share;  ///< of all that is integrated
    Integral whole{};
};

}  // namespace

Digits50 mean_power(const Measured& f, const std::vector<Vector<double>>& parts, int power) {
    constexpr int deepest = 16;
    constexpr double within = 1e-10, settled = 1e-9;
    const std::array<Digits50, 2> ends{f.scan.exact_end(false), f.scan.exact_end(true)};
    const std::vector<Vector<double>> pieces = between_corners(f, parts);
    const std::vector<Measured> on_pieces = on_each(f, parts, pieces);
    Digits50 length = 0;
    for (const Vector<double>& piece : pieces)
        length += piece.y - piece.x;
    std::vector<Chunk> chunks;
    double size = 0;
    for (std::size_t i = 0; i < pieces.size(); ++i) {
        const double way = pieces[i].y - pieces[i].x;
        const double turns = f.scan.model.driven_by_slide() ? 1 : std::ceil(way / (2 * std::numbers::pi));
        for (double turn = 0; turn < turns; ++turn) {
            Chunk chunk{{on_pieces[i], pieces[i], ends, power},
                        turn / turns,
                        (turn + 1) / turns,
                        way / turns / length.convert_to<double>()};
            chunk.whole = by_one_rule(chunk.term, chunk.first, chunk.last);
            size += chunk.whole.of_sizes;
            chunks.push_back(std::move(chunk));
        }
    }
    // Where a drive dwells there may be nothing but rounding, beside which that of the others is much.
    Integral sum;
    for (const Chunk& chunk : chunks) {
        const double allowed = within * std::max(chunk.whole.of_sizes, chunk.share * size);
        const Integral one = bisected(chunk.term, chunk.first, chunk.last, chunk.whole, allowed, deepest);
        sum = {sum.value + one.value, sum.missed + one.missed, sum.of_sizes + one.of_sizes};
    }
    // Not a number where it does not settle, as what grows beyond all bounds does not.
    return sum.missed <= settled * sum.of_sizes ? Digits50(sum.value) / length : Digits50(missing);
}

namespace {

/// The break of a drive's motion in fifty digits that is this input in doubles; an input that is none as it is.
Digits50 exact_break(const LinkageModel& model, double input) {
    constexpr double rounding = 1e-12;
    const Digits50 turn = 2 * pi<Digits50>(), turns = floor(Digits50(input / turn + rounding));
    for (const linkage::DriveLawIn<Digits50>& law : laws_in<Digits50>(model.drives)) {
        if (!law.motion) continue;
        for (const Digits50& in_turn : linkage::breaks_of(*law.motion))
            if (const Digits50 at = turns * turn + in_turn; abs(at - input) < rounding) return at;
    }
    return input;
}

}  // namespace

Digits50 mean_of_derivative(const Measured& f, const std::vector<Vector<double>>& parts) {
    const std::vector<Vector<double>> pieces = between_breaks(f.scan, parts);
    const std::vector<Measured> on_pieces = on_each(f, parts, pieces);
    Digits50 grown = 0, length = 0;
    for (std::size_t i = 0; i < pieces.size(); ++i) {
        const auto& [from, to] = pieces[i];
        // At the very breaks, and after the very cycle, so that what does not jump grows by nothing.
        const auto integral = [&](double at) {
            const bool whole = f.scan.full_turn();
            if (!whole && (at == f.scan.from() || at == f.scan.to())) return on_pieces[i].at(at, -1);
            const Digits50 exact = whole && at == f.scan.to()
                                       ? Digits50(f.scan.from() + 2 * pi<Digits50>() * f.scan.model.turns)
                                       : exact_break(f.scan.model, at);
            return on_pieces[i].between({f.scan.from(), f.scan.to()}, exact, -1);
        };
        grown += integral(to) - integral(from);
        length += to - from;
    }
    return grown / length;
}

}  // namespace mechwright::again

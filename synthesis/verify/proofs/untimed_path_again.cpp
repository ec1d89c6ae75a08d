#include "synthesis/verify/proofs/untimed_path_again.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <vector>

#include "synthesis/exact/homotopy/complex.h"

namespace mechwright {

namespace {

using Number = homotopy::Complex<Digits50>;

constexpr std::size_t functions = 16, degrees = 6;
// Places over half a turn; over the other half parts are as long.
constexpr std::size_t circle_places = 16384;
/// Of a square that is summed up in doubles, over the terms of its sum; and of the few steps after it.
constexpr double rounding = 1e-14, rounding_of_steps = 1e-13;

/// A part of degree k that goes round f times: Re(d r^k e^(i f theta)).
struct Wave {
    std::size_t degree, frequency;
};
constexpr std::array<Wave, 9> waves{{{1, 1}, {2, 0}, {2, 2}, {3, 1}, {3, 3}, {4, 0}, {4, 2}, {5, 1}, {6, 0}}};

using Values = std::array<Digits50, functions>;
using Factors = std::array<Number, functions>;

/// The functions Re and Im of z^j z'^k, j >= k, at z = p + r e^(i theta).
struct Expansion {
    Values value;                               ///< at p
    std::array<Factors, waves.size()> factors;  ///< the d of each function
};

std::size_t wave_of(std::size_t degree, std::size_t frequency) {
    const auto at = std::find_if(waves.begin(), waves.end(),
                                 [&](const Wave& w) { return w.degree == degree && w.frequency == frequency; });
    return static_cast<std::size_t>(at - waves.begin());
}

Number zero() { return {Digits50(0), Digits50(0)}; }
Number conjugate(const Number& z) { return {z.re, -z.im}; }

/// (p + e)^n by powers of e.
std::array<Number, 4> power_of_sum(const Number& p, std::size_t n) {
    std::array<Number, 4> factors{Number{Digits50(1), Digits50(0)}, zero(), zero(), zero()};
    for (std::size_t i = 0; i < n; ++i)
        for (std::size_t k = 4; k-- > 0;)
            factors[k] = factors[k] * p + (k > 0 ? factors[k - 1] : zero());
    return factors;
}

Expansion expanded(const Number& p) {
    Expansion e;
    for (Factors& factors : e.factors)
        factors.fill(zero());
    std::size_t row = 0;
    for (std::size_t j = 0; j <= 3; ++j)
        for (std::size_t k = 0; k <= j; ++k) {
            const auto of_z = power_of_sum(p, j), of_conjugate = power_of_sum(conjugate(p), k);
            const Number value = of_z[0] * of_conjugate[0];
            e.value[row] = value.re;
            if (j != k) e.value[row + 1] = value.im;
            for (std::size_t a = 0; a <= j; ++a)
                for (std::size_t b = 0; b <= k; ++b) {
                    if (a + b == 0) continue;
                    // Im(c z) is Re(-i c z), and Re(c z') Re(c' z).
                    const Number c = of_z[a] * of_conjugate[b], turned{c.im, -c.re};
                    Factors* const of = &e.factors[wave_of(a + b, a > b ? a - b : b - a)];
                    (*of)[row] = (*of)[row] + (a >= b ? c : conjugate(c));
                    if (j != k) (*of)[row + 1] = (*of)[row + 1] + (a >= b ? turned : conjugate(turned));
                }
            row += j == k ? 1 : 2;
        }
    for (std::size_t w = 0; w < waves.size(); ++w)
        for (Number& d : e.factors[w])
            if (waves[w].frequency == 0) d.im = 0;
    return e;
}

using Triangle = std::array<Values, functions>;

/// Cholesky's lower triangle of sum_i w_i f(p_i) f(p_i)^T; false where that is singular.
bool triangle_of(const std::vector<Expansion>& targets, std::span<const double> witness, Triangle& lower) {
    for (std::size_t i = 0; i < functions; ++i)
        for (std::size_t j = 0; j <= i; ++j) {
            Digits50 sum = 0;
            for (std::size_t t = 0; t < targets.size(); ++t)
                sum += witness[t] * targets[t].value[i] * targets[t].value[j];
            for (std::size_t k = 0; k < j; ++k)
                sum -= lower[i][k] * lower[j][k];
            if (i == j && !(sum > 0)) return false;
            lower[i][j] = i == j ? Digits50(sqrt(sum)) : Digits50(sum / lower[j][j]);
        }
    return true;
}

/// The functions combined so that their weighted squares sum up to c . c.
template <class T>
void combine(const Triangle& lower, std::array<T, functions>& of) {
    for (std::size_t i = 0; i < functions; ++i) {
        for (std::size_t k = 0; k < i; ++k)
            of[i] = of[i] - lower[i][k] * of[k];
        of[i] = Digits50(1 / lower[i][i]) * of[i];
    }
}

/// The square of the length of a part along the circle: the sum of Re(t_s e^(2 i s theta)).
struct SquareAlong {
    std::array<double, 4> cosine{}, sine{};
    double all = 0;

    void add(std::size_t s, const Number& t) {
        cosine[s] += t.re.convert_to<double>();
        sine[s] += t.im.convert_to<double>();
        all += std::abs(t.re.convert_to<double>()) + std::abs(t.im.convert_to<double>());
    }
};

Number product(const Factors& a, const Factors& b, bool conjugated) {
    Number sum = zero();
    for (std::size_t i = 0; i < functions; ++i)
        sum = sum + a[i] * (conjugated ? conjugate(b[i]) : b[i]);
    return sum;
}

std::array<SquareAlong, degrees> squares_along(const Expansion& e) {
    const Digits50 half = Digits50(1) / 2;
    std::array<SquareAlong, degrees> squares;
    for (std::size_t i = 0; i < waves.size(); ++i)
        for (std::size_t j = 0; j < waves.size(); ++j) {
            if (waves[i].degree != waves[j].degree) continue;
            SquareAlong& of = squares[waves[i].degree - 1];
            const std::size_t f = waves[i].frequency, g = waves[j].frequency;
            const Number beside = half * product(e.factors[i], e.factors[j], true);
            of.add((f > g ? f - g : g - f) / 2, f >= g ? beside : conjugate(beside));
            of.add((f + g) / 2, half * product(e.factors[i], e.factors[j], false));
        }
    return squares;
}

/// cos and sin of 2 s theta at all these places.
struct Circle {
    std::array<std::vector<double>, 4> cosine, sine;

    Circle() {
        for (std::size_t s = 0; s < 4; ++s)
            for (std::size_t q = 0; q < circle_places; ++q) {
                const double angle = 2 * std::numbers::pi * static_cast<double>(s * q % circle_places) / circle_places;
                cosine[s].push_back(std::cos(angle));
                sine[s].push_back(std::sin(angle));
            }
    }
};

/// No |f(p + e) - f(p)|^2 with |e| <= r is greater.
double greatest_change(const Expansion& e, double r) {
    static const Circle circle;
    const auto squares = squares_along(e);
    double most = 0;
    for (std::size_t q = 0; q < circle_places; ++q) {
        double sum = 0;
        for (std::size_t k = degrees; k-- > 0;) {
            double square = rounding * squares[k].all;
            for (std::size_t s = 0; s < 4; ++s)
                square += squares[k].cosine[s] * circle.cosine[s][q] - squares[k].sine[s] * circle.sine[s][q];
            sum = (sum + std::sqrt(std::max(square, 0.0))) * r;
        }
        most = std::max(most, sum);
    }
    const double bound = most * (1 + rounding_of_steps) / std::cos(3 * std::numbers::pi / (2 * circle_places));
    return bound * bound;
}

/// The targets in parts of their root mean square distance from their middle, with combined functions.
struct CombinedTargets {
    std::vector<Expansion> targets{};
    Digits50 unit = 0;
};

CombinedTargets combined(const MissedPoints& missed) {
    const std::size_t n = missed.points.size();
    Number middle = zero();
    for (const Vector<double>& p : missed.points)
        middle = middle + Number{Digits50(p.x) / n, Digits50(p.y) / n};
    Digits50 square = 0;
    for (const Vector<double>& p : missed.points)
        square += norm(Number{p.x - middle.re, p.y - middle.im}) / n;
    CombinedTargets all{{}, sqrt(square)};
    if (n < functions || !(all.unit > 0)) return all;
    for (const Vector<double>& p : missed.points)
        all.targets.push_back(expanded({(p.x - middle.re) / all.unit, (p.y - middle.im) / all.unit}));
    Triangle lower;
    if (!triangle_of(all.targets, missed.witness, lower)) return {{}, all.unit};
    for (Expansion& e : all.targets) {
        combine(lower, e.value);
        for (Factors& factors : e.factors)
            combine(lower, factors);
    }
    return all;
}

/// w |f(p)|^2.
Digits50 share_of(const Expansion& e, double weight) {
    Digits50 sum = 0;
    for (const Digits50& value : e.value)
        sum += value * value;
    return weight * sum;
}

}  // namespace

bool no_curve_has_lesser_sum(const MissedPoints& missed, const Digits50& sum) {
    const CombinedTargets all = combined(missed);
    for (std::size_t i = 0; i < all.targets.size(); ++i) {
        const Digits50 share = share_of(all.targets[i], missed.witness[i]);
        const Digits50 radius = sqrt(share * sum / missed.weights[i]) / all.unit;
        const double change = greatest_change(all.targets[i], radius.convert_to<double>());
        if (!(missed.witness[i] * Digits50(change) <= share)) return false;
    }
    return !all.targets.empty();
}

bool no_curve_comes_within(const MissedPoints& missed, const Digits50& distance) {
    const CombinedTargets all = combined(missed);
    const double radius = Digits50(distance / all.unit).convert_to<double>();
    Digits50 sum = 0;
    for (std::size_t i = 0; i < all.targets.size(); ++i)
        sum += std::min<Digits50>(share_of(all.targets[i], missed.witness[i]),
                                  missed.witness[i] * Digits50(greatest_change(all.targets[i], radius)));
    return !all.targets.empty() && sum < 1;
}

}  // namespace mechwright

#include "synthesis/proof/coupler_sextic.h"

#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <numbers>
#include <vector>

namespace mechwright {

namespace {

using Complex = std::complex<double>;

constexpr int functions = 16;
constexpr int degrees = 6;
/// Functions along a circle about a point: the parts of degree k are waves of frequencies k, k - 2, ..., none above 3.
struct Wave {
    int degree, frequency;
    bool sine;
};
constexpr std::array<Wave, 15> waves{{{1, 1, false},
                                      {1, 1, true},
                                      {2, 0, false},
                                      {2, 2, false},
                                      {2, 2, true},
                                      {3, 1, false},
                                      {3, 1, true},
                                      {3, 3, false},
                                      {3, 3, true},
                                      {4, 0, false},
                                      {4, 2, false},
                                      {4, 2, true},
                                      {5, 1, false},
                                      {5, 1, true},
                                      {6, 0, false}}};
constexpr int greatest_frequency(int degree) { return std::min(degree, degrees - degree); }

/// Directions over half a turn in which parts are evaluated; the other half has the same sizes.
constexpr std::size_t directions = 64;
constexpr double between_directions = std::numbers::pi / (2 * directions);
/// Rounding of a function of size 1, with that of the transformation that follows.
constexpr double rounding = 1e-14;
/// What the result is made smaller by, for rounding of the targets and of the last steps, and so that it can be proven
/// again in another way.
constexpr double rounding_of_bound = 1e-6;
/// Weights are made better in so many rounds, by this power of what is uneven, and less later on.
constexpr int rounds = 24;
constexpr double power_of_round = 0.5;
constexpr double power_of_late_round = 0.1;
constexpr int halvings = 14;

using Column = Eigen::Matrix<double, functions, 1>;
using Square = Eigen::Matrix<double, functions, functions>;
using WaveColumns = Eigen::Matrix<double, functions, static_cast<int>(waves.size())>;

/// The functions about a target.
struct Target {
    Column value;
    WaveColumns wave;
    double size;  ///< no function and no wave has a greater value
    double weight;
};

std::size_t column_of(int degree, int frequency, bool sine) {
    const auto at = std::find_if(waves.begin(), waves.end(), [&](const Wave& w) {
        return w.degree == degree && w.frequency == frequency && w.sine == sine;
    });
    return static_cast<std::size_t>(at - waves.begin());
}

/// The two functions of (p + e)^j conj(p + e)^k, of which the second is nothing where j = k.
void expand(Complex p, int j, int k, Eigen::Index row, Target& t) {
    constexpr std::array<std::array<double, 4>, 4> choose{{{1, 0, 0, 0}, {1, 1, 0, 0}, {1, 2, 1, 0}, {1, 3, 3, 1}}};
    std::array<Complex, 4> power{1, p, p * p, p * p * p};
    const auto at = [](int i) { return static_cast<std::size_t>(i); };
    const bool both = j != k;
    for (int a = 0; a <= j; ++a)
        for (int b = 0; b <= k; ++b) {
            const Complex c =
                choose[at(j)][at(a)] * choose[at(k)][at(b)] * power[at(j - a)] * std::conj(power[at(k - b)]);
            if (a + b == 0) {
                t.value[row] = c.real();
                if (both) t.value[row + 1] = c.imag();
                continue;
            }
            const int frequency = std::abs(a - b);
            const auto cosine = static_cast<Eigen::Index>(column_of(a + b, frequency, false));
            t.wave(row, cosine) += c.real();
            if (both) t.wave(row + 1, cosine) += c.imag();
            if (frequency == 0) continue;
            const double side = a > b ? 1 : -1;
            t.wave(row, cosine + 1) -= side * c.imag();
            if (both) t.wave(row + 1, cosine + 1) += side * c.real();
        }
}

Target target_at(Complex p, double weight) {
    Target t{Column::Zero(), WaveColumns::Zero(), std::pow(1 + std::abs(p), degrees), weight};
    Eigen::Index row = 0;
    for (int j = 0; j <= 3; ++j)
        for (int k = 0; k <= j; ++k) {
            expand(p, j, k, row, t);
            row += j == k ? 1 : 2;
        }
    return t;
}

/// How quickly the functions can change about a target: the sizes of their parts of each degree in each direction.
struct Rates {
    std::array<std::array<double, degrees>, directions> of{};

    /// Of |f(p + e) - f(p)| / |e| for |e| <= d.
    double greatest(double d) const {
        double most = 0;
        for (const auto& rate : of) {
            double sum = 0;
            for (int k = degrees; k-- > 0;)
                sum = sum * d + rate[static_cast<std::size_t>(k)];
            most = std::max(most, sum);
        }
        return most;
    }
};

/// cos or sin of a wave in all directions.
std::array<double, directions> in_directions(const Wave& wave) {
    std::array<double, directions> all;
    for (std::size_t q = 0; q < directions; ++q) {
        const double angle = wave.frequency * std::numbers::pi * static_cast<double>(q) / directions;
        all[q] = wave.sine ? std::sin(angle) : std::cos(angle);
    }
    return all;
}

/// Squared sizes of the part of a degree, by direction, from the scalar products of its waves; with their rounding.
std::array<double, directions> squares_of_part(const WaveColumns& columns, int degree) {
    static const std::array<std::array<double, directions>, waves.size()> values = [] {
        std::array<std::array<double, directions>, waves.size()> all;
        std::transform(waves.begin(), waves.end(), all.begin(), in_directions);
        return all;
    }();
    std::array<double, directions> squares{};
    double all = 0;
    for (std::size_t i = 0; i < waves.size(); ++i) {
        if (waves[i].degree != degree) continue;
        const auto column = columns.col(static_cast<Eigen::Index>(i));
        all += column.squaredNorm();
        for (std::size_t j = 0; j <= i; ++j) {
            if (waves[j].degree != degree) continue;
            const double product = column.dot(columns.col(static_cast<Eigen::Index>(j))) * (i == j ? 1 : 2);
            for (std::size_t q = 0; q < directions; ++q)
                squares[q] += product * values[i][q] * values[j][q];
        }
    }
    for (double& square : squares)
        square = std::max(square, 0.0) + rounding * functions * all;
    return squares;
}

/// Between directions the size of a part is no more than at the nearest one and what Bernstein's inequality allows.
Rates rates_of(const WaveColumns& columns, double error) {
    Rates rates;
    for (int degree = 1; degree <= degrees; ++degree) {
        const auto squares = squares_of_part(columns, degree);
        const int frequency = greatest_frequency(degree);
        const double most =
            std::sqrt(*std::max_element(squares.begin(), squares.end())) / std::cos(frequency * between_directions);
        for (std::size_t q = 0; q < directions; ++q)
            rates.of[q][static_cast<std::size_t>(degree - 1)] =
                std::min(most, std::sqrt(squares[q]) + frequency * between_directions * most) + error;
    }
    return rates;
}

/// What weights come to.
struct Weighed {
    double sum = 0;       ///< bound of the weighted sum of squares
    double greatest = 0;  ///< bound of the greatest distance
    Eigen::VectorXd per_square;
};

/// The greatest number in [0, most] up to which `within` holds, to rounding; 0 where it holds nowhere.
template <class Within>
double last_within(double most, const Within& within) {
    double low = 0, high = most;
    for (int i = 0; i < halvings; ++i) {
        const double middle = (low + high) / 2;
        (within(middle) ? low : high) = middle;
    }
    return low;
}

/// A matrix that makes sum_i w_i (c . f(p_i))^2 nearly |c|^2. Whatever rounding has made of it, the functions combined
/// with it are what is measured from then on.
Square combining(const std::vector<Target>& targets, const Eigen::VectorXd& weights) {
    Square combined = Square::Identity();
    for (int pass = 0; pass < 2; ++pass) {  // twice, for the digits
        Square gram = Square::Zero();
        for (std::size_t i = 0; i < targets.size(); ++i) {
            const Column value = combined * targets[i].value;
            gram += weights[static_cast<Eigen::Index>(i)] * value * value.transpose();
        }
        combined = Square(gram.llt().matrixL().solve(combined));
    }
    return combined;
}

Weighed weighed(const std::vector<Target>& targets, const Eigen::VectorXd& weights) {
    const auto n = static_cast<Eigen::Index>(targets.size());
    const Square combined = combining(targets, weights);
    const double size = combined.norm();
    Weighed r{0, 0, Eigen::VectorXd::Zero(n)};
    if (!std::isfinite(size)) return r;

    std::vector<Rates> rates;
    Eigen::VectorXd share(n);
    Square gram = -Square::Identity();
    double error_of_rows = 0;
    for (Eigen::Index i = 0; i < n; ++i) {
        const Target& t = targets[static_cast<std::size_t>(i)];
        const double error = rounding * functions * size * t.size;
        const Column value = combined * t.value;
        rates.push_back(rates_of(combined * t.wave, error));
        gram += weights[i] * value * value.transpose();
        error_of_rows += weights[i] * error * error;
        share[i] = weights[i] * std::pow(value.norm() + error, 2);
    }
    const double all = std::pow(std::sqrt(std::max(0.0, 1 - gram.norm())) - std::sqrt(error_of_rows), 2);
    if (!(gram.norm() < 0.5 && error_of_rows < 0.1)) return r;

    double widest = 0;
    for (Eigen::Index i = 0; i < n; ++i) {
        const Rates& rate = rates[static_cast<std::size_t>(i)];
        const double radius = last_within(std::sqrt(share[i] / weights[i]) / rate.greatest(0), [&](double d) {
            return weights[i] * std::pow(d * rate.greatest(d), 2) <= share[i];
        });
        r.per_square[i] = share[i] / (targets[static_cast<std::size_t>(i)].weight * radius * radius);
        widest = std::max(widest, radius);
    }
    r.sum = all / r.per_square.maxCoeff();
    r.greatest = last_within(widest, [&](double d) {
        double sum = 0;
        for (Eigen::Index i = 0; i < n; ++i)
            sum += std::min(share[i], weights[i] * std::pow(d * rates[static_cast<std::size_t>(i)].greatest(d), 2));
        return sum < all;
    });
    return r;
}

/// The targets from their middle, in parts of their root mean square distance from it.
struct Scaled {
    std::vector<Target> targets;
    double unit = 0;
};

Scaled scaled(std::span<const Vector<double>> points, std::span<const double> weights) {
    const auto n = static_cast<double>(points.size());
    Complex middle = 0;
    for (const Vector<double>& p : points)
        middle += Complex(p.x, p.y) / n;
    double square = 0;
    for (const Vector<double>& p : points)
        square += std::norm(Complex(p.x, p.y) - middle) / n;
    Scaled s{{}, std::sqrt(square)};
    for (std::size_t i = 0; s.unit > 0 && i < points.size(); ++i)
        s.targets.push_back(target_at((Complex(points[i].x, points[i].y) - middle) / s.unit, weights[i]));
    return s;
}

void keep_greater(double bound, const Eigen::VectorXd& weights, double& best, std::vector<double>& of_best) {
    if (!(bound > best)) return;
    best = bound;
    of_best.assign(weights.begin(), weights.end());
}

}  // namespace

DistancesFromCouplerCurves least_distances_from_coupler_curves(std::span<const Vector<double>> points,
                                                               std::span<const double> weights) {
    DistancesFromCouplerCurves best;
    const Scaled s = scaled(points, weights);
    if (s.targets.size() < functions) return best;
    Eigen::VectorXd trial = Eigen::VectorXd::Ones(static_cast<Eigen::Index>(points.size()));
    for (int round = 0; round < rounds; ++round) {
        const Weighed now = weighed(s.targets, trial);
        if (!(now.sum > 0)) break;
        keep_greater(now.sum, trial, best.sum_of_squares, best.weights_of_sum);
        keep_greater(now.greatest, trial, best.greatest, best.weights_of_greatest);
        const double power = round < rounds / 2 ? power_of_round : power_of_late_round;
        trial = trial.array() * (now.per_square.array() / now.per_square.maxCoeff()).pow(-power);
        trial /= trial.maxCoeff();
    }
    best.sum_of_squares *= s.unit * s.unit * (1 - rounding_of_bound);
    best.greatest *= s.unit * (1 - rounding_of_bound);
    return best;
}

}  // namespace mechwright

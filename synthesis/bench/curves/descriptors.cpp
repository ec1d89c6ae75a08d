#include "synthesis/bench/curves/descriptors.h"

#include <cmath>
#include <limits>

#include "analysis/numbers/scalar.h"

namespace mechwright::bench {

namespace {

using Complex = std::complex<double>;

/// Coefficients of e^(iks) of a polygon, for k from -harmonics to harmonics without 0, and its middle by length: the
/// integral of each side by parts, as Kuhl and Giardina have it for x and y.
struct Series {
    std::vector<Complex> forward, backward;
    Complex middle;
};

Series series_of(std::span<const Vector<double>> points, int harmonics) {
    Series s{std::vector<Complex>(static_cast<std::size_t>(harmonics)),
             std::vector<Complex>(static_cast<std::size_t>(harmonics)), 0};
    const auto at = [&](std::size_t i) {
        const Vector<double>& p = points[i % points.size()];
        return Complex(p.x, p.y);
    };
    double length = 0;
    for (std::size_t i = 0; i < points.size(); ++i)
        length += std::abs(at(i + 1) - at(i));
    if (!(length > 0)) return {};
    const double whole = 2 * pi<double>();
    double reached = 0;
    for (std::size_t i = 0; i < points.size(); ++i) {
        const Complex side = at(i + 1) - at(i);
        const double size = std::abs(side);
        if (!(size > 0)) continue;
        s.middle += size / length * 0.5 * (at(i) + at(i + 1));
        const double from = whole * reached / length, to = whole * (reached + size) / length;
        for (int k = 1; k <= harmonics; ++k) {
            // (1 / 2 pi) integral of z e^(-iks), by parts: what is left of a polygon are the jumps of its slope.
            const Complex slope = side / (to - from);
            const double square = whole * k * k;
            const auto n = static_cast<std::size_t>(k - 1);
            s.forward[n] += slope / square * (std::polar(1.0, -k * to) - std::polar(1.0, -k * from));
            s.backward[n] += slope / square * (std::polar(1.0, k * to) - std::polar(1.0, k * from));
        }
        reached += size;
    }
    return s;
}

double power(const Series& s, std::size_t k) { return std::norm(s.forward[k]) + std::norm(s.backward[k]); }

}  // namespace

Descriptors descriptors_of(std::span<const Vector<double>> points, int harmonics) {
    Series s = series_of(points, harmonics);
    if (s.forward.empty()) return {};
    // At the start s0 both parts of the first ellipse point the same way: along its long axis.
    const double start = (std::arg(s.backward[0]) - std::arg(s.forward[0])) / 2;
    for (std::size_t k = 0; k < s.forward.size(); ++k) {
        const double turn = static_cast<double>(k + 1) * start;
        s.forward[k] *= std::polar(1.0, turn);
        s.backward[k] *= std::polar(1.0, -turn);
    }
    const Complex factor = s.forward[0] + s.backward[0];
    if (!(std::abs(factor) > 0)) return {};
    for (std::size_t k = 0; k < s.forward.size(); ++k) {
        s.forward[k] /= factor;
        s.backward[k] /= factor;
    }
    return {std::move(s.forward), std::move(s.backward), s.middle, factor};
}

int harmonics_of(std::span<const Vector<double>> points, int most, double part) {
    const Series s = series_of(points, most);
    double all = 0;
    for (std::size_t k = 0; k < s.forward.size(); ++k)
        all += power(s, k);
    double held = 0;
    for (std::size_t k = 0; k < s.forward.size(); ++k) {
        held += power(s, k);
        if (held >= (1 - part) * all) return static_cast<int>(k + 1);
    }
    return most;
}

Difference difference(const Descriptors& of, const Descriptors& other) {
    Difference least{std::numeric_limits<double>::infinity(), 0, 1};
    if (of.forward.size() != other.forward.size() || of.forward.empty()) return least;
    // The other way round the parts of a pair change places; from the other end of the axis the first pair changes its
    // sign, which its factor takes, and so the pairs with even k do.
    for (const bool reversed : {false, true})
        for (const double end : {1.0, -1.0}) {
            double sum = 0;
            for (std::size_t k = 0; k < of.forward.size(); ++k) {
                const double sign = k % 2 == 0 ? 1 : end;
                const Complex& forward = reversed ? other.backward[k] : other.forward[k];
                const Complex& backward = reversed ? other.forward[k] : other.backward[k];
                sum += std::norm(of.forward[k] - sign * forward) + std::norm(of.backward[k] - sign * backward);
            }
            if (std::sqrt(sum) >= least.distance) continue;
            const Complex factor = end * of.factor / other.factor;
            least = {std::sqrt(sum), of.middle - factor * other.middle, factor};
        }
    return least;
}

}  // namespace mechwright::bench

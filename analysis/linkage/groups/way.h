#pragma once
/// \file
/// The way of a larger group along one branch of its motion: where its links are at so many inputs that they are known
/// nearly at every other. follow_way.h makes it.

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <span>
#include <vector>

namespace mechwright::linkage {

/// An end of a way: a limit is a turning point, at which two branches meet.
struct WayEnd {
    double at = 0;
    bool limit = false;
    std::vector<double> places{};  ///< of a limit: of the group's unknowns
    std::vector<double> along{};   ///< of a limit: how these move there while the input stands
};

class Way {
public:
    std::vector<double> at{};      ///< inputs of the master, rising
    std::vector<double> places{};  ///< of the unknowns at each
    std::vector<double> slopes{};  ///< their derivatives by the input
    WayEnd first{}, last{};
    double period = 0;              ///< after which inputs are the same; 0: never
    bool whole = false;             ///< the way goes on without end
    std::vector<double> advance{};  ///< of a whole way: by how much each unknown grows in a period
    int sign = 1;                   ///< of the group's determinant

    double from() const { return first.at; }
    double to() const { return last.at; }

    /// Whether an input is another one, to rounding, but for whole periods.
    bool is_at(double master, double input) const {
        constexpr double rounding = 1e-12;
        const double apart = period > 0 ? std::remainder(master - input, period) : master - input;
        return std::abs(apart) <= rounding * (1 + std::abs(master));
    }
    /// Whether it goes along all of an interval.
    bool covers(double start, double end) const {
        constexpr double beside = 1e-6;
        if (whole) return true;
        const double shift =
            period > 0 ? period * std::round((0.5 * (start + end) - 0.5 * (from() + to())) / period) : 0;
        const auto room = [&](const WayEnd& side) { return (side.limit ? 1e-11 : beside) * (1 + std::abs(side.at)); };
        return start >= from() + shift - room(first) && end <= to() + shift + room(last);
    }

    struct Near {
        bool found = false;
        double to_limit = std::numeric_limits<double>::infinity();  ///< how far the input is from a limit
    };
    /// Writes places of the unknowns near an input: off by the fourth power of the distance of the knots.
    Near near(double master, std::span<double> out) const {
        const double rounding = 1e-12 * (1 + std::abs(master));
        const std::size_t n = out.size();
        double x = master, turns = 0;
        if (at.empty() || !std::isfinite(master)) return {};
        if (period > 0 && (x < from() - rounding || x > to() + rounding)) {
            turns = whole ? -std::floor((x - from()) / period) : std::ceil((from() - rounding - x) / period);
            x += turns * period;
        }
        if (x < from() - rounding || x > to() + rounding) return {};
        Near result{true};
        for (const WayEnd* end : {&first, &last})
            if (end->limit) result.to_limit = std::min(result.to_limit, std::abs(x - end->at));
        const auto next = static_cast<std::size_t>(std::upper_bound(at.begin(), at.end(), x) - at.begin());
        if (next == 0)
            beside(first, 0, x, out);
        else if (next == at.size())
            beside(last, at.size() - 1, x, out);
        else
            between(next - 1, x, out);
        if (turns != 0 && whole)
            for (std::size_t i = 0; i < n; ++i)
                out[i] -= turns * advance[i];
        return result;
    }

private:
    /// Between the last knot and an end: at a limit places go like the root of the distance.
    void beside(const WayEnd& end, std::size_t knot, double x, std::span<double> out) const {
        const double whole_way = end.at - at[knot];
        const double share = end.limit && whole_way != 0 ? std::sqrt(std::max((end.at - x) / whole_way, 0.0)) : 1;
        for (std::size_t i = 0; i < out.size(); ++i) {
            const double place = places[knot * out.size() + i];
            out[i] = end.limit ? end.places[i] + share * (place - end.places[i]) : place;
        }
    }
    /// The cubic through two knots with their slopes.
    void between(std::size_t knot, double x, std::span<double> out) const {
        const std::size_t n = out.size();
        const double width = at[knot + 1] - at[knot], s = (x - at[knot]) / width, r = 1 - s;
        for (std::size_t i = 0; i < n; ++i) {
            const double a = places[knot * n + i], b = places[(knot + 1) * n + i];
            const double up = width * slopes[knot * n + i], down = width * slopes[(knot + 1) * n + i];
            out[i] = r * r * ((1 + 2 * s) * a + s * up) + s * s * ((1 + 2 * r) * b - r * down);
        }
    }
};

}  // namespace mechwright::linkage

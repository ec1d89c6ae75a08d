#pragma once
/// \file
/// Smooth functions of an interval, sampled in panels until the samples of each say the whole of it: from them follow
/// all zeros, and integrals to rounding. A panel is resolved where the last coefficients of its Chebyshev series vanish
/// against its values (Trefethen, Approximation Theory and Approximation Practice, chapters 3 and 8); what is not is
/// halved, down to kinks. Integrals are those of the series, Fejer's first rule.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <span>
#include <vector>

#include "analysis/numbers/extremes.h"
#include "analysis/numbers/function_reference.h"

namespace mechwright {

/// An interval of x by a share s in [0, 1], in which what goes like the root of the distance from its ends is smooth.
struct Stretch {
    double from = 0;
    double to = 0;
    bool root_at_from = false;
    bool root_at_to = false;

    double length() const { return to - from; }
    double at(double s) const {
        if (root_at_from && root_at_to)
            return s < 0.5 ? from + length() * (s * s * (3 - 2 * s))
                           : to - length() * ((1 - s) * (1 - s) * (1 + 2 * s));
        if (root_at_from) return from + length() * s * s;
        if (root_at_to) return to - length() * (1 - s) * (1 - s);
        return s < 0.5 ? from + length() * s : to - length() * (1 - s);
    }
    /// The share at which x is. That of two roots is the zero of s^2 (3 - 2 s) - p with p the part of the length: a
    /// third of an angle whose half has the sine sqrt(p).
    double share_of(double x) const {
        if (!root_at_from && !root_at_to) return (x - from) / length();
        if (!(x > from)) return 0;
        if (!(x < to)) return 1;
        const double before = (x - from) / length(), after = (to - x) / length();
        if (!root_at_to) return std::sqrt(before);
        if (!root_at_from) return 1 - std::sqrt(after);
        const auto third = [](double part) {
            const double angle = std::asin(std::sqrt(part)) / 3;
            return 2 * std::cos(std::numbers::pi / 6 - angle) * std::sin(angle);
        };
        return before < 0.5 ? third(before) : 1 - third(after);
    }
    /// dx/ds.
    double speed(double s) const {
        return length() * (root_at_from ? root_at_to ? 6 * s * (1 - s) : 2 * s : root_at_to ? 2 * (1 - s) : 1);
    }
    /// Its slope by s.
    double speed_slope(double s) const {
        return length() * (root_at_from ? root_at_to ? 6 - 12 * s : 2 : root_at_to ? -2 : 0);
    }
    /// The shares between which functions are looked at: not the very ends where they are singular.
    double first() const { return root_at_from ? beside_end : 0; }
    double last() const { return root_at_to ? 1 - beside_end : 1; }

    static constexpr double beside_end = 0x1p-20;
};

/// A part of [0, 1] with the values of a function at its nodes, which grow.
struct Panel {
    static constexpr std::size_t nodes = 16;
    double from = 0;
    double to = 0;
    std::array<double, nodes> value{};

    double at(std::size_t node) const { return 0.5 * ((from + to) + (to - from) * abscissas()[node]); }
    /// What the polynomial through values at the nodes leads to at the first end of a panel, or the last.
    template <class T>
    static T at_end(const std::array<T, nodes>& values, bool last) {
        static const std::array<double, nodes> weights = [] {
            std::array<double, nodes> made{};
            double sum = 0;
            for (std::size_t i = 0; i < nodes; ++i)
                sum += made[i] = barycentric(i) / (1 + abscissas()[i]);
            for (double& weight : made)
                weight /= sum;
            return made;
        }();
        T sum(0);
        for (std::size_t i = 0; i < nodes; ++i)
            sum = sum + T(weights[last ? nodes - 1 - i : i]) * values[i];
        return sum;
    }
    /// Of a value in the integral over the panel.
    double weight(std::size_t node) const { return 0.5 * (to - from) * weights()[node]; }

    /// The slope at a node of the polynomial through values at all of them, by the way along the panel.
    template <class T>
    T slope_at(std::size_t node, const std::array<T, nodes>& values) const {
        T sum(0);
        for (std::size_t i = 0; i < nodes; ++i)
            sum = sum + T(differences()[node][i] * 2 / (to - from)) * values[i];
        return sum;
    }

    static const std::array<double, nodes>& abscissas() {
        static const std::array<double, nodes> x = [] {
            std::array<double, nodes> made{};
            for (std::size_t i = 0; i < nodes; ++i)
                made[i] = -std::cos(std::numbers::pi * (2 * static_cast<double>(i) + 1) / (2 * nodes));
            return made;
        }();
        return x;
    }
    /// The weight of a node in the barycentric formula (Berrut and Trefethen, Barycentric Lagrange interpolation, SIAM
    /// Review 46 (2004), 501-517, equation 5.4).
    static double barycentric(std::size_t node) {
        const double root = std::sin((2 * static_cast<double>(node) + 1) * std::numbers::pi / (2 * nodes));
        return node % 2 == 0 ? root : -root;
    }
    /// From values at the nodes in [-1, 1] to slopes there (the same, section 9.3).
    static const std::array<std::array<double, nodes>, nodes>& differences() {
        static const auto d = [] {
            std::array<std::array<double, nodes>, nodes> made{};
            for (std::size_t i = 0; i < nodes; ++i)
                for (std::size_t j = 0; j < nodes; ++j) {
                    if (i == j) continue;
                    made[i][j] = barycentric(j) / barycentric(i) / (abscissas()[i] - abscissas()[j]);
                    made[i][i] -= made[i][j];
                }
            return made;
        }();
        return d;
    }
    /// Of an integral over [-1, 1].
    static const std::array<double, nodes>& weights() {
        static const std::array<double, nodes> w = [] {
            std::array<double, nodes> made{};
            for (std::size_t i = 0; i < nodes; ++i) {
                const double angle = std::numbers::pi * (2 * static_cast<double>(i) + 1) / (2 * nodes);
                double sum = 1;
                for (std::size_t k = 1; k <= nodes / 2 - 1; ++k)
                    sum -= 2 * std::cos(2 * static_cast<double>(k) * angle) / (4 * static_cast<double>(k * k) - 1);
                made[i] = 2 * sum / nodes;
            }
            return made;
        }();
        return w;
    }
};

/// The panels of one function, in order.
class Panels {
public:
    struct Limits {
        std::size_t first = 1;       ///< so many panels to begin with
        double within = 1e-6;        ///< of the greatest value of a panel: what its last coefficients may be
        double noise = 1e-14;        ///< of the greatest value of all: what rounding makes
        double floor = 0;            ///< a value: what rounding makes of a function that is 0
        double narrowest = 1e-9;     ///< where a function has a kink
        double narrowest_first = 0;  ///< of the first panel and of the last: more where rounding of s itself counts
        double narrowest_last = 0;
        std::size_t most = 4096;  ///< panels
        bool everywhere = false;  ///< stop at the first value that is not finite
        bool continuous = false;  ///< the function jumps nowhere: panels that lead to other values where they meet
                                  ///< hide a kink between their last nodes and there
        bool at_ends = false;     ///< it has its values at both ends, too, to which the outer panels lead
    };

    using Function = FunctionReference<double(double)>;
    using Found = FunctionReference<void(double)>;

    /// Of g(s) over [from, to]. Where g is not finite it counts as resolved once its panel is as narrow as a kink's.
    Panels(const Function& g, double from, double to, const Limits& limits) : limits_(limits) {
        std::vector<Panel> open;
        const double step = (to - from) / static_cast<double>(limits.first);
        for (std::size_t i = limits.first; i-- > 0;)
            open.push_back(sampled(g, from + step * static_cast<double>(i),
                                   i + 1 == limits.first ? to : from + step * static_cast<double>(i + 1)));
        while (!open.empty() && !(limits.everywhere && !finite_)) {
            const Panel panel = open.back();
            open.pop_back();
            const auto is_narrow = [&](const Panel& one) {
                const double narrowest = std::max({limits.narrowest, one.from == from ? limits.narrowest_first : 0,
                                                   one.to == to ? limits.narrowest_last : 0});
                return one.to - one.from < narrowest * (to - from) || done_.size() + open.size() + 2 > limits.most;
            };
            const auto halve = [&](const Panel& one) {
                const double middle = 0.5 * (one.from + one.to);
                open.push_back(sampled(g, middle, one.to));
                open.push_back(sampled(g, one.from, middle));
            };
            if (!is_narrow(panel) && !(is_resolved(panel) && leads_to_ends(g, panel, from, to))) {
                halve(panel);
                continue;
            }
            if (!done_.empty() && parts_from(done_.back(), panel)) {
                // Of the two the wider one is halved.
                const Panel before = done_.back();
                if (before.to - before.from > panel.to - panel.from && !is_narrow(before)) {
                    done_.pop_back();
                    open.push_back(panel);
                    halve(before);
                    continue;
                }
                if (!is_narrow(panel)) {
                    halve(panel);
                    continue;
                }
            }
            done_.push_back(panel);
        }
    }

    std::span<const Panel> all() const& { return done_; }

    /// Whether all values that were seen are finite.
    bool finite() const { return finite_; }

    /// The greatest value seen, in size.
    double greatest() const { return greatest_; }

    /// The zeros of g, the function whose panels these are, between the first panel and the last: reported to found(s)
    /// in increasing order.
    void zeros(const Function& g, const Found& found) const { zeros_in(Grid(*this, g), g, found); }

    /// The same where the slope of g is known too: three zeros between neighbouring samples, or spread over two such
    /// intervals, are found as well.
    void zeros(const Function& g, const Function& slope, const Found& found) const {
        const Grid grid(*this, g);
        std::vector<double> single;
        zeros_in(grid, g, [&](double s) { single.push_back(s); });
        if (single.size() > 2 * done_.size()) {  // rounding noise
            for (const double s : single)
                found(s);
            return;
        }
        // Intervals beside a lone zero may hold a pair that no sample tells of.
        std::size_t done = 0;
        const auto between = [&](std::size_t right, double zero) {
            if (right <= done) return;
            const double left_end = grid.at[right - 1], right_end = grid.at[right], width = right_end - left_end;
            std::array<double, 4> look{zero, left_end + 0.25 * width, left_end + 0.5 * width, left_end + 0.75 * width};
            if (zero < left_end)
                look = {left_end + width / 64, left_end + width / 16, left_end + width / 4, left_end + width / 2};
            if (zero > right_end)
                look = {right_end - width / 64, right_end - width / 16, right_end - width / 4, right_end - width / 2};
            zeros_between_turns(g, slope, left_end, right_end, grid.value[right - 1], grid.value[right], look, found);
            done = right;
        };
        const auto empty = [&](std::size_t right) {
            return right > 0 && right < grid.at.size() && std::none_of(single.begin(), single.end(), [&](double s) {
                       return s >= grid.at[right - 1] && s <= grid.at[right];
                   });
        };
        for (std::size_t i = 0; i < single.size(); ++i) {
            const auto right =
                static_cast<std::size_t>(std::upper_bound(grid.at.begin(), grid.at.end(), single[i]) - grid.at.begin());
            const bool alone = right > 0 && right < grid.at.size() && grid.at[right - 1] < single[i] &&
                               (i == 0 || single[i - 1] <= grid.at[right - 1]) &&
                               (i + 1 == single.size() || single[i + 1] >= grid.at[right]);
            if (!alone) {
                found(single[i]);
                continue;
            }
            if (empty(right - 1)) between(right - 1, single[i]);
            between(right, single[i]);
            if (empty(right + 1)) between(right + 1, single[i]);
        }
    }

    /// The integral of the function.
    double integral() const {
        double sum = 0;
        for (const Panel& panel : done_)
            for (std::size_t i = 0; i < Panel::nodes; ++i)
                sum += panel.weight(i) * panel.value[i];
        return sum;
    }

private:
    struct Grid {
        std::vector<double> at, value;

        Grid(const Panels& panels, const Function& g) {
            at.reserve(panels.done_.size() * Panel::nodes + 2);
            value.reserve(at.capacity());
            add(panels.done_.front().from, g(panels.done_.front().from));
            for (const Panel& panel : panels.done_)
                for (std::size_t i = 0; i < Panel::nodes; ++i)
                    add(panel.at(i), panel.value[i]);
            add(panels.done_.back().to, g(panels.done_.back().to));
        }
        void add(double s, double v) {
            at.push_back(s);
            value.push_back(v);
        }
    };

    static void zeros_in(const Grid& grid, const Function& g, const Found& found) {
        std::size_t next = 0;
        // Points of the grid are asked for in order, each once.
        zeros_on_grid([&](double s) { return next < grid.at.size() && s == grid.at[next] ? grid.value[next++] : g(s); },
                      std::span<const double>(grid.at), found);
    }

    /// The zeros of g between two samples, as its slope parts them: that may vanish once there, or twice, then next to
    /// one of the places in `look`.
    static void zeros_between_turns(const Function& g, const Function& slope, double left, double right, double g_left,
                                    double g_right, const std::array<double, 4>& look, const Found& found) {
        std::array<double, 4> at{left};
        std::size_t count = 1;
        const auto turns = [&](double s) {
            if (count < 3) at[count++] = s;
        };
        const double at_left = slope(left), at_right = slope(right);
        const auto below = [&](double a, double b) { return at_left > 0 ? a < b : a > b; };
        if ((at_left > 0) != (at_right > 0)) {
            turns(zero_between<double>(slope, left, right, at_left, at_right));
        } else {
            double lowest = look[0], at_lowest = slope(lowest);
            for (std::size_t i = 1; i < look.size(); ++i)
                if (const double here = slope(look[i]); below(here, at_lowest)) {
                    lowest = look[i];
                    at_lowest = here;
                }
            if ((at_lowest > 0) != (at_left > 0)) {
                turns(zero_between<double>(slope, left, lowest, at_left, at_lowest));
                turns(zero_between<double>(slope, lowest, right, at_lowest, at_right));
            } else if (below(at_lowest, at_left) && below(at_lowest, at_right)) {
                zeros_in_dip(slope, left, lowest, right, at_left, at_lowest, at_right, turns);
            }
        }
        at[count++] = right;
        double last = g_left;
        for (std::size_t i = 1; i < count; ++i) {
            const double here = i + 1 == count ? g_right : g(at[i]);
            if (here != 0 && (here > 0) != (last > 0)) found(zero_between<double>(g, at[i - 1], at[i], last, here));
            if (here != 0) last = here;
        }
    }

    Panel sampled(const Function& g, double from, double to) {
        Panel panel{from, to};
        for (std::size_t i = 0; i < Panel::nodes; ++i) {
            panel.value[i] = g(panel.at(i));
            finite_ = finite_ && std::isfinite(panel.value[i]);
            if (std::isfinite(panel.value[i])) greatest_ = std::max(greatest_, std::abs(panel.value[i]));
        }
        return panel;
    }

    /// Whether two neighbours lead to different values where they meet.
    bool parts_from(const Panel& before, const Panel& after) const {
        return limits_.continuous && differ(Panel::at_end(before.value, true), Panel::at_end(after.value, false));
    }
    bool leads_to_ends(const Function& g, const Panel& panel, double from, double to) const {
        return !limits_.at_ends || (!(panel.from == from && differ(Panel::at_end(panel.value, false), g(from))) &&
                                    !(panel.to == to && differ(Panel::at_end(panel.value, true), g(to))));
    }
    /// By so much that the integral over what is beyond the last node, 1/400 of a panel, is more than a resolved panel
    /// leaves open.
    bool differ(double one, double other) const {
        constexpr double at_end = 400;
        return std::abs(one - other) > at_end * ((limits_.within + limits_.noise) * greatest_ + limits_.floor);
    }

    bool is_resolved(const Panel& panel) const {
        constexpr std::size_t n = Panel::nodes, last = 3;
        // cos(k angle of node i): the last coefficients alone are needed.
        static const std::array<std::array<double, n>, last> cosine = [] {
            std::array<std::array<double, n>, last> made{};
            for (std::size_t k = 0; k < last; ++k)
                for (std::size_t i = 0; i < n; ++i)
                    made[k][i] = std::cos(static_cast<double>(n - 1 - k) * std::numbers::pi *
                                          (2 * static_cast<double>(i) + 1) / (2 * n));
            return made;
        }();
        double size = 0, tail = 0;
        for (const double value : panel.value) {
            if (!std::isfinite(value)) return false;
            size = std::max(size, std::abs(value));
        }
        for (std::size_t k = 0; k < last; ++k) {
            double sum = 0;
            for (std::size_t i = 0; i < n; ++i)
                sum += panel.value[i] * cosine[k][i];
            tail = std::max(tail, std::abs(sum) * 2 / n);
        }
        return tail <= limits_.within * size + limits_.noise * greatest_ + limits_.floor;
    }

    Limits limits_;
    double greatest_ = 0;
    bool finite_ = true;
    std::vector<Panel> done_;
};

}  // namespace mechwright

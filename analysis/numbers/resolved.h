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
    /// dx/ds.
    double speed(double s) const {
        return length() * (root_at_from ? root_at_to ? 6 * s * (1 - s) : 2 * s : root_at_to ? 2 * (1 - s) : 1);
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
    /// Of a value in the integral over the panel.
    double weight(std::size_t node) const { return 0.5 * (to - from) * weights()[node]; }

    static const std::array<double, nodes>& abscissas() {
        static const std::array<double, nodes> x = [] {
            std::array<double, nodes> made{};
            for (std::size_t i = 0; i < nodes; ++i)
                made[i] = -std::cos(std::numbers::pi * (2 * static_cast<double>(i) + 1) / (2 * nodes));
            return made;
        }();
        return x;
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
        std::size_t first = 1;    ///< so many panels to begin with
        double within = 1e-6;     ///< of the greatest value of a panel: what its last coefficients may be
        double noise = 1e-14;     ///< of the greatest value of all: what rounding makes
        double narrowest = 1e-9;  ///< where a function has a kink
        std::size_t most = 4096;  ///< panels
    };

    /// Of g(s) over [from, to]. Where g is not finite it counts as resolved once its panel is as narrow as a kink's.
    template <class Function>
    Panels(const Function& g, double from, double to, const Limits& limits) : limits_(limits) {
        std::vector<Panel> open;
        const double step = (to - from) / static_cast<double>(limits.first);
        for (std::size_t i = limits.first; i-- > 0;)
            open.push_back(sampled(g, from + step * static_cast<double>(i),
                                   i + 1 == limits.first ? to : from + step * static_cast<double>(i + 1)));
        while (!open.empty()) {
            const Panel panel = open.back();
            open.pop_back();
            const double middle = 0.5 * (panel.from + panel.to);
            if (is_resolved(panel) || panel.to - panel.from < limits.narrowest * (to - from) ||
                done_.size() + open.size() + 2 > limits.most) {
                done_.push_back(panel);
            } else {
                open.push_back(sampled(g, middle, panel.to));
                open.push_back(sampled(g, panel.from, middle));
            }
        }
    }

    std::span<const Panel> all() const& { return done_; }

    /// The zeros of g, the function whose panels these are, between the first panel and the last: reported to found(s)
    /// in increasing order.
    template <class Function, class Found>
    void zeros(const Function& g, const Found& found) const {
        std::vector<double> grid, values;
        grid.reserve(done_.size() * Panel::nodes + 2);
        values.reserve(grid.capacity());
        const auto add = [&](double s, double value) {
            grid.push_back(s);
            values.push_back(value);
        };
        add(done_.front().from, g(done_.front().from));
        for (const Panel& panel : done_)
            for (std::size_t i = 0; i < Panel::nodes; ++i)
                add(panel.at(i), panel.value[i]);
        add(done_.back().to, g(done_.back().to));
        std::size_t next = 0;
        // Points of the grid are asked for in order, each once.
        zeros_on_grid([&](double s) { return next < grid.size() && s == grid[next] ? values[next++] : g(s); },
                      std::span<const double>(grid), found);
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
    template <class Function>
    Panel sampled(const Function& g, double from, double to) {
        Panel panel{from, to};
        for (std::size_t i = 0; i < Panel::nodes; ++i) {
            panel.value[i] = g(panel.at(i));
            if (std::isfinite(panel.value[i])) greatest_ = std::max(greatest_, std::abs(panel.value[i]));
        }
        return panel;
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
        return tail <= limits_.within * size + limits_.noise * greatest_;
    }

    Limits limits_;
    double greatest_ = 0;
    std::vector<Panel> done_;
};

}  // namespace mechwright

#include "synthesis/mechanism/linkage/again/swept_again.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <utility>
#include <vector>

#include "analysis/numbers/extremes.h"
#include "analysis/numbers/resolved.h"
#include "synthesis/mechanism/linkage/again/measured.h"

namespace mechwright::again {

namespace {

using Interval = std::pair<double, double>;

/// The line over a short part of the motion, over which its ends rise or fall: from `low` to `high` about its input. x
/// is along slices, y across.
struct SweptCell {
    double low = 0, high = 0;
    Vector<InputSeries> first, second;
    double bottom = 0, top = 0;  ///< of both ends
};

double value(const InputSeries& f, double by) {
    double sum = 0;
    for (std::size_t k = powers_of_input + 1; k-- > 0;)
        sum = sum * by + f.c[k];
    return sum;
}

/// Where a function does so, if it changes its sign between two places.
template <class Function>
std::optional<double> root_between(double low, double high, const Function& f) {
    const double at_low = f(low), at_high = f(high);
    if ((at_low > 0) == (at_high > 0)) return {};
    return zero_between<double>(f, low, high, at_low, at_high);
}

class SweptSlices {
public:
    SweptSlices(const Scan& scan, const LinkageRoom& room, std::span<const Vector<double>> screen) : scan_(scan) {
        for (const Vector<double>& corner : screen)
            screen_.push_back(in_slices(corner));
        for (const Vector<double>& corner : screen_)
            heights_.push_back(corner.y);
        add_cells(room);
    }

    double area() {
        if (!possible_ || cells_.empty()) return missing;
        std::sort(heights_.begin(), heights_.end());
        double sum = 0;
        const double size = heights_.back() - heights_.front();
        for (std::size_t i = 0; i + 1 < heights_.size(); ++i)
            if (heights_[i + 1] - heights_[i] > 1e-14 * size) sum += integral_between(heights_[i], heights_[i + 1]);
        return sum;
    }

private:
    /// Slices grow like roots from where an end of the line turns back; elsewhere they may have corners.
    double integral_between(double from, double to) const {
        const Stretch stretch{from, to, true, true};
        const auto f = [&](double s) { return covered_at(stretch.at(s)) * stretch.speed(s); };
        const double size = heights_.back() - heights_.front();
        const Panels panels(f, 0, 1,
                            {.within = 1e-11,
                             .noise = 1e-12,
                             .floor = 1e-13 * size * size,
                             .narrowest = 1e-9,
                             .everywhere = true,
                             .continuous = true,
                             .at_ends = true});
        return panels.finite() ? panels.integral() : missing;
    }
    /// Slices lie in a direction that nothing in a drawing is likely to have.
    static Vector<double> in_slices(const Vector<double>& at) { return turned(at, across()); }
    static Vector<double> across() { return {std::cos(0.7321), std::sin(0.7321)}; }

    static constexpr double closest = 1e-9;  ///< to an end, of the whole way

    std::vector<double> inputs() const {
        constexpr int even = 720;
        constexpr double closer = 0.9, widest = 0.05;
        const double way = scan_.to() - scan_.from();
        const int count = even * std::max(1, scan_.model.turns);
        std::vector<double> all;
        for (int i = 0; i <= count; ++i)
            all.push_back(i < count ? scan_.from() + way * i / count : scan_.to());
        if (scan_.full_turn()) return all;
        for (double share = widest; share > closest; share *= closer) {
            all.push_back(scan_.from() + share * way);
            all.push_back(scan_.to() - share * way);
        }
        std::sort(all.begin(), all.end());
        // The ends themselves may be limits.
        all.front() = scan_.from() + closest * way;
        all.back() = scan_.to() - closest * way;
        std::sort(all.begin(), all.end());
        return all;
    }
    std::optional<std::pair<Vector<InputSeries>, Vector<InputSeries>>> ends_at(double input, const LinkageRoom& room) {
        const SeriesSignals* there = scan_.look(input);
        if (there == nullptr) return {};
        const auto in_slice = [&](std::size_t pin) {
            const Vector<InputSeries> at = there->in_pose().in_drawing(pin);
            const Vector<double> by = across();
            return Vector<InputSeries>{by.x * at.x - by.y * at.y, by.y * at.x + by.x * at.y};
        };
        return std::pair(in_slice(room.pins[0]), in_slice(room.pins[1]));
    }
    void add_cells(const LinkageRoom& room) {
        const std::vector<double> all = inputs();
        for (std::size_t i = 0; i + 1 < all.size(); ++i) {
            const double middle = 0.5 * (all[i] + all[i + 1]);
            if (!(all[i + 1] > all[i])) continue;
            const auto ends = ends_at(middle, room);
            possible_ = possible_ && ends.has_value();
            if (!possible_) return;
            // An end that stays where it is has no other height.
            if (i == 0) heights_.insert(heights_.end(), {ends->first.y.c[0], ends->second.y.c[0]});
            add_monotone({all[i] - middle, all[i + 1] - middle, ends->first, ends->second, 0, 0});
        }
        if (scan_.full_turn()) return;
        const SweptCell first = cells_.front(), last = cells_.back();
        add_end(room, first, false);
        add_end(room, last, true);
    }
    /// In parts over which both ends rise or fall.
    void add_monotone(const SweptCell& cell) {
        for (const Vector<InputSeries>* end : {&cell.first, &cell.second}) {
            const InputSeries slope = slope_of(end->y);
            const auto at = root_between(cell.low, cell.high, [&](double by) { return value(slope, by); });
            if (!at) continue;
            heights_.push_back(value(end->y, *at));
            // Beside a root the slope is rounding, of either sign.
            const double wide = 1e-9 * (cell.high - cell.low);
            if (!(*at - cell.low > wide && cell.high - *at > wide)) continue;
            SweptCell before = cell, after = cell;
            before.high = after.low = *at;
            add_monotone(before);
            add_monotone(after);
            return;
        }
        add_single(cell);
    }
    void add_single(SweptCell cell) {
        const double all[]{value(cell.first.y, cell.low), value(cell.first.y, cell.high),
                           value(cell.second.y, cell.low), value(cell.second.y, cell.high)};
        cell.bottom = *std::min_element(std::begin(all), std::end(all));
        cell.top = *std::max_element(std::begin(all), std::end(all));
        cells_.push_back(cell);
    }
    /// From the last sample to where the motion ends, which may be a limit.
    void add_end(const LinkageRoom& room, const SweptCell& beside, bool last) {
        const double at = last ? beside.high : beside.low;
        const auto coordinate = [&](std::size_t pin, bool y) {
            return of_poses(scan_,
                            [pin, y]<class T>(const PoseSignals<T>& pose) {
                                const Vector<T> place = pose.in_drawing(pin);
                                return y ? place.y : place.x;
                            })
                .at(last ? scan_.to() : scan_.from())
                .template convert_to<double>();
        };
        // A parabola of the root of the way from the end, with the place and the slope of the sample.
        const double way = closest * (scan_.to() - scan_.from()) * (last ? -1 : 1);
        const auto parabola = [&](const InputSeries& near, double end) {
            const double far = value(near, at) - end, slope = 2 * way * value(slope_of(near), at);
            const InputSeries root = InputSeries::variable(0);
            return InputSeries(end) + (2 * far - slope) * root + (slope - far) * root * root;
        };
        const auto to_end = [&](const Vector<InputSeries>& near, std::size_t pin) {
            const Vector<double> end = in_slices({coordinate(pin, false), coordinate(pin, true)});
            heights_.push_back(end.y);
            return Vector<InputSeries>{parabola(near.x, end.x), parabola(near.y, end.y)};
        };
        const SweptCell cell{0, 1, to_end(beside.first, room.pins[0]), to_end(beside.second, room.pins[1]), 0, 0};
        possible_ = possible_ && std::isfinite(cell.first.x.c[1]) && std::isfinite(cell.second.x.c[1]);
        if (possible_) add_monotone(cell);
    }

    /// Where the line of a cell crosses a height, of which it does so at all between two of its inputs.
    void add_crossed(const SweptCell& cell, double y, std::vector<Interval>& crossed) const {
        const auto first = [&](double by) { return value(cell.first.y, by) - y; };
        const auto second = [&](double by) { return value(cell.second.y, by) - y; };
        const auto x = [&](double by) {
            const double a = first(by), b = second(by), ax = value(cell.first.x, by), bx = value(cell.second.x, by);
            return ax + a / (a - b) * (bx - ax);
        };
        struct Stop {
            double by, x;
        };
        std::vector<Stop> stops;
        for (const double end : {cell.low, cell.high})
            if (first(end) * second(end) < 0) stops.push_back({end, x(end)});
        if (const auto by = root_between(cell.low, cell.high, first)) stops.push_back({*by, value(cell.first.x, *by)});
        if (const auto by = root_between(cell.low, cell.high, second))
            stops.push_back({*by, value(cell.second.x, *by)});
        std::sort(stops.begin(), stops.end(), [](const Stop& a, const Stop& b) { return a.by < b.by; });
        for (std::size_t i = 0; i + 1 < stops.size(); ++i) {
            const double from = stops[i].by, to = stops[i + 1].by, middle = 0.5 * (from + to);
            if (!(first(middle) * second(middle) < 0)) continue;
            Interval interval = std::minmax(stops[i].x, stops[i + 1].x);
            add_turn(x, from, to, interval);
            crossed.push_back(interval);
        }
    }
    /// How far the crossing turns back between two inputs: by golden sections where it is beyond both of its ends.
    template <class Function>
    static void add_turn(const Function& x, double from, double to, Interval& interval) {
        const double step = 1e-5 * (to - from), start = x(from + step) - x(from + 2 * step),
                     end = x(to - step) - x(to - 2 * step);
        if (!(start * end > 0)) return;
        const double sign = start < 0 ? 1 : -1;  // it rises at first
        constexpr double golden = 0.6180339887498949;
        double low = from, high = to, a = high - golden * (high - low), b = low + golden * (high - low);
        double at_a = sign * x(a), at_b = sign * x(b);
        for (int i = 0; i < 40; ++i) {
            if (at_a > at_b) {
                high = b;
                b = a;
                at_b = at_a;
                a = high - golden * (high - low);
                at_a = sign * x(a);
            } else {
                low = a;
                a = b;
                at_a = at_b;
                b = low + golden * (high - low);
                at_b = sign * x(b);
            }
        }
        const double farthest = sign * std::max(at_a, at_b);
        if (std::isfinite(farthest))
            interval = {std::min(interval.first, farthest), std::max(interval.second, farthest)};
    }
    /// How much of a slice is passed, within the screen where there is one.
    double covered_at(double y) const {
        std::vector<Interval> crossed;
        for (const SweptCell& cell : cells_)
            if (y >= cell.bottom && y <= cell.top) add_crossed(cell, y, crossed);
        std::sort(crossed.begin(), crossed.end());
        const std::vector<Interval> open = screen_at(y);
        double sum = 0, reached = -std::numeric_limits<double>::infinity();
        for (const Interval& each : crossed) {
            const double from = std::max(each.first, reached);
            if (!(each.second > from)) continue;
            reached = each.second;
            if (screen_.empty()) sum += reached - from;
            for (const Interval& part : open)
                sum += std::max(0.0, std::min(part.second, reached) - std::max(part.first, from));
        }
        return sum;
    }
    std::vector<Interval> screen_at(double y) const {
        std::vector<double> sides;
        for (std::size_t i = 0; i < screen_.size(); ++i) {
            const Vector<double>&a = screen_[i], &b = screen_[(i + 1) % screen_.size()];
            if ((a.y > y) != (b.y > y)) sides.push_back(a.x + (y - a.y) / (b.y - a.y) * (b.x - a.x));
        }
        std::sort(sides.begin(), sides.end());
        std::vector<Interval> parts;
        for (std::size_t i = 0; i + 1 < sides.size(); i += 2)
            parts.push_back({sides[i], sides[i + 1]});
        return parts;
    }

    const Scan& scan_;
    std::vector<SweptCell> cells_{};
    std::vector<Vector<double>> screen_{};
    std::vector<double> heights_{};  ///< at which what is covered may have a corner
    bool possible_ = true;
};

}  // namespace

Digits50 swept_area(const Scan& scan, const LinkageRoom& room, std::span<const Vector<double>> within) {
    return Digits50(SweptSlices(scan, room, within).area());
}

Digits50 uncovered(const Scan& scan, const LinkageRoom& room) {
    Digits50 twice = 0;
    for (std::size_t i = 0; i < room.screen.size(); ++i) {
        const Vector<double>&a = room.screen[i], &b = room.screen[(i + 1) % room.screen.size()];
        twice += Digits50(a.x) * Digits50(b.y) - Digits50(a.y) * Digits50(b.x);
    }
    // What is less than the rounding of the slices is nothing.
    constexpr double rounding = 1e-12;
    const Digits50 whole = twice / 2, rest = whole - swept_area(scan, room, room.screen);
    return abs(rest) <= rounding * whole ? Digits50(0) : rest;
}

}  // namespace mechwright::again

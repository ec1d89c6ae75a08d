#pragma once
/// \file
/// The components of a linkage's quantity where its terms have been found: functions of the dimensions, in any number
/// type.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <span>
#include <vector>

#include "analysis/geometry/polygon.h"
#include "analysis/linkage/measuring/means.h"
#include "synthesis/mechanism/linkage/rooms/approach.h"
#include "synthesis/mechanism/linkage/rooms/found_apart.h"
#include "synthesis/mechanism/linkage/rooms/found_room.h"
#include "synthesis/mechanism/linkage/rooms/swept/area.h"
#include "synthesis/mechanism/linkage/rooms/turned_size.h"
#include "synthesis/mechanism/linkage/targets/generated.h"

namespace mechwright::measuring {

/// Which of the greatest terms and which of the least make a difference.
struct Difference {
    std::size_t high, low;
    double value;
};

/// All of them, the greatest first.
inline std::vector<Difference> differences_of(const Found& found) {
    std::vector<Difference> all;
    for (std::size_t i = 0; i < found.plus.size(); ++i)
        for (std::size_t j = 0; j < found.minus.size(); ++j)
            all.push_back({i, j, found.plus[i].value() - found.minus[j].value()});
    std::stable_sort(all.begin(), all.end(),
                     [](const Difference& a, const Difference& b) { return a.value > b.value; });
    return all;
}

template <class T>
void put_greatest_first(std::vector<T>& all) {
    std::stable_sort(all.begin(), all.end(), [](const T& a, const T& b) { return value_of(a) > value_of(b); });
}

/// The components, the worst first, as many as there are, as functions of the dimensions.
template <class T, std::size_t K>
class Components {
public:
    Components(const Over& over, std::span<const T> seeded, std::span<const Signal> signals,
               linkage::Measured<double, K>& plain, const Course& course, const Found& found,
               std::array<double, 2> stretch)
        : over_(over),
          seeded_(over.dimensions_of(seeded)),
          shape_(over.shape_of(seeded)),
          measured_(measured<T, K>(over, seeded, signals)),
          plain_(plain),
          course_(course),
          found_(found),
          stretch_(stretch) {
        if (!course.turns.empty()) measured_.start_at(course);
        if (over.over_input) ends_ = moving_ends(seeded[seeded_.size()], seeded[seeded_.size() + 1]);
        if (over.is_of_function()) measured_.ask(wanted(seeded, over.motion.function->series));
        // Several points may be farthest in one pose.
        const Kind kind = over.measure.kind;
        if (is_of_parts(kind)) measured_.keep_poses();
        arguments_ = seeded;
    }

    std::vector<T> all() {
        const Kind kind = over_.measure.kind;
        std::vector<T> out;
        switch (kind) {
            case Kind::mean: out.push_back(mean(false)); break;
            case Kind::rms: {
                using std::sqrt;
                out.push_back(sqrt(mean(true)));
                break;
            }
            case Kind::range:
            case Kind::deviation: add_differences(kind == Kind::range ? 1 : 0.5, out); break;
            case Kind::room_width:
            case Kind::room_height: add_differences(1, out); break;
            case Kind::room_area:
                if constexpr (K == order_of_places) add_areas(out);
                break;
            case Kind::turned_width:
            case Kind::turned_area:
                if constexpr (K == order_of_slopes)
                    out.push_back(least_size(measured_, course_, found_.box, kind == Kind::turned_area, ends_));
                break;
            case Kind::self_distance:
                if constexpr (K == order_of_places)
                    for (const Approach& approach : found_.approaches)
                        out.push_back(distance_of(measured_, course_, approach, ends_));
                break;
            case Kind::swept_area:
            case Kind::uncovered:
                if constexpr (K == order_of_slopes) out.push_back(swept());
                break;
            case Kind::time_ratio: add_time_ratios(out); break;
            case Kind::extent: out.push_back(extent()); break;
            case Kind::function_rms: out.push_back(root_mean_square_error()); break;
            case Kind::total_length: {
                T sum(0);
                for (const T& length : link_lengths(over_.model, seeded_))
                    sum = sum + length;
                out.push_back(sum);
                break;
            }
            case Kind::link_ratio:
                if constexpr (K == order_of_places) add_link_ratios(out);
                break;
            case Kind::full_turn_margin:
            case Kind::assembly_margin:
                if constexpr (K == order_of_places) add_margins(out);
                break;
            default:
                for (const Term& term : found_.plus)
                    out.push_back(value(term));
        }
        return out;
    }

private:
    /// The radius of the arc that is followed.
    T radius() const { return shape_.size() == ArcShape::parameters ? shape_.back() : T(0); }
    linkage::Wanted<T> wanted(std::span<const T> arguments, std::span<const double> part) const {
        return over_.wanted_of(arguments, found_.whole_turns, part);
    }
    T at_sample(const Term& term) {
        measured_.ask(wanted(arguments_, {&over_.motion.function->parts[term.sample].y, 1}));
        return T(term.factor) * linkage::value_at_share(measured_, term.asked, course_, term.place, ends_);
    }
    T root_mean_square_error() {
        using std::sqrt;
        if (!found_.samples) return sqrt(mean(true));
        T sum(0);
        for (const Term& term : found_.plus) {
            const T error = at_sample(term);
            sum = sum + error * error;
        }
        return sqrt(T(sum / T(static_cast<double>(found_.plus.size()))));
    }
    T value(const Term& term) {
        if (found_.samples) return at_sample(term);
        if (term.also)
            return linkage::value_where_equal(measured_, {term.asked.signal, term.factor, term.constant}, *term.also,
                                              course_, term.place);
        const bool of_arc = over_.measure.kind == Kind::distance_greatest;
        return (of_arc ? T(T(-term.factor) * radius()) : T(term.constant)) +
               T(term.factor) * linkage::value_at(measured_, term.asked, course_, term.place, ends_);
    }
    /// By how much the time of both ends changes with start and range of the input.
    linkage::MovingEnds<T> moving_ends(const T& start, const T& range) const {
        const T first = start - T(number_as<double>(value_of(start)));
        const T last = first + (range - T(number_as<double>(value_of(range))));
        const T per_rate = T(over_.model.unit_of_input() / over_.rate);
        return value_of(range) < 0 ? linkage::MovingEnds<T>{per_rate * last, per_rate * first}
                                   : linkage::MovingEnds<T>{per_rate * first, per_rate * last};
    }
    /// Where the guided point is at an end of the motion, in the axes of what it follows.
    Vector<T> at_end(bool last) {
        const Extreme end{last ? course_.travel.to : course_.travel.from, 0, false,
                          last ? course_.travel.last : course_.travel.first};
        return {linkage::value_at(measured_, {1, 0}, course_, end, ends_),
                linkage::value_at(measured_, {2, 0}, course_, end, ends_)};
    }
    T extent() {
        if (shape_.size() == LineShape::parameters) return LineShape::extent({T(0), T(0)}, at_end(false), at_end(true));
        return ArcShape::extent({T(0), T(0), radius()}, at_end(false), at_end(true));
    }
    T mean(bool squared) {
        return linkage::mean_of(measured_, plain_, over_.measure.asked, course_, stretch_[0], stretch_[1], squared,
                                ends_);
    }
    void add_margins(std::vector<T>& out) {
        for (const linkage::MarginPlace& place : found_.margins)
            out.push_back(over_.model.scale.at(seeded_) * linkage::margin_at(measured_, place,
                                                                             course_.turns.near(place.place.at),
                                                                             course_.travel, ends_));
        // Where no dyad closes by lengths nothing comes apart.
        if (out.empty()) {
            const double size = size_of(plain_.driven());
            out.push_back(T(size > 0 ? size : 1));
        }
    }
    void add_differences(double factor, std::vector<T>& out) {
        std::vector<T> high, low;
        for (const Term& term : found_.plus)
            high.push_back(value(term));
        for (const Term& term : found_.minus)
            low.push_back(value(term));
        for (const Difference& one : differences_of(found_))
            out.push_back(T(factor) * (high[one.high] - low[one.low]));
    }
    /// A product of two differences, each of which is a candidate for a side of the box. The greatest is that of the
    /// sides: no other difference is as great without its sign.
    void add_areas(std::vector<T>& out) {
        const auto differences = [&](const std::vector<Term>& plus, const std::vector<Term>& minus) {
            std::vector<T> low, all;
            for (const Term& term : minus)
                low.push_back(value(term));
            for (const Term& term : plus) {
                const T high = value(term);
                for (const T& one : low)
                    all.push_back(high - one);
            }
            return all;
        };
        const std::vector<T> widths = differences(found_.plus, found_.minus),
                             heights = differences(found_.plus_across, found_.minus_across);
        for (const T& width : widths)
            for (const T& height : heights)
                out.push_back(width * height);
        put_greatest_first(out);
    }
    void add_time_ratios(std::vector<T>& out) {
        const Term &high = found_.plus.front(), &low = found_.minus.front();
        const T apart =
            (T(high.place.at) + T(over_.rate) * shift(high)) - (T(low.place.at) + T(over_.rate) * shift(low));
        const T one = value_of(apart) < 0 ? T(apart + T(over_.period())) : apart, other = T(over_.period()) - one;
        const bool slow = value_of(one) > value_of(other);
        out.push_back(slow ? T(one / other) : T(other / one));
        out.push_back(slow ? T(other / one) : T(one / other));
    }
    /// What is swept, or what of the screen is left.
    T swept() {
        const T area = area_within(measured_, plain_, course_, found_.swept, ends_);
        if (over_.measure.kind == Kind::swept_area) return area;
        constexpr double rounding = 1e-12;
        const double whole = area_of(screen_of(over_));
        const T rest = T(whole) - area;
        return std::abs(value_of(rest)) <= rounding * whole ? T(0) : rest;
    }
    T shift(const Term& term) { return linkage::shift_of(measured_, term.asked, course_, term.place, ends_); }
    void add_link_ratios(std::vector<T>& out) {
        std::vector<T> lengths = link_lengths(over_.model, seeded_);
        put_greatest_first(lengths);
        const std::size_t n = lengths.size(), few = std::min(most_of_range, n);
        for (std::size_t i = 0; i < few; ++i)
            for (std::size_t j = 0; j < few; ++j)
                if (i != n - 1 - j) out.push_back(lengths[i] / lengths[n - 1 - j]);
        if (n == 1) out.push_back(T(1));
        put_greatest_first(out);
    }

    const Over& over_;
    std::span<const T> seeded_, shape_, arguments_;
    linkage::Measured<T, K> measured_;
    linkage::Measured<double, K>& plain_;
    const Course& course_;
    const Found& found_;
    std::array<double, 2> stretch_;
    linkage::MovingEnds<T> ends_{};
};

}  // namespace mechwright::measuring

#pragma once
/// \file
/// Where the curves of a swept outline cross each other, and themselves.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

#include "synthesis/mechanism/linkage/rooms/swept/motion_samples.h"

namespace mechwright::measuring {

/// Where a curve is cut, and the corner there.
struct SweptCut {
    double at = 0;
    std::size_t corner = 0;
};

/// Finds them between chords of the curves, and exactly by Newton's method. `ends` are the corners at which each curve
/// begins and ends; those found are added to the outline's.
template <std::size_t K>
class CrossingSearch {
public:
    using Ends = std::vector<std::array<std::size_t, 2>>;

    CrossingSearch(const BladeMotion<K>& motion, SweptCurves<double, K>& curves, SweptOutline& outline,
                   const Ends& ends)
        : motion_(motion), curves_(curves), outline_(outline), ends_(ends), cuts_(outline.curves.size()) {
        for (std::size_t i = 0; i < outline.curves.size(); ++i)
            add_chords(i);
        std::sort(chords_.begin(), chords_.end(), [](const Chord& a, const Chord& b) { return a.low.x < b.low.x; });
    }

    std::vector<std::vector<SweptCut>> cuts() {
        for (std::size_t i = 0; i < chords_.size(); ++i)
            for (std::size_t j = i + 1; j < chords_.size() && chords_[j].low.x <= chords_[i].high.x; ++j)
                if (chords_[j].low.y <= chords_[i].high.y && chords_[i].low.y <= chords_[j].high.y)
                    look(chords_[i], chords_[j]);
        return std::move(cuts_);
    }

private:
    struct Chord {
        std::size_t curve, index, count;
        double from, to;
        Vector<double> start, end, low, high;

        /// The corners of the curve that it touches.
        bool touches(std::size_t corner, const std::array<std::size_t, 2>& ends) const {
            return (index == 0 && ends[0] == corner) || (index + 1 == count && ends[1] == corner);
        }
    };
    using Place = std::pair<Vector<double>, Vector<double>>;

    /// A place and its slope by the input, or the share.
    Place place(const SweptCurve& curve, double at, bool exactly) {
        const bool straight = curve.is_straight();
        const auto series = straight || exactly ? curves_.at(curve, at) : motion_.about(curve.piece, at).on(curve.kind);
        const double rate = straight ? 1 : motion_.rate();
        return {{series.x.c[0], series.y.c[0]}, {series.x.c[1] / rate, series.y.c[1] / rate}};
    }
    void add_chords(std::size_t index) {
        constexpr double bulge = 0.05, beside = 1e-7;  // of a chord's length; of the curve
        const SweptCurve& curve = outline_.curves[index];
        std::size_t count = 1;
        Stretch stretch{curve.from, curve.to};
        if (!curve.is_straight()) {
            const Stretch& whole = outline_.pieces[curve.piece].stretch;
            stretch.root_at_from = whole.root_at_from && curve.from == whole.from;
            stretch.root_at_to = whole.root_at_to && curve.to == whole.to;
            const auto share = (curve.to - curve.from) / whole.length();
            count = 6 + static_cast<std::size_t>(share * static_cast<double>(motion_.samples[curve.piece].size()));
        }
        Vector<double> before{};
        double input = curve.from;
        for (std::size_t i = 0; i <= count; ++i) {
            // The envelope is 0 / 0 where a blade rests.
            const double share = std::clamp(static_cast<double>(i) / static_cast<double>(count), beside, 1 - beside);
            const double next = curve.is_straight() ? (i == 0 ? curve.from : curve.to) : stretch.at(share);
            const Vector<double> at = place(curve, next, false).first;
            if (i > 0) {
                const double more = bulge * std::hypot(at.x - before.x, at.y - before.y);
                chords_.push_back({index,
                                   i - 1,
                                   count,
                                   input,
                                   next,
                                   before,
                                   at,
                                   {std::min(at.x, before.x) - more, std::min(at.y, before.y) - more},
                                   {std::max(at.x, before.x) + more, std::max(at.y, before.y) + more}});
            }
            before = at;
            input = next;
        }
    }

    bool are_neighbours(const Chord& a, const Chord& b) const {
        if (a.curve == b.curve)
            return std::max(a.index, b.index) - std::min(a.index, b.index) <= 1 ||
                   (ends_[a.curve][0] == ends_[a.curve][1] && a.index + b.index + 1 == a.count &&
                    std::min(a.index, b.index) == 0 && motion_.closed);
        for (const std::size_t corner : ends_[a.curve])
            if (a.touches(corner, ends_[a.curve]) && b.touches(corner, ends_[b.curve])) return true;
        return false;
    }
    /// Curves that lie flat on each other can cross twice between two chords: from their middles and all their ends.
    void look(const Chord& a, const Chord& b) {
        if (are_neighbours(a, b)) return;
        if (outline_.curves[a.curve].kind == SweptCurve::Kind::side &&
            outline_.curves[b.curve].kind == SweptCurve::Kind::side)
            return;
        look_from(a, b, 0.5 * (a.from + a.to), 0.5 * (b.from + b.to));
        for (const double s : {a.from, a.to})
            for (const double t : {b.from, b.to})
                look_from(a, b, s, t);
    }
    void look_from(const Chord& a, const Chord& b, double s, double t) {
        constexpr int most_steps = 12;
        constexpr double small = 1e-15, beyond = 0.2, parallel = 1e-6, same = 1e-7;
        const SweptCurve &one = outline_.curves[a.curve], &other = outline_.curves[b.curve];
        const double wide_a = a.to - a.from, wide_b = b.to - b.from;
        const auto is_in = [](double x, double from, double to, double more) {
            return x >= from - more && x <= to + more;
        };
        bool exactly = false;
        for (int i = 0; i < most_steps; ++i) {
            const auto [p, u] = place(one, s, exactly);
            const auto [q, v] = place(other, t, exactly);
            const double determinant = cross(u, v);
            if (!(std::abs(determinant) > parallel * std::hypot(u.x, u.y) * std::hypot(v.x, v.y))) return;
            const Vector<double> apart = q - p;
            const double by_one = cross(apart, v) / determinant, by_other = cross(apart, u) / determinant;
            s = std::clamp(s + by_one, a.from - wide_a, a.to + wide_a);
            t = std::clamp(t + by_other, b.from - wide_b, b.to + wide_b);
            s = std::clamp(s, one.from, one.to);
            t = std::clamp(t, other.from, other.to);
            const double accuracy = exactly ? small : 1e-9;
            const bool settled =
                std::abs(by_one) <= accuracy * (1 + std::abs(s)) && std::abs(by_other) <= accuracy * (1 + std::abs(t));
            if (settled && exactly) break;
            if (i > 5 && !exactly && !settled) return;
            exactly = exactly || settled;
        }
        if (!exactly || !is_in(s, a.from, a.to, beyond * wide_a) || !is_in(t, b.from, b.to, beyond * wide_b)) return;
        const auto at_end = [](const SweptCurve& curve, double at) {
            return std::min(at - curve.from, curve.to - at) <= same * (curve.to - curve.from);
        };
        const bool one_ends = at_end(one, s), other_ends = at_end(other, t);
        if (one_ends && other_ends) return;
        const auto is_known = [&](std::size_t curve, double at) {
            return std::any_of(cuts_[curve].begin(), cuts_[curve].end(), [&](const SweptCut& cut) {
                return std::abs(cut.at - at) <= same * (outline_.curves[curve].to - outline_.curves[curve].from);
            });
        };
        SweptCorner corner{.kind = SweptCorner::Kind::crossing};
        corner.one = a.curve;
        corner.other = b.curve;
        corner.at_one = s;
        corner.at_other = t;
        const std::size_t index = outline_.corners.size();
        const bool cuts_one = !one_ends && !is_known(a.curve, s), cuts_other = !other_ends && !is_known(b.curve, t);
        if (!cuts_one && !cuts_other) return;
        // What crosses itself has two places there: a corner for each.
        outline_.corners.push_back(corner);
        if (cuts_one) cuts_[a.curve].push_back({s, index});
        if (a.curve == b.curve) {
            corner.at_one = t;
            corner.at_other = s;
            outline_.corners.push_back(corner);
        }
        if (cuts_other) cuts_[b.curve].push_back({t, outline_.corners.size() - 1});
    }

    const BladeMotion<K>& motion_;
    SweptCurves<double, K>& curves_;
    SweptOutline& outline_;
    const Ends& ends_;
    std::vector<Chord> chords_{};
    std::vector<std::vector<SweptCut>> cuts_;
};

template <std::size_t K>
std::vector<std::vector<SweptCut>> cuts_at_crossings(const BladeMotion<K>& motion, SweptCurves<double, K>& curves,
                                                     SweptOutline& outline,
                                                     const std::vector<std::array<std::size_t, 2>>& ends) {
    return CrossingSearch<K>(motion, curves, outline, ends).cuts();
}

}  // namespace mechwright::measuring

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

#include "analysis/numbers/extremes.h"
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

    CrossingSearch(BladeMotion<K>& motion, SweptCurves<double, K>& curves, SweptOutline& outline, const Ends& ends)
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
        const std::size_t known = outline_.corners.size();
        for (std::size_t i = 0; i < known; ++i)
            cut_where_passed_again(i);
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

    /// Curves are gone along by shares: of a straight one itself, else of its piece, in which they are smooth at
    /// limits.
    double input_of(const SweptCurve& curve, double share) const {
        return curve.is_straight() ? share : outline_.pieces[curve.piece].stretch.at(share);
    }
    double share_of(const SweptCurve& curve, double input) const {
        return curve.is_straight() ? input : outline_.pieces[curve.piece].stretch.share_of(input);
    }
    /// A place and its slope by the share.
    Place place(const SweptCurve& curve, double share, bool exactly) {
        const bool straight = curve.is_straight();
        const double at = input_of(curve, share);
        exactly = exactly || straight || motion_.is_beside_limit(curve.piece, at);
        const auto series = exactly ? curves_.at(curve, at) : motion_.about(curve.piece, at).on(curve.kind);
        const double speed = straight ? 1 : outline_.pieces[curve.piece].stretch.speed(share) / motion_.rate();
        return {{series.x.c[0], series.y.c[0]}, {series.x.c[1] * speed, series.y.c[1] * speed}};
    }
    void add_chords(std::size_t index) {
        constexpr double bulge = 0.05, beside = 1e-7;  // of a chord's length; of the curve
        const SweptCurve& curve = outline_.curves[index];
        const double from = share_of(curve, curve.from), to = share_of(curve, curve.to);
        const std::size_t count =
            curve.is_straight()
                ? 1
                : 6 + static_cast<std::size_t>((to - from) * static_cast<double>(motion_.samples[curve.piece].size()));
        Vector<double> before{};
        double share = from;
        for (std::size_t i = 0; i <= count; ++i) {
            // The envelope is 0 / 0 where a blade rests.
            const double part = std::clamp(static_cast<double>(i) / static_cast<double>(count),
                                           curve.is_straight() ? 0 : beside, curve.is_straight() ? 1 : 1 - beside);
            const double next = from + (to - from) * part;
            const Vector<double> at = place(curve, next, false).first;
            if (i > 0) {
                const double more = bulge * std::hypot(at.x - before.x, at.y - before.y);
                chords_.push_back({index,
                                   i - 1,
                                   count,
                                   share,
                                   next,
                                   before,
                                   at,
                                   {std::min(at.x, before.x) - more, std::min(at.y, before.y) - more},
                                   {std::max(at.x, before.x) + more, std::max(at.y, before.y) + more}});
            }
            before = at;
            share = next;
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
        constexpr double small = 1e-15, beyond = 0.2, parallel = 1e-6;
        const SweptCurve &one = outline_.curves[a.curve], &other = outline_.curves[b.curve];
        const std::array one_from_to{share_of(one, one.from), share_of(one, one.to)},
            other_from_to{share_of(other, other.from), share_of(other, other.to)};
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
            s = std::clamp(s, one_from_to[0], one_from_to[1]);
            t = std::clamp(t, other_from_to[0], other_from_to[1]);
            const double accuracy = exactly ? small : 1e-9;
            const bool settled =
                std::abs(by_one) <= accuracy * (1 + std::abs(s)) && std::abs(by_other) <= accuracy * (1 + std::abs(t));
            if (settled && exactly) break;
            if (i > 5 && !exactly && !settled) return;
            exactly = exactly || settled;
        }
        if (!exactly || !is_in(s, a.from, a.to, beyond * wide_a) || !is_in(t, b.from, b.to, beyond * wide_b)) return;
        const auto at_end = [](const std::array<double, 2>& from_to, double at) {
            return std::min(at - from_to[0], from_to[1] - at) <= same * (from_to[1] - from_to[0]);
        };
        const bool one_ends = at_end(one_from_to, s), other_ends = at_end(other_from_to, t);
        if (one_ends && other_ends) return;
        const bool cuts_one = !one_ends && !is_known(a.curve, s), cuts_other = !other_ends && !is_known(b.curve, t);
        s = input_of(one, s);
        t = input_of(other, t);
        SweptCorner corner{.kind = SweptCorner::Kind::crossing};
        corner.one = a.curve;
        corner.other = b.curve;
        corner.at_one = s;
        corner.at_other = t;
        const std::size_t index = outline_.corners.size();
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
    bool is_known(std::size_t index, double share) const {
        const SweptCurve& curve = outline_.curves[index];
        const double wide = share_of(curve, curve.to) - share_of(curve, curve.from);
        return std::any_of(cuts_[index].begin(), cuts_[index].end(), [&](const SweptCut& cut) {
            return std::abs(share_of(curve, cut.at) - share) <= same * wide;
        });
    }

    /// A path that goes over itself again, as that of a rocker's pin, is cut where it folds on another pass: what of it
    /// is a border changes there, and no curve crosses it.
    void cut_where_passed_again(std::size_t corner) {
        using At = SweptCorner::Kind;
        constexpr double off = 1e-9;  // of the size
        const SweptCorner::Kind kind = outline_.corners[corner].kind;
        if (kind != At::first_folds && kind != At::second_folds) return;
        const auto path = kind == At::first_folds ? SweptCurve::Kind::first_path : SweptCurve::Kind::second_path;
        const double at = outline_.corners[corner].place.at;
        const auto end_of = [&](const Blade<double, K>& blade) {
            return path == SweptCurve::Kind::first_path ? blade.first : blade.second;
        };
        const auto fold = end_of(motion_.exactly(outline_.corners[corner].piece, at));
        // How far the path has to go to come next to the fold, times its speed.
        const auto beyond = [&](const Blade<double, K>& blade) {
            const auto end = end_of(blade);
            return (end.x.c[0] - fold.x.c[0]) * end.x.c[1] + (end.y.c[0] - fold.y.c[0]) * end.y.c[1];
        };
        for (std::size_t i = 0; i < outline_.curves.size(); ++i) {
            const SweptCurve& curve = outline_.curves[i];
            if (curve.kind != path || ends_[i][0] == corner || ends_[i][1] == corner) continue;
            motion_.for_steps(curve.piece, curve.from, curve.to, [&](const auto& before, const auto& after) {
                const double from = beyond(before.blade), to = beyond(after.blade);
                if (!(from < 0 && to > 0)) return;
                const double input =
                    zero_between<double>([&](double x) { return beyond(motion_.exactly(curve.piece, x)); },
                                         before.input, after.input, from, to);
                const auto end = end_of(motion_.exactly(curve.piece, input));
                if (!(std::hypot(end.x.c[0] - fold.x.c[0], end.y.c[0] - fold.y.c[0]) <= off * motion_.size)) return;
                if (is_known(i, share_of(curve, input))) return;
                SweptCorner pass{.kind = At::passed_again};
                pass.place.at = input;
                pass.piece = curve.piece;
                pass.of = corner;
                outline_.corners.push_back(pass);
                cuts_[i].push_back({input, outline_.corners.size() - 1});
            });
        }
    }

    static constexpr double same = 1e-7;  ///< of a curve: places are one

    BladeMotion<K>& motion_;
    SweptCurves<double, K>& curves_;
    SweptOutline& outline_;
    const Ends& ends_;
    std::vector<Chord> chords_{};
    std::vector<std::vector<SweptCut>> cuts_;
};

template <std::size_t K>
std::vector<std::vector<SweptCut>> cuts_at_crossings(BladeMotion<K>& motion, SweptCurves<double, K>& curves,
                                                     SweptOutline& outline,
                                                     const std::vector<std::array<std::size_t, 2>>& ends) {
    return CrossingSearch<K>(motion, curves, outline, ends).cuts();
}

}  // namespace mechwright::measuring

#pragma once
/// \file
/// The search for the outline of what a blade sweeps: all curves of which it can be made are cut where they cross, and
/// what has swept places on one side only is kept. The outline is found where its arcs close.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "analysis/geometry/polygon.h"
#include "analysis/numbers/extremes.h"
#include "synthesis/mechanism/linkage/measured_over.h"
#include "synthesis/mechanism/linkage/rooms/swept/covering.h"
#include "synthesis/mechanism/linkage/rooms/swept/crossings.h"
#include "synthesis/mechanism/linkage/rooms/swept/motion_samples.h"

namespace mechwright::measuring {

/// Whether an end of the blade stays where it is.
using FixedEnds = std::array<bool, 2>;

template <std::size_t K>
class SweptSearch {
public:
    using Kind = SweptCurve::Kind;
    using Pose = Blade<double, K>;

    SweptSearch(linkage::Measured<double, K>& measured, const linkage::Course& course, const FixedEnds& fixed,
                std::span<const Vector<double>> screen)
        : measured_(measured), course_(course), fixed_(fixed), screen_(screen) {}

    /// Absent where the linkage does not close over the motion, or no outline was found that closes.
    std::optional<SweptOutline> found() {
        for (const double of_radian : {48.0, 160.0, 512.0}) {
            outline_ = {};
            ends_.clear();
            BladeMotion<K> motion(measured_, course_, of_radian);
            if (!motion.possible) return {};
            outline_.pieces = motion.pieces;
            add_curves(motion);
            for (std::size_t i = 0; i < screen_.size(); ++i)
                add_side(screen_[i], screen_[(i + 1) % screen_.size()]);
            SweptCurves<double, K> curves(measured_, course_, outline_, {});
            auto cuts = cuts_at_crossings(motion, curves, outline_, ends_);
            for (std::size_t i = 0; i < outline_.curves.size(); ++i)
                add_arcs(motion, curves, i, cuts[i]);
            const bool lost = outline_.arcs.empty() && enters_screen(motion);
            if (!lost && closes(motion, curves)) return std::move(outline_);
        }
        return {};
    }

private:
    std::size_t corner(SweptCorner made) {
        outline_.corners.push_back(std::move(made));
        return outline_.corners.size() - 1;
    }
    void add(SweptCurve curve, std::size_t first, std::size_t last) {
        if (!(curve.to > curve.from)) return;
        outline_.curves.push_back(curve);
        ends_.push_back({first, last});
    }
    void add_side(const Vector<double>& from, const Vector<double>& to) {
        SweptCurve side{.kind = Kind::side, .from = 0, .to = 1};
        side.start = from;
        side.end = to;
        add(side, corner({}), corner({}));
    }

    void add_curves(BladeMotion<K>& motion) {
        const std::size_t seam = corner({});
        for (std::size_t i = 0; i < motion.pieces.size(); ++i) {
            std::array<std::size_t, 2> at_end{seam, seam}, foot{seam, seam};
            for (const bool last : {false, true})
                if (is_end_of_stroke(motion, i, last)) std::tie(at_end[last], foot[last]) = add_end(motion, i, last);
            add_between_folds(motion, i, at_end, foot);
        }
    }
    static bool is_end_of_stroke(const BladeMotion<K>& motion, std::size_t piece, bool last) {
        if (motion.closed) return false;
        if (motion.pieces.size() == 1) return true;
        const std::size_t stroke = motion.pieces[piece].stroke;
        return last ? piece + 1 == motion.pieces.size() || motion.pieces[piece + 1].stroke != stroke
                    : piece == 0 || motion.pieces[piece - 1].stroke != stroke;
    }

    /// The blade where a stroke ends, in two parts where its points leave it to both sides; the corner there, and that
    /// at the foot, where the envelope begins.
    std::pair<std::size_t, std::size_t> add_end(BladeMotion<K>& motion, std::size_t piece, bool last) {
        const Stretch& stretch = motion.pieces[piece].stretch;
        const auto& sample = last ? motion.samples[piece].back() : motion.samples[piece].front();
        SweptCorner end{.kind = SweptCorner::Kind::end};
        // By the input itself ends of the motion are known, which move with limits, stops or what is given.
        const linkage::Travel& travel = course_.travel;
        const double input = last ? stretch.to : stretch.from;
        const bool of_motion = input == (last ? travel.to : travel.from);
        const linkage::Limit limit = !of_motion ? linkage::Limit{} : last ? travel.last : travel.first;
        end.place = {input, 0, false, limit, motion.pieces[piece].within};
        end.piece = piece;
        if (limit.exists())
            end.at_limit = {sample.blade.first.x.c[0], sample.blade.first.y.c[0], sample.blade.second.x.c[0],
                            sample.blade.second.y.c[0]};
        if (!limit.is_singular() && motion.is_rest(sample.blade)) end.kind = SweptCorner::Kind::rest;
        const std::size_t at = corner(end);
        SweptCurve blade{.kind = Kind::blade, .from = 0, .to = 1, .piece = piece, .place = at};
        const auto [a, b] = leaves(motion, piece, last);
        constexpr double at_end = 1e-9;
        const double share = a / (a - b);
        const bool within = share > at_end && share < 1 - at_end;
        if (fixed_[0] || fixed_[1] || !(share > -at_end && share < 1 + at_end))
            return add(blade, at, at), std::pair(at, at);
        SweptCorner foot{.kind = SweptCorner::Kind::foot};
        foot.piece = piece;
        foot.of = at;
        foot.at_one = within ? share : std::round(share);
        const std::size_t middle = corner(foot);
        blade.to = within ? share : 1;
        add(blade, at, within ? middle : at);
        if (within) {
            blade.from = share;
            blade.to = 1;
            add(blade, middle, at);
        }
        return {at, middle};
    }
    /// How both ends leave the blade's line into the motion, to the right; of a rest by their accelerations. Of a
    /// limit, beside which velocities grow beyond all bounds, by what they tend to against their difference.
    std::pair<double, double> leaves(BladeMotion<K>& motion, std::size_t piece, bool last) {
        constexpr double beside = 1e-4;
        const Stretch& stretch = motion.pieces[piece].stretch;
        if (!(last ? stretch.root_at_to : stretch.root_at_from)) {
            const Pose& blade = (last ? motion.samples[piece].back() : motion.samples[piece].front()).blade;
            return leaves_by(blade, motion.is_rest(blade) ? 2 : 1, last);
        }
        const auto both = [&](double s) {
            return leaves_by(motion.exactly(piece, stretch.at(last ? 1 - s : s)), 1, last);
        };
        const double share = linkage::detail::limit_from_beside(
            [&](double s) {
                const auto [a, b] = both(s);
                return a / (a - b);
            },
            1);
        const auto [a, b] = both(beside);
        const double sense = a < b ? -1 : 1;
        return {sense * share, sense * (share - 1)};
    }
    static std::pair<double, double> leaves_by(const Pose& blade, std::size_t order, bool last) {
        const Vector<double> along{blade.along().x.c[0], blade.along().y.c[0]};
        const auto across = [&](const Vector<Series<double, K>>& end) {
            return cross(Vector<double>{end.x.c[order], end.y.c[order]}, along) * (last && order == 1 ? -1 : 1);
        };
        return {across(blade.first), across(blade.second)};
    }

    struct Fold {
        double input;
        std::size_t corner;
        bool of_first;
    };
    /// Zeros of a function of the pose between two inputs of a piece.
    template <class Function>
    std::vector<double> zeros(BladeMotion<K>& motion, std::size_t piece, double from, double to, const Function& f) {
        std::vector<double> found;
        motion.for_steps(piece, from, to, [&](const BladeSample<K>& before, const BladeSample<K>& after) {
            const double low = f(before.blade), high = f(after.blade);
            if ((low > 0) == (high > 0)) return;
            found.push_back(zero_between<double>([&](double x) { return f(motion.exactly(piece, x)); }, before.input,
                                                 after.input, low, high));
        });
        return found;
    }
    void add_between_folds(BladeMotion<K>& motion, std::size_t piece, const std::array<std::size_t, 2>& at_end,
                           const std::array<std::size_t, 2>& foot) {
        const Stretch& stretch = motion.pieces[piece].stretch;
        std::vector<Fold> folds;
        for (const bool of_first : {true, false}) {
            std::vector<Fold> own;
            if (!fixed_[of_first ? 0 : 1])
                for (const double input : zeros(motion, piece, stretch.from, stretch.to, [of_first](const Pose& blade) {
                         return (of_first ? blade.first_across() : blade.second_across()).c[0];
                     })) {
                    SweptCorner fold{.kind =
                                         of_first ? SweptCorner::Kind::first_folds : SweptCorner::Kind::second_folds};
                    fold.place.at = input;
                    fold.piece = piece;
                    own.push_back({input, corner(fold), of_first});
                }
            add_path(of_first ? Kind::first_path : Kind::second_path, piece, own, at_end);
            folds.insert(folds.end(), own.begin(), own.end());
        }
        if (fixed_[0] || fixed_[1]) {  // The whole blade turns back.
            for (const Fold& fold : folds)
                add({.kind = Kind::blade, .from = 0, .to = 1, .piece = piece, .place = fold.corner}, fold.corner,
                    fold.corner);
            return;
        }
        std::sort(folds.begin(), folds.end(), [](const Fold& a, const Fold& b) { return a.input < b.input; });
        add_envelopes(motion, piece, folds, foot);
    }
    void add_path(Kind kind, std::size_t piece, std::span<const Fold> folds, const std::array<std::size_t, 2>& at_end) {
        if (fixed_[kind == Kind::first_path ? 0 : 1]) return;
        const Stretch& stretch = outline_.pieces[piece].stretch;
        double from = stretch.from;
        std::size_t first = at_end[0];
        for (const Fold& fold : folds) {
            add({.kind = kind, .from = from, .to = fold.input, .piece = piece}, first, fold.corner);
            from = fold.input;
            first = fold.corner;
        }
        add({.kind = kind, .from = from, .to = stretch.to, .piece = piece}, first, at_end[1]);
    }
    /// Between folds where the foot is on the blade, from cusp to cusp; where both ends fold at once the whole blade.
    void add_envelopes(BladeMotion<K>& motion, std::size_t piece, std::span<const Fold> folds,
                       const std::array<std::size_t, 2>& foot) {
        const Stretch& stretch = motion.pieces[piece].stretch;
        constexpr double at_once = 1e-9;
        for (std::size_t i = 0; i <= folds.size(); ++i) {
            const double from = i > 0 ? folds[i - 1].input : stretch.from,
                         to = i < folds.size() ? folds[i].input : stretch.to;
            const std::size_t first = i > 0 ? folds[i - 1].corner : foot[0],
                              last = i < folds.size() ? folds[i].corner : foot[1];
            if (i > 0 && i < folds.size() && folds[i - 1].of_first != folds[i].of_first &&
                to - from < at_once * stretch.length()) {
                add({.kind = Kind::blade, .from = 0, .to = 1, .piece = piece, .place = first}, first, first);
                continue;
            }
            const Pose middle = motion.exactly(piece, 0.5 * (from + to));
            if (!(middle.first_across().c[0] * middle.second_across().c[0] < 0)) continue;
            if (stays(motion, piece, from, to)) continue;
            double start = from;
            std::size_t before = first;
            for (const double cusp : zeros(motion, piece, from, to, [](const Pose& blade) {
                     const auto place = blade.on(Kind::envelope);
                     return cross(Vector<double>{place.x.c[1], place.y.c[1]},
                                  left_of(Vector<double>{blade.along().x.c[0], blade.along().y.c[0]}));
                 })) {
                const std::size_t here = corner({});
                add({.kind = Kind::envelope, .from = start, .to = cusp, .piece = piece}, before, here);
                start = cusp;
                before = here;
            }
            add({.kind = Kind::envelope, .from = start, .to = to, .piece = piece}, before, last);
        }
    }
    /// Whether the blade turns about one and the same place.
    bool stays(BladeMotion<K>& motion, std::size_t piece, double from, double to) {
        constexpr double still = 1e-9;
        constexpr int looks = 8;
        for (int i = 0; i < looks; ++i) {
            const auto place = motion.exactly(piece, from + (to - from) * (i + 0.5) / looks).on(Kind::envelope);
            if (!(std::hypot(place.x.c[1], place.y.c[1]) <= still * motion.speed)) return false;
        }
        return true;
    }

    /// Whether what is swept beside a curve lies to the left of it.
    bool is_left(BladeMotion<K>& motion, const SweptCurve& curve, double at) {
        if (curve.kind == Kind::side) return true;
        if (curve.kind != Kind::blade) {
            const Pose blade = motion.exactly(curve.piece, at);
            if (curve.kind == Kind::first_path) return blade.first_across().c[0] > 0;
            if (curve.kind == Kind::second_path) return blade.second_across().c[0] < 0;
            const auto along = blade.along();
            return along.x.c[0] * along.y.c[1] - along.y.c[0] * along.x.c[1] < 0;
        }
        const SweptCorner& end = outline_.corners[curve.place];
        if (end.kind == SweptCorner::Kind::end || end.kind == SweptCorner::Kind::rest) {
            const auto [a, b] = leaves(motion, curve.piece, end.place.at == motion.pieces[curve.piece].stretch.to);
            return a + at * (b - a) < 0;
        }
        // It turns back: what is beside a place lies on the side to which that is accelerated.
        const Pose blade = motion.exactly(curve.piece, end.place.at);
        const auto [a, b] = leaves_by(blade, 2, false);
        return a + at * (b - a) < 0;
    }

    void add_arcs(BladeMotion<K>& motion, SweptCurves<double, K>& curves, std::size_t index,
                  std::vector<SweptCut>& cuts) {
        const SweptCurve& curve = outline_.curves[index];
        cuts.push_back({curve.from, ends_[index][0]});
        cuts.push_back({curve.to, ends_[index][1]});
        std::sort(cuts.begin(), cuts.end(), [](const SweptCut& a, const SweptCut& b) { return a.at < b.at; });
        for (std::size_t i = 0; i + 1 < cuts.size(); ++i) {
            const double middle = 0.5 * (cuts[i].at + cuts[i + 1].at);
            if (!(cuts[i + 1].at > cuts[i].at)) continue;
            const auto at = curves.at(curve, middle);
            const Vector<double> place{at.x.c[0], at.y.c[0]}, way{at.x.c[1], at.y.c[1]};
            const bool left = is_left(motion, curve, middle);
            if (curve.kind != Kind::side && !screen_.empty() && !is_in_polygon(screen_, place)) continue;
            const BesideCurve beside{curve, outline_, middle, place, way, left};
            if (covers(motion, beside) != (curve.kind == Kind::side)) continue;
            outline_.arcs.push_back({index, cuts[i].at, cuts[i + 1].at, cuts[i].corner, cuts[i + 1].corner, !left});
        }
    }
    /// Whether an end of the blade is in the screen anywhere.
    bool enters_screen(const BladeMotion<K>& motion) const {
        for (const auto& piece : motion.samples)
            for (const BladeSample<K>& sample : piece)
                for (const auto* end : {&sample.blade.first, &sample.blade.second})
                    if (!screen_.empty() && is_in_polygon(screen_, Vector<double>{end->x.c[0], end->y.c[0]}))
                        return true;
        return false;
    }
    /// Where an arc begins or ends: at the end of a stroke by the blade there, of whose ends series at a limit know
    /// nothing. The envelope is 0 / 0 where a blade turns back.
    Vector<double> place_at(BladeMotion<K>& motion, SweptCurves<double, K>& curves, const SweptArc& arc, bool last) {
        constexpr double beside = 1e-7;
        const SweptCurve& curve = outline_.curves[arc.curve];
        const SweptCorner& corner = outline_.corners[last ? arc.last : arc.first];
        const bool foot = corner.kind == SweptCorner::Kind::foot;
        const SweptCorner& end = foot ? outline_.corners[corner.of] : corner;
        if (!curve.is_straight() && (end.kind == SweptCorner::Kind::end || end.kind == SweptCorner::Kind::rest)) {
            const auto& samples = motion.samples[end.piece];
            const bool at_last = end.place.at == motion.pieces[end.piece].stretch.to;
            const Pose& blade = (at_last ? samples.back() : samples.front()).blade;
            const double share = foot ? corner.at_one : curve.kind == Kind::second_path ? 1 : 0;
            const auto place = blade.first + Series<double, K>(share) * blade.along();
            return {place.x.c[0], place.y.c[0]};
        }
        const double inside = curve.kind == Kind::envelope ? beside * (arc.to - arc.from) : 0;
        const auto place = curves.at(curve, last ? arc.to - inside : arc.from + inside);
        return {place.x.c[0], place.y.c[0]};
    }
    /// Whether each arc is followed by one that begins where it ends.
    bool closes(BladeMotion<K>& motion, SweptCurves<double, K>& curves) {
        constexpr double near = 1e-6;
        struct End {
            Vector<double> at;
            bool used = false;
        };
        std::vector<End> starts;
        std::vector<Vector<double>> ends;
        for (const SweptArc& arc : outline_.arcs) {
            const Vector<double> first = place_at(motion, curves, arc, false),
                                 last = place_at(motion, curves, arc, true);
            starts.push_back({arc.backward ? last : first});
            ends.push_back(arc.backward ? first : last);
        }
        for (const Vector<double>& end : ends) {
            const auto next = std::find_if(starts.begin(), starts.end(), [&](const End& start) {
                const Vector<double> apart = start.at - end;
                return !start.used && std::hypot(apart.x, apart.y) <= near * motion.size;
            });
            if (next == starts.end()) return false;
            next->used = true;
        }
        return true;
    }

    linkage::Measured<double, K>& measured_;
    const linkage::Course& course_;
    FixedEnds fixed_;
    std::span<const Vector<double>> screen_;
    SweptOutline outline_{};
    std::vector<std::array<std::size_t, 2>> ends_{};  ///< the corners at which each curve begins and ends
};

/// The outline of what a room's blade sweeps, of its screen where the uncovered rest of that is asked for.
template <std::size_t K>
std::optional<SweptOutline> swept_outline(const Over& over, linkage::Measured<double, K>& measured,
                                          const linkage::Course& course) {
    const LinkageRoom& room = over.model.rooms[over.measure.of_room];
    const auto is_fixed = [&](std::size_t k) { return linkage::is_on(over.model.structure.pins[room.pins[k]], 0); };
    const std::vector<Vector<double>> screen =
        over.measure.kind == Kind::uncovered ? screen_of(over) : std::vector<Vector<double>>{};
    return SweptSearch<K>(measured, course, {is_fixed(0), is_fixed(1)}, screen).found();
}

}  // namespace mechwright::measuring

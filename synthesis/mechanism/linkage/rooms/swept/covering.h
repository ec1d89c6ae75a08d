#pragma once
/// \file
/// Whether a blade passes over a place.

#include <cmath>
#include <cstddef>
#include <numbers>
#include <tuple>

#include "analysis/numbers/extremes.h"
#include "synthesis/mechanism/linkage/rooms/swept/motion_samples.h"

namespace mechwright::measuring {

/// A place on a curve, which goes on along `way`, and the side of this on which places beside it are swept.
struct BesideCurve {
    const SweptCurve& curve;
    const SweptOutline& outline;
    double at;
    Vector<double> place, way;
    bool left;
};

/// Looks for passes over one place.
template <std::size_t K>
class PassesOver {
public:
    PassesOver(BladeMotion<K>& motion, const BesideCurve& beside) : motion_(motion), beside_(beside) {
        const SweptCurve& curve = beside.curve;
        own_ = curve.kind != SweptCurve::Kind::side;
        if (!own_) return;
        own_input_ = curve.kind == SweptCurve::Kind::blade ? beside.outline.corners[curve.place].place.at : beside.at;
        // Where the place is on the blade by being on the curve, how far off the blade is has a double zero on
        // envelopes, and where it turns back.
        const auto turns_back = [&] {
            const SweptCorner::Kind kind = beside.outline.corners[curve.place].kind;
            return kind == SweptCorner::Kind::first_folds || kind == SweptCorner::Kind::second_folds;
        };
        twice_ = curve.kind == SweptCurve::Kind::envelope || (curve.kind == SweptCurve::Kind::blade && turns_back());
    }

    /// Whether places on both sides of the curve are swept, or this curve lies on another that stands for both.
    bool any() {
        for (std::size_t piece = 0; piece < motion_.pieces.size(); ++piece) {
            const auto& all = motion_.samples[piece];
            const bool own = own_ && motion_.pieces[piece].stroke == motion_.pieces[beside_.curve.piece].stroke;
            double before = 0, input = 0;
            for (const BladeSample<K>& sample : all) {
                const double divisor = own ? own_zero(sample.input) : 1;
                if (std::abs(divisor) < 1e-9) continue;  // on its own pass
                const double off = off_of(sample.blade) / divisor;
                if (before != 0 && off != 0 && (off < 0) != (before < 0)) {
                    const double near = input + (sample.input - input) * (before / (before - off));
                    const auto over_own = [&](double x) {
                        return off_of(motion_.exactly(piece, x)) / (own ? own_zero(x) : 1);
                    };
                    const Pose pass =
                        motion_.is_beside_limit(piece, 0.5 * (input + sample.input))
                            ? exactly_at(piece, zero_between<double>(over_own, input, sample.input, before, off))
                            : from_series(piece, near, input, sample.input);
                    if (is_pass(pass)) return true;
                }
                before = off;
                input = sample.input;
            }
        }
        return false;
    }

private:
    /// To the left of the blade, times its length.
    double off_of(const Blade<double, K>& blade) const {
        const Vector<double> first{blade.first.x.c[0], blade.first.y.c[0]},
            along{blade.along().x.c[0], blade.along().y.c[0]};
        return cross(along, beside_.place - first);
    }
    /// Vanishes at its own pass alone.
    double own_zero(double input) const {
        const double way = input - own_input_;
        if (!motion_.closed) return twice_ ? way * way : way;
        const double period = motion_.pieces.back().stretch.to - motion_.pieces.front().stretch.from;
        const double root = std::sin(std::numbers::pi * way / period);
        // A single zero would change the sign of what comes back after a period: that of twice the way does not.
        return twice_ ? root * root : root;
    }
    struct Pose {
        double input;
        Blade<double, K> blade;
    };
    Pose exactly_at(std::size_t piece, double input) { return {input, motion_.exactly(piece, input)}; }
    /// Of a pass between two inputs, near one, by the sample next to it.
    Pose from_series(std::size_t piece, double near, double low, double high) const {
        for (int i = 0; i < 4; ++i) {
            const auto blade = motion_.about(piece, near);
            const auto along = blade.along();
            const Series<double, K> off = along.x * (Series<double, K>(beside_.place.y) - blade.first.y) -
                                          along.y * (Series<double, K>(beside_.place.x) - blade.first.x);
            const double next = near - off.c[0] / off.c[1] * motion_.rate();
            if (!(next >= low && next <= high)) break;
            near = next;
        }
        return {near, motion_.about(piece, near)};
    }
    /// Whether the place is within the blade, or at its end and the other side swept.
    bool is_pass(const Pose& pose) const {
        constexpr double same = 1e-9;  // of the size
        const Blade<double, K>& blade = pose.blade;
        const Vector<double> first{blade.first.x.c[0], blade.first.y.c[0]},
            along{blade.along().x.c[0], blade.along().y.c[0]};
        const double length = std::hypot(along.x, along.y), within = same * motion_.size;
        const double far = dot(beside_.place - first, along) / length;
        if (far < -within || far > length + within) return false;
        if (far > within && far < length - within) return true;
        if (!own_) return false;
        const bool at_first = far <= within;
        if ((cross(beside_.way, at_first ? along : -along) > 0) != beside_.left) return true;
        // Of two that lie on each other one stands for both: that with the swept side to the left, where one of them
        // goes back.
        const auto& end = at_first ? blade.first : blade.second;
        if (dot(Vector<double>{end.x.c[1], end.y.c[1]}, beside_.way) < 0) return !beside_.left;
        return std::tuple(at_first ? SweptCurve::Kind::first_path : SweptCurve::Kind::second_path, pose.input) <
               std::tuple(beside_.curve.kind, own_input_);
    }

    BladeMotion<K>& motion_;
    const BesideCurve& beside_;
    bool own_ = false, twice_ = false;
    double own_input_ = 0;
};

template <std::size_t K>
bool covers(BladeMotion<K>& motion, const BesideCurve& beside) {
    return PassesOver<K>(motion, beside).any();
}

}  // namespace mechwright::measuring

#include "synthesis/mechanism/cam/cam_again.h"

#include <algorithm>
#include <limits>

#include "analysis/numbers/golden_section.h"

namespace mechwright::cam::again {

namespace {

/// A place on an analytic piece, with the value of a measure there.
struct Sample {
    std::size_t segment, piece;
    double from, u, to;  ///< the place, and the ends of the piece
    double value;

    bool same_piece(const Sample& other) const { return segment == other.segment && piece == other.piece; }
};

/// A measure all along some segments, in double.
std::vector<Sample> samples_of(const RebuiltMotion& motion, bool (*wanted)(SegmentKind), const Sought& f) {
    std::vector<Sample> samples;
    for (std::size_t i = 0; i < motion.segments.size(); ++i) {
        const Segment<double>& segment = motion.plain_segments[i];
        if (!wanted(segment.kind)) continue;
        const std::size_t count = segment.kind == SegmentKind::dwell ? 1 : pieces(segment);
        const int steps = segment.kind == SegmentKind::dwell ? 1 : count > 8 ? 8 : 128;
        for (std::size_t piece = 0; piece < count; ++piece) {
            const double from = break_before(segment, piece), to = break_before(segment, piece + 1);
            for (int k = 0; k <= steps; ++k) {
                const double u = k == steps ? to : from + k * (to - from) / steps;
                samples.push_back({i, piece, from, u, to, f.rough(f.context, motion.roughly(i, piece, u))});
            }
        }
    }
    return samples;
}

/// The place near a sample, between two others, at which a measure is greatest: golden sections in double, then
/// Newton's method on the slope in fifty digits, kept in the piece.
Digits50 peak_near(const RebuiltMotion& motion, const Sample& at, double left, double right, const Sought& f) {
    const auto plain = [&](double x) { return f.rough(f.context, motion.roughly(at.segment, at.piece, x)); };
    Digits50 u = greatest_between(plain, left, right);
    const Digits50 width = at.to - at.from, fine_step = 1e-6 * width;
    // Newton's method squares what is left: after so short a step none of the digits that count changes.
    const Digits50 short_step = 1e-8 * width;
    for (int step = 0; step < 3; ++step) {
        const auto slope = derivatives<Digits50>([&](const Digits50& t) {
            const Digits50 x = u + t * fine_step / Step<Digits50>::first;
            return f.fine(f.context, motion.here(at.segment, at.piece, x));
        });
        if (!(slope.second < 0)) break;
        const Digits50 next =
            std::clamp<Digits50>(u - slope.first / slope.second * (fine_step / Step<Digits50>::first), at.from, at.to);
        const Digits50 moved = abs(next - u);
        u = next;
        if (moved <= short_step) break;
    }
    return u;
}

}  // namespace

Digits50 find_greatest(const RebuiltMotion& motion, bool (*wanted)(SegmentKind), const Sought& f) {
    const std::vector<Sample> found = samples_of(motion, wanted, f);
    double best = -std::numeric_limits<double>::infinity(), scale = 0;
    for (const Sample& sample : found) {
        best = std::max(best, sample.value);
        scale = std::max(scale, std::abs(sample.value));
    }
    // Differences between samples that are nothing but the rounding of difference formulas in double: the measure is
    // constant there, and a few of the samples stand for all.
    const double flat = 1e-9 * scale;
    constexpr int most_flat = 3;
    int flat_ones = 0;
    Digits50 result = -std::numeric_limits<double>::infinity();
    for (std::size_t k = 0; k < found.size(); ++k) {
        const Sample& at = found[k];
        const bool has_before = k > 0 && found[k - 1].same_piece(at);
        const bool has_after = k + 1 < found.size() && found[k + 1].same_piece(at);
        if (!has_before) flat_ones = 0;
        if (has_before && found[k - 1].value > at.value) continue;
        if (has_after && found[k + 1].value >= at.value) continue;
        // A peak rises above its highest sample by less than the samples beside that fall short of it.
        const double rise =
            std::max(has_before ? at.value - found[k - 1].value : 0, has_after ? at.value - found[k + 1].value : 0);
        if (!(at.value + rise >= best - flat)) continue;
        if (rise <= flat && ++flat_ones > most_flat) continue;
        const auto fine = [&](const Digits50& u) { return f.fine(f.context, motion.here(at.segment, at.piece, u)); };
        result = std::max(result, fine(at.u));
        if (rise > flat && at.to > at.from && motion.segments[at.segment].kind != SegmentKind::dwell)
            result = std::max(result, fine(peak_near(motion, at, has_before ? found[k - 1].u : at.from,
                                                     has_after ? found[k + 1].u : at.to, f)));
    }
    return result;
}

}  // namespace mechwright::cam::again

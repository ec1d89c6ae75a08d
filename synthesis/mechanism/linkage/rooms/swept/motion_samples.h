#pragma once
/// \file
/// Samples of a blade over the strokes of a motion, and the strokes themselves: between rests of the blade, but those
/// that go over the places of another.

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

#include "synthesis/mechanism/linkage/rooms/swept/curves.h"

namespace mechwright::measuring {

/// A blade at an input with its series by the time.
template <std::size_t K>
struct BladeSample {
    double input = 0;
    Blade<double, K> blade;
};

template <std::size_t K>
Series<double, K> moved_on(const Series<double, K>& f, double time) {
    Series<double, K> g = f;
    for (std::size_t k = 0; k < K; ++k)  // Horner's scheme, once for each derivative
        for (std::size_t j = K; j-- > k;)
            g.c[j] += time * g.c[j + 1];
    return g;
}

template <std::size_t K>
class BladeMotion {
public:
    using Pose = Blade<double, K>;

    BladeMotion(linkage::Measured<double, K>& measured, const linkage::Course& course, double of_radian)
        : measured_(measured), course_(course), of_radian_(of_radian) {
        const linkage::Travel& travel = course.travel;
        const Stretch all = linkage::detail::stretch_of(course, travel.from, travel.to);
        for (const linkage::MotionPart& part : linkage::parts_of(measured.driven().laws, all))
            pieces.push_back({part.stretch, part.within, 0});
        closed = travel.whole;
        sample_all();
        if (possible && pieces.size() == 1) split_at_rests();
    }

    std::vector<SweptPiece> pieces{};
    std::vector<std::vector<BladeSample<K>>> samples{};  ///< of each piece, from end to end
    bool closed = false;                                 ///< the only stroke comes back to where it begins
    bool possible = true;
    double size = 0;   ///< how far places are from each other
    double speed = 0;  ///< the greatest

    Pose exactly(std::size_t piece, double input) { return blade_at(measured_, course_, input, pieces[piece].within); }
    /// From the sample next to it.
    Pose about(std::size_t piece, double input) const {
        const auto& all = samples[piece];
        const auto after = std::lower_bound(all.begin() + 2, all.end() - 2, input,
                                            [](const BladeSample<K>& one, double x) { return one.input < x; });
        const auto& nearest = input - (after - 1)->input < after->input - input ? *(after - 1) : *after;
        const double time = (input - nearest.input) / measured_.rate();
        const auto on = [&](const Vector<Series<double, K>>& at) {
            return Vector<Series<double, K>>{moved_on(at.x, time), moved_on(at.y, time)};
        };
        return {on(nearest.blade.first), on(nearest.blade.second)};
    }
    double rate() const { return measured_.rate(); }
    /// Whether an input is between a limit of a piece and the sample next to it, where series are of no use.
    bool is_beside_limit(std::size_t piece, double input) const {
        const Stretch& stretch = pieces[piece].stretch;
        const auto& all = samples[piece];
        return (stretch.root_at_from && input < all[1].input) ||
               (stretch.root_at_to && input > all[all.size() - 2].input);
    }
    /// Calls look(before, after) for neighbouring samples between two inputs of a piece. Its ends are samples there,
    /// but what is beside them where the blade rests or becomes infinitely fast.
    template <class Look>
    void for_steps(std::size_t piece, double from, double to, const Look& look) {
        constexpr double beside = 0x1p-17;
        const Stretch& stretch = pieces[piece].stretch;
        const auto& all = samples[piece];
        const bool beside_first = stretch.root_at_from || is_rest(all.front().blade),
                   beside_last = stretch.root_at_to || is_rest(all.back().blade);
        const double first = beside_first ? std::max(from, stretch.at(beside)) : from,
                     last = beside_last ? std::min(to, stretch.at(1 - beside)) : to;
        BladeSample<K> before{first, exactly(piece, first)};
        for (const BladeSample<K>& sample : all) {
            if (sample.input <= first) continue;
            if (sample.input >= last) break;
            look(before, sample);
            before = sample;
        }
        look(before, BladeSample<K>{last, exactly(piece, last)});
    }
    bool is_rest(const Pose& blade) const { return speed_of(blade) <= resting * speed; }

private:
    static constexpr double resting = 1e-9;  ///< of the greatest speed

    static double speed_of(const Pose& blade) {
        double sum = 0;
        for (const auto* f : {&blade.first.x, &blade.first.y, &blade.second.x, &blade.second.y})
            sum += f->c[1] * f->c[1];
        return std::sqrt(sum);
    }
    static double apart(const Pose& a, const Pose& b) {
        return std::hypot(std::hypot(a.first.x.c[0] - b.first.x.c[0], a.first.y.c[0] - b.first.y.c[0]),
                          std::hypot(a.second.x.c[0] - b.second.x.c[0], a.second.y.c[0] - b.second.y.c[0]));
    }

    void sample_all() {
        samples.clear();
        for (std::size_t i = 0; i < pieces.size(); ++i)
            samples.push_back(sampled(i));
        const auto& first = samples.front().front();
        size = speed = 0;
        for (const auto& piece : samples)
            for (const auto& sample : piece) {
                const double far = apart(sample.blade, first.blade), fast = speed_of(sample.blade);
                possible = possible && std::isfinite(far);
                size = std::max(size, far);
                const bool end = &sample == &piece.front() || &sample == &piece.back();
                if (!end && std::isfinite(fast)) speed = std::max(speed, fast);
            }
        const auto long_by = first.blade.along();
        size = std::max(size, std::hypot(long_by.x.c[0], long_by.y.c[0]));
    }
    std::vector<BladeSample<K>> sampled(std::size_t piece) {
        constexpr std::size_t fewest = 32, most = 1 << 13;
        const Stretch& stretch = pieces[piece].stretch;
        const auto count = std::clamp<std::size_t>(
            static_cast<std::size_t>(std::ceil(of_radian_ * stretch.length() / measured_.unit_of_input())), fewest,
            most);
        std::vector<BladeSample<K>> all;
        for (std::size_t i = 0; i <= count; ++i) {
            const double s = static_cast<double>(i) / static_cast<double>(count);
            const double input = stretch.at(s);
            const bool at_first = i == 0 && stretch.root_at_from, at_last = i == count && stretch.root_at_to;
            if (at_first || at_last) {
                const auto at = [&](std::size_t signal) {
                    return Series<double, K>(linkage::value_at_limit(measured_, {signal, 0}, course_, at_last));
                };
                all.push_back({input, {{at(0), at(1)}, {at(2), at(3)}}});
            } else {
                all.push_back({input, exactly(piece, input)});
            }
        }
        return all;
    }

    /// Where the speed of both ends is least between samples, and zero.
    std::vector<double> rests() {
        std::vector<double> found;
        const auto& all = samples.front();
        const std::size_t last = all.size() - 1;
        const auto squared = [](const Pose& blade) {
            Series<double, K> sum(0);
            for (const auto* f : {&blade.first.x, &blade.first.y, &blade.second.x, &blade.second.y})
                sum = sum + slope_of(*f) * slope_of(*f);
            return sum;
        };
        for (std::size_t i = closed ? 0 : 1; i < last; ++i) {
            const double before = speed_of(all[i > 0 ? i - 1 : last - 1].blade), here = speed_of(all[i].blade);
            if (!(here <= before && here < speed_of(all[i + 1].blade)) || here > 0.1 * speed) continue;
            double input = all[i].input;
            for (int step = 0; step < 8; ++step) {
                const auto w = squared(exactly(0, input));
                const double by = -w.derivative(1) / w.derivative(2) * measured_.rate();
                if (!(std::abs(by) < 2 * (all[i + 1].input - all[i].input))) break;
                input += by;
            }
            if (is_rest(exactly(0, input))) found.push_back(input);
        }
        return found;
    }
    void split_at_rests() {
        const std::vector<double> at = rests();
        if (at.empty()) return;
        const SweptPiece whole = pieces.front();
        pieces.clear();
        std::vector<double> ends = at;
        if (closed)
            ends.push_back(at.front() + course_.period());
        else {
            ends.insert(ends.begin(), whole.stretch.from);
            ends.push_back(whole.stretch.to);
        }
        for (std::size_t i = 0; i + 1 < ends.size(); ++i)
            pieces.push_back({{ends[i], ends[i + 1], whole.stretch.root_at_from && ends[i] == whole.stretch.from,
                               whole.stretch.root_at_to && ends[i + 1] == whole.stretch.to},
                              whole.within,
                              i});
        closed = false;
        sample_all();
        drop_repeated();
    }
    /// Whether all poses of a stroke are passed by another.
    bool repeats(std::size_t stroke, std::size_t other) {
        constexpr int looks = 9;
        constexpr double same = 1e-9;  // of the size
        const auto& all = samples[other];
        for (int k = 0; k < looks; ++k) {
            const Pose pose = exactly(stroke, pieces[stroke].stretch.at((k + 0.5) / looks));
            const auto nearest = std::min_element(all.begin(), all.end(), [&](const auto& a, const auto& b) {
                return apart(a.blade, pose) < apart(b.blade, pose);
            });
            double input = nearest->input;
            double least = apart(nearest->blade, pose);
            // From where it rests, or becomes infinitely fast, no step leads on.
            if (nearest == all.begin()) input = 0.5 * (input + all[1].input);
            if (nearest == all.end() - 1) input = 0.5 * (input + (nearest - 1)->input);
            const auto pose_at = [&](double x) {
                return is_beside_limit(other, x) ? exactly(other, x) : about(other, x);
            };
            for (int step = 0; step < 24 && least > same * size; ++step) {
                const Pose there = pose_at(input);
                double slope = 0, bend = 0;
                const auto add = [&](const Series<double, K>& a, const Series<double, K>& b) {
                    slope += (a.c[0] - b.c[0]) * a.c[1];
                    bend += a.c[1] * a.c[1];
                };
                add(there.first.x, pose.first.x);
                add(there.first.y, pose.first.y);
                add(there.second.x, pose.second.x);
                add(there.second.y, pose.second.y);
                // No farther than half of the way to an end.
                const double next = input - slope / bend * measured_.rate();
                input = std::clamp(next, 0.5 * (input + all.front().input), 0.5 * (input + all.back().input));
                least = std::min(least, apart(pose_at(input), pose));
            }
            if (!(least <= same * size)) return false;
        }
        return true;
    }
    void drop_repeated() {
        std::vector<std::size_t> kept;
        std::vector<std::size_t> order(pieces.size());
        for (std::size_t i = 0; i < order.size(); ++i)
            order[i] = i;
        std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return way(a) > way(b); });
        for (const std::size_t i : order)
            if (std::none_of(kept.begin(), kept.end(), [&](std::size_t k) { return repeats(i, k); })) kept.push_back(i);
        std::sort(kept.begin(), kept.end());
        for (std::size_t i = 0; i < kept.size(); ++i) {
            pieces[i] = pieces[kept[i]];
            samples[i] = samples[kept[i]];
        }
        pieces.resize(kept.size());
        samples.resize(kept.size());
    }
    /// How far both ends go along a stroke.
    double way(std::size_t piece) const {
        double sum = 0;
        for (std::size_t i = 0; i + 1 < samples[piece].size(); ++i)
            sum += apart(samples[piece][i].blade, samples[piece][i + 1].blade);
        return sum;
    }

    linkage::Measured<double, K>& measured_;
    const linkage::Course& course_;
    double of_radian_;
};

}  // namespace mechwright::measuring

// Extremes of what is measured: a look at all samples in doubles, then Newton's method on differences of fifty digits.

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "synthesis/mechanism/linkage/again/measured.h"

namespace mechwright::again {

namespace {

/// Where the greatest value of f, or of its negative, lies between two inputs: golden section. At a cusp, where a point
/// comes to rest or pins meet, there is no derivative.
Extreme by_golden_section(const Measured& f, SignalsAgain<Digits50>& signals, const Vector<Digits50>& between,
                          double sign) {
    constexpr int steps = 80;
    const Digits50 golden = (3 - sqrt(Digits50(5))) / 2;
    Digits50 from = between.x, to = between.y, a = from + golden * (to - from), b = to - golden * (to - from);
    Digits50 at_a = f.measure(signals, 0, a), at_b = f.measure(signals, 0, b);
    for (int i = 0; i < steps; ++i)
        if (sign * at_a > sign * at_b) {
            to = std::exchange(b, a);
            at_b = at_a;
            a = from + golden * (to - from);
            at_a = f.measure(signals, 0, a);
        } else {
            from = std::exchange(a, b);
            at_a = at_b;
            b = to - golden * (to - from);
            at_b = f.measure(signals, 0, b);
        }
    return sign * at_a > sign * at_b ? Extreme{a, at_a} : Extreme{b, at_b};
}

/// From a sample at which it is extreme among its neighbours to where its derivative vanishes, or to a cusp.
Extreme polished(const Measured& f, double left, double middle, double right, double sign) {
    constexpr double settled = 1e-16, varies = 1e-6;
    SignalsAgain<Digits50> signals = f.precise(middle);
    Digits50 x = middle;
    bool found = false;
    for (int i = 0; i < 8 && !found; ++i) {
        const Digits50 step = f.measure(signals, 1, x) / f.measure(signals, 2, x);
        if (!isfinite(step) || x - step < left || x - step > right) break;
        x -= step;
        found = abs(step) < settled * signals.follower.unit();
    }
    const Extreme smooth{x, f.measure(signals, 0, x)};
    const double low = f.seen(left), high = f.seen(right);
    if (found || !(std::abs(low - f.seen(middle)) > varies * std::abs(low)) ||
        !(std::abs(high - f.seen(middle)) > varies * std::abs(high)))
        return smooth;
    return by_golden_section(f, signals, {left, right}, sign);
}

/// At an end of a part of the motion, or between it and its neighbour among the samples where that is better.
Extreme polished_end(const Measured& f, double end, double neighbour, double sign) {
    const Extreme at_end{end, f.at(end)};
    // On a short piece differences of doubles need all their digits, and have none beside its ends.
    const auto seen_at = [&](double at) {
        return sign * (f.is_on_piece() ? f.at(at).convert_to<double>() : f.seen(at));
    };
    const double seen_at_end = seen_at(end);
    double best = end, most = seen_at_end;
    for (const double share : {0x1p-12, 0x1p-6, 0.25})
        if (const double at = end + share * (neighbour - end), seen = seen_at(at); seen > most) {
            best = at;
            most = seen;
        }
    if (best == end) return at_end;
    const Extreme inside = polished(f, std::min(end, neighbour), best, std::max(end, neighbour), sign);
    return sign * inside.value > sign * at_end.value || isnan(at_end.value) ? inside : at_end;
}

}  // namespace

namespace {

/// Inputs of a piece at which it is looked at: the samples in it, and its ends; some more between `breaks`, where there
/// may be few.
std::vector<double> inputs_to_look_at(const Scan& scan, const Vector<double>& piece, bool breaks) {
    constexpr int fewest = 16;
    const auto [from, to] = piece;
    std::vector<double> x{from};
    for (const double at : scan.at)
        if (at > from && at < to) x.push_back(at);
    if (to > from) x.push_back(to);
    if (!breaks || x.size() >= fewest) return x;
    x = {from};
    for (int i = 1; i < fewest; ++i)
        x.push_back(from + (to - from) * i / fewest);
    x.push_back(to);
    return x;
}

/// Of a piece that is constant to the rounding of differences of doubles every so manieth is looked at: no law has an
/// acceleration, or a jerk, that is nearly constant and not quite. 1 of any other.
std::size_t thinned(const std::vector<double>& seen, bool breaks) {
    constexpr double rounding = 1e-7;
    constexpr std::size_t some = 4;
    const auto [least, greatest] = std::minmax_element(seen.begin(), seen.end());
    const bool flat = breaks && *greatest - *least <= rounding * (1 + std::abs(*greatest));
    return flat && seen.size() > some ? seen.size() / some : 1;
}

}  // namespace

std::vector<Vector<double>> between_breaks(const Scan& scan, const std::vector<Vector<double>>& parts) {
    const auto laws = laws_in<double>(scan.model.drives);
    std::vector<Vector<double>> pieces;
    for (const auto& [from, to] : parts)
        for (const linkage::MotionPart& part : linkage::parts_of(laws, {from, to}))
            pieces.push_back({part.stretch.from, part.stretch.to});
    return pieces;
}

std::vector<Measured> on_each(const Measured& f, const std::vector<Vector<double>>& parts,
                              const std::vector<Vector<double>>& pieces) {
    std::vector<Measured> all;
    for (const Vector<double>& piece : pieces)
        all.push_back(pieces.size() > parts.size() ? f.on(piece) : f);
    return all;
}

Extreme extreme(const Measured& of_all, const std::vector<Vector<double>>& parts, double sign) {
    struct Candidate {
        double left, at, right, seen;
        const Measured* f;
    };
    const std::vector<Vector<double>> pieces = between_breaks(of_all.scan, parts);
    const std::vector<Measured> on_pieces = on_each(of_all, parts, pieces);
    std::vector<Candidate> candidates;
    double best = -std::numeric_limits<double>::infinity(), worst = -best;
    for (std::size_t k = 0; k < pieces.size(); ++k) {
        const Measured& f = on_pieces[k];
        std::vector<double> x = inputs_to_look_at(f.scan, pieces[k], pieces.size() > parts.size());
        const bool breaks = pieces.size() > parts.size();
        std::vector<double> seen;
        for (const double at : x) {
            const bool end = at == x.front() || at == x.back();
            seen.push_back(sign * (breaks && end ? f.at(at).convert_to<double>() : f.seen(at)));
        }
        const std::size_t every_of_piece = thinned(seen, breaks);
        for (std::size_t i = 0; i < x.size(); ++i) {
            const bool first = i == 0, last = i + 1 == x.size();
            if (std::isfinite(seen[i])) {
                best = std::max(best, seen[i]);
                worst = std::min(worst, seen[i]);
            }
            if (!first && !last && i % every_of_piece != 0) continue;
            // At the very ends of a motion doubles may see nothing.
            if (first || last || (!(seen[i] < seen[i - 1]) && !(seen[i] < seen[i + 1])))
                candidates.push_back({first ? x[i] : x[i - 1], x[i], last ? x[i] : x[i + 1], seen[i], &f});
        }
    }
    // What is constant to rounding has an extreme at every sample: some of them tell what there is to be told.
    constexpr std::size_t some = 24;
    const bool flat = best - worst <= 1e-11 * (1 + std::abs(best));
    const std::size_t every = flat && candidates.size() > some ? candidates.size() / some : 1;
    Extreme found;
    for (std::size_t i = 0; i < candidates.size(); ++i) {
        constexpr double near_best = 1e-2;
        const Candidate& c = candidates[i];
        const bool end = c.left == c.at || c.right == c.at;
        const bool of_motion = c.at == c.f->scan.from() || c.at == c.f->scan.to();
        // Next to a limit doubles see little of what is at an end.
        if (!(end && (of_motion || pieces.size() == parts.size())) &&
            (c.seen < best - near_best * (best - worst) - 1e-12 || i % every != 0))
            continue;
        const Extreme one = end ? polished_end(*c.f, c.at, c.left == c.at ? c.right : c.left, sign)
                                : polished(*c.f, c.left, c.at, c.right, sign);
        if (!isnan(one.value) && (isnan(found.value) || sign * one.value > sign * found.value)) found = one;
    }
    return found;
}

}  // namespace mechwright::again

// Extremes of what is measured: found in doubles by its series at many inputs, then measured in fifty digits.

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <utility>
#include <vector>

#include "synthesis/mechanism/linkage/again/measured.h"

namespace mechwright::again {

namespace {

/// So near to a corner, or to an end of a piece, an input is at it.
double near_corner(const Scan& scan) { return 1e-9 * (scan.model.driven_by_slide() ? scan.to() - scan.from() : 1); }

/// What is measured at an input, its sign turned where the least is sought.
struct Seen {
    double at = 0;
    double value = missing;
    double slope = 0;      ///< by the input
    double curvature = 0;  ///< half of the second derivative

    bool exists() const { return std::isfinite(value) && std::isfinite(slope); }
};

Seen seen_at(const Measured& f, double input, double sign) {
    const InputSeries s = f.seen(input);
    return {input, sign * s.c[0], sign * s.c[1], sign * s.c[2]};
}

/// What is measured on a piece at inputs so close together that cubics through them show all that is near the best.
class Looks {
public:
    Looks(const Measured& f, const Vector<double>& piece, double sign) : f_(f), sign_(sign) {
        for (const double at : inputs_in(piece)) {
            const Seen next = seen_at(f, at, sign);
            if (!next.exists()) continue;
            if (!all.empty()) look_between(Seen(all.back()), next, deepest);
            add(next);
        }
    }
    std::vector<Seen> all{};
    double best = -std::numeric_limits<double>::infinity(), worst = -best;

private:
    static constexpr int deepest = 12;

    /// The samples in it, so many at least, and some close to its ends, beside which there may be a limit or a corner.
    std::vector<double> inputs_in(const Vector<double>& piece) const {
        constexpr int fewest = 16;
        const auto [from, to] = piece;
        std::vector<double> x;
        for (const double at : f_.scan.at)
            if (at > from && at < to) x.push_back(at);
        if (x.size() < fewest) {
            x.clear();
            for (int i = 1; i < fewest; ++i)
                x.push_back(from + (to - from) * i / fewest);
        }
        const double first = x.front() - from, last = to - x.back();
        const double least = f_.may_have_corner_at(from) ? 0x1p-8 : 0x1p-20,
                     least_at_end = f_.may_have_corner_at(to) ? 0x1p-8 : 0x1p-20;
        for (const double share : {0x1p-4, 0x1p-8, 0x1p-12, 0x1p-16, 0x1p-20}) {
            if (share >= least) x.push_back(from + share * first);
            if (share >= least_at_end) x.push_back(to - share * last);
        }
        // So close to the end of a motion that is no cycle differences have no digits: the end itself tells what is
        // there.
        const double close = f_.scan.full_turn() ? 0 : 1e-6 * (f_.scan.model.driven_by_slide() ? to - from : 1);
        std::erase_if(x, [&](double at) {
            return (from == f_.scan.from() && at - from < close) || (to == f_.scan.to() && to - at < close);
        });
        std::sort(x.begin(), x.end());
        return x;
    }
    void add(const Seen& seen) {
        best = std::max(best, seen.value);
        worst = std::min(worst, seen.value);
        all.push_back(seen);
    }
    /// Looks in the middle, and on both sides of it where it is not as the neighbours say and near the best.
    void look_between(const Seen& left, const Seen& right, int depth) {
        constexpr double as_said = 1e-9;
        const double way = right.at - left.at;
        const Seen middle = seen_at(f_, left.at + 0.5 * way, sign_);
        if (!middle.exists()) return;
        const double said = 0.5 * (left.value + right.value) + 0.125 * way * (left.slope - right.slope);
        const double missed = std::abs(middle.value - said);
        const double most = std::max({left.value, middle.value, right.value});
        const bool deeper = depth > 0 && missed > as_said * (1 + std::abs(most)) && most + 8 * missed > best;
        best = std::max(best, most);
        if (deeper) look_between(left, middle, depth - 1);
        add(middle);
        if (deeper) look_between(middle, right, depth - 1);
    }

    const Measured& f_;
    double sign_;
};

/// A place at which it may be greatest.
struct Candidate {
    const Measured* f;
    Seen left, right;       ///< between which it is stationary; alike at an end of a piece
    double most = missing;  ///< no more is expected there
};

/// Where it is stationary between two inputs, as doubles say: Newton's method with halving.
double stationary_between(const Measured& f, const Seen& left, const Seen& right, double sign) {
    constexpr int most_steps = 60;
    double from = left.at, to = right.at, x = from + 0.5 * (to - from);
    for (int i = 0; i < most_steps; ++i) {
        const Seen here = seen_at(f, x, sign);
        if (!here.exists() || here.slope == 0) break;
        (here.slope > 0 ? from : to) = x;
        const double newton = x - here.slope / (2 * here.curvature);
        const double next = newton > from && newton < to ? newton : from + 0.5 * (to - from);
        const bool settled = std::abs(next - x) <= 4 * std::numeric_limits<double>::epsilon() * (1 + std::abs(x));
        x = next;
        if (settled) break;
    }
    return x;
}

/// There in fifty digits, one step of Newton's method nearer to where it is stationary.
Extreme measured_at(const Measured& f, const Seen& left, const Seen& right, double sign) {
    const double near = stationary_between(f, left, right, sign);
    SignalsAgain<Digits50> signals = f.precise(near);
    const Digits50 x = near, step = f.measure(signals, 1, x) / f.measure(signals, 2, x);
    const Extreme here{x, f.measure(signals, 0, x)};
    if (!isfinite(step) || !(x - step > left.at && x - step < right.at)) return here;
    const Extreme nearer{x - step, f.measure(signals, 0, x - step)};
    return sign * nearer.value < sign * here.value ? here : nearer;
}

/// What is seen nearest to a limit at which the motion ends.
struct BesideLimit {
    const Measured* f;
    Seen seen;
    bool last;

    double slope_from_limit() const { return last ? -seen.slope : seen.slope; }
    /// No more is expected between them.
    double most() const {
        const double end = last ? f->scan.to() : f->scan.from();
        return seen.value + 2 * std::abs(end - seen.at) * std::abs(seen.slope);
    }
};

/// The greatest between a limit and what is seen nearest to it, where it rises from both: in fifty digits, as doubles
/// have none there.
Extreme greatest_beside(const BesideLimit& beside, double sign) {
    constexpr int most_steps = 40;
    const Measured& f = *beside.f;
    const std::array<Digits50, 2> ends{f.scan.exact_end(false), f.scan.exact_end(true)};
    const Digits50 end = ends[beside.last ? 1 : 0];
    const auto input = [&](const Digits50& way) { return Digits50(beside.last ? end - way : end + way); };
    const auto rises = [&](const Digits50& way) {
        const Digits50 slope = sign * f.between(ends, input(way), 1);
        return beside.last ? slope < 0 : slope > 0;
    };
    Digits50 far = abs(end - beside.seen.at), near = far * Digits50("1e-12");
    if (!rises(near)) return {};  // the greatest is the limit itself
    for (int i = 0; i < most_steps; ++i) {
        const Digits50 middle = sqrt(near * far);
        (rises(middle) ? near : far) = middle;
    }
    return {input(near), f.between(ends, input(near))};
}

/// Those of a piece but for its ends. What is constant to rounding is stationary everywhere: one of these is enough.
void add_stationary(const Measured& f, const Looks& looks, std::vector<Candidate>& candidates) {
    constexpr double rounding = 1e-12;
    const std::vector<Seen>& seen = looks.all;
    if (looks.best - looks.worst <= rounding * (1 + std::abs(looks.best))) {
        if (!seen.empty()) candidates.push_back({&f, seen[seen.size() / 2], seen[seen.size() / 2], looks.best});
        return;
    }
    for (std::size_t i = 0; i + 1 < seen.size(); ++i) {
        const Seen &left = seen[i], &right = seen[i + 1];
        if (!(left.slope >= 0) || !(right.slope <= 0)) continue;
        const double way = right.at - left.at;
        candidates.push_back(
            {&f, left, right, std::max(left.value, right.value) + way * std::min(left.slope, -right.slope)});
    }
}

/// Where a full turn begins and ends there may be one.
bool has_corner_at_seam(const Measured& f) { return f.scan.full_turn() && has_corner_at(f, f.scan.from()); }

/// Where the vector whose size a signal is, which is not constant, vanishes inside a piece.
void add_corners(const Scan& scan, const linkage::Signal& size_of, const Vector<double>& piece, bool whole,
                 std::vector<double>& corners) {
    constexpr double vanishes = 1e-9, moves = 1e-6;  // of the greatest
    const double within = whole ? linkage::by_itself : 0.5 * (piece.x + piece.y);
    struct Motion {
        double at, growth, size, slope, step;
    };
    // The square of the size is least where growth, half its derivative, vanishes.
    const auto at = [&](double input) -> Motion {
        const SeriesSignals* signals = scan.look(input, within);
        if (signals == nullptr) return {input, missing, missing, missing, missing};
        const Vector<InputSeries> v = signals->vector(size_of);
        const Vector<double> value{v.x.c[0], v.y.c[0]}, slope{v.x.c[1], v.y.c[1]};
        const double growth = dot(value, slope), square = dot(slope, slope);
        return {input, growth, std::hypot(value.x, value.y), std::sqrt(square), growth / square};
    };
    std::vector<Motion> seen;
    double size = 0, slope = 0;
    for (const double input : scan.at)
        if (input >= piece.x && input <= piece.y) {
            seen.push_back(at(input));
            if (std::isfinite(seen.back().size)) size = std::max(size, seen.back().size);
            if (std::isfinite(seen.back().slope)) slope = std::max(slope, seen.back().slope);
        }
    for (std::size_t i = 0; i + 1 < seen.size(); ++i) {
        if (!(seen[i].growth <= 0) || !(seen[i + 1].growth >= 0)) continue;
        constexpr int most_steps = 20;
        Motion here = seen[i].size < seen[i + 1].size ? seen[i] : seen[i + 1];
        for (int k = 0; k < most_steps && std::isfinite(here.step); ++k) {
            const double last = here.at;
            here = at(std::clamp(here.at - here.step, seen[i].at, seen[i + 1].at));
            if (here.at == last) break;
        }
        const bool inside = here.at - piece.x > near_corner(scan) && piece.y - here.at > near_corner(scan);
        if (inside && here.size <= vanishes * size && here.slope > moves * slope) corners.push_back(here.at);
    }
}

}  // namespace

bool has_corner_at(const Measured& f, double input) {
    const SeriesSignals* signals = f.scan.look(input);
    return signals != nullptr && std::any_of(f.sizes.begin(), f.sizes.end(), [&](std::size_t size) {
               const Vector<InputSeries> v = signals->vector(f.scan.model.signals[size]);
               const double slope = std::hypot(v.x.c[1], v.y.c[1]);
               return slope > 0 && std::hypot(v.x.c[0], v.y.c[0]) <= near_corner(f.scan) * slope;
           });
}

std::vector<Vector<double>> between_breaks(const Scan& scan, const std::vector<Vector<double>>& parts) {
    const auto laws = laws_in<double>(scan.model.drives);
    std::vector<Vector<double>> pieces;
    for (const auto& [from, to] : parts)
        for (const linkage::MotionPart& part : linkage::parts_of(laws, {from, to}))
            pieces.push_back({part.stretch.from, part.stretch.to});
    return pieces;
}

std::vector<Vector<double>> between_corners(const Measured& f, const std::vector<Vector<double>>& parts) {
    std::vector<Vector<double>> pieces;
    const std::vector<Vector<double>> smooth = between_breaks(f.scan, parts);
    for (const Vector<double>& piece : smooth) {
        std::vector<double> ends{piece.x, piece.y};
        for (const std::size_t size : f.sizes)
            add_corners(f.scan, f.scan.model.signals[size], piece, smooth.size() == parts.size(), ends);
        std::sort(ends.begin(), ends.end());
        for (std::size_t i = 0; i + 1 < ends.size(); ++i)
            if (ends[i] < ends[i + 1]) pieces.push_back({ends[i], ends[i + 1]});
    }
    return pieces;
}

std::vector<Measured> on_each(const Measured& f, const std::vector<Vector<double>>& parts,
                              const std::vector<Vector<double>>& pieces) {
    // A break may be the end of a part.
    const auto& drives = f.scan.model.drives;
    const bool any =
        pieces.size() > parts.size() || has_corner_at_seam(f) ||
        std::any_of(drives.begin(), drives.end(), [](const auto& drive) { return drive.motion != nullptr; });
    std::vector<Measured> all;
    for (const Vector<double>& piece : pieces)
        all.push_back(any && piece.x < piece.y ? f.on(piece) : f);
    return all;
}

Extreme extreme(const Measured& f, const std::vector<Vector<double>>& parts, double sign) {
    const std::vector<Vector<double>> pieces = between_corners(f, parts);
    const std::vector<Measured> on_pieces = on_each(f, parts, pieces);
    std::vector<Candidate> candidates;
    std::vector<BesideLimit> beside_limits;
    for (std::size_t k = 0; k < pieces.size(); ++k) {
        const Measured& on = on_pieces[k];
        if (!(pieces[k].x < pieces[k].y)) {
            candidates.push_back({&on, {pieces[k].x}, {pieces[k].x}, std::numeric_limits<double>::infinity()});
            continue;
        }
        const Looks looks(on, pieces[k], sign);
        add_stationary(on, looks, candidates);
        // Doubles see nothing at an end itself, and next to a limit little.
        const auto& seen = looks.all;
        for (const bool last : {false, true}) {
            const double end = last ? pieces[k].y : pieces[k].x;
            const bool of_motion = end == f.scan.from() || end == f.scan.to() || seen.empty();
            double most = std::numeric_limits<double>::infinity();
            if (!of_motion) {
                const Seen& beside = last ? seen.back() : seen.front();
                const double way = std::abs(end - beside.at);
                most = beside.value + 2 * way * std::abs(beside.slope) + 1e-9 * (1 + std::abs(beside.value));
            }
            candidates.push_back({&on, {end}, {end}, most});
            if (!of_motion || f.scan.full_turn() || seen.empty()) continue;
            const BesideLimit beside{&on, last ? seen.back() : seen.front(), last};
            if (beside.slope_from_limit() < 0) beside_limits.push_back(beside);
        }
    }
    // The most promising first, until the rest promise no more than was found. What is constant to rounding is
    // stationary everywhere: some of these places tell what there is to be told.
    std::stable_sort(candidates.begin(), candidates.end(),
                     [](const Candidate& a, const Candidate& b) { return a.most > b.most; });
    constexpr std::size_t most_tries = 64;
    Extreme found;
    for (std::size_t i = 0; i < candidates.size(); ++i) {
        const Candidate& c = candidates[i];
        if (!isnan(found.value) && (i >= most_tries || c.most < sign * found.value)) break;
        const bool end = c.left.at == c.right.at;
        const Extreme one = end ? Extreme{c.left.at, c.f->at(c.left.at)} : measured_at(*c.f, c.left, c.right, sign);
        if (!isnan(one.value) && (isnan(found.value) || sign * one.value > sign * found.value)) found = one;
    }
    for (const BesideLimit& beside : beside_limits) {
        if (beside.most() < sign * found.value) continue;
        const Extreme one = greatest_beside(beside, sign);
        if (!isnan(one.value) && sign * one.value > sign * found.value) found = one;
    }
    return found;
}

namespace {

/// What is seen on a piece at many inputs, close together at its ends.
std::vector<Seen> seen_on(const Measured& f, const Vector<double>& piece) {
    constexpr int steps = 600;
    std::vector<Seen> all;
    for (int i = 1; i < steps; ++i) {
        const double share = 0.5 - 0.5 * std::cos(std::numbers::pi * i / steps);
        const Seen next = seen_at(f, piece.x + (piece.y - piece.x) * share, 1);
        if (next.exists()) all.push_back(next);
    }
    return all;
}

Extreme extreme_between(const Measured& f, const Seen& left, const Seen& right) {
    return measured_at(f, left, right, left.slope > 0 ? 1 : -1);
}

}  // namespace

std::vector<Extreme> every_extreme(const Measured& f, const std::vector<Vector<double>>& parts, bool is_cycle) {
    const std::vector<Vector<double>> pieces = between_corners(f, parts);
    const std::vector<Measured> on_pieces = on_each(f, parts, pieces);
    std::vector<Extreme> found;
    const auto add_end = [&](std::size_t k, double input) { found.push_back({input, on_pieces[k].at(input)}); };
    const double period = f.scan.to() - f.scan.from();
    // Where the cycle begins anew nothing breaks.
    const auto is_seam = [&](std::size_t k) {
        return !on_pieces[k].is_on_piece() && pieces[k].x == f.scan.from() && pieces[k - 1].y == f.scan.to();
    };
    std::optional<Seen> first, last;
    for (std::size_t k = 0; k < pieces.size(); ++k) {
        if (k == 0 && !is_cycle) add_end(k, pieces[k].x);
        const std::vector<Seen> seen = seen_on(on_pieces[k], pieces[k]);
        if (seen.empty()) return {};
        if (last && last->slope * seen.front().slope < 0) {
            last->at -= is_seam(k) ? period : 0;
            is_seam(k) ? found.push_back(extreme_between(f, *last, seen.front())) : add_end(k, pieces[k].x);
        }
        for (std::size_t i = 0; i + 1 < seen.size(); ++i)
            if (seen[i].slope * seen[i + 1].slope < 0)
                found.push_back(extreme_between(on_pieces[k], seen[i], seen[i + 1]));
        if (!first) first = seen.front();
        last = seen.back();
    }
    if (!last) return {};
    if (!is_cycle) {
        add_end(pieces.size() - 1, pieces.back().y);
    } else if (last->slope * first->slope < 0) {
        first->at += period;
        found.push_back(extreme_between(f, *last, *first));
    }
    return found;
}

}  // namespace mechwright::again

#pragma once
/// \file
/// The quantities of a function generator as smooth components (measured.h), for any mechanism. `Generator` has
/// `static constexpr std::size_t reads`, how many arguments it has, and `template <class T> static T error(const
/// std::array<T, reads>&, std::size_t assembly, const T& share, const T& part)`: the structural error, its output at a
/// share of the input's range less what the part of the output's range asks for.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "analysis/numbers/dual.h"
#include "analysis/numbers/extremes.h"
#include "synthesis/mechanism/measured.h"
#include "synthesis/target/function/formulas_again.h"
#include "synthesis/target/function/function_target.h"
#include "synthesis/target/function/resolved_nodes.h"

namespace mechwright {

inline bool has_samples(const FunctionTarget* f) { return f != nullptr && !f->parts.empty(); }

/// Where there is no function, the output that is asked for stays the same.
template <class T>
T part_of(const FunctionTarget* f, const T& share) {
    return f != nullptr ? part_at(*f, share) : T(0.0);
}

/// Even steps over the range, ends included, between which extremes of the error are sought.
inline const std::array<double, 129>& shares_of_range() {
    static const auto shares = [] {
        std::array<double, 129> all;
        for (std::size_t i = 0; i < all.size(); ++i)
            all[i] = static_cast<double>(i) / static_cast<double>(all.size() - 1);
        return all;
    }();
    return shares;
}

/// Whether an error is an angle in (-pi, pi], which jumps by a turn where the output is half a turn off. The generator
/// then says `static constexpr bool wraps = true`.
template <class Generator>
concept WrapsAround = requires {
    requires Generator::wraps;
};

/// The last share before the error jumps by a turn, of one that does between two shares.
template <class Error>
double share_before_jump(const Error& error, double before, double after) {
    const double first = error(before);
    for (double middle = 0.5 * (before + after); before < middle && middle < after; middle = 0.5 * (before + after))
        (std::abs(error(middle) - first) > std::numbers::pi ? after : before) = middle;
    return before;
}

/// Reports to `found` all extremes of the error in their order along the range: its ends, where its slope vanishes, and
/// where it is half a turn.
template <class Generator, class Found>
void for_each_extreme(const FunctionTarget* f, const std::array<double, Generator::reads>& x, std::size_t assembly,
                      const Found& found) {
    if (has_samples(f)) {
        for (const Vector<double>& s : f->parts)
            found(ErrorExtreme{s.x, s.y, Generator::error(x, assembly, s.x, s.y), false});
        return;
    }
    using D = Dual<double, 1>;
    const auto error = [&](double share) { return Generator::error(x, assembly, share, part_of(f, share)); };
    std::array<D, Generator::reads> constant;
    std::copy(x.begin(), x.end(), constant.begin());
    const std::span<const double> grid = shares_of_range();
    ErrorExtreme last{0, 0, error(0), false};
    // A jump waits for the zeros before it, which are known some steps later.
    std::optional<double> jump;
    const auto report_jump_before = [&](double share) {
        if (!jump || *jump > share) return;
        found(ErrorExtreme{*jump, 0, error(*jump), false});
        jump.reset();
    };
    const auto pass = [&](double share, double value) {
        if (WrapsAround<Generator> && std::abs(value - last.error) > std::numbers::pi) {
            report_jump_before(share);
            jump = share_before_jump(error, std::min(last.share, share), std::max(last.share, share));
        }
        last = {share, 0, value, false};
    };
    std::size_t next = 0;
    const auto slope = [&](double share) {
        const D at = D::variable(share, 0);
        const D e = Generator::error(constant, assembly, at, part_of(f, at));
        if (next < grid.size() && share == grid[next]) {
            pass(share, e.value);
            ++next;
        }
        return e.partial[0];
    };
    found(last);
    zeros_on_grid(slope, grid, [&](double share) {
        report_jump_before(share);
        if (share > 0 && share < 1) found(ErrorExtreme{share, 0, error(share), true});
    });
    report_jump_before(1);
    found(ErrorExtreme{1, 1, error(1), false});
}

/// The greatest of them, by size, in their order along the range; fewer are filled up with the last.
template <class Generator, std::size_t count>
std::array<ErrorExtreme, count> greatest_extremes(const FunctionTarget* f,
                                                  const std::array<double, Generator::reads>& x, std::size_t assembly) {
    std::array<ErrorExtreme, count + 1> kept{};
    std::size_t known = 0;
    for_each_extreme<Generator>(f, x, assembly, [&](const ErrorExtreme& extreme) {
        kept[known++] = extreme;
        if (known <= count) return;
        const auto least = std::min_element(kept.begin(), kept.end(), [](const ErrorExtreme& a, const ErrorExtreme& b) {
            return std::abs(a.error) < std::abs(b.error);
        });
        std::copy(least + 1, kept.end(), least);
        --known;
    });
    std::array<ErrorExtreme, count> greatest;
    for (std::size_t k = 0; k < count; ++k)
        greatest[k] = kept[std::min(k, known - 1)];
    return greatest;
}

/// The greatest size of the structural error over the range: every extreme of it with the sign that makes it positive.
template <class Generator>
struct FunctionMax {
    static constexpr std::size_t reads = Generator::reads;
    static constexpr std::size_t most = 16;
    template <class T>
    static std::size_t components(const Motion& motion, const std::array<T, reads>& x, Components<T> out) {
        std::array<double, reads> plain;
        std::transform(x.begin(), x.end(), plain.begin(), [](const T& v) { return value_of(v); });
        const FunctionTarget* f = motion.function;
        const auto extremes = greatest_extremes<Generator, most>(f, plain, motion.assembly);
        for (std::size_t k = 0; k < most; ++k) {
            const ErrorExtreme& e = extremes[k];
            const auto along = [&]<class U>(const std::array<U, reads>& d, const U& share) {
                return Generator::error(d, motion.assembly, share, part_of(f, share));
            };
            // To first derivatives the place is a constant, and what is asked for there too.
            const bool moves = e.stationary && std::is_same_v<T, SecondDual<double, reads>>;
            const T error = moves ? at_stationary(x, e.share, along)
                                  : Generator::error(x, motion.assembly, T(e.share),
                                                     T(has_samples(f) ? e.part : part_of(f, e.share)));
            out[k] = e.error < 0 ? T(-error) : error;
        }
        return most;
    }
};

struct QuadratureNode {
    double share;
    double weight;
};

/// The double exponential rule of Takahasi and Mori on [0, 1]: share = 1 / (1 + exp(-pi sinh t)) at even steps of t.
inline const std::array<QuadratureNode, 61>& quadrature_nodes() {
    static const auto nodes = [] {
        std::array<QuadratureNode, 61> all;
        constexpr double step = 0.1;
        double sum = 0;
        for (std::size_t k = 0; k < all.size(); ++k) {
            const double t = step * (static_cast<double>(k) - 0.5 * static_cast<double>(all.size() - 1));
            const double decay = std::exp(-std::numbers::pi * std::sinh(t));
            all[k] = {1 / (1 + decay), std::cosh(t) * decay / ((1 + decay) * (1 + decay))};
            sum += all[k].weight;
        }
        for (QuadratureNode& node : all)
            node.weight /= sum;
        return all;
    }();
    return nodes;
}

/// Calls use(share, part, weight) so that the weighted sum is the mean over the range: of samples the mean of them,
/// else the integral.
template <class Use>
void for_each_node(const FunctionTarget& f, const Use& use) {
    if (!f.parts.empty()) {
        for (const Vector<double>& s : f.parts)
            use(s.x, s.y, 1.0 / static_cast<double>(f.parts.size()));
        return;
    }
    for (const QuadratureNode& node : quadrature_nodes())
        use(node.share, part_at(f, node.share), node.weight);
}

/// The root of the mean square of the structural error.
template <class Generator>
struct FunctionRms {
    static constexpr std::size_t reads = Generator::reads;
    static constexpr std::size_t most = 1;
    template <class T>
    static std::size_t components(const Motion& motion, const std::array<T, reads>& x, Components<T> out) {
        using std::sqrt;
        const FunctionTarget& f = *motion.function;
        T sum(0.0);
        const auto add = [&](double share, double part, double weight) {
            const T error = Generator::error(x, motion.assembly, T(share), T(part));
            sum += T(weight) * error * error;
        };
        if (has_samples(&f)) {
            for (const Vector<double>& s : f.parts)
                add(s.x, s.y, 1.0 / static_cast<double>(f.parts.size()));
        } else {
            std::array<double, reads> plain;
            std::transform(x.begin(), x.end(), plain.begin(), [](const T& v) { return value_of(v); });
            const ResolvedIntervals intervals = resolved(f, plain, motion.assembly);
            for (std::size_t k = 0; k < intervals.count; ++k)
                for_each_kronrod_node(intervals.at[k], [&](double share, double weight, double) {
                    add(share, part_at(f, share), weight);
                });
        }
        out[0] = sqrt(sum);
        return 1;
    }

private:
    static ResolvedIntervals resolved(const FunctionTarget& f, const std::array<double, reads>& x,
                                      std::size_t assembly) {
        using D = Dual<double, 1>;
        std::array<D, reads> constant;
        std::copy(x.begin(), x.end(), constant.begin());
        const auto along = [&](double share) {
            const D at = D::variable(share, 0);
            const D error = Generator::error(constant, assembly, at, part_at(f, at));
            return std::pair(error.value, error.partial[0]);
        };
        const D part = D::variable(0, 0);
        const double way = Generator::error(constant, assembly, D(0.0), part).partial[0];
        return resolved_intervals(along, std::abs(way));
    }
};

/// All extremes of the error, for reports.
template <class Generator>
std::vector<ErrorExtreme> error_extremes(const FunctionTarget* f, const std::array<double, Generator::reads>& x,
                                         std::size_t assembly) {
    std::vector<ErrorExtreme> all;
    for_each_extreme<Generator>(f, x, assembly, [&](const ErrorExtreme& extreme) { all.push_back(extreme); });
    return all;
}

/// The registry's function_extremes.
template <class Generator>
std::vector<ErrorExtreme> function_extremes_by(const FunctionTarget& f, Form form, std::span<const double> arguments) {
    return error_extremes<Generator>(&f, seeded<double, Generator::reads>(arguments), form.assembly);
}

inline bool generates_function(const Motion& motion) { return motion.function != nullptr; }

template <std::size_t count>
std::size_t always(const Motion&) {
    return count;
}

/// function-max and function-rms of a generator, measured again by `Again` (formulas_again.h). `reads` are the
/// dimensions before the scales.
template <class Generator, class Again>
std::vector<Quantity> function_quantities(const Reads& reads, Unit unit, const char* greatest, const char* mean) {
    return {{.name = "function-max",
             .unit = unit,
             .meaning = greatest,
             .reduce = Reduce::greatest,
             .reads = reads,
             .defined = generates_function,
             .components = always<FunctionMax<Generator>::most>,
             .measure = measure_by<FunctionMax<Generator>>,
             .measure_again = function_max_again<Again>,
             .section = "function"},
            {.name = "function-rms",
             .unit = unit,
             .meaning = mean,
             .reduce = Reduce::only,
             .reads = reads,
             .defined = generates_function,
             .components = always<1>,
             .measure = measure_by<FunctionRms<Generator>>,
             .measure_again = function_rms_again<Again>,
             .section = "function"}};
}

inline bool has_input_range(const Motion& motion) {
    return motion.function != nullptr || motion.followed != Followed::nothing || motion.is_range_of_use;
}

/// Whether a crank that turns from one angle to another, either way, passes a third.
inline bool passes(double from, double to, double angle) {
    constexpr double turn = 2 * std::numbers::pi;
    const double low = std::min(from, to);
    return std::ceil((low - angle) / turn) * turn + angle <= std::max(from, to);
}

/// Whether an angle that a crank does not pass is nearer to the one it starts from than to the one it ends at.
inline bool nearer_to_first(double from, double to, double angle) {
    return std::cos(angle - from) >= std::cos(angle - to);
}

/// The transmission angle over the input range, whose ends are design variables: `Transmission` has `reads`, and
/// `template <class T> static std::array<T, 4> angles(std::size_t assembly, const std::array<T, reads>&)`, which gives
/// it wherever it can be extreme. The worst is the least of the angle and its supplement.
enum class TransmissionExtreme { least, greatest, worst };

template <class Transmission, TransmissionExtreme extreme>
struct InputTransmission {
    static constexpr std::size_t reads = Transmission::reads;
    static constexpr std::size_t most = extreme == TransmissionExtreme::worst ? 8 : 4;
    template <class T>
    static std::size_t components(const Motion& motion, const std::array<T, reads>& x, Components<T> out) {
        const std::array<T, 4> angles = Transmission::angles(motion.assembly, x);
        for (std::size_t k = 0; k < angles.size(); ++k) {
            out[k] = angles[k];
            if constexpr (extreme == TransmissionExtreme::worst) out[4 + k] = std::numbers::pi - angles[k];
        }
        return most;
    }
};

/// A quantity over the input range by a formula of measured.h; not one of the contract's list, but what stands in for
/// one there, or what a search needs. `reads` are the dimensions before start and range of the input.
template <class Formula>
Quantity input_quantity(const char* name, const Reads& reads, Unit unit, Reduce reduce) {
    return {.name = name,
            .unit = unit,
            .meaning = "over the input range",
            .reduce = reduce,
            .reads = reads,
            .defined = has_input_range,
            .components = always<Formula::most>,
            .measure = measure_by<Formula>};
}

/// A formula of a limited motion (Ends) over the input range: start and range are its last arguments.
template <class Formula, std::size_t limited_family>
struct OverInput {
    static constexpr std::size_t reads = Formula::reads + 2;
    static constexpr std::size_t most = Formula::most;
    template <class T>
    static std::size_t components(const Motion& motion, const std::array<T, reads>& x, Components<T> out) {
        std::array<T, Formula::reads> own;
        std::copy_n(x.begin(), own.size(), own.begin());
        Ends<T> ends{x[own.size()], x[own.size()] + x[own.size() + 1]};
        if (value_of(ends.to) < value_of(ends.from)) std::swap(ends.from, ends.to);
        Motion over = motion;
        over.family = limited_family;
        over.full_turn = false;
        over.from = value_of(ends.from);
        over.to = value_of(ends.to);
        return Formula::components(over, own, out, ends);
    }
};

/// What stands in over the input range for a quantity by such a formula, which has so many components there.
template <class Formula, std::size_t limited_family, std::size_t count>
Quantity moving_quantity(const char* name, const Reads& reads, Unit unit, Reduce reduce, bool worst_first = false) {
    Quantity quantity = input_quantity<OverInput<Formula, limited_family>>(name, reads, unit, reduce);
    quantity.components = always<count>;
    quantity.worst_first = worst_first;
    return quantity;
}

template <class Transmission, TransmissionExtreme extreme>
Quantity input_transmission_quantity(const char* name, const Reads& reads) {
    return input_quantity<InputTransmission<Transmission, extreme>>(
        name, reads, Unit::angle, extreme == TransmissionExtreme::greatest ? Reduce::greatest : Reduce::least);
}

/// What keeps a design assembled over its input range.
template <class Margin>
Quantity input_margin_quantity(const Reads& reads) {
    return input_quantity<Margin>("assembly margin over the input range", reads, Unit::length, Reduce::least);
}

}  // namespace mechwright

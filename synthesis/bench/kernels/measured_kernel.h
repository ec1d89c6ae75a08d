#pragma once
/// \file
/// One kernel measured in every form and order: rows for the table.

#include <algorithm>
#include <cmath>
#include <limits>

#include "analysis/numbers/dual.h"
#include "analysis/numbers/second_dual.h"
#include "synthesis/bench/instructions.h"
#include "synthesis/bench/kernels/costs.h"
#include "synthesis/bench/kernels/kernel_list.h"
#include "synthesis/bench/section.h"
#include "synthesis/bench/timing.h"
#include "synthesis/mechanism/mechanism.h"

namespace mechwright::bench {

/// The form of a row: by which formulas and numbers.
namespace form {
inline constexpr std::string_view textbook = "textbook";
inline constexpr std::string_view ours = "ours";
inline constexpr std::string_view fifty = "ours, fifty digits";
}  // namespace form

/// The order of a row with derivatives by the dimensions; the others are named by the kernel.
namespace order {
inline constexpr std::string_view gradient = "gradient of order 0";
inline constexpr std::string_view hessian = "Hessian of order 0";
}  // namespace order

namespace kernel_detail {

/// Two numbers and their derivatives as one list.
template <class T>
std::vector<T> numbers_of(const Vector<T>& v) {
    return {v.x, v.y};
}
template <class T, std::size_t N>
std::vector<T> numbers_of(const Vector<Dual<T, N>>& v) {
    std::vector<T> all(v.x.partial.begin(), v.x.partial.end());
    all.insert(all.end(), v.y.partial.begin(), v.y.partial.end());
    return all;
}
template <class T, std::size_t N>
std::vector<T> numbers_of(const Vector<SecondDual<T, N>>& v) {
    std::vector<T> all(v.x.second.begin(), v.x.second.end());
    all.insert(all.end(), v.y.second.begin(), v.y.second.end());
    return all;
}

/// Correct digits of all numbers together, from none to seventeen.
inline double digits_kept(const std::vector<double>& found, const std::vector<Digits50>& exact) {
    Digits50 error = 0, size = 0;
    for (std::size_t i = 0; i < exact.size(); ++i) {
        if (!std::isfinite(found[i])) return 0;
        error += abs(Digits50(found[i]) - exact[i]);
        size += abs(exact[i]);
    }
    if (error == 0) return 17;
    return std::clamp(-std::log10(static_cast<double>(Digits50(error / size))) + 0.0, 0.0, 17.0);
}

/// The dimensions as independent variables of a number type with derivatives.
template <class Number, std::size_t N, class T>
std::array<Number, N> variables(const std::array<T, N>& x) {
    std::array<Number, N> all;
    for (std::size_t i = 0; i < N; ++i)
        all[i] = Number::variable(x[i], i);
    return all;
}
template <std::size_t N>
std::array<Digits50, N> precise(const std::array<double, N>& x) {
    std::array<Digits50, N> all;
    std::copy(x.begin(), x.end(), all.begin());
    return all;
}

template <std::size_t N>
std::array<Counted, N> counted(const std::array<double, N>& x) {
    std::array<Counted, N> all;
    std::transform(x.begin(), x.end(), all.begin(), Counted::variable);
    return all;
}

/// The textbook's gradient: central differences of its positions.
template <class Kernel>
std::array<Vector<double>, Kernel::size> differences(const typename Kernel::Input& in) {
    constexpr double step = 6e-6;
    std::array<Vector<double>, Kernel::size> all;
    for (std::size_t i = 0; i < Kernel::size; ++i) {
        auto up = in.x, down = in.x;
        const double h = step * std::max(std::abs(in.x[i]), 1e-3);
        up[i] += h;
        down[i] -= h;
        all[i] = (1 / (up[i] - down[i])) *
                 (Kernel::template textbook<0>(up, in.at) - Kernel::template textbook<0>(down, in.at));
    }
    return all;
}

template <std::size_t N>
std::vector<double> numbers_of(const std::array<Vector<double>, N>& gradient) {
    std::vector<double> all;
    for (const auto& v : gradient)
        all.push_back(v.x);
    for (const auto& v : gradient)
        all.push_back(v.y);
    return all;
}

/// A row's worth: what is called, and what it should give.
template <class Kernel>
struct Form {
    std::string_view order;
    std::string_view name;
    Piece piece;
    std::function<void()> once;  ///< for counting instructions; none: not counted
    std::function<std::vector<double>(const typename Kernel::Input&)> found;  ///< none: exact by definition
    std::function<std::vector<Digits50>(const typename Kernel::Input&)> exact;
    CallMix mix{};
};

template <class Kernel, class Call>
Form<Kernel> formed(std::string_view order, std::string_view name, const Call& call) {
    static const std::vector<typename Kernel::Input> inputs = Kernel::usual();
    Form<Kernel> f{order, name, piece([call](std::size_t k) { return call(inputs[k % usual_count]); }), {}, {}, {}};
    f.once = [call] {
        auto result = call(inputs[1]);
        benchmark::DoNotOptimize(result);
    };
    return f;
}

template <class Kernel, int order>
void add_forms(std::vector<Form<Kernel>>& all) {
    using Input = typename Kernel::Input;
    const auto exact = [](const Input& in) {
        return numbers_of(Kernel::template ours<order>(precise(in.x), Digits50(in.at)));
    };
    const auto textbook = [](const Input& in) { return Kernel::template textbook<order>(in.x, in.at); };
    const auto ours = [](const Input& in) { return Kernel::template ours<order>(in.x, in.at); };
    all.push_back(formed<Kernel>(Kernel::orders[order], form::textbook, textbook));
    all.back().found = [textbook](const Input& in) { return numbers_of(textbook(in)); };
    all.back().exact = exact;
    all.push_back(formed<Kernel>(Kernel::orders[order], form::ours, ours));
    all.back().found = [ours](const Input& in) { return numbers_of(ours(in)); };
    all.back().exact = exact;
    all.back().mix = mix_of([] {
        const Input in = Kernel::usual()[1];
        return Kernel::template ours<order>(counted(in.x), Counted::variable(in.at));
    });
    all.push_back(formed<Kernel>(Kernel::orders[order], form::fifty, [](const Input& in) {
        return Kernel::template ours<order>(precise(in.x), Digits50(in.at));
    }));
    all.back().once = nullptr;
}

template <class Kernel>
void add_derivatives(std::vector<Form<Kernel>>& all) {
    using Input = typename Kernel::Input;
    using First = Dual<double, Kernel::size>;
    using Second = SecondDual<double, Kernel::size>;
    const auto gradient = [](const Input& in) {
        return Kernel::template ours<0>(variables<First>(in.x), First(in.at));
    };
    const auto hessian = [](const Input& in) {
        return Kernel::template ours<0>(variables<Second>(in.x), Second(in.at));
    };
    const auto exact_gradient = [](const Input& in) {
        using Exact = Dual<Digits50, Kernel::size>;
        return numbers_of(Kernel::template ours<0>(variables<Exact>(precise(in.x)), Exact(Digits50(in.at))));
    };
    all.push_back(
        formed<Kernel>(order::gradient, form::textbook, [](const Input& in) { return differences<Kernel>(in); }));
    all.back().found = [](const Input& in) { return numbers_of(differences<Kernel>(in)); };
    all.back().exact = exact_gradient;
    all.push_back(formed<Kernel>(order::gradient, form::ours, gradient));
    all.back().found = [gradient](const Input& in) { return numbers_of(gradient(in)); };
    all.back().exact = exact_gradient;
    all.push_back(formed<Kernel>(order::hessian, form::ours, hessian));
    all.back().found = [hessian](const Input& in) { return numbers_of(hessian(in)); };
    all.back().exact = [](const Input& in) {
        using Exact = SecondDual<Digits50, Kernel::size>;
        return numbers_of(Kernel::template ours<0>(variables<Exact>(precise(in.x)), Exact(Digits50(in.at))));
    };
}

/// The median and the least of the digits over some inputs.
struct Kept {
    double median = std::numeric_limits<double>::quiet_NaN();
    double least = std::numeric_limits<double>::quiet_NaN();
};

template <class Kernel>
Kept kept(const Form<Kernel>& f, const std::vector<typename Kernel::Input>& inputs) {
    if (!f.found) return {};
    std::vector<double> digits;
    for (const auto& in : inputs)
        digits.push_back(digits_kept(f.found(in), f.exact(in)));
    std::sort(digits.begin(), digits.end());
    return {digits[digits.size() / 2], digits.front()};
}

inline Cell cell_of(double number) { return std::isnan(number) ? Cell() : Cell(number); }

}  // namespace kernel_detail

/// What stands in the columns that a row has beyond its names.
struct KernelNumbers {
    Timing timing;
    std::optional<long> instructions;
    CallMix mix;
    double least = std::numeric_limits<double>::quiet_NaN();  ///< seconds; NaN where there is no bound
    double chain = least;                                     ///< seconds; NaN where it is not known
    double instruction = 0;                                   ///< seconds that one takes at least
    double usual_median = std::numeric_limits<double>::quiet_NaN(), usual_least = usual_median;
    double hard_median = usual_median, hard_least = usual_median;
};

Row kernel_row(std::string_view order, std::string_view form, const KernelNumbers& numbers);

template <class Kernel>
std::vector<Row> measured_kernel(const Effort& effort) {
    using namespace kernel_detail;
    std::vector<Form<Kernel>> forms;
    add_forms<Kernel, 0>(forms);
    add_forms<Kernel, 1>(forms);
    add_forms<Kernel, 2>(forms);
    add_derivatives<Kernel>(forms);
    std::vector<Piece> pieces;
    for (const auto& f : forms)
        pieces.push_back(f.piece);
    const std::vector<Timing> timings = timed(pieces, effort.pick(5, 21), effort.pick(0.1, 1.0));
    const OperationCosts costs = scalar_costs(), latencies = scalar_latencies();
    const double instruction = instruction_cost();
    std::vector<Row> rows;
    for (std::size_t i = 0; i < forms.size() && !effort.stopped(); ++i) {
        const auto& f = forms[i];
        KernelNumbers n{timings[i], f.once ? instructions_of(f.once) : std::nullopt, f.mix};
        if (f.mix.all.sums_and_products > 0) {
            n.least = least_seconds(f.mix.all, costs);
            n.chain = chain_seconds(f.mix.chain, latencies);
        }
        n.instruction = instruction;
        const Kept usual = kept(f, Kernel::usual()), hard = kept(f, Kernel::hard_ones());
        n.usual_median = usual.median;
        n.usual_least = usual.least;
        n.hard_median = hard.median;
        n.hard_least = hard.least;
        rows.push_back(kernel_row(f.order, f.name, n));
    }
    return rows;
}

}  // namespace mechwright::bench

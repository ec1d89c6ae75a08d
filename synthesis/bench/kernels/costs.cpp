#include "synthesis/bench/kernels/costs.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

#include "synthesis/bench/timing.h"

namespace mechwright::bench {

namespace {

constexpr int repetitions = 9;
constexpr double least_time = 0.05;
constexpr long rounds = 64;
constexpr std::size_t chains = 14;

// One number or one register of them; the compiler calculates with it as with a double.
using One = double;
using Two = double __attribute__((vector_size(16)));
using Four = double __attribute__((vector_size(32)));
using Eight = double __attribute__((vector_size(64)));

/// Keeps the compiler from merging, dropping or moving what was computed, at no cost.
template <class Register>
[[gnu::always_inline]] inline void keep(Register& r) {
#if defined(__x86_64__)
    asm volatile("" : "+v"(r));
#else
    benchmark::DoNotOptimize(r);
#endif
}

[[gnu::always_inline]] inline void take_root(One& x) { x = std::sqrt(x); }
template <class Register>
[[gnu::always_inline]] inline void take_root(Register& x) {
    for (std::size_t i = 0; i < sizeof(Register) / sizeof(double); ++i)
        x[i] = std::sqrt(x[i]);
}

enum class Operation { sums_and_products, quotients, roots };

template <Operation operation, class Register>
[[gnu::always_inline]] inline void step(Register& r, const Register& y, bool sum) {
    if constexpr (operation == Operation::sums_and_products) {
        r = sum ? r + y : r * y;
    } else if constexpr (operation == Operation::quotients) {
        r = r / y;
    } else {
        take_root(r);
        r = r * y;  // does not come to 1, whose root takes less; another unit multiplies meanwhile
    }
    keep(r);
}

/// Chains side by side that stay in registers: as many as hide the latency of a sum, of a product.
template <class Register, Operation operation>
[[gnu::always_inline]] inline void steps(double* out) {
    Register a = Register{} + 1.5, b = a, c = a, d = a, e = a, f = a, g = a, h = a, i = a, j = a, l = a, m = a, n = a,
             o = a;
    Register y = Register{} + 1.3;
    keep(y);
    const auto go = [&](Register & r, bool sum) __attribute__((always_inline)) { step<operation>(r, y, sum); };
    for (long k = 0; k < rounds; ++k) {
        go(a, true), go(b, false), go(c, true), go(d, false);
        go(e, true), go(f, false), go(g, true), go(h, false);
        go(i, true), go(j, false), go(l, true), go(m, false);
        go(n, true), go(o, false);
    }
    const Register all = ((a + b) + (c + d)) + ((e + f) + (g + h)) + ((i + j) + (l + m)) + (n + o);
    *out = reinterpret_cast<const double*>(&all)[0];
}

template <Operation operation>
void one(double* out) {
    steps<One, operation>(out);
}
template <Operation operation>
void one_after_another(double* out) {
    One x = 1.5, y = 1.3;
    keep(y);
    for (long k = 0; k < rounds * static_cast<long>(chains); ++k)
        step<operation>(x, y, k % 2 == 0);
    *out = x;
}
template <Operation operation>
void baseline(double* out) {
    steps<Two, operation>(out);
}
#if defined(__x86_64__)
template <Operation operation>
[[gnu::target("avx2")]] void avx2(double* out) {
    steps<Four, operation>(out);
}
template <Operation operation>
[[gnu::target("avx512f")]] void avx512(double* out) {
    steps<Eight, operation>(out);
}
#endif

double seconds_each(void (*of)(double*), std::size_t lanes) {
    const Piece calls = [of](benchmark::State& state) {
        double out = 0;
        for (auto _ : state) {
            of(&out);
            benchmark::DoNotOptimize(out);
        }
    };
    return timed({calls}, repetitions, least_time).front().median / static_cast<double>(rounds * chains * lanes);
}

/// Calls that are independent, or of which each needs the result of the one before: that costs two sums and a product
/// more.
double seconds_of_call(double (*call)(double), bool chained) {
    const Piece calls = [call, chained](benchmark::State& state) {
        double x = 0;
        for (auto _ : state) {
            x += 2.399963229728653;  // the golden angle
            if (x > 2 * std::numbers::pi) x -= 2 * std::numbers::pi;
            if (chained)
                x += 1e-9 * call(x);
            else
                benchmark::DoNotOptimize(call(x));
        }
    };
    return timed({calls}, repetitions, least_time).front().median;
}

double sine_and_cosine(double x) { return std::sin(x) + std::cos(x); }

double angle(double x) { return std::atan2(x - 3, 1.5); }

double measured_instruction() {
    constexpr int each = 16;
    const Piece nothing = [](benchmark::State& state) {
        for (auto _ : state)
            for (long k = 0; k < rounds; ++k)
                asm volatile(
                    "nop\n nop\n nop\n nop\n nop\n nop\n nop\n nop\n"
                    "nop\n nop\n nop\n nop\n nop\n nop\n nop\n nop");
    };
    return timed({nothing}, repetitions, least_time).front().median / static_cast<double>(rounds * each);
}

OperationCosts measured_latencies() {
    using enum Operation;
    const double sum = seconds_each(one_after_another<sums_and_products>, 1);
    return {sum, seconds_each(one_after_another<quotients>, 1), seconds_each(one_after_another<roots>, 1) - sum,
            seconds_of_call(sine_and_cosine, true) - 3 * sum, seconds_of_call(angle, true) - 3 * sum};
}

OperationCosts measured_lane_costs(InstructionSet set) {
    using enum Operation;
#if defined(__x86_64__)
    if (set == InstructionSet::avx512)
        return {seconds_each(avx512<sums_and_products>, 8), seconds_each(avx512<quotients>, 8),
                seconds_each(avx512<roots>, 8), 0, 0};
    if (set == InstructionSet::avx2)
        return {seconds_each(avx2<sums_and_products>, 4), seconds_each(avx2<quotients>, 4),
                seconds_each(avx2<roots>, 4), 0, 0};
#endif
    static_cast<void>(set);
    return {seconds_each(baseline<sums_and_products>, 2), seconds_each(baseline<quotients>, 2),
            seconds_each(baseline<roots>, 2), 0, 0};
}

}  // namespace

double instruction_cost() {
    static const double seconds = measured_instruction();
    return seconds;
}

OperationCosts scalar_costs() {
    using enum Operation;
    static const OperationCosts costs{seconds_each(one<sums_and_products>, 1), seconds_each(one<quotients>, 1),
                                      seconds_each(one<roots>, 1), seconds_of_call(sine_and_cosine, false),
                                      seconds_of_call(angle, false)};
    return costs;
}

OperationCosts scalar_latencies() {
    static const OperationCosts latencies = measured_latencies();
    return latencies;
}

OperationCosts lane_costs(InstructionSet set) {
    static std::map<InstructionSet, OperationCosts> known;
    const auto [place, is_new] = known.try_emplace(set);
    if (is_new) place->second = measured_lane_costs(set);
    return place->second;
}

double least_seconds(const OperationMix& mix, const OperationCosts& costs) {
    const double sums = mix.sums_and_products * costs.sum_or_product;
    const double quotients = mix.quotients * costs.quotient + mix.roots * costs.root;
    // A sine and the cosine of the same angle come from one call.
    return std::max(sums, quotients) + 0.5 * mix.sines * costs.sine_and_cosine + mix.angles * costs.angle;
}

double chain_seconds(const OperationMix& chain, const OperationCosts& latencies) {
    return chain.sums_and_products * latencies.sum_or_product + chain.quotients * latencies.quotient +
           chain.roots * latencies.root + chain.sines * latencies.sine_and_cosine + chain.angles * latencies.angle;
}

}  // namespace mechwright::bench

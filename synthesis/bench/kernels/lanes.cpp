#include "synthesis/bench/kernels/lanes.h"

#include "analysis/numbers/lanes.h"
#include "synthesis/bench/kernels/measured_kernel.h"

namespace mechwright::bench {

namespace {

constexpr std::size_t widest = 8;
using Kernel = CouplerPointKernel;

/// The usual four-bars, eight side by side: [dimension][linkage].
struct Group {
    alignas(64) std::array<std::array<double, widest>, Kernel::size> x;
};
struct Points {
    alignas(64) std::array<double, widest> x, y;
};

std::vector<Group> groups_of(const std::vector<Kernel::Input>& inputs) {
    std::vector<Group> groups(inputs.size() / widest);
    for (std::size_t k = 0; k < groups.size() * widest; ++k)
        for (std::size_t i = 0; i < Kernel::size; ++i)
            groups[k / widest].x[i][k % widest] = inputs[k].x[i];
    return groups;
}

template <int order, class T>
[[gnu::always_inline]] inline void in_lanes(const std::vector<Group>& groups, const HalfTurn<double>& half,
                                            std::vector<Points>& out) {
    const HalfTurn<T> at{T(half.cosine), T(half.sine)};
    for (std::size_t g = 0; g < groups.size(); ++g)
        for (std::size_t first = 0; first < widest; first += T::count) {
            std::array<T, Kernel::size> x;
            for (std::size_t i = 0; i < Kernel::size; ++i)
                x[i].read(groups[g].x[i].data() + first);
            const Vector<T> reached = Kernel::ours<order>(x, at);
            reached.x.write(out[g].x.data() + first);
            reached.y.write(out[g].y.data() + first);
        }
}

template <int order>
void one_by_one(const std::vector<Group>& groups, const HalfTurn<double>& half, std::vector<Points>& out) {
    for (std::size_t g = 0; g < groups.size(); ++g)
        for (std::size_t lane = 0; lane < widest; ++lane) {
            const auto& [ground, crank, coupler, rocker, along, across] = groups[g].x;
            const std::array x{ground[lane], crank[lane], coupler[lane], rocker[lane], along[lane], across[lane]};
            const Vector<double> reached = Kernel::ours<order>(x, half);
            out[g].x[lane] = reached.x;
            out[g].y[lane] = reached.y;
        }
}

template <int order>
[[gnu::flatten]] void baseline(const std::vector<Group>& g, const HalfTurn<double>& half, std::vector<Points>& out) {
    in_lanes<order, BaselineLanes>(g, half, out);
}
#if defined(__x86_64__)
template <int order>
[[gnu::flatten, gnu::target("avx2")]] void avx2(const std::vector<Group>& g, const HalfTurn<double>& half,
                                                std::vector<Points>& out) {
    in_lanes<order, Avx2Lanes>(g, half, out);
}
template <int order>
[[gnu::flatten, gnu::target("avx512f")]] void avx512(const std::vector<Group>& g, const HalfTurn<double>& half,
                                                     std::vector<Points>& out) {
    in_lanes<order, Avx512Lanes>(g, half, out);
}
#endif

using Body = void (*)(const std::vector<Group>&, const HalfTurn<double>&, std::vector<Points>&);

struct LaneForm {
    std::string_view order;
    std::string_view name;
    std::size_t lanes;
    Body body;
    CallMix mix;
    OperationCosts costs;
};

template <int order>
Body body_of(InstructionSet set) {
#if defined(__x86_64__)
    if (set == InstructionSet::avx512) return avx512<order>;
    if (set == InstructionSet::avx2) return avx2<order>;
#endif
    static_cast<void>(set);
    return baseline<order>;
}

std::size_t lanes_of(InstructionSet set) {
    return set == InstructionSet::avx512 ? Avx512Lanes::count
           : set == InstructionSet::avx2 ? Avx2Lanes::count
                                         : BaselineLanes::count;
}

template <int order>
CallMix mix_at_angle() {
    return mix_of([] {
        const auto in = Kernel::usual()[1];
        const HalfTurn<double> half = half_turn(in.at);
        return Kernel::ours<order>(kernel_detail::counted(in.x), HalfTurn<Counted>{half.cosine, half.sine});
    });
}

template <int order>
void add_forms(std::vector<LaneForm>& all) {
    const CallMix mix = mix_at_angle<order>();
    const std::string_view name = Kernel::orders[order];
    all.push_back({name, one_by_one_name, 1, one_by_one<order>, mix, scalar_costs()});
    for (const auto& [set, form] : lane_names)
        if (is_available(set)) all.push_back({name, form, lanes_of(set), body_of<order>(set), mix, lane_costs(set)});
}

/// What one more group takes, shared among its linkages. Each step is some microseconds: not all groups.
std::optional<long> instructions_of_a_linkage(Body body, const std::vector<Group>& groups) {
    const auto of = [&](long count) {
        const std::vector<Group> some(groups.begin(), groups.begin() + count);
        std::vector<Points> out(some.size());
        return instructions_of([&] { body(some, half_turn(1.0), out); });
    };
    const auto few = of(2), more = of(6);
    if (!few || !more) return std::nullopt;
    return static_cast<long>(std::lround(static_cast<double>(*more - *few) / (4.0 * widest)));
}

/// Whether a body gives the same digits as `one_by_one`.
bool same_digits(const std::vector<Points>& a, const std::vector<Points>& b) {
    for (std::size_t g = 0; g < a.size(); ++g)
        if (a[g].x != b[g].x || a[g].y != b[g].y) return false;
    return true;
}

}  // namespace

std::vector<Row> measured_lanes(const Effort& effort) {
    const std::vector<Group> groups = groups_of(Kernel::usual());
    std::vector<LaneForm> forms;
    add_forms<0>(forms);
    add_forms<1>(forms);
    add_forms<2>(forms);
    std::vector<Points> out(groups.size()), first;
    std::vector<Piece> pieces;
    for (const LaneForm& f : forms)
        pieces.push_back([&groups, &out, body = f.body](benchmark::State& state) {
            double angle = 0;
            for (auto _ : state) {
                body(groups, half_turn(angle += 0.1), out);
                benchmark::DoNotOptimize(out.data());
                benchmark::ClobberMemory();
            }
        });
    const std::vector<Timing> timings = timed(pieces, effort.pick(5, 21), effort.pick(0.1, 1.0));
    const double each = 1 / static_cast<double>(groups.size() * widest);
    const double instruction = instruction_cost();
    const OperationCosts latencies = scalar_latencies();
    std::vector<Row> rows;
    for (std::size_t i = 0; i < forms.size(); ++i) {
        const LaneForm& f = forms[i];
        KernelNumbers n{{timings[i].median * each, timings[i].lower * each, timings[i].upper * each}, {}, f.mix};
        n.instructions = instructions_of_a_linkage(f.body, groups);
        n.least = least_seconds(f.mix.all, f.costs);
        n.chain = chain_seconds(f.mix.chain, latencies) / static_cast<double>(f.lanes);
        n.instruction = instruction;
        f.body(groups, half_turn(1.0), out);
        if (f.name == one_by_one_name) first = out;
        if (!same_digits(out, first)) throw std::logic_error("lanes have other digits than single numbers");
        rows.push_back(kernel_row(f.order, f.name, n));
    }
    return rows;
}

}  // namespace mechwright::bench

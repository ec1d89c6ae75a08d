#include "analysis/numbers/lanes.h"

#include "synthesis/bench/linkages/blocks.h"

namespace mechwright::bench {

namespace {

/// More lanes than the built-in kernel has: a step of a linkage waits for what it takes.
using WideAvx512Lanes = Lanes<16, 2>;
using Dimensions = std::array<double, CouplerPointKernel::size>;

template <class T>
constexpr std::size_t lanes_of() {
    if constexpr (std::is_same_v<T, double>)
        return 1;
    else
        return T::count;
}

template <class T>
T read(const double* from) {
    if constexpr (std::is_same_v<T, double>) {
        return *from;
    } else {
        T x;
        x.read(from);
        return x;
    }
}

template <class T>
void write(const T& x, double* to) {
    if constexpr (std::is_same_v<T, double>)
        *to = x;
    else
        x.write(to);
}

template <class T>
[[gnu::always_inline]] inline void built_in(const Dimensions& dimensions, AngleBlock& block) {
    std::array<T, CouplerPointKernel::size> x;
    for (std::size_t i = 0; i < x.size(); ++i)
        x[i] = T(dimensions[i]);
    for (std::size_t i = 0; i < AngleBlock::count; i += lanes_of<T>()) {
        const HalfTurn<T> half{read<T>(block.half_cosine.data() + i), read<T>(block.half_sine.data() + i)};
        const Vector<T> at = CouplerPointKernel::ours<0>(x, half);
        write(at.x, block.x.data() + i);
        write(at.y, block.y.data() + i);
    }
}

/// Rows stand on the stack: no more numbers than the linkages here have.
constexpr std::size_t most_numbers = 256;

template <class T>
[[gnu::always_inline]] inline void linkage_block(const linkage::Needed& needed, std::span<const double> design,
                                                 AngleBlock& block) {
    std::array<T, most_numbers> room;
    const std::span<T> row(room.data(), needed.size);
    linkage::take_design<T>(needed, design, row);
    for (std::size_t i = 0; i < AngleBlock::count; i += lanes_of<T>()) {
        linkage::set_input<T>(needed, 0, T(0.0), {read<T>(block.cosine.data() + i), read<T>(block.sine.data() + i)},
                              row);
        linkage::place_needed<T>(needed, row);
        write(row[needed.point], block.x.data() + i);
        write(row[needed.point + 1], block.y.data() + i);
    }
}

/// The design is set outside of what is compiled for an instruction set: plain code that is called from there waits for
/// the upper halves of registers.
template <void (*place)(const linkage::Needed&, std::span<const double>, AngleBlock&)>
void linkage_of_design(const PointOfLinkage& l, AngleBlock& block) {
    std::array<double, most_numbers> room;
    const std::span<double> design(room.data(), l.needed.size);
    linkage::set_design<double, double>(l.needed, l.numbers, l.sides, design);
    place(l.needed, design, block);
}

[[gnu::flatten]] void built_in_baseline(const Dimensions& d, AngleBlock& b) { built_in<BaselineLanes>(d, b); }
[[gnu::flatten]] void linkage_baseline(const linkage::Needed& n, std::span<const double> d, AngleBlock& b) {
    linkage_block<BaselineLanes>(n, d, b);
}
#if defined(__x86_64__)
[[gnu::flatten, gnu::target("avx2")]] void built_in_avx2(const Dimensions& d, AngleBlock& b) {
    built_in<Avx2Lanes>(d, b);
}
[[gnu::flatten, gnu::target("avx2")]] void linkage_avx2(const linkage::Needed& n, std::span<const double> d,
                                                        AngleBlock& b) {
    linkage_block<Avx2Lanes>(n, d, b);
}
[[gnu::flatten, gnu::target("avx512f")]] void built_in_avx512(const Dimensions& d, AngleBlock& b) {
    built_in<Avx512Lanes>(d, b);
}
[[gnu::flatten, gnu::target("avx512f")]] void linkage_avx512(const linkage::Needed& n, std::span<const double> d,
                                                             AngleBlock& b) {
    linkage_block<WideAvx512Lanes>(n, d, b);
}
#endif

}  // namespace

BlockOf block_one_by_one() { return {built_in<double>, linkage_of_design<linkage_block<double>>}; }

BlockOf block_in_lanes(InstructionSet set) {
#if defined(__x86_64__)
    if (set == InstructionSet::avx512) return {built_in_avx512, linkage_of_design<linkage_avx512>};
    if (set == InstructionSet::avx2) return {built_in_avx2, linkage_of_design<linkage_avx2>};
#endif
    static_cast<void>(set);
    return {built_in_baseline, linkage_of_design<linkage_baseline>};
}

}  // namespace mechwright::bench

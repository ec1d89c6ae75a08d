#pragma once
/// \file
/// N numbers that go through the same formulas side by side: many candidates of a search at once. A comparison answers
/// lane by lane, and `select` takes from either side lane by lane.
///
/// Every operation is the IEEE operation of each lane, so that a lane holds the bits of plain double arithmetic,
/// whatever instruction set carries it out and however many lanes there are. Lanes lie in memory between operations:
/// functions compiled for different instruction sets can hand them to each other, and what is inlined keeps them in
/// registers all the same. N is 2, 4 or 8: what so many registers of the instruction set hold. With two of them the
/// processor has something to do while one waits for its roots and quotients.

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>

#include "analysis/geometry/vector.h"
#include "analysis/numbers/scalar.h"

namespace mechwright {

namespace detail {

/// N values in memory, copied by way of registers: not piece by piece, as plain structures would be.
template <class Derived, class Value, std::size_t N, std::size_t Registers>
struct InLanes {
    static constexpr std::size_t width = N / Registers;

    // What the compiler calculates with between a load and a store.
    using Register [[gnu::vector_size(width * sizeof(Value))]] = Value;

    alignas(sizeof(Register)) std::array<Value, N> lane;

    InLanes() = default;
    InLanes(const InLanes& other) { copy(other); }
    InLanes& operator=(const InLanes& other) {
        copy(other);
        return *this;
    }

    struct Loaded {
        Register v;
    };

    static Loaded loaded(const Value* from) {
        Loaded l;
        std::memcpy(&l.v, from, sizeof l.v);
        return l;
    }

    /// The k-th register.
    Loaded load(std::size_t k) const { return loaded(lane.data() + k * width); }
    void store(std::size_t k, const Register& v) { std::memcpy(lane.data() + k * width, &v, sizeof v); }

    /// From and to N numbers anywhere.
    void read(const Value* from) {
        for (std::size_t k = 0; k < Registers; ++k)
            store(k, loaded(from + k * width).v);
    }
    void write(Value* to) const {
        for (std::size_t k = 0; k < Registers; ++k) {
            const Register v = load(k).v;
            std::memcpy(to + k * width, &v, sizeof v);
        }
    }

    /// Each register the result of an operation on those of the same number.
    template <class Operation>
    static Derived each(const Operation& operation) {
        Derived r;
        for (std::size_t k = 0; k < Registers; ++k)
            operation(k, r);
        return r;
    }

private:
    void copy(const InLanes& other) {
        for (std::size_t k = 0; k < Registers; ++k)
            store(k, other.load(k).v);
    }
};

}  // namespace detail

/// Yes or no in each lane: all bits set, or none.
template <std::size_t N, std::size_t Registers = 1>
struct LaneMask : detail::InLanes<LaneMask<N, Registers>, std::int64_t, N, Registers> {
    /// Yes where both say yes.
    friend LaneMask both(const LaneMask& a, const LaneMask& b) {
        return LaneMask::each([&](auto k, auto& r) { r.store(k, a.load(k).v & b.load(k).v); });
    }
    /// Whether a lane says yes.
    friend bool any(const LaneMask& a) {
        std::int64_t all = 0;
        for (const std::int64_t lane : a.lane)
            all |= lane;
        return all != 0;
    }
};

template <std::size_t N, std::size_t Registers = 1>
struct Lanes : detail::InLanes<Lanes<N, Registers>, double, N, Registers> {
    using Mask = LaneMask<N, Registers>;
    static constexpr std::size_t count = N;

    Lanes() = default;
    Lanes(double all) {  // NOLINT(google-explicit-constructor): constants mix freely
        this->lane.fill(all);
    }

    Lanes& operator+=(const Lanes& b) { return *this = *this + b; }
    Lanes& operator-=(const Lanes& b) { return *this = *this - b; }

    friend Lanes operator+(const Lanes& a, const Lanes& b) {
        return Lanes::each([&](auto k, auto& r) { r.store(k, a.load(k).v + b.load(k).v); });
    }
    friend Lanes operator-(const Lanes& a, const Lanes& b) {
        return Lanes::each([&](auto k, auto& r) { r.store(k, a.load(k).v - b.load(k).v); });
    }
    friend Lanes operator*(const Lanes& a, const Lanes& b) {
        return Lanes::each([&](auto k, auto& r) { r.store(k, a.load(k).v * b.load(k).v); });
    }
    friend Lanes operator/(const Lanes& a, const Lanes& b) {
        return Lanes::each([&](auto k, auto& r) { r.store(k, a.load(k).v / b.load(k).v); });
    }
    friend Lanes operator-(const Lanes& a) {
        return Lanes::each([&](auto k, auto& r) { r.store(k, -a.load(k).v); });
    }

    friend Mask operator<(const Lanes& a, const Lanes& b) {
        return Mask::each([&](auto k, auto& r) { r.store(k, a.load(k).v < b.load(k).v); });
    }
    friend Mask operator>=(const Lanes& a, const Lanes& b) {
        return Mask::each([&](auto k, auto& r) { r.store(k, a.load(k).v >= b.load(k).v); });
    }
    friend Mask operator>(const Lanes& a, const Lanes& b) { return b < a; }

    friend Lanes select(const Mask& condition, const Lanes& yes, const Lanes& no) {
        return Lanes::each([&](auto k, auto& r) { r.store(k, condition.load(k).v ? yes.load(k).v : no.load(k).v); });
    }

    friend Lanes abs(const Lanes& a) { return select(a < Lanes(0.0), -a, a); }

    friend Lanes sqrt(const Lanes& a) {
        Lanes r;
        for (std::size_t i = 0; i < N; ++i)
            r.lane[i] = std::sqrt(a.lane[i]);
        return r;
    }
};

template <std::size_t N, std::size_t Registers>
Vector<Lanes<N, Registers>> select(const LaneMask<N, Registers>& condition, const Vector<Lanes<N, Registers>>& yes,
                                   const Vector<Lanes<N, Registers>>& no) {
    return {select(condition, yes.x, no.x), select(condition, yes.y, no.y)};
}

/// As for one number, but without its care for squares that overflow or vanish: lengths in lanes are of order one.
template <std::size_t N, std::size_t Registers>
Lanes<N, Registers> hypotenuse(const Lanes<N, Registers>& a, const Lanes<N, Registers>& b) {
    return sqrt(a * a + b * b);
}

template <std::size_t N, std::size_t Registers>
Lanes<N, Registers> root_or_zero(const Lanes<N, Registers>& x) {
    const Lanes<N, Registers> none(0.0);
    return sqrt(select(x > none, x, none));
}

/// Of the eight candidates of a group, as many at a time as each instruction set calculates the fastest in formulas
/// with roots and quotients: one, two and four registers were compared, as far as they make eight.
using BaselineLanes = Lanes<4, 2>;
using Avx2Lanes = Lanes<8, 2>;
using Avx512Lanes = Lanes<8>;

/// Lanes of a group of numbers, as many as there are of T, from one on.
template <class T, std::size_t N>
T loaded(const std::array<double, N>& group, std::size_t first) {
    T lanes;
    lanes.read(group.data() + first);
    return lanes;
}

}  // namespace mechwright

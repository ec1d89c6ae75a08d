#pragma once
/// \file
/// N numbers that go through the same formulas side by side: many candidates of a search at once. A comparison answers
/// lane by lane, and `select` takes from either side lane by lane.
///
/// Every operation is the IEEE operation of each lane, so that a lane holds the bits of plain double arithmetic,
/// whatever instruction set carries it out and however many lanes there are. Lanes lie in memory between operations:
/// functions compiled for different instruction sets can hand them to each other, and what is inlined keeps them in
/// registers all the same. N is 2, 4 or 8: what one register of the instruction set holds.

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>

#include "analysis/geometry/vector.h"
#include "analysis/numbers/scalar.h"

namespace mechwright {

namespace detail {

/// N values in memory, copied by way of one register: not piece by piece, as plain structures would be.
template <class Value, std::size_t N>
struct InLanes {
    alignas(N * sizeof(Value)) std::array<Value, N> lane;

    // What the compiler calculates with between a load and a store.
    using Register [[gnu::vector_size(N * sizeof(Value))]] = Value;

    InLanes() = default;
    InLanes(const InLanes& other) { store(other.load().v); }
    InLanes& operator=(const InLanes& other) {
        store(other.load().v);
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

    Loaded load() const { return loaded(lane.data()); }
    void store(const Register& v) { std::memcpy(lane.data(), &v, sizeof v); }

    /// From and to N numbers anywhere.
    void read(const Value* from) { store(loaded(from).v); }
    void write(Value* to) const {
        const Register v = load().v;
        std::memcpy(to, &v, sizeof v);
    }
};

template <class Result, class Register>
Result stored(const Register& v) {
    Result r;
    r.store(v);
    return r;
}

}  // namespace detail

/// Yes or no in each lane: all bits set, or none.
template <std::size_t N>
struct LaneMask : detail::InLanes<std::int64_t, N> {
    /// Yes where both say yes.
    friend LaneMask both(const LaneMask& a, const LaneMask& b) {
        return detail::stored<LaneMask>(a.load().v & b.load().v);
    }
};

template <std::size_t N>
struct Lanes : detail::InLanes<double, N> {
    Lanes() = default;
    Lanes(double all) {  // NOLINT(google-explicit-constructor): constants mix freely
        this->lane.fill(all);
    }

    Lanes& operator+=(const Lanes& b) { return *this = *this + b; }
    Lanes& operator-=(const Lanes& b) { return *this = *this - b; }

    friend Lanes operator+(const Lanes& a, const Lanes& b) { return detail::stored<Lanes>(a.load().v + b.load().v); }
    friend Lanes operator-(const Lanes& a, const Lanes& b) { return detail::stored<Lanes>(a.load().v - b.load().v); }
    friend Lanes operator*(const Lanes& a, const Lanes& b) { return detail::stored<Lanes>(a.load().v * b.load().v); }
    friend Lanes operator/(const Lanes& a, const Lanes& b) { return detail::stored<Lanes>(a.load().v / b.load().v); }
    friend Lanes operator-(const Lanes& a) { return detail::stored<Lanes>(-a.load().v); }

    friend LaneMask<N> operator<(const Lanes& a, const Lanes& b) {
        return detail::stored<LaneMask<N>>(a.load().v < b.load().v);
    }
    friend LaneMask<N> operator>=(const Lanes& a, const Lanes& b) {
        return detail::stored<LaneMask<N>>(a.load().v >= b.load().v);
    }
    friend LaneMask<N> operator>(const Lanes& a, const Lanes& b) { return b < a; }

    friend Lanes select(const LaneMask<N>& condition, const Lanes& yes, const Lanes& no) {
        return detail::stored<Lanes>(condition.load().v ? yes.load().v : no.load().v);
    }

    friend Lanes abs(const Lanes& a) { return select(a < Lanes(0.0), -a, a); }

    friend Lanes sqrt(const Lanes& a) {
        Lanes r;
        for (std::size_t i = 0; i < N; ++i)
            r.lane[i] = std::sqrt(a.lane[i]);
        return r;
    }
};

template <std::size_t N>
Vector<Lanes<N>> select(const LaneMask<N>& condition, const Vector<Lanes<N>>& yes, const Vector<Lanes<N>>& no) {
    return {select(condition, yes.x, no.x), select(condition, yes.y, no.y)};
}

/// As for one number, but without its care for squares that overflow or vanish: lengths in lanes are of order one.
template <std::size_t N>
Lanes<N> hypotenuse(const Lanes<N>& a, const Lanes<N>& b) {
    return sqrt(a * a + b * b);
}

template <std::size_t N>
Lanes<N> root_or_zero(const Lanes<N>& x) {
    const Lanes<N> none(0.0);
    return sqrt(select(x > none, x, none));
}

}  // namespace mechwright

#pragma once
/// \file
/// A double that writes down what is done with it: the mix of operations that a formula asks of a processor. Counted is
/// what the result depends on, each operation once: a compiler leaves out the rest, and so does the bound.

#include <array>
#include <cmath>
#include <map>
#include <vector>

#include "analysis/cam/law.h"
#include "analysis/geometry/vector.h"
#include "analysis/numbers/scalar.h"

namespace mechwright::bench {

/// Operations by what they cost.
struct OperationMix {
    int sums_and_products = 0;  ///< comparisons and signs not counted
    int quotients = 0;
    int roots = 0;
    int sines = 0;   ///< sines and cosines, each
    int angles = 0;  ///< atan2
};

/// What a call does.
struct CallMix {
    OperationMix all;
    OperationMix chain;  ///< of operations of which each needs the one before: the chain that takes longest
};

/// What was done, in order. An operation on numbers that are known beforehand is one too: it has no node.
struct Operations {
    enum class Kind { variable, sum, difference, product, quotient, root, sine, cosine, angle };
    struct Node {
        Kind kind;
        int a, b;  ///< its operands, or `constant`
        double constant_a, constant_b;
        auto operator<=>(const Node&) const = default;
    };
    static constexpr int constant = -1;

    std::vector<Node> nodes;
    std::map<Node, int> known;     ///< of nodes: the same done again is the same
    std::vector<int> looked_at{};  ///< by comparisons

    int number_of(const Node& node) {
        const auto [place, is_new] = known.emplace(node, static_cast<int>(nodes.size()));
        if (is_new) nodes.push_back(node);
        return place->second;
    }
    /// Of the nodes that the results and the comparisons depend on.
    OperationMix mix(const std::vector<int>& results) const;
    /// Of the chain of nodes that takes longest to come to one of the results.
    OperationMix longest_chain(const std::vector<int>& results) const;
};

struct Counted {
    double value = 0;
    int node = Operations::constant;

    Counted() = default;
    Counted(double x) : value(x) {}  // NOLINT(google-explicit-constructor): constants mix freely

    static inline Operations done{};

    /// A number that is not known beforehand.
    static Counted variable(double x) {
        Counted c(x);
        c.node = static_cast<int>(done.nodes.size());
        done.nodes.push_back({Operations::Kind::variable, Operations::constant, Operations::constant, 0, 0});
        return c;
    }

    Counted& operator+=(const Counted& b) { return *this = *this + b; }
    Counted& operator-=(const Counted& b) { return *this = *this - b; }

    friend Counted operator+(const Counted& a, const Counted& b) { return did(Kind::sum, a.value + b.value, a, b); }
    friend Counted operator-(const Counted& a, const Counted& b) {
        return did(Kind::difference, a.value - b.value, a, b);
    }
    friend Counted operator*(const Counted& a, const Counted& b) { return did(Kind::product, a.value * b.value, a, b); }
    friend Counted operator/(const Counted& a, const Counted& b) {
        return did(Kind::quotient, a.value / b.value, a, b);
    }
    friend Counted operator-(const Counted& a) { return same(-a.value, a); }
    friend bool operator<(const Counted& a, const Counted& b) { return look(a, b), a.value < b.value; }
    friend bool operator>(const Counted& a, const Counted& b) { return look(a, b), a.value > b.value; }
    friend bool operator<=(const Counted& a, const Counted& b) { return look(a, b), a.value <= b.value; }
    friend bool operator>=(const Counted& a, const Counted& b) { return look(a, b), a.value >= b.value; }
    friend bool operator==(const Counted& a, const Counted& b) { return look(a, b), a.value == b.value; }

    friend Counted sqrt(const Counted& a) { return did(Kind::root, std::sqrt(a.value), a, Counted()); }
    friend Counted sin(const Counted& a) { return did(Kind::sine, std::sin(a.value), a, Counted()); }
    friend Counted cos(const Counted& a) { return did(Kind::cosine, std::cos(a.value), a, Counted()); }
    friend Counted atan2(const Counted& y, const Counted& x) {
        return did(Kind::angle, std::atan2(y.value, x.value), y, x);
    }
    friend Counted abs(const Counted& a) { return same(std::abs(a.value), a); }
    friend Counted hypot(const Counted& a, const Counted& b) { return sqrt(a * a + b * b); }

private:
    using Kind = Operations::Kind;

    static Counted did(Kind kind, double result, const Counted& a, const Counted& b) {
        Counted c(result);
        if (a.node == Operations::constant && b.node == Operations::constant) return c;
        c.node = done.number_of({kind, a.node, b.node, a.node == Operations::constant ? a.value : 0,
                                 b.node == Operations::constant ? b.value : 0});
        return c;
    }
    static Counted same(double result, const Counted& a) {
        Counted c(result);
        c.node = a.node;
        return c;
    }
    static void look(const Counted& a, const Counted& b) {
        for (const int node : {a.node, b.node})
            if (node != Operations::constant) done.looked_at.push_back(node);
    }
};

/// The mix of one call, which gives a vector.
template <class F>
CallMix mix_of(const F& f) {
    Counted::done = {};
    const Vector<Counted> result = f();
    const std::vector results{result.x.node, result.y.node};
    return {Counted::done.mix(results), Counted::done.longest_chain(results)};
}

}  // namespace mechwright::bench

namespace mechwright {

// Compensated sums are counted as they are computed.
template <>
inline constexpr bool plain_doubles<bench::Counted> = true;

// The constants of a law are known to the compiler.
template <>
struct detail::Underlying<bench::Counted> {
    using type = double;
};

}  // namespace mechwright

#pragma once
/// \file
/// Random four-bars for properties that hold for every linkage. They are drawn by the shortest link and the margins by
/// which links turn fully (log-uniform down to 1e-9 of it, so that change points are common), at sizes over six
/// decades; a failing one is printed as the dimensions of a problem file.

#include <gtest/gtest.h>
// Needs gtest.h before it.
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <iomanip>
#include <limits>
#include <numbers>
#include <ostream>

#include "analysis/four_bar.h"

namespace mechwright::test {

constexpr double ulp = std::numeric_limits<double>::epsilon();

inline double between(double low, double high) {
    constexpr std::int64_t steps = std::int64_t{1} << 52;
    const auto step = *rc::gen::resize(rc::kNominalSize, rc::gen::inRange<std::int64_t>(0, steps));
    return low + (high - low) * static_cast<double>(step) / static_cast<double>(steps);
}

inline double log_between(double low, double high) { return std::exp(between(std::log(low), std::log(high))); }

/// A linkage whose crank turns fully (crank-rocker or double crank), at any crank angle.
struct TurningLinkage {
    FourBar<double> links;
    Assembly assembly;
    double crank_angle;
};

/// Any linkage that assembles, at a crank angle of its assembled range.
struct AnyLinkage {
    FourBar<double> links;
    Assembly assembly;
    double crank_angle;
};

inline double sum_of(const FourBar<double>& m) { return m.ground + m.crank + m.coupler + m.rocker; }
inline double shortest_of(const FourBar<double>& m) { return std::min({m.ground, m.crank, m.coupler, m.rocker}); }

/// One link as shortest and the three margins a + b - shortest - c of the others.
inline FourBar<double> drawn_by_margins(bool crank_shortest, double least_margin = 1e-9) {
    const double scale = log_between(1e-3, 1e3);
    const double p = scale * log_between(least_margin, 10), q = scale * log_between(least_margin, 10),
                 s = scale * log_between(least_margin, 10);
    const double a = scale + (q + s) / 2, b = scale + (p + s) / 2, c = scale + (p + q) / 2;
    return crank_shortest ? FourBar<double>{a, scale, b, c} : FourBar<double>{scale, a, b, c};
}

inline TurningLinkage drawn_turning_linkage() {
    FourBar<double> m{};
    do {
        m = drawn_by_margins(*rc::gen::arbitrary<bool>());
    } while (!assembled_range(m).full_turn);  // a margin below rounding can vanish
    const auto assembly = *rc::gen::element(Assembly::open, Assembly::crossed);
    // Near the ground line, where change points are, as often as anywhere.
    const double offset = *rc::gen::arbitrary<bool>() ? between(0, 2 * std::numbers::pi) : log_between(1e-9, 1);
    const double base = *rc::gen::element(0.0, std::numbers::pi);
    return {m, assembly, base + (*rc::gen::arbitrary<bool>() ? offset : -offset)};
}

/// A crank-rocker, half the time with a crank down to 1e-6 of the other links.
struct CrankRocker {
    FourBar<double> links;
};

inline CrankRocker drawn_crank_rocker() {
    FourBar<double> m{};
    do {
        m = drawn_by_margins(true);
        const double crank = m.crank * (*rc::gen::arbitrary<bool>() ? log_between(1e-6, 1) : 1);
        const double less = m.crank - crank;
        m = {m.ground - less, crank, m.coupler - less, m.rocker - less};
    } while (!(grashof_margin(m) > 0));
    return {m};
}

inline AnyLinkage drawn_any_linkage() {
    if (*rc::gen::arbitrary<bool>()) {
        const TurningLinkage t = drawn_turning_linkage();
        return {t.links, t.assembly, t.crank_angle};
    }
    const double scale = log_between(1e-3, 1e3);
    FourBar<double> m{};
    do {
        const double spread = log_between(1e-6, 10);
        const auto length = [&] { return scale * std::exp(between(-spread, spread)); };
        m = {length(), length(), length(), length()};
    } while (closing_margin(m) <= 0);
    const auto range = assembled_range(m);
    const auto assembly = *rc::gen::element(Assembly::open, Assembly::crossed);
    return {m, assembly, range.from + (range.to - range.from) * between(0, 1)};
}

inline std::ostream& show(std::ostream& out, const FourBar<double>& m, Assembly assembly, double crank_angle) {
    return out << std::setprecision(17) << "mechanism = \"four-bar\"  # at crank angle " << crank_angle
               << " rad\n[dimensions]\nground = " << m.ground << "\ncrank = " << m.crank << "\ncoupler = " << m.coupler
               << "\nrocker = " << m.rocker
               << "\nassembly = " << (assembly == Assembly::open ? "\"open\"\n" : "\"crossed\"\n");
}

inline std::ostream& operator<<(std::ostream& out, const TurningLinkage& l) {
    return show(out, l.links, l.assembly, l.crank_angle);
}

inline std::ostream& operator<<(std::ostream& out, const AnyLinkage& l) {
    return show(out, l.links, l.assembly, l.crank_angle);
}

inline std::ostream& operator<<(std::ostream& out, const CrankRocker& l) {
    return show(out, l.links, Assembly::open, 0);
}

}  // namespace mechwright::test

namespace rc {

template <>
struct Arbitrary<mechwright::test::CrankRocker> {
    static Gen<mechwright::test::CrankRocker> arbitrary() {
        return gen::exec([] { return mechwright::test::drawn_crank_rocker(); });
    }
};

template <>
struct Arbitrary<mechwright::test::TurningLinkage> {
    static Gen<mechwright::test::TurningLinkage> arbitrary() {
        return gen::exec([] { return mechwright::test::drawn_turning_linkage(); });
    }
};

template <>
struct Arbitrary<mechwright::test::AnyLinkage> {
    static Gen<mechwright::test::AnyLinkage> arbitrary() {
        return gen::exec([] { return mechwright::test::drawn_any_linkage(); });
    }
};

}  // namespace rc

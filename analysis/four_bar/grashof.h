#pragma once
/// \file
/// Which links of a four-bar turn fully. Reference: Grashof's rule in the form of Theory of Machines, section 2.2; the
/// margins and their compensated sums follow from the triangle inequalities at the two collinear positions.

#include <algorithm>
#include <array>
#include <utility>

#include "analysis/four_bar/four_bar.h"

namespace mechwright {

/// What the crank and the rocker of a four-bar can do.
enum class FourBarClass {
    crank_rocker,   ///< the crank is shortest and turns fully, the rocker swings
    double_crank,   ///< the ground link is shortest; crank and rocker turn fully (drag link)
    double_rocker,  ///< the coupler is shortest and turns fully; crank and rocker swing
    rocker_crank,   ///< the rocker is shortest and turns fully; the crank swings
    triple_rocker,  ///< non-Grashof: no link turns fully against another
    open_chain      ///< one link is longer than the other three together: it cannot be assembled
};

/// The three margins of a link that is to turn fully as the shortest: with shortest s and the others a, b, c they are
/// a + b - s - c for each choice of c. All are >= 0 exactly where s is shortest and Grashof's rule holds; the least of
/// them is then p + q - s - l.
template <class T>
struct FullTurnMargins {
    T ground_longest;  ///< or the crank, where the ground link is the shortest
    T coupler_longest;
    T rocker_longest;
};

/// Margins for the crank as the shortest link.
template <class T>
FullTurnMargins<T> crank_rocker_margins(const FourBar<T>& m) {
    return {sum_difference(m.coupler, m.rocker, m.ground, m.crank),
            sum_difference(m.ground, m.rocker, m.crank, m.coupler),
            sum_difference(m.ground, m.coupler, m.crank, m.rocker)};
}

/// Margins for the ground link as the shortest link.
template <class T>
FullTurnMargins<T> double_crank_margins(const FourBar<T>& m) {
    return {sum_difference(m.coupler, m.rocker, m.ground, m.crank),
            sum_difference(m.crank, m.rocker, m.ground, m.coupler),
            sum_difference(m.crank, m.coupler, m.ground, m.rocker)};
}

/// p + q - s - l: the two middle links less shortest and longest. Negative: non-Grashof; zero: change points.
template <class T>
T grashof_margin(const FourBar<T>& m) {
    std::array<T, 4> length{m.ground, m.crank, m.coupler, m.rocker};
    std::sort(length.begin(), length.end(), [](const T& a, const T& b) { return a < b; });
    return sum_difference(length[1], length[2], length[0], length[3]);
}

/// The class of a linkage, with the special cases that have change points named.
struct Grashof {
    FourBarClass kind;
    bool change_point;   ///< the margin is zero: all four pins can fall into one line
    bool parallelogram;  ///< opposite links are equal
    bool kite;           ///< adjacent links are equal in pairs (deltoid)
};

/// How much the three shorter links together exceed the longest. Negative: no assembly at any crank angle.
template <class T>
T closing_margin(const FourBar<T>& m) {
    std::array<T, 4> length{m.ground, m.crank, m.coupler, m.rocker};
    std::sort(length.begin(), length.end(), [](const T& a, const T& b) { return a < b; });
    return sum_difference(length[1], length[2], length[3], T(-length[0]));
}

/// Classifies a linkage by the signs of exact margins; no tolerance enters.
template <class T>
Grashof classify(const FourBar<T>& m) {
    const T margin = grashof_margin(m);
    const bool parallelogram = m.ground == m.coupler && m.crank == m.rocker;
    const bool kite = (m.ground == m.crank && m.coupler == m.rocker) || (m.ground == m.rocker && m.crank == m.coupler);
    FourBarClass kind = FourBarClass::triple_rocker;
    if (closing_margin(m) < T(0)) {
        kind = FourBarClass::open_chain;
    } else if (margin >= T(0)) {
        const T shortest = std::min({m.ground, m.crank, m.coupler, m.rocker});
        if (m.crank == shortest)
            kind = FourBarClass::crank_rocker;
        else if (m.ground == shortest)
            kind = FourBarClass::double_crank;
        else if (m.coupler == shortest)
            kind = FourBarClass::double_rocker;
        else
            kind = FourBarClass::rocker_crank;
    }
    return {kind, margin == T(0), parallelogram, kite};
}

/// The class as a designer calls it.
constexpr const char* name_of(FourBarClass kind) {
    switch (kind) {
        case FourBarClass::crank_rocker: return "crank-rocker";
        case FourBarClass::double_crank: return "double crank (drag link)";
        case FourBarClass::double_rocker: return "double rocker";
        case FourBarClass::rocker_crank: return "rocker-crank";
        case FourBarClass::triple_rocker: return "triple rocker (non-Grashof)";
        case FourBarClass::open_chain: return "cannot be assembled";
    }
    return "";
}

}  // namespace mechwright

#pragma once
/// \file
/// Random ram-driving mechanisms whose crank turns fully and whose ram makes two strokes in each turn, margins down to
/// 1e-6 of the links, at sizes over six decades.

#include "analysis/quick_return.h"
#include "tests/properties/linkages.h"

namespace mechwright::test {

inline double drawn_sign() { return *rc::gen::arbitrary<bool>() ? 1.0 : -1.0; }

/// A length a little or much longer than another.
inline double longer_than(double length) { return length * (1 + log_between(1e-6, 10)); }

inline SliderCrank<double> drawn_output(double scale) {
    const double arm = scale * log_between(1e-2, 1);
    const double offset = *rc::gen::arbitrary<bool>() ? 0.0 : scale * log_between(1e-3, 1);
    return {arm, longer_than(arm + offset), drawn_sign() * offset};
}

inline SliderCrank<double> drawn_slider_crank() { return drawn_output(log_between(1e-3, 1e3)); }

inline Whitworth<double> drawn_whitworth() {
    const double scale = log_between(1e-3, 1e3);
    const double centre_distance = scale * log_between(1e-2, 1);
    const SliderCrank<double> output = drawn_output(scale);
    return {centre_distance, longer_than(centre_distance), output.crank, longer_than(output.crank), between(-3, 3)};
}

inline CrankShaper<double> drawn_crank_shaper() {
    while (true) {
        const double scale = log_between(1e-3, 1e3);
        const double crank = scale * log_between(1e-2, 1);
        const double lever = scale * log_between(1e-1, 1);
        const CrankShaper<double> m{longer_than(crank), crank, lever, lever * log_between(0.1, 10),
                                    lever * log_between(0.3, 2)};
        if (makes_two_strokes(m)) return m;
    }
}

inline DragLink<double> drawn_drag_link(double least_margin = 1e-9) {
    while (true) {
        const FourBar<double> links = drawn_by_margins(false, least_margin);
        const SliderCrank<double> output = drawn_output(links.ground);
        const DragLink<double> m{links,
                                 output.crank,
                                 between(-3, 3),
                                 output.rod,
                                 between(-3, 3),
                                 output.offset,
                                 *rc::gen::element(Assembly::open, Assembly::crossed)};
        if (makes_two_strokes(m)) return m;
    }
}

/// Runs a property on each of the four kinds.
template <class Property>
void for_each_drive(const Property& property) {
    property(drawn_slider_crank());
    property(drawn_crank_shaper());
    property(drawn_whitworth());
    property(drawn_drag_link());
}

/// Runs a property on one of them, a drag link not so close to a change point that its fast motion is shorter than
/// crank angles can tell apart.
template <class Property>
void for_some_drive(const Property& property) {
    switch (*rc::gen::inRange(0, 4)) {
        case 0: return property(drawn_slider_crank());
        case 1: return property(drawn_crank_shaper());
        case 2: return property(drawn_whitworth());
        default: return property(drawn_drag_link(1e-4));
    }
}

}  // namespace mechwright::test

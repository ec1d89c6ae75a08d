#pragma once
/// \file
/// The arguments of a coupler curve that is fitted (curve_fit.h), and its nearest points to targets.

#include <span>

#include "analysis/four_bar.h"
#include "synthesis/mechanism/curve_fit.h"

namespace mechwright::coupler_curve {

struct Arguments {
    FourBar<double> links;
    CouplerPoint<double> point;
    Placement<double> placement;
    Assembly assembly;
};

inline Arguments arguments_of(std::size_t assembly, std::span<const double> a) {
    return {{a[0], a[1], a[2], a[3]},
            {a[4], a[5]},
            {{a[6], a[7]}, a[8]},
            assembly == 0 ? Assembly::open : Assembly::crossed};
}

template <class T>
FourBar<T> in_lanes(const FourBar<double>& m) {
    return {T(m.ground), T(m.crank), T(m.coupler), T(m.rocker)};
}

/// As CurveFit::nearest.
void nearest_on_curve(InstructionSet set, std::size_t assembly, std::span<const double> arguments,
                      const SampledCurve& curve, const NearestChords& chords, const GroupedTargets& targets,
                      NearestOnCurve& out);

}  // namespace mechwright::coupler_curve

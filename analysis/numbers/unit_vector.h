#pragma once
/// \file
/// Directions by their angles, in any number type.

#include "analysis/geometry/vector.h"
#include "analysis/numbers/scalar.h"

namespace mechwright {

/// The unit vector at an angle from the x axis.
template <class T>
Vector<T> unit_at(const T& angle) {
    const auto [sine, cosine] = sine_and_cosine(angle);
    return {cosine, sine};
}

}  // namespace mechwright

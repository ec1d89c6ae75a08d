#pragma once
/// \file
/// How the dimensions of the slider-crank stand in the registry (quick_return/layout.h).

#include "analysis/slider_crank.h"
#include "synthesis/mechanism/quick_return/layout.h"

namespace mechwright::quick_return {

template <>
struct Layout<SliderCrank> : UsualRam {
    static constexpr std::size_t reads = 3;
    static constexpr std::array<std::size_t, 2> links{0, 1};
    template <class T>
    static SliderCrank<T> make(const std::array<T, reads>& x, std::size_t) {
        return {x[0], x[1], x[2]};
    }
};

}  // namespace mechwright::quick_return

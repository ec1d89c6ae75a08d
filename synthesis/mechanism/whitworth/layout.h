#pragma once
/// \file
/// How the dimensions of Whitworth's drive stand in the registry (quick_return/layout.h).

#include "analysis/quick_return/whitworth.h"
#include "synthesis/mechanism/quick_return/layout.h"

namespace mechwright::quick_return {

template <>
struct Layout<Whitworth> : UsualRam {
    static constexpr std::size_t reads = 5;
    static constexpr std::array<std::size_t, 4> links{0, 1, 2, 3};
    template <class T>
    static Whitworth<T> make(const std::array<T, reads>& x, std::size_t) {
        return {x[0], x[1], x[2], x[3], x[4]};
    }
};

}  // namespace mechwright::quick_return

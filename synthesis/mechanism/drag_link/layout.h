#pragma once
/// \file
/// How the dimensions of the drag link stand in the registry (quick_return/layout.h).

#include "analysis/quick_return/drag_link.h"
#include "synthesis/mechanism/quick_return/layout.h"

namespace mechwright::quick_return {

template <>
struct Layout<DragLink> : UsualRam {
    static constexpr std::size_t reads = 9;
    static constexpr std::array<std::size_t, 6> links{0, 1, 2, 3, 4, 6};
    template <class T>
    static DragLink<T> make(const std::array<T, reads>& x, std::size_t assembly) {
        return {
            {x[0], x[1], x[2], x[3]}, x[4], x[5], x[6], x[7], x[8], assembly == 0 ? Assembly::open : Assembly::crossed};
    }
};

}  // namespace mechwright::quick_return

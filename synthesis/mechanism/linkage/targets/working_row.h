#pragma once
/// \file
/// Room to calculate in that stands on the stack, but for what needs much of it.

#include <array>
#include <cstddef>
#include <span>
#include <vector>

namespace mechwright {

/// So many numbers to work in, without needing for memory up to `Most`.
template <class T, std::size_t Most>
class WorkingRow {
public:
    std::span<T> of(std::size_t count) {
        if (count <= Most) return {here_.data(), count};
        more_.resize(count);
        return more_;
    }

private:
    std::array<T, Most> here_;
    std::vector<T> more_{};
};

}  // namespace mechwright

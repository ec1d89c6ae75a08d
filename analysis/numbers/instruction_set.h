#pragma once
/// \file
/// Which instructions carry out the arithmetic of lanes (lanes.h). The digits are the same in all of them.

#include <atomic>
#include <initializer_list>

namespace mechwright {

enum class InstructionSet { baseline, avx2, avx512 };

/// Whether this processor has the instructions.
inline bool is_available(InstructionSet set) {
#if defined(__x86_64__)
    switch (set) {
        case InstructionSet::baseline: return true;
        case InstructionSet::avx2: return __builtin_cpu_supports("avx2");
        case InstructionSet::avx512: return __builtin_cpu_supports("avx512f");
    }
#endif
    return set == InstructionSet::baseline;
}

namespace detail {

inline std::atomic<InstructionSet> widest_allowed = InstructionSet::avx512;

}  // namespace detail

/// From now on nothing wider is used.
inline void allow_instruction_sets_up_to(InstructionSet widest) { detail::widest_allowed = widest; }

/// The widest that this processor has and that is allowed.
inline InstructionSet widest_instruction_set() {
    const InstructionSet allowed = detail::widest_allowed;
    for (const InstructionSet set : {InstructionSet::avx512, InstructionSet::avx2})
        if (set <= allowed && is_available(set)) return set;
    return InstructionSet::baseline;
}

}  // namespace mechwright

#pragma once
/// \file
/// Which instructions carry out the arithmetic of lanes (lanes.h). The digits are the same in all of them.

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

/// The widest that this processor has.
inline InstructionSet widest_instruction_set() {
    static const InstructionSet widest = is_available(InstructionSet::avx512) ? InstructionSet::avx512
                                         : is_available(InstructionSet::avx2) ? InstructionSet::avx2
                                                                              : InstructionSet::baseline;
    return widest;
}

}  // namespace mechwright

// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/grains/engine/kernels.hpp"

namespace triax::sim {
namespace {

/// By the processor and the system; what this program was built with is another question.
bool runs_here([[maybe_unused]] InstructionSet set) {
#if defined(__x86_64__)
  if (set == InstructionSet::avx2) return __builtin_cpu_supports("avx2");
  if (set == InstructionSet::avx512)
    return __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq") &&
           __builtin_cpu_supports("avx512vl");
#endif
  return set == InstructionSet::portable;
}

}  // namespace

bool available(InstructionSet set) { return kernels(set).pairs && runs_here(set); }

InstructionSet best_instruction_set() {
  if (available(InstructionSet::avx512)) return InstructionSet::avx512;
  return available(InstructionSet::avx2) ? InstructionSet::avx2 : InstructionSet::portable;
}

Kernels kernels(InstructionSet set) {
  if (set == InstructionSet::avx512) return kAvx512Kernels;
  return set == InstructionSet::avx2 ? kAvx2Kernels : kPortableKernels;
}

}  // namespace triax::sim

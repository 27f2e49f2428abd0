#include "sim/grains/kernels.hpp"

namespace triax::sim {

bool available(InstructionSet set) {
  switch (set) {
    case InstructionSet::portable:
      return true;
    case InstructionSet::avx2:
#if defined(__x86_64__)
      return kAvx2Kernels.pairs && __builtin_cpu_supports("avx2");
#else
      return false;
#endif
  }
  return false;
}

InstructionSet best_instruction_set() {
  return available(InstructionSet::avx2) ? InstructionSet::avx2 : InstructionSet::portable;
}

Kernels kernels(InstructionSet set) {
  return set == InstructionSet::avx2 ? kAvx2Kernels : kPortableKernels;
}

}  // namespace triax::sim

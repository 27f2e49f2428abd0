// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The two inner loops: forces of pairs, motion of grains. One version for each instruction set,
// chosen at run time. All give the same bits: the same operations in the same order for each pair
// and each grain, none fused, loads added up in the order of the pairs. Plain data and pointers
// only: a function of another header, compiled here with AVX, might be taken by the linker for all.
#include <cstdint>

#include "sim/grains/state/grain.hpp"

namespace triax::sim {

/// Some of the near pairs. Loads of grain i are added to loads[i − first_grain].
struct PairRange {
  const Grain* grains;
  GrainLoad* loads;
  std::int32_t first_grain;
  std::int64_t begin, end;  ///< pairs; begin is a multiple of 8
  const std::int32_t *i, *j;
  double *tx, *ty, *tz;  ///< tangential force of j on i, N
  const double *stiffness, *reach, *half_difference;
  double friction_coefficient;  ///< tan φ
  double tangential_step;       ///< k_t/k_n Δt, s
  double half_step;             ///< Δt/2, s
  /// Where what sliding took is added, J (grain_ledger.hpp), pair by pair; null: not counted.
  double* friction_j = nullptr;
};

// NOLINTBEGIN(modernize-avoid-c-arrays): plain data, as grain.hpp
/// What the motion of grains adds, grain by grain, J and kg m/s (grain_ledger.hpp), for each
/// component of its own: x, y, z of the velocity and, from 4 on, of the spin; 3 and 7 say nothing.
struct MotionSums {
  double kinetic[8]{};         ///< ½ m v₋ v₊: at the time of the forces
  double damping_before[8]{};  ///< half of what damping took, with v₋ …
  double damping_after[8]{};   ///< … and with v₊
  double momentum[8]{};        ///< Σ m v₊
  double braked[8]{};          ///< − Σ of the damping forces × Δt
};
// NOLINTEND(modernize-avoid-c-arrays)

/// Some of the grains. Their loads are taken (and set to 0).
struct GrainRange {
  Grain* grains;     ///< of the first
  GrainLoad* loads;  ///< of the first
  std::int64_t count;
  double time_step, damping;
  MotionSums* sums = nullptr;  ///< null: not counted
};

/// Squares of the two highest speeds, m²/s². One that is not a number may hide here; grains that
/// are nowhere are found outside (guarded_steps.hpp).
struct FastestTwo {
  double first, second;
};

struct Kernels {
  void (*pairs)(const PairRange&);
  FastestTwo (*motion)(const GrainRange&);
};

enum class InstructionSet : std::uint8_t { portable, avx2, avx512 };

/// Whether this program has it and this processor runs it.
bool available(InstructionSet set);
/// The fastest one available.
InstructionSet best_instruction_set();
/// Pre-condition: available(set).
Kernels kernels(InstructionSet set);

// The versions; those a program was built without are null.
extern const Kernels kPortableKernels;
extern const Kernels kAvx2Kernels;
extern const Kernels kAvx512Kernels;  ///< F, DQ and VL

/// Pairs or grains that do not fill a vector are left to the portable version.
void portable_pairs(const PairRange& range);
FastestTwo portable_motion(const GrainRange& range);

}  // namespace triax::sim

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The UMAT of umat_fixture.f90, and what it must give.
#include <cmath>
#include <string>

#include "sim/materials/laws.hpp"

namespace triax::sim::test {

#ifdef TRIAX_UMAT_FIXTURE
inline constexpr const char* kUmatFixture = TRIAX_UMAT_FIXTURE;
#else
inline constexpr const char* kUmatFixture = nullptr;
#endif

/// Says why and returns false where the fixture could not be built.
inline bool umat_fixture_is_there() {
  if (kUmatFixture == nullptr) WARN("skipped: there is no Fortran compiler");
  return kUmatFixture != nullptr;
}

/// What the plug-in does at the first strain, as umat_fixture.f90 numbers it.
enum class Misbehaviour {
  none = 0,
  null_pointer = 1,
  stop = 2,
  xit = 3,
  nan_stress = 4,
  endless = 5,
  fatal_message = 6,
  asks_for_less = 7,
  no_tangent = 8,
  infinite_tangent = 9,
  nan_state = 10,
  lopsided = 11,
  error_message = 12,
  prints = 13,
  past_state = 14,
  before_stress = 15,
  past_tangent = 16,
  past_properties = 17,
  far_past_state = 18,
  before_state = 21,
  signals_triax = 22,  ///< the answer of kill() is STATEV(2)
  forks = 23,          ///< that of fork() is
  own_session = 24,    ///< that of setsid() is
  allocates = 25,      ///< STATEV(2) is 1 if 256 megabytes were to be had
  ignores_signals = 26,
  sleeps = 27,
  slow = 28,       ///< 0.9 s, then the right answer
  slow_once = 29,  ///< in each process
  stops_itself = 30,
  closes_all_files = 31,  ///< and ignores signals
  replaces_all_files = 32,
  writes_past_properties = 33,
  before_properties = 34,
  before_tangent = 35,
  past_stress = 36,
  changes_inputs = 37,  ///< after the stress is right
  jumps = 38,           ///< longjmp to nowhere
  aborts = 39,
  takes_all_memory = 40,
  opens_files = 41,          ///< until there are no more
  owns_file_for_triax = 42,  ///< the answers of fcntl(F_SETOWN), of fcntl(F_SETSIG), ...
  signal_of_file = 43,
  owns_device_for_triax = 44,
  limits_triax = 45,
  opens_memory_of_triax = 46,  ///< -1 where refused
  reads_maps_of_triax = 47,
  crashes_late = 48  ///< after 400 calls with strain, in each process
};

// kPa
inline constexpr double kBulk = 20e3, kShear = 12e3, kM = 1.2, kN = 0.3, kCohesion = 5;

inline ParameterSet umat_fixture(Misbehaviour misbehaviour = Misbehaviour::none,
                                 double kpa_per_unit = 1) {
  ParameterSet set;
  set.texts["umat"] = kUmatFixture;
  set.texts["name"] = "CONE";
  set.numbers["state_variables"] = 12;
  set.numbers["void_ratio_index"] = 1;
  set.lists["properties"] = {kBulk / kpa_per_unit,
                             kShear / kpa_per_unit,
                             kM,
                             kN,
                             kCohesion / kpa_per_unit,
                             static_cast<double>(misbehaviour)};
  return set;
}

inline Material make_umat(const ParameterSet& set) { return find_law("umat")->make(set, {}); }

/// Drained compression from the isotropic stress p₀ to an axial strain beyond yield.
struct ConeInCompression {
  double q, volumetric_strain;  // kPa
  ConeInCompression(double p0_kpa, double axial_strain) {
    q = 3 * (kM * p0_kpa + kCohesion) / (3 - kM);
    const double elastic_volume = q / 3 / kBulk, elastic_shear = q / 3 / kShear;
    const double plastic = axial_strain - elastic_shear - elastic_volume / 3;
    const double plastic_shear = plastic / (1 - kN / 3);
    volumetric_strain = elastic_volume - kN * plastic_shear;
  }
};

}  // namespace triax::sim::test

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// A virtual campaign of triaxial tests on one sand, of which everything is known.
#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "lab/devices/transducer.hpp"
#include "lab/results/quantity.hpp"
#include "src/study/soil/sheared_test.hpp"

namespace triax::bench {

using Transducers = std::array<lab::Transducer, lab::kRawQuantityCount>;

/// A class of instruments with what a laboratory of that class errs by in the void ratio.
struct InstrumentClass {
  std::string name;
  Transducers transducers;
  double void_ratio_error = 0;  ///< standard
};
/// "ideal", "advanced", "standard", as the program's sets have them.
std::vector<InstrumentClass> instrument_classes();

/// The sand: NorSand with a logarithmic or a power line, SANISAND (compression and extension, power
/// line), or Mohr and Coulomb (c′ and φ′ only).
enum class Sand { norsand_log, norsand_power, sanisand, mohr_coulomb };
inline constexpr int kSands = 4;
std::string to_string(Sand sand);

/// What is put into one test.
enum class Spoilt { none, void_ratio, load_cell, cell_pressure };
inline constexpr int kSpoilt = 4;
inline constexpr double kSpoiltVoidRatio = 0.08, kSpoiltForce = 1.15, kSpoiltCellPressure = 25e3;
std::string to_string(Spoilt spoilt);

struct SoilTruth {
  std::optional<double> m, m_extension, gamma, lambda, e0, slope, exponent;
  std::optional<double> cohesion_kPa, friction_angle_deg;
  std::function<double(double)> critical_void_ratio;           ///< of p′ in kPa; empty: none
  std::function<std::optional<double>(double, double)> onset;  ///< η of ψ₀ and p′₀ in kPa
};

struct Campaign {
  Sand sand = Sand::norsand_log;
  std::string instruments;
  SoilTruth truth;
  std::vector<study::ShearedTest> tests;
  Spoilt spoilt = Spoilt::none;
  std::string spoilt_test;
  bool spoilt_drained = false;
  double spoilt_deviations = 0;  ///< size of the error beside the scatter (limit.hpp)
  double could_be_named = 0;     ///< the chance of the best test
};

/// 4 to 20 tests; a set of Mohr and Coulomb 3 to 8. The seed chooses the sand's parameters, how far
/// the tests are sheared (15 to 30 %), p′₀ (50 to 500 kPa), ψ₀ and drainage. Each specimen has a
/// critical state line and friction of its own (standard deviations 0.005 in e and 1 % in M; 1 % of
/// the strength in the sets). The calibration of each instrument (its non-linearity) is one of the
/// campaign.
Campaign make_campaign(std::uint64_t seed, Sand sand, const InstrumentClass& instruments,
                       Spoilt spoilt = Spoilt::none);

}  // namespace triax::bench

// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/triaxial/sheet/corrections_box.hpp"

#include <fmt/format.h>

#include <numbers>

#include "src/study/sheet/load_corrections.hpp"

namespace triax::src {
namespace {

std::string area_words(const SheetTest& test) {
  const auto& failure = test.values.failure;
  const auto& start = test.result.stored.summary.consolidation;
  if (!failure || !start.diameter_m) return {};
  return fmt::format("A = A_c(1 − ε_v)/(1 − ε₁) = {:.1f} mm² (A_c = {:.1f} mm²)",
                     failure->state.area_m2 * 1e6,
                     std::numbers::pi / 4 * *start.diameter_m * *start.diameter_m * 1e6);
}

/// By the standard that was applied; of none, how large that of D4767 would be.
std::string membrane_words(const SheetTest& test) {
  const auto& stored = test.result.stored;
  const auto& specimen = stored.header.specimen;
  const auto& applied = stored.summary.membrane_correction;
  const auto& start = stored.summary.consolidation;
  if (applied.empty()) return "unknown: the record was already reduced";
  if (!specimen.membrane_modulus_pa || !specimen.membrane_thickness_m) return "none applied";
  const bool iso = applied == "iso", none = applied == "none";
  const auto& d = iso ? specimen.diameter_m : start.diameter_m;
  const double e = *specimen.membrane_modulus_pa, t = *specimen.membrane_thickness_m;
  std::string text = none ? "none applied; ASTM D4767 would subtract Δq = 4 E t ε₁/D_c"
                     : iso ? "ISO 17892-9: Δσ₁ = (4 E t/D)(ε₁ + ε_v/3), Δσ₃ = (4 E t/D) ε_v/3"
                           : "ASTM D4767: Δq = 4 E t ε₁/D_c";
  if (test.values.failure && d) {
    const auto& s = test.values.failure->state;
    const double k = 4 * e * t / *d * 1e-3;
    text +=
        iso ? fmt::format(": {:.2f}, {:.2f} kPa", k * (s.strain.axial + s.volumetric_strain / 3),
                          k * s.volumetric_strain / 3)
            : fmt::format(" = {:.2f} kPa", k * s.strain.axial);
  }
  text += fmt::format(" (E = {:.0f} kPa, t = {:.2f} mm", e * 1e-3, t * 1e3);
  if (d) text += fmt::format(", D = {:.1f} mm", *d * 1e3);
  return text + (none ? ")" : "); subtracted");
}

std::string side_drain_words(const study::LoadCorrections& corrections) {
  const auto& drains = corrections.side_drains;
  if (!drains) return corrections.why_no_side_drains;
  const double kPa = drains->taken_off_pa * 1e-3;
  if (!drains->load_n_per_m)
    return fmt::format(
        "BS 1377-8, Table 2: Δq = {:.2f} kPa (D = {:.1f} mm; below ε₁ = 2 % in "
        "proportion)",
        kPa, drains->diameter_m * 1e3);
  return fmt::format(
      "ASTM D4767: Δq = K_fp P_fp/A_c · min(ε₁/2 %, 1) = {:.2f} kPa (K_fp = {:.3g} kN/m, P_fp = "
      "{:.0f} % of π D_c, D_c = {:.1f} mm)",
      kPa, *drains->load_n_per_m * 1e-3, drains->cover * 100, drains->diameter_m * 1e3);
}

std::string piston_words(const study::LoadCorrections& corrections) {
  const auto& piston = corrections.piston;
  if (!piston) return corrections.why_no_piston;
  if (piston->area_m2 == 0)
    return fmt::format("Δq = R/A = {:.2f} kPa (R = {:.1f} N)", piston->taken_off_pa * 1e-3,
                       piston->friction_n);
  return fmt::format(
      "Δq = (R + a_p(σ_c − σ_c0) − m g)/A = {:.2f} kPa (R = {:.1f} N, a_p = {:.1f} mm², σ_c − σ_c0 "
      "= {:.1f} kPa, m g = {:.1f} N)",
      piston->taken_off_pa * 1e-3, piston->friction_n, piston->area_m2 * 1e6,
      (piston->cell_pressure_pa - piston->zero_pressure_pa) * 1e-3, piston->weight_n);
}

}  // namespace

SheetBox corrections_box(const SheetTest& test) {
  SheetBox box{.title = "Corrections (values at failure)"};
  const auto& stored = test.result.stored;
  const auto corrections = study::load_corrections(stored, test.values, test.words);
  const auto add = [&](const char* label, const std::string& value) {
    if (!value.empty()) box.facts.push_back({label, {value}});
  };
  add("area",
      stored.header.is_raw() ? area_words(test) : "as in the record, which was already reduced");
  add("membrane", membrane_words(test));
  add("side drains", side_drain_words(corrections));
  add("piston", piston_words(corrections));
  if (const auto left = corrections.q_left_pa(test.values))
    add("q_f without them", fmt::format("{:.1f} − {:.2f} = {:.1f} kPa: side drains and piston are "
                                        "NOT subtracted in any other value and figure",
                                        test.values.failure->state.q * 1e-3,
                                        corrections.taken_off_pa() * 1e-3, *left * 1e-3));
  return box;
}

}  // namespace triax::src

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Short tests with the instruments of a laboratory, and every fault that a device can have.
#include <fmt/format.h>

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "lab/devices/fault.hpp"
#include "lab/programmes/programme_reader.hpp"
#include "lab/rig/session.hpp"
#include "lab/rig/simulated/virtual_rig.hpp"

namespace triax::lab::testing {

/// What a short test is made of; consolidation is over 60 s after its start, shear begins at 75 s.
struct ShortTest {
  std::string name, type;
  double p_eff_kPa = 100, void_ratio = 1.086;
  double compliance_mm3_per_kPa = 0.1;
  std::string shear;  ///< the stages of shear
};

inline std::string text_of(const ShortTest& t) {
  return fmt::format(R"([test]
name = "{}"
type = "{}"
seed = 6
scan_interval_s = 0.5
[specimen]
material = "inl2/S28-general"
height_mm = 140.0
diameter_mm = 70.0
void_ratio = {}
initial_effective_stress_kPa = {}
[rig]
back_pressure_kPa = 300.0
water_bulk_modulus_GPa = 2.2
system_compliance_mm3_per_kPa = {}
drainage_resistance_kPa_s_per_mm3 = 0.1
[rig.frame]
travel_mm = 24.0
load_limit_N = 5000.0
bandwidth_Hz = 1.0
[rig.cell_controller]
time_constant_s = 0.1
fluid_compliance_mm3_per_kPa = 20.0
capacity_cm3 = 400.0
[rig.back_controller]
time_constant_s = 0.1
fluid_compliance_mm3_per_kPa = 3.0
capacity_cm3 = 200.0
[rig.transducers.axial_displacement]
range_mm = 25.0
bits = 18
noise_mm = 0.0005
[rig.transducers.axial_force]
range_N = 5000.0
bits = 18
noise_N = 0.5
[rig.transducers.cell_pressure]
range_kPa = 2000.0
bits = 18
noise_kPa = 0.05
[rig.transducers.pore_pressure]
range_kPa = 2000.0
bits = 18
noise_kPa = 0.05
[rig.transducers.back_pressure]
range_kPa = 2000.0
bits = 16
noise_kPa = 0.1
[rig.transducers.back_volume]
range_mm3 = 100000.0
resolution_mm3 = 1.0
[rig.transducers.cell_volume]
range_mm3 = 400000.0
resolution_mm3 = 1.0
[[stages]]
name = "consolidation"
role = "consolidation"
drainage = "open"
axial = "free"
cell_rate_kPa_per_min = 20.0
cell_target_kPa = {}
end = [{{quantity = "cell_pressure_kPa", above = {}}}]
[[stages]]
name = "rest"
role = "consolidation"
drainage = "open"
axial = "free"
end = [{{quantity = "time_s", above = 15.0}}]
)",
                     t.name, t.type, t.void_ratio, t.p_eff_kPa - 20, t.compliance_mm3_per_kPa,
                     300 + t.p_eff_kPa, 300 + t.p_eff_kPa) +
         t.shear;
}

inline std::string undrained(const std::string& axial, const std::string& end) {
  return "[[stages]]\nname = \"undrained\"\nrole = \"shear\"\ndrainage = "
         "\"closed\"\ntime_limit_min = 30.0\n" +
         axial + "\nend = [" + end + "]\n";
}

inline std::vector<ShortTest> short_tests() {
  const std::string constant_q = R"(
[[stages]]
name = "drained shear"
role = "shear"
time_limit_min = 30.0
drainage = "open"
axial = "displacement"
axial_rate_mm_per_min = {}
end = [{{quantity = "q_kPa", above = {}}}]
[[stages]]
name = "at constant q"
role = "shear"
time_limit_min = 30.0
drainage = "{}"
axial = "constant_q"
cell_rate_kPa_per_min = {}
{}
end = [{{quantity = "axial_strain_pct", above = 3.0}}, {{quantity = "p_eff_kPa", below = 2.0}}]
)";
  // A logger that averages, as slow stages have it: what stands out of four looks, a mean dilutes.
  const std::string means = "scan_interval_s = 1.0\naveraging_s = 1.0";
  return {
      {"loose, by displacement", "ICU", 100, 1.088, 0.1,
       undrained("axial = \"displacement\"\naxial_rate_mm_per_min = 0.5",
                 "{quantity = \"axial_strain_pct\", above = 1.0}")},
      {"loose, by load", "ICU", 100, 1.088, 0.1,
       undrained("axial = \"load\"\nload_rate_N_per_min = 100.0",
                 "{quantity = \"axial_strain_pct\", above = 3.0}")},
      {"loose, drained at constant q", "CSD", 100, 1.192, 0.1,
       fmt::format(fmt::runtime(constant_q), 0.1, 30, "open", -12, means)},
      {"loose, undrained at constant q", "CSU", 300, 1.073, 2.0,
       fmt::format(fmt::runtime(constant_q), 0.3, 180, "closed", -15, "")},
      {"dense, by displacement", "ICU", 300, 0.752, 0.1,
       undrained("axial = \"displacement\"\naxial_rate_mm_per_min = 2.0",
                 "{quantity = \"axial_strain_pct\", above = 4.0}")},
  };
}

/// Every fault of every device, for good from that time on; sizes that matter.
inline std::vector<Fault> every_fault(double from_s) {
  const auto size = [](const std::string& device, FaultKind kind) {
    const bool volume = device.ends_with("volume");
    const bool force = device == "axial_force", way = device == "axial_displacement";
    if (kind == FaultKind::latency) return 5.0;
    if (kind == FaultKind::leak) return 1e-9 / 60 * 500 / 1e5;
    const double spike = way ? 1e-3 : force ? 100 : volume ? 2e-6 : 50e3;
    if (kind == FaultKind::spike) return spike;
    return kind == FaultKind::drift ? spike / 5 / 60 : 0;
  };
  std::vector<Fault> all;
  for (const std::string& device : fault_devices())
    for (const FaultKind kind : possible_faults(device))
      all.push_back({device, kind, from_s, {}, size(device, kind)});
  return all;
}

struct Outcome {
  TestSummary summary;
  std::vector<Event> events;
  double last_time_s = 0;
  std::optional<double> shear_from_s;
  std::optional<double> told_s;  ///< when the first collapse was told, while the test ran
  bool safe() const {
    return std::ranges::any_of(summary.warnings,
                               [](const Warning& w) { return w.text.starts_with("safe state"); });
  }
  /// What the rig's software and the look at the sensors said, beside the injected faults.
  std::string said() const {
    std::string all;
    for (const Warning& w : summary.warnings)
      if (!w.text.starts_with("simulated fault")) all += w.text + '\n';
    return all;
  }
};

inline Outcome run_with(Programme programme, std::vector<Fault> faults) {
  programme.faults = std::move(faults);
  VirtualRig rig(programme);
  Outcome out;
  SessionListener listener;
  listener.happened = [&](const Event& event) {
    out.events.push_back(event);
    const bool collapse =
        event.kind == EventKind::loss_of_sustainability || event.kind == EventKind::limit_surface;
    if (collapse && !out.told_s) out.told_s = out.last_time_s;
  };
  listener.scanned = [&](const Reading& reading, const State&) {
    out.last_time_s = reading.time_s;
    if (!out.shear_from_s && rig.header().stage(reading.stage)->role == StageRole::shear)
      out.shear_from_s = reading.time_s;
  };
  out.summary = run_session(rig, {}, {listener});
  return out;
}

}  // namespace triax::lab::testing

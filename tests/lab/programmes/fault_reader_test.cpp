// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/programmes/fault_reader.hpp"

#include <catch2/catch.hpp>

#include "tests/lab/programmes/rig_text.hpp"

using namespace triax::lab;
using Catch::Contains;

namespace {
const std::string kRanged = "[rig.transducers.pore_pressure]\nrange_kPa = 1000\n";

Fault read_one_fault(const std::string& lines) {
  return test::with_rig(kRanged + "[[faults]]\n" + lines).faults.at(0);
}
/// The first of `lines` is line 17.
std::string complaint_of_faults(const std::string& lines) {
  return test::complaint_of_rig(kRanged + "[[faults]]\n" + lines);
}
}  // namespace

TEST_CASE("faults are read in SI, in the order of the file") {
  const auto faults = test::with_rig(kRanged + R"([[faults]]
device = "pore_pressure"
kind = "stuck"
from_min = 60
[[faults]]
device = "pore_pressure"
kind = "open_circuit"
from_s = 90
until_min = 2
[[faults]]
device = "axial_force"
kind = "spike"
from_s = 0
until_s = 50
spike_N = 20
)")
                          .faults;
  REQUIRE(faults.size() == 3);
  CHECK(faults[0] == Fault{.device = "pore_pressure", .kind = FaultKind::stuck, .from_s = 3600});
  CHECK(faults[1] == Fault{.device = "pore_pressure",
                           .kind = FaultKind::open_circuit,
                           .from_s = 90,
                           .until_s = 120});
  CHECK(faults[2] == Fault{.device = "axial_force",
                           .kind = FaultKind::spike,
                           .from_s = 0,
                           .until_s = 50,
                           .size = 20});
}

TEST_CASE("a fault's size has the unit of its device in the name of its key") {
  const std::string from = "from_s = 1\n";
  CHECK(
      read_one_fault(from + "device = \"pore_pressure\"\nkind = \"drift\"\ndrift_kPa_per_min = -6")
          .size == Approx(-100));
  CHECK(read_one_fault(from + "device = \"axial_displacement\"\nkind = \"spike\"\nspike_mm = 2")
            .size == Approx(2e-3));
  CHECK(
      read_one_fault(from + "device = \"back_volume\"\nkind = \"latency\"\nlatency_s = 2.5").size ==
      2.5);
  CHECK(read_one_fault(from + "device = \"cell_controller\"\nkind = \"leak\"\n"
                              "leak_mm3_per_min_at_100kPa = 6")
            .size == Approx(1e-15));
  CHECK(read_one_fault(from + "device = \"valve\"\nkind = \"does_not_close\"").kind ==
        FaultKind::does_not_close);
}

TEST_CASE("every device takes every fault that is possible for it") {
  for (const auto& device : fault_devices())
    for (const FaultKind kind : possible_faults(device)) {
      const auto channel = find_quantity(device);
      std::string lines = "device = \"" + device + "\"\nkind = \"" + std::string(to_string(kind)) +
                          "\"\nfrom_s = 1\n";
      const std::string unit = device == "axial_force" ? "N"
                               : channel               ? std::string(info(*channel).unit)
                                                       : "";
      if (kind == FaultKind::spike) lines += "spike_" + unit + " = 1\n";
      if (kind == FaultKind::drift) lines += "drift_" + unit + "_per_min = 1\n";
      if (kind == FaultKind::latency) lines += "latency_s = 1\n";
      if (kind == FaultKind::leak) lines += "leak_mm3_per_min_at_100kPa = 1\n";
      INFO(lines);
      if (channel && kind == FaultKind::open_circuit)
        lines = "[rig.transducers." + device + "]\nrange_" + unit + " = 1000\n[[faults]]\n" + lines;
      else
        lines = "[[faults]]\n" + lines;
      CHECK(test::complaint_of_rig(lines) == "accepted");
    }
}

TEST_CASE("a fault that a device cannot have is refused with those that it can have") {
  CHECK_THAT(
      complaint_of_faults("device = \"valve\"\nkind = \"spike\"\nfrom_s = 1"),
      Contains("p.toml:18: [faults 1] kind: 'spike' is not a fault of valve; must be one of: "
               "does_not_close, does_not_open"));
  CHECK_THAT(complaint_of_faults("device = \"frame\"\nkind = \"drop_out\"\nfrom_s = 1"),
             Contains("must be one of: stuck"));
  CHECK_THAT(complaint_of_faults("device = \"pore_presure\"\nkind = \"stuck\"\nfrom_s = 1"),
             Contains("p.toml:17") && Contains("did you mean 'pore_pressure'?"));
  CHECK_THAT(complaint_of_faults("device = \"q_kPa\"\nkind = \"stuck\"\nfrom_s = 1"),
             Contains("valve"));
}

TEST_CASE("an open circuit without a range is refused") {
  CHECK_THAT(
      complaint_of_faults("device = \"axial_force\"\nkind = \"open_circuit\"\nfrom_s = 1"),
      Contains("p.toml:18") && Contains("it needs range_N in [rig.transducers.axial_force]"));
}

TEST_CASE("times and sizes of faults that cannot be are refused") {
  const std::string stuck = "device = \"pore_pressure\"\nkind = \"stuck\"\n";
  CHECK_THAT(complaint_of_faults(stuck), Contains("from_min or from_s is missing"));
  CHECK_THAT(complaint_of_faults(stuck + "from_s = -1"), Contains("p.toml:19"));
  CHECK_THAT(complaint_of_faults(stuck + "from_s = 1\nfrom_min = 1"),
             Contains("either from_min or from_s"));
  CHECK_THAT(complaint_of_faults(stuck + "from_s = 60\nuntil_min = 1"),
             Contains("p.toml:20") && Contains("is not after"));
  CHECK_THAT(complaint_of_faults(stuck + "from_s = 1\nspike_kPa = 4"),
             Contains("unknown key 'spike_kPa'"));
  const std::string spike = "device = \"pore_pressure\"\nkind = \"spike\"\nfrom_s = 1\n";
  CHECK_THAT(complaint_of_faults(spike), Contains("spike_kPa is missing"));
  CHECK_THAT(complaint_of_faults(spike + "spike_kPa = 0"), Contains("p.toml:20"));
  CHECK_THAT(complaint_of_faults(spike + "spike_N = 5"), Contains("is 'spike_N' a misspelling"));
  const std::string late = "device = \"pore_pressure\"\nkind = \"latency\"\nfrom_s = 1\n";
  // 60 readings of 1 s
  CHECK(complaint_of_faults(late + "latency_s = 60") == "accepted");
  CHECK_THAT(complaint_of_faults(late + "latency_s = 61"), Contains("at most 60"));
  CHECK_THAT(complaint_of_faults("device = \"pore_pressure\"\nkind = \"drift\"\nfrom_s = 1\n"
                                 "drift_kPa_per_min = 0"),
             Contains("leave the fault out"));
}

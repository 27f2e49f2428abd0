// SPDX-License-Identifier: GPL-3.0-or-later
// The benchmark's record, shorter: parsed, reduced and judged as in bench/replay.
#include <fmt/format.h>
#include <catch2/catch.hpp>

#include "bench/replay/synthetic_record.hpp"
#include "lab/rig/recorded.hpp"
#include "lab/rig/session.hpp"

using namespace triax;

TEST_CASE("the benchmark's record collapses near the true peak of q, through its noise") {
  constexpr long kRows = 50000;
  bench::SyntheticRecord record(kRows);
  std::string text =
      "time_s,axial_displacement_mm,axial_force_kN,cell_pressure_kPa,back_pressure_kPa,"
      "pore_pressure_kPa,back_volume_mm3\n";
  for (long i = 0; i < kRows; ++i) {
    const auto r = record.row(i);
    text += fmt::format("{:.1f},{:.4f},{:.6f},{:.3f},{:.3f},{:.3f},{:.1f}\n", r.time_s,
                        r.displacement_mm, r.force_kN, r.cell_kPa, r.back_kPa, r.pore_kPa,
                        r.volume_mm3);
  }
  const auto rig = lab::open_record(
      lab::open_memory("record.csv", text),
      {.dialect = {}, .sets = {{"specimen.height_mm", "140"}, {"specimen.diameter_mm", "70"}}});
  const lab::TestSummary s = lab::run_session(*rig, {});
  CHECK(s.readings == kRows);
  REQUIRE(s.collapse.kind == lab::CollapseKind::flow);
  const double peak_strain = 12.0 / 140 * double(record.peak_row()) / double(kRows - 1);
  CHECK(*s.collapse.onset->axial_strain == Approx(peak_strain).epsilon(0.06));
  CHECK(*s.collapse.onset->q_pa == Approx(bench::SyntheticRecord::q(peak_strain)).epsilon(0.01));
}

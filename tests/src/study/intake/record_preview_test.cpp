// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/study/intake/record_preview.hpp"

#include <catch2/catch.hpp>

using namespace triax;
using study::Json;

namespace {

std::string reduced_record(int rows) {
  std::string text = "axial_strain_pct,deviator_stress_kPa,mean_effective_stress_kPa\n";
  for (int i = 0; i < rows; ++i)
    text += std::to_string(0.001 * i) + ',' + std::to_string(i) + ',' +
            std::to_string(200 - i / 8) + '\n';
  return text;
}

}  // namespace

TEST_CASE("preview_json: the stress path in kPa, first and last reading", "[intake]") {
  const auto rig = lab::open_record(lab::open_memory("x.csv", reduced_record(1600)), {});
  const Json preview = study::preview_json(*rig);
  CHECK(preview["readings"] == 1600);
  CHECK(preview["missing"].empty());
  const Json& path = preview["path"];
  REQUIRE(path["q_kPa"].size() == 800);
  CHECK(path["p_eff_kPa"].size() == 800);
  CHECK(path["q_kPa"].front() == 0);
  CHECK(path["q_kPa"].back().get<double>() == Approx(1599));
  CHECK(path["p_eff_kPa"].front().get<double>() == Approx(200));
  CHECK(path["p_eff_kPa"].back().get<double>() == Approx(1));
}

TEST_CASE("preview_json: no path without the specimen of a raw record", "[intake]") {
  std::string text =
      "time_s,axial_displacement_mm,axial_force_kN,cell_pressure_kPa,pore_pressure_kPa\n";
  for (int i = 0; i < 30; ++i)
    text += std::to_string(i) + ',' + std::to_string(0.01 * i) + ',' + std::to_string(0.001 * i) +
            ",600,500\n";
  const auto rig = lab::open_record(lab::open_memory("x.csv", text), {});
  const Json preview = study::preview_json(*rig);
  CHECK(preview["path"].is_null());
  REQUIRE(preview["missing"].size() == 2);
  CHECK(preview["missing"][0]["key"] == "specimen.height_mm");
}

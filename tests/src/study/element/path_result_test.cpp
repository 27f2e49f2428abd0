// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/study/element/path_result.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "lab/paths/path_reader.hpp"
#include "src/element/path_json.hpp"
#include "src/element/path_text.hpp"
#include "src/study/element/run_element.hpp"
#include "tests/lab/paths/path_text.hpp"

using namespace triax;
using nlohmann::json;

namespace {

study::PathResult result_of(const std::string& toml) {
  return study::run_element(lab::read_path(toml, "p.toml"));
}

}  // namespace

TEST_CASE("a tensor's rows hold its components") {
  const auto result = result_of(lab::test::with(lab::test::kPath, "p_eff_kPa = 100.0",
                                                "stress_kPa = [100, 90, 80, 0, 0, 0]"));
  CHECK(result.value(result.start, "effective_stress_33_kPa") == 80.0);
  CHECK(result.value(result.last, "strain_11").value() == Approx(0.02));
}

TEST_CASE("the verdict of a lost control names condition, place and state") {
  const auto result = result_of(lab::test::with(
      lab::test::with(lab::test::kPath, "axial_strain = 0.02", "q_kPa = 300"), "1.0", "1.086"));
  CHECK(result.outcome == sim::StepOutcome::lost_control);
  CHECK(result.limiting_variable == "q_kPa");
  for (const char* part : {"q_kPa", "compression", "37.211 kPa", "p'"})
    CHECK(result.message.find(part) != std::string::npos);
  const std::string text = src::path_text(result);
  CHECK(text.find("simulated") != std::string::npos);
  CHECK(text.find("outcome     lost_control: " + result.message) != std::string::npos);
  CHECK(json::parse(src::path_json(result))["message"] == result.message);
}

TEST_CASE("where the stress vanishes no ratio of it is told, and round-off is no peak") {
  const std::string stress = "\"radial_stress_kPa = 0\"", drained = "undrained";
  auto dilated = lab::test::with(lab::test::kPath, stress, "\"volumetric_strain = -0.05\"");
  dilated = lab::test::with(dilated, drained, "drained");
  const auto gone =
      result_of(lab::test::with(dilated, "axial_strain = 0.02", "axial_strain = 0.05"));
  CHECK(gone.outcome == sim::StepOutcome::failed);
  CHECK(gone.limiting_variable.empty());
  CHECK(gone.message.find("the effective stress has vanished") != std::string::npos);
  CHECK(gone.message.find("eta") == std::string::npos);
  CHECK_FALSE(gone.told_eta(gone.last));
  CHECK(gone.told_eta(gone.start) == 0.0);
  CHECK(src::path_text(gone).find("largest |q|") != std::string::npos);

  const auto swollen =
      result_of(lab::test::with(dilated, "\"axial_strain = 0.02\", \"volumetric_strain = -0.05\"",
                                "\"axial_strain = -0.0005\", \"radial_strain = -0.0005\""));
  REQUIRE(swollen.went_to_the_end());
  CHECK(json::parse(src::path_json(swollen))["peak"].is_null());
  CHECK(src::path_text(swollen).find("largest |q|") == std::string::npos);
}

TEST_CASE("leaving the range of the set is said once for each quantity, with the place") {
  using lab::test::with;
  const auto warned = [](const study::PathResult& result, const std::string& words) {
    return std::ranges::count_if(result.warnings, [&](const std::string& warning) {
      return warning.find(words) != std::string::npos;
    });
  };
  const auto within = result_of(lab::test::kPath);
  CHECK(warned(within, "outside the range") == 0);

  const auto liquefied =
      result_of(with(with(lab::test::kPath, "void_ratio = 1.0", "void_ratio = 1.19"),
                     "axial_strain = 0.02", "axial_strain = 0.1"));
  CHECK(warned(liquefied, "outside the range") == 1);
  std::size_t i = 0;
  while (liquefied.value(liquefied.rows.at(i), "p_eff_kPa").value() >= 10) ++i;
  REQUIRE(i > 0);
  const double strain = 100 * liquefied.value(liquefied.rows[i], "axial_strain").value();
  CHECK(warned(liquefied, fmt::format("from axial strain {:.3f} % on p' is ", strain)) == 1);
  CHECK(warned(liquefied, "kPa, outside the range 10 to 1000 kPa of sanisand/S28-general") == 1);

  const auto dense = result_of(with(with(lab::test::kPath, "void_ratio = 1.0", "void_ratio = 0.65"),
                                    "p_eff_kPa = 100.0", "p_eff_kPa = 1200.0"));
  CHECK(warned(dense, "at the start void ratio is 0.65, outside the range 0.7 to 1.2") == 1);
  CHECK(warned(dense, "at the start p' is 1200 kPa, outside the range 10 to 1000 kPa") == 1);
  CHECK(warned(dense, "outside the range") == 2);
}

// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/probe/strain_paths_json.hpp"

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "src/probe/strain_paths_figures.hpp"
#include "src/probe/strain_paths_text.hpp"

using namespace triax;
using nlohmann::json;

namespace {

study::StrainPathsResult loose(const std::vector<double>& R) {
  return study::strain_paths({.material = lab::find_material("inl2/S28-general"),
                              .p = 100e3,
                              .void_ratio = 1.086,
                              .R = R,
                              .axial_strain = 0.02});
}

}  // namespace

TEST_CASE("R = 1 is the undrained test: its printed peak, where W2 vanishes") {
  const json d = json::parse(src::strain_paths_json(loose({1.0})));
  CHECK(d["origin"] == "simulated");
  CHECK(d["start"]["p_eff_kPa"] == 100.0);
  const json& path = d["strain_paths"][0];
  CHECK(path["peak"]["q_kPa"].get<double>() == Approx(44.62).margin(0.05));
  CHECK(path["peak"]["eta"].get<double>() == Approx(0.5954).margin(5e-4));
  CHECK(path["peak"]["axial_strain"].get<double>() == Approx(0.00414).margin(2e-5));
  CHECK(path["first_unstable"]["axial_strain"].get<double>() ==
        Approx(path["peak"]["axial_strain"].get<double>()).epsilon(1e-5));
  CHECK(path["message"].is_null());
  CHECK(path["points"].size() > 100);
  CHECK(path["points"][0]["control_stress_kPa"].get<double>() == Approx(0).margin(1e-9));
}

TEST_CASE("a path that ends before its end is told, as is a path without a peak") {
  const auto result = loose({0.7, 3.0});
  REQUIRE(result.warnings.size() >= 1);
  CHECK(result.warnings[0].find("R 0.7: ") == 0);
  const json d = json::parse(src::strain_paths_json(result));
  CHECK(d["strain_paths"][0]["message"].is_string());
  CHECK(d["strain_paths"][1]["peak"].is_null());
  const std::string text = src::strain_paths_text(result);
  CHECK(text.find("(simulated)") != std::string::npos);
  CHECK(text.find("–") != std::string::npos);
}

TEST_CASE("the data hold all points of all paths") {
  const auto result = loose({0.8, 1.0});
  const auto data = src::strain_paths_data(result);
  CHECK(data.origin == "simulated");
  CHECK(data.rows.size() == result.paths[0].points.size() + result.paths[1].points.size());
  for (const auto& row : data.rows) {
    REQUIRE(row.size() == data.columns.size());
    // sigma1 - sigma3/R from p' and q
    const double s1 = *row[3] + 2 * *row[4] / 3, s3 = *row[3] - *row[4] / 3;
    CHECK(*row[2] == Approx(s1 - s3 / *row[0]).margin(1e-9));
  }
  CHECK(src::strain_paths_drawing(result).caption.find("inl2/S28-general") != std::string::npos);
}

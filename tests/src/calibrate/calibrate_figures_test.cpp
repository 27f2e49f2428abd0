// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/calibrate/calibrate_figures.hpp"

#include <catch2/catch.hpp>

#include "bench/calibrate/virtual_tests.hpp"
#include "src/calibrate/calibrate_text.hpp"
#include "tests/src/contains.hpp"

using namespace triax;
using namespace triax::src;

TEST_CASE("figures and text show measured beside computed of each kind of test") {
  const auto set = lab::find_material("mohr_coulomb/Hostun-loose");
  study::CalibrationRequest request{
      .start = set, .free = {{"friction_angle_deg", 20, 45}}, .searches = 1};
  std::mt19937_64 dice(1);
  for (const auto imposed : {study::Imposed::drained, study::Imposed::undrained})
    request.paths.push_back(bench::virtual_path(set, {imposed, 100, 0.9}, {0.2, 1e-5}, dice, 60));
  const auto found = study::calibrate(request);
  const auto figures = calibrate_figures(found);
  REQUIRE(figures.size() == 2);
  CHECK(figures[0].name == "undrained");
  CHECK(figures[1].name == "drained");
  for (const auto& figure : figures) {
    const std::string svg = to_svg(*figure.drawing.plot);
    CHECK(svg.find("calibrated") != std::string::npos);
    CHECK(figure.data.origin == "simulated");
    CHECK(figure.data.rows.size() == found.measured[figure.name == "drained" ? 0 : 1].knots.size());
  }
  const std::string text = calibrate_text(found);
  for (const char* part : {"friction_angle_deg", "1 of 1 ended there", "volumetric_strain",
                           "Misfit", "mohr_coulomb from 2 tests"})
    CHECK(text.find(part) != std::string::npos);
}

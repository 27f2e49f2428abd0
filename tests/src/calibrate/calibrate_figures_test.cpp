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
  for (const char* part : {"friction_angle_deg", "1 of 1 ended at this optimum",
                           "volumetric_strain", "Misfit", "mohr_coulomb from 2 tests"})
    CHECK(text.find(part) != std::string::npos);
}

TEST_CASE("the domain that a set implies is drawn and told, with the scatter of the draws") {
  const auto set = lab::find_material("hypoplastic/Toyoura-HG99");
  study::CalibrationRequest request{.start = set,
                                    .free = {{"critical_friction_angle_deg", 25, 40}},
                                    .searches = 1,
                                    .left_out = false,
                                    .domain = true};
  std::mt19937_64 dice(1);
  for (const double p_kPa : {100, 300})
    request.paths.push_back(
        bench::virtual_path(set, {study::Imposed::undrained, p_kPa, 0.95}, {0.5, 1e-5}, dice, 60));
  const auto found = study::calibrate(request);
  REQUIRE(found.domain);
  const auto figures = calibrate_figures(found);
  REQUIRE(figures.size() == 2);
  CHECK(figures[1].name == "domain");
  const std::string svg = to_svg(*figures[1].drawing.plot);
  for (const char* part : {"first unstable direction", "plastic limit", "onset of collapse",
                           "deviator stress q (kPa)", "e = 0.95"})
    CHECK(svg.find(part) != std::string::npos);
  const auto& data = figures[1].data;
  CHECK(data.rows.size() == found.domain->compression.size() + found.domain->cones.size());
  for (const auto& row : data.rows) CHECK(row.size() == data.columns.size());
  const std::string text = calibrate_text(found);
  for (const char* part : {"Cones and domain that the set implies, at e = 0.95", "first unstable",
                           "of 200 sets drawn", "100 %", "opening"})
    CHECK(text.find(part) != std::string::npos);
}

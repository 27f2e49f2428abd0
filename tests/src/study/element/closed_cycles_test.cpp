// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/study/element/closed_cycles.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

#include "lab/paths/path_reader.hpp"
#include "src/study/element/run_element.hpp"

using namespace triax;

namespace {

constexpr double kP1 = 60, kP2 = 150, kQ1 = 10, kQ2 = 50;  // kPa

/// p1, q1 -> p2, q1 -> p2, q2 -> p1, q2 -> p1, q1, or the other way round.
std::string rectangle(const std::string& material, const std::string& parameters, bool forward,
                      int rows = 200) {
  std::string toml = fmt::format(
      "[path]\nname = \"cycle\"\nmaterial = \"{}\"\n{}[start]\nvoid_ratio = 0.8\n"
      "stress_kPa = {{axial = {}, radial = {}}}\n",
      material, parameters, kP1 + 2 * kQ1 / 3, kP1 - kQ1 / 3);
  const double dp = kP2 - kP1, dq = kQ2 - kQ1;
  const std::pair<double, double> legs[] = {{dp, 0}, {0, dq}, {-dp, 0}, {0, -dq}};
  const int order[2][4] = {{0, 1, 2, 3}, {1, 0, 3, 2}};
  for (int i = 0; i < 4; ++i) {
    const auto& [p, q] = legs[order[forward ? 0 : 1][i]];
    toml += fmt::format(
        "[[segments]]\nname = \"leg {}\"\ndrainage = \"drained\"\nrows = {}\n"
        "conditions = [\"p_kPa = {}\", \"q_kPa = {}\"]\n",
        i + 1, rows, p, q);
  }
  return toml;
}

bool warned(const std::string& toml) {
  const auto result = study::run_element(lab::read_path(toml, "cycle.toml"));
  REQUIRE(result.went_to_the_end());
  return std::ranges::any_of(result.warnings, [](const std::string& words) {
    return words.find("closed cycle of stress that ends with segment leg 4") != std::string::npos;
  });
}

}  // namespace

TEST_CASE("a closed cycle that gives work for nothing is told, by its amount") {
  const auto description = lab::read_path(rectangle("elastic/Hostun-loose", "", true), "c.toml");
  const auto& path = std::get<sim::Path<sim::Axisymmetric>>(description.path);
  const auto cycle =
      study::least_closed_cycle(sim::run_path(*description.material.material.axisymmetric, path));
  REQUIRE(cycle);
  const auto shear = [](double p_kPa) { return 60e6 / 2.4 * std::pow(p_kPa / 100, 0.65); };
  const double closed = 1e6 * (kQ2 * kQ2 - kQ1 * kQ1) / 6 * (1 / shear(kP2) - 1 / shear(kP1));
  CHECK(cycle->work == Approx(closed).epsilon(1e-3));
  CHECK(cycle->segment == 3);

  CHECK(warned(rectangle("elastic/Hostun-loose", "", true)));
  // The other way round the same work is lost, which any plastic law may do.
  CHECK_FALSE(warned(rectangle("elastic/Hostun-loose", "", false)));
  // Two rows a leg do not say it.
  CHECK_FALSE(warned(rectangle("elastic/Hostun-loose", "", true, 2)));
}

TEST_CASE("with an energy no cycle is told of, nor of a linear law") {
  const std::string energy = "[parameters]\nhyperelastic = 1\n";
  for (const bool forward : {true, false}) {
    CHECK_FALSE(warned(rectangle("elastic/Hostun-loose", energy, forward)));
    CHECK_FALSE(warned(rectangle("elastic/linear", "", forward)));
  }
  const std::string clay = "[parameters]\noverconsolidation_ratio = 20\n";
  CHECK(warned(rectangle("cam_clay/Hostun-like", clay, true)));
  CHECK_FALSE(warned(rectangle("cam_clay/Hostun-like", clay + "hyperelastic = 1\n", true)));
  CHECK_FALSE(warned(rectangle("cam_clay/Hostun-like", clay + "hyperelastic = 1\n", false)));
}

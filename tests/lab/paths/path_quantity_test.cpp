// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/paths/path_quantity.hpp"

#include <catch2/catch.hpp>
#include <set>

#include "sim/point/path_runner.hpp"

using namespace triax;

TEST_CASE("keys are there once and say their unit, components behind the triaxial ones") {
  std::set<std::string_view> seen;
  bool components = false;
  for (const auto& row : lab::path_quantity_keys()) {
    INFO(row.key);
    CHECK(seen.insert(row.key).second);
    CHECK((row.scale == 1e3) == row.key.ends_with("_kPa"));
    CHECK((row.scale == 1e-2) == row.key.ends_with("_pct"));
    CHECK(row.lowest < row.highest);
    const bool component = row.quantity >= sim::PathQuantity::strain_component;
    CHECK(component >= components);
    components = component;
  }
}

TEST_CASE("a component's key is the component") {
  sim::PathPoint<sim::Tensor> at;
  at.stress << 1e3, 2e3, 3e3, 4e3 * std::numbers::sqrt2, 0, 0;
  at.strain << 0.1, 0.2, 0.3, 0, 0, 0.6 * std::numbers::sqrt2;
  at.pore_pressure = 10e3;
  const auto value = [&](std::string_view key) {
    for (const auto& row : lab::path_quantity_keys())
      if (row.key == key) return *sim::value_of(row.quantity, row.component, at) / row.scale;
    return -1.0;
  };
  CHECK(value("effective_stress_22_kPa") == Approx(2));
  CHECK(value("stress_33_kPa") == Approx(13));
  CHECK(value("stress_12_kPa") == Approx(4));
  CHECK(value("strain_23") == Approx(0.6));
  CHECK(value("radial_strain_pct") == Approx(25));
}

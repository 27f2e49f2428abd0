// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/intake/meaning.hpp"

#include <catch2/catch.hpp>

using namespace triax::lab;

namespace {

ColumnSample column(std::string heading, std::vector<double> values, double half_unit = 0.005,
                    std::string unit_of_row = {}) {
  return {{std::move(heading)}, std::move(unit_of_row), std::move(values), half_unit};
}

std::string text(const ColumnMeaning& column) {
  const ColumnReading& reading = column.reading;
  if (!reading.quantity) return "not used";
  return reading.quantity->name + (reading.sign < 0 ? " -" : " ") + reading.unit;
}

}  // namespace

TEST_CASE("Meaning: p' and q of the two-dimensional kind are found by the pore pressure") {
  const std::vector columns{column("Strain (%)", {0, 0.5, 1, 2, 4}),
                            column("q (kPa)", {0, 30.9, 42.25, 48.2, 52}),
                            column("p' (kPa)", {150, 149.5, 140.25, 136.9, 137.9}),
                            column("u (kPa)", {200, 231.4, 252, 261.3, 264.1})};
  const Meaning meaning = find_meaning(columns, {});
  CHECK(text(meaning.columns[0]) == "axial_strain %");
  CHECK(text(meaning.columns[1]) == "half_deviator_stress kPa");
  CHECK(text(meaning.columns[2]) == "mean_effective_stress_2d kPa");
  CHECK(text(meaning.columns[3]) == "pore_pressure kPa");
}

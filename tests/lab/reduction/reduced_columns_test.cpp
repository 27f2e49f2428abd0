// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/reduction/reduced_columns.hpp"

#include <catch2/catch.hpp>
#include <utility>
#include <vector>

#include "lab/records/channels.hpp"

using namespace triax::lab;
using enum Quantity;

namespace {

// One state in every measure: σ₁′ = 150, σ₃′ = 90, u = 40 kPa.
const std::vector<std::pair<Quantity, double>> kMeasures = {
    {effective_axial_stress, 150e3}, {effective_radial_stress, 90e3}, {deviator_stress, 60e3},
    {mean_effective_stress, 110e3},  {stress_ratio, 60.0 / 110},      {axial_stress, 190e3},
    {radial_stress, 130e3},          {cell_pressure, 130e3},          {pore_pressure, 40e3}};

struct Reduced {
  State state;
  std::string missing;
};

Reduced reduce(const std::vector<Quantity>& stresses) {
  RecordHeader header;
  header.columns = stresses;
  header.columns.push_back(axial_strain);
  Reading reading;
  reading[axial_strain] = 0.01;
  for (const auto& [quantity, value] : kMeasures)
    if (std::ranges::count(stresses, quantity)) reading[quantity] = value;
  return {ReducedColumns(header).reduce(reading), missing_channels(header.columns)};
}

void check_whole(const State& state) {
  CHECK(state.q == Approx(60e3));
  CHECK(state.p_eff == Approx(110e3));
  CHECK(state.effective_stress.axial == Approx(150e3));
  CHECK(state.effective_stress.radial == Approx(90e3));
  CHECK(state.strain.axial == 0.01);
}

RecordHeader header_of(std::vector<Quantity> columns, Drainage drainage = Drainage::open) {
  RecordHeader header;
  header.columns = std::move(columns);
  header.stages = {{.number = 1, .role = StageRole::shear, .drainage = drainage}};
  return header;
}

}  // namespace

TEST_CASE("ReducedColumns: shear begins behind the stages before it") {
  RecordHeader header = header_of({axial_strain, deviator_stress, mean_effective_stress});
  header.stages.insert(header.stages.begin(), {.number = 0, .role = StageRole::consolidation});
  ReducedColumns columns(header);
  for (const auto& [stage, p_eff] : {std::pair(0, 50e3), {0, 180e3}, {1, 200e3}, {1, 210e3}}) {
    Reading reading;
    reading.stage = stage;
    reading[axial_strain] = 0;
    reading[deviator_stress] = 0;
    reading[mean_effective_stress] = p_eff;
    columns.reduce(reading);
  }
  CHECK(columns.consolidation().p_eff_pa == 200e3);
}

TEST_CASE("each pair of stresses gives the whole state of stress") {
  const std::vector<Quantity> combination =
      GENERATE(values<std::vector<Quantity>>({{effective_axial_stress, effective_radial_stress},
                                              {deviator_stress, mean_effective_stress},
                                              {deviator_stress, effective_axial_stress},
                                              {deviator_stress, effective_radial_stress},
                                              {deviator_stress, stress_ratio},
                                              {mean_effective_stress, stress_ratio},
                                              {axial_stress, radial_stress, pore_pressure},
                                              {deviator_stress, radial_stress, pore_pressure},
                                              {deviator_stress, cell_pressure, pore_pressure}}));
  INFO(heading(combination[0]) << ", " << heading(combination[1]));
  const auto [state, missing] = reduce(combination);
  CHECK(missing.empty());
  check_whole(state);
}

TEST_CASE("whatever the channels' check lets through is completed, with the pore pressure") {
  int complete = 0;
  for (unsigned set = 0; set < 1U << kMeasures.size(); ++set) {
    std::vector<Quantity> stresses;
    for (std::size_t i = 0; i < kMeasures.size(); ++i)
      if (set >> i & 1U) stresses.push_back(kMeasures[i].first);
    const auto [state, missing] = reduce(stresses);
    if (!missing.empty()) continue;
    ++complete;
    check_whole(state);
    const bool total = std::ranges::any_of(stresses, [](Quantity q) {
      return q == axial_stress || q == radial_stress || q == cell_pressure || q == pore_pressure;
    });
    CHECK(std::isnan(state.pore_pressure) == !total);
    if (total) CHECK(state.pore_pressure == Approx(40e3));
  }
  CHECK(complete > 100);
}

TEST_CASE("q and eta of an isotropic state say nothing of p', and nothing becomes infinite") {
  ReducedColumns columns(header_of({axial_strain, deviator_stress, stress_ratio}));
  Reading reading;
  reading[deviator_stress] = 0;
  reading[stress_ratio] = 0;
  CHECK(std::isnan(columns.reduce(reading).p_eff));
  reading[deviator_stress] = 1e3;
  CHECK(std::isnan(columns.reduce(reading).p_eff));
  CHECK_FALSE(columns.consolidation().p_eff_pa);
}

TEST_CASE("an excess pore pressure stands for the pore pressure only where nothing else does") {
  Reading reading;
  reading[deviator_stress] = 60e3;
  reading[mean_effective_stress] = 110e3;
  reading[excess_pore_pressure] = 7e3;
  ReducedColumns alone(
      header_of({axial_strain, deviator_stress, mean_effective_stress, excess_pore_pressure}));
  CHECK(alone.reduce(reading).pore_pressure == 7e3);
  CHECK(alone.warnings().size() == 3);  // reduced; no volume; excess only
  // A gap in the pore pressure's own column is not filled from another zero.
  ReducedColumns both(header_of(
      {axial_strain, deviator_stress, mean_effective_stress, excess_pore_pressure, pore_pressure}));
  CHECK(std::isnan(both.reduce(reading).pore_pressure));
  CHECK(both.warnings().size() == 2);
}

TEST_CASE("the volumetric strain comes from what is there") {
  Reading reading;
  reading[axial_strain] = 0.03;
  const auto volumetric = [&](Drainage drainage) {
    return ReducedColumns(header_of({axial_strain}, drainage)).reduce(reading).volumetric_strain;
  };
  CHECK(volumetric(Drainage::closed) == 0);
  CHECK(std::isnan(volumetric(Drainage::open)));
  reading[shear_strain] = 0.028;
  CHECK(volumetric(Drainage::open) == Approx(0.006));
  reading[shear_strain] = kMissing;
  // A measured diameter: what is left of the volume of the cylinder is 0.97 · 1.012².
  reading[radial_strain] = -0.012;
  CHECK(volumetric(Drainage::open) == Approx(1 - 0.97 * 1.012 * 1.012));

  ReducedColumns columns(header_of({axial_strain, void_ratio}));
  Reading voids;
  voids[axial_strain] = 0;
  voids[void_ratio] = 1.0;
  CHECK(columns.reduce(voids).volumetric_strain == 0);
  voids[void_ratio] = 0.98;
  const State state = columns.reduce(voids);
  CHECK(state.volumetric_strain == Approx(0.01));
  CHECK(state.void_ratio == 0.98);
  CHECK(*columns.consolidation().void_ratio == 1.0);
}

// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/records/truth_toml.hpp"

#include <catch2/catch.hpp>

#include "lab/base/bad_input.hpp"
#include "sim/mechanics/units.hpp"

using namespace triax::lab;

namespace {

Truth read_back(const std::string& text) {
  const TomlTable document = TomlTable::parse(text, "m");
  return read_truth(document.required_table("truth"));
}

}  // namespace

TEST_CASE("run-aways read back to the bit, what is unknown stays empty") {
  Truth truth;
  truth.lost_sustainability = true;
  truth.time_s = 12.25;
  truth.q_pa = triax::sim::to_si(56.49, *triax::sim::find_unit("kPa"));
  truth.run_aways = {
      {12.25, 0.1 + 0.2, 12.5, 1e-6, -3.1e-6, 0.67, 12.75, RunAwayEnd::new_equilibrium, 0.0125,
       triax::sim::to_si(56.3, *triax::sim::find_unit("kPa")), 97e3, 521e3},
      {40, 2, 41, {}, {}, {}, {}, RunAwayEnd::none}};
  const Truth found = read_back(truth_toml(truth));
  CHECK(found.time_s == 12.25);
  CHECK(found.q_pa == truth.q_pa);
  CHECK_FALSE(found.axial_strain);
  REQUIRE(found.run_aways.size() == 2);
  CHECK(found.run_aways[0].start_s == 12.25);
  CHECK(found.run_aways[0].largest_kinetic_energy_j == 0.1 + 0.2);
  CHECK(found.run_aways[0].largest_at_s == 12.5);
  CHECK(found.run_aways[0].kinetic_energy_j == 1e-6);
  CHECK(found.run_aways[0].second_order_work_j == -3.1e-6);
  CHECK(found.run_aways[0].expected_ratio == 0.67);
  CHECK(found.run_aways[0].end_s == 12.75);
  CHECK(found.run_aways[0].end == RunAwayEnd::new_equilibrium);
  CHECK(found.run_aways[0].axial_strain == 0.0125);
  CHECK(found.run_aways[0].q_pa == truth.run_aways[0].q_pa);
  CHECK(found.run_aways[0].p_eff_pa == 97e3);
  CHECK(found.run_aways[0].pore_pressure_pa == 521e3);
  CHECK_FALSE(found.run_aways[1].q_pa);
  CHECK_FALSE(found.run_aways[1].kinetic_energy_j);
  CHECK_FALSE(found.run_aways[1].end_s);
  CHECK(found.run_aways[1].end == RunAwayEnd::none);
}

TEST_CASE("a run-away that cannot be is refused at its line") {
  const std::string good =
      "[truth]\n[[truth.run_aways]]\nstart_s = 5\nlargest_kinetic_energy_J = 1\n"
      "largest_at_s = 6\n";
  CHECK(read_back(good).run_aways.size() == 1);
  CHECK_THROWS_WITH(read_back(good + "end_s = 4\n"),
                    Catch::StartsWith("m:6: ") && Catch::Contains("before start_s"));
  CHECK_THROWS_WITH(read_back(good + "ending = \"a bang\"\n"),
                    Catch::StartsWith("m:6: ") && Catch::Contains("new equilibrium"));
  CHECK_THROWS_WITH(read_back(good + "energy_J = 1\n"), Catch::Contains("unknown key 'energy_J'"));
  CHECK_THROWS_WITH(read_back(good + "end_s = inf\n"), Catch::Contains("end_s"));
  CHECK_THROWS_WITH(read_back("[truth]\n[[truth.run_aways]]\nlargest_at_s = 6\n"),
                    Catch::Contains("start_s is missing"));
}

// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/triaxial/facts/run_away_fact.hpp"

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "src/output/words.hpp"
#include "src/triaxial/json_report.hpp"
#include "src/triaxial/text_report.hpp"
#include "tests/src/sample_tests.hpp"

using namespace triax;
using namespace triax::src;
using namespace triax::study;
using Catch::Contains;

namespace {

const lab::RunAwayTruth kArrested{3.5,   12.3e-3, 3.7,  2e-6,
                                  -4e-6, 0.99,    3.75, lab::RunAwayEnd::new_equilibrium};

}  // namespace

TEST_CASE("energies are written with the prefix that suits them") {
  CHECK(joules(2.5) == "2.5 J");
  CHECK(joules(0.0) == "0 J");
  CHECK(joules(12.3e-3) == "12.3 mJ");
  CHECK(joules(-4.56e-6) == "-4.56 µJ");
  CHECK(joules(7e-9) == "7 nJ");
  CHECK(joules({}) == kUnknown);
}

TEST_CASE("a run-away is told with its energy, Eq. (5) and its end; many are counted") {
  const auto lines =
      run_away_lines({kArrested, {40, 2, 41, {}, {}, {}, {}, lab::RunAwayEnd::none}});
  REQUIRE(lines.size() == 2);
  CHECK_THAT(
      lines[0],
      Contains("at 3.5 s") && Contains("12.3 mJ after 0.2 s") &&
          Contains(
              "E_c 2 µJ against −W₂/2 2 µJ, ratio 1.000 where 0.990 is expected (past the peak)") &&
          Contains("new equilibrium after 0.25 s"));
  CHECK_THAT(lines[1], Contains("not resolved") && Contains("still moving when the test ended"));
  const auto many = run_away_lines(std::vector<lab::RunAwayTruth>(12, kArrested));
  REQUIRE(many.size() == 6);
  CHECK(many.back() == "and 7 more");
}

TEST_CASE("reports and documents carry the run-aways of the truth") {
  auto test = src::test::simulated_test();
  CHECK(text_report({test}).find("Runaway") == std::string::npos);
  test.stored.summary.truth->run_aways = {kArrested};
  test.stored.sweep = db::SweepMembership{"s", 4, {{"seed", "7"}, {"specimen.material", "a/b"}}};
  CHECK_THAT(text_report({test}),
             Contains("Runaway") && Contains("number 4 of the sweep s: seed = 7"));
  const auto d = nlohmann::json::parse(json_report({test}));
  const auto& run_away = d["collapse"]["truth"]["run_aways"][0];
  CHECK(run_away["largest_kinetic_energy_J"] == 12.3e-3);
  CHECK(run_away["kinetic_energy_over_half_work"] == Approx(1));
  CHECK(run_away["expected_ratio"] == 0.99);
  CHECK(run_away["ending"] == "new equilibrium");
  CHECK(d["test"]["sweep"]["values"]["seed"] == 7);
  CHECK(d["test"]["sweep"]["values"]["specimen.material"] == "a/b");
  CHECK(nlohmann::json::parse(json_of_test(test)) == d);
}

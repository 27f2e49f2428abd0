// SPDX-License-Identifier: GPL-3.0-or-later
#include <catch2/catch.hpp>

#include "bench/calibrate/virtual_tests.hpp"
#include "src/study/calibrate/calibration.hpp"
#include "tests/sim/materials/umat_fixture.hpp"

using namespace triax;
using namespace triax::study;

namespace {

lab::MaterialSet set_with(sim::test::Misbehaviour what) {
  lab::MaterialSet set{.name = "umat/cone", .law = sim::find_law("umat")};
  set.parameters = sim::test::umat_fixture(what);
  set.material = sim::test::make_umat(set.parameters);
  return set;
}

}  // namespace

TEST_CASE("numbers of a UMAT are found from tests that it made", "[slow]") {
  if (!sim::test::umat_fixture_is_there()) return;
  lab::MaterialSet start{.name = "umat/cone", .law = sim::find_law("umat")};
  start.parameters = sim::test::umat_fixture();
  start.material = sim::test::make_umat(start.parameters);
  CalibrationRequest request{.start = start, .searches = 1, .seed = 1, .threads = 1};
  std::mt19937_64 dice(1);
  for (const double p_kPa : {100, 200})
    request.paths.push_back(
        bench::virtual_path(start, {Imposed::drained, p_kPa, 0.8}, {}, dice, 60));
  request.free = lab::read_search(R"([search]
"properties.2" = [5000.0, 40000.0]
"properties.3" = [0.9, 1.5]
)",
                                  "umat.toml");
  request.start.parameters.lists["properties"][1] = 20e3;
  request.start.parameters.lists["properties"][2] = 1.0;
  request.start.material = sim::test::make_umat(request.start.parameters);
  const auto found = calibrate(request);
  REQUIRE(found.parameters.size() == 2);
  CHECK(found.parameters[0].value == Approx(sim::test::kShear).epsilon(0.01));
  CHECK(found.parameters[1].value == Approx(sim::test::kM).epsilon(0.01));
  CHECK(found.material.parameters.lists.at("properties")[2] == found.parameters[1].value);
}

TEST_CASE("A plug-in that crashes is a misfit that no parameter lessens") {
  if (!sim::test::umat_fixture_is_there()) return;
  const auto free = lab::read_search(R"([search]
"properties.3" = [0.9, 1.5]
)",
                                     "umat.toml");
  std::mt19937_64 dice(1);
  const std::vector<MeasuredPath> paths = {bench::virtual_path(
      set_with(sim::test::Misbehaviour::none), {Imposed::drained, 100, 0.8}, {}, dice, 20)};
  const SearchSpace sound(set_with(sim::test::Misbehaviour::none), free);
  const Misfit good(sound, paths, 1, {});
  CHECK(good.residuals_of({sound.start_point()}).norm() < 0.05);
  for (const auto what : {sim::test::Misbehaviour::null_pointer, sim::test::Misbehaviour::stop,
                          sim::test::Misbehaviour::nan_stress}) {
    const SearchSpace space(set_with(what), free);
    const Misfit misfit(space, paths, 1, {});
    const auto r = misfit.residuals_of(
        {Unknowns::Constant(1, 0.1), Unknowns::Constant(1, 0.5), Unknowns::Constant(1, 0.9)});
    CHECK(r.allFinite());
    CHECK(r.col(0).norm() > kRefused);  // two series, each of weight 1
    CHECK(r.col(0) == r.col(1));
    CHECK(r.col(0) == r.col(2));
  }
}

namespace {

/// What a set of the fixture implies, as if its M had been calibrated on a test of a sound one.
ImpliedDomain implied_by(sim::test::Misbehaviour what) {
  const auto free = lab::read_search(R"([search]
"properties.3" = [0.9, 1.5]
)",
                                     "umat.toml");
  std::mt19937_64 dice(1);
  const std::vector<MeasuredPath> paths = {bench::virtual_path(
      set_with(sim::test::Misbehaviour::none), {Imposed::drained, 100, 0.8}, {}, dice, 20)};
  const Uncertainty sure{.parameters = {{.key = "properties.3"}},
                         .covariance = Eigen::MatrixXd::Constant(1, 1, 1e-4),
                         .degrees_of_freedom = 30};
  const SearchSpace space(set_with(what), free);
  const Misfit misfit(space, paths, 2, {});
  return implied_domain(misfit, space.start_point(), sure, {}, [](double) { return true; }).value();
}

}  // namespace

TEST_CASE("A UMAT is asked for its domain by fewer draws at fewer states", "[slow]") {
  if (!sim::test::umat_fixture_is_there()) return;
  const ImpliedDomain found = implied_by(sim::test::Misbehaviour::none);
  CHECK(found.draws == 10);
  CHECK(found.compression.size() == 3);
  CHECK_THAT(found.none, Catch::Contains("before the plastic limit"));
}

TEST_CASE("A UMAT that crashes has no domain and says so") {
  if (!sim::test::umat_fixture_is_there()) return;
  const ImpliedDomain found = implied_by(sim::test::Misbehaviour::stop);
  CHECK(found.draws == 0);  // nothing is gained by crashing it again
  CHECK_FALSE(found.compression[0].limit.best);
  CHECK_THAT(found.none, Catch::Contains("gives no result in some directions"));
}

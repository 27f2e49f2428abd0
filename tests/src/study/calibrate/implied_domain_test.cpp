// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/study/calibrate/implied_domain.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "bench/calibrate/virtual_tests.hpp"
#include "sim/mechanics/axisymmetric.hpp"
#include "src/study/calibrate/implied_domain_json.hpp"
#include "src/study/calibrate/parameter_draws.hpp"
#include "src/study/domain/domain_run.hpp"
#include "src/study/domain/usual_grid.hpp"
#include "src/study/student.hpp"

using namespace triax;
using namespace triax::study;
using Catch::Contains;

namespace {

using Unknown = std::pair<lab::SearchRange, double>;  ///< with its standard error in the space

/// A set as if it had been calibrated on some tests of itself.
struct Calibrated {
  Calibrated(const std::string& name, const std::vector<Unknown>& unknowns, double degrees = 30)
      : space(lab::find_material(name), ranges(unknowns)), sure{.degrees_of_freedom = degrees} {
    std::mt19937_64 dice(1);
    for (const Imposed imposed : {Imposed::drained, Imposed::undrained})
      paths.push_back(bench::virtual_path(space.start(), {imposed, 200, 0.95}, {}, dice, 60));
    const auto n = static_cast<Eigen::Index>(unknowns.size());
    sure.covariance = Eigen::MatrixXd::Zero(n, n);
    for (const auto& [range, error] : unknowns) {
      const auto i = static_cast<Eigen::Index>(sure.parameters.size());
      sure.covariance(i, i) = error * error;
      sure.parameters.push_back({.key = range.key, .determined = error < 0.25});
    }
  }
  static std::vector<lab::SearchRange> ranges(const std::vector<Unknown>& unknowns) {
    std::vector<lab::SearchRange> all;
    for (const auto& [range, error] : unknowns) all.push_back(range);
    return all;
  }
  ImpliedDomain domain(int threads = 2, int draws = 40) const {
    const Misfit misfit(space, paths, threads, {});
    return implied_domain(misfit, space.start_point(), sure, {.seed = 3, .draws = draws},
                          [](double) { return true; })
        .value();
  }

  SearchSpace space;
  std::vector<MeasuredPath> paths;
  Uncertainty sure;
};

const std::string kSandByName = "hypoplastic/Toyoura-HG99";
Unknown friction(double error, double low = 25, double high = 40) {
  return {{.key = "critical_friction_angle_deg", .low = low, .high = high}, error};
}

double standard_deviation_of(const ParameterDraws& draws, Eigen::Index unknown) {
  double sum = 0, squares = 0;
  for (const Unknowns& x : draws.points) sum += x(unknown), squares += x(unknown) * x(unknown);
  const auto n = static_cast<double>(draws.points.size());
  return std::sqrt(squares / n - sum * sum / n / n);
}

/// M of Mohr-Coulomb in triaxial compression.
double ratio_of(double friction_deg) {
  const double sine = std::sin(sim::radians(friction_deg));
  return 6 * sine / (3 - sine);
}

}  // namespace

TEST_CASE("sets are drawn from Student's distribution of the estimate") {
  const Calibrated c(kSandByName, {friction(0.02)}, 4);
  const Unknowns x = c.space.start_point();
  const auto draws = draw_parameters(c.space, x, c.sure, 4000, 1);
  REQUIRE(draws.points.size() == 4000);
  const double wide = student_quantile(4, 0.95) * 0.02;
  const auto inside = std::ranges::count_if(
      draws.points, [&](const Unknowns& y) { return std::abs(y(0) - x(0)) < wide; });
  CHECK(static_cast<double>(inside) / 4000 == Approx(0.95).margin(0.012));  // 3.5 of its errors
  CHECK(draw_parameters(c.space, x, c.sure, 5, 1).points[4] == draws.points[4]);
  CHECK(draw_parameters(c.space, x, c.sure, 1, 2).points[0] != draws.points[0]);
}

TEST_CASE("a parameter that is not determined stays within its range and leaves others alone") {
  Calibrated c(kSandByName,
               {friction(0.02), {{.key = "peak_exponent", .low = 0.01, .high = 0.5}, 1e4}}, 1000);
  REQUIRE_FALSE(c.sure.parameters[1].determined);
  const auto draws = draw_parameters(c.space, c.space.start_point(), c.sure, 2000, 1);
  REQUIRE(draws.points.size() == 2000);
  for (const Unknowns& x : draws.points) CHECK((x.minCoeff() >= 0 && x.maxCoeff() <= 1));
  CHECK(draws.outside > 0);
  CHECK(standard_deviation_of(draws, 0) == Approx(0.02).epsilon(0.06));
  CHECK(standard_deviation_of(draws, 1) > 0.15);
  // What is told of the other where both stand for each other: b known at its range's variance
  // leaves a what it has beyond that.
  c.sure.covariance << 1.01e4, 1e4, 1e4, 1e4;
  CHECK(bounded_covariance(c.sure)(0, 0) == Approx(1e2 + 1.0 / 12).epsilon(1e-3));
}

TEST_CASE("sets that the law refuses are drawn anew and counted") {
  // The law wants the critical void ratio above the densest one.
  const auto sand = lab::find_material(kSandByName);
  const double densest = *value_of(sand, "densest_void_ratio");
  const double critical = *value_of(sand, "critical_void_ratio");
  const Calibrated c(
      kSandByName,
      {{{.key = "critical_void_ratio", .low = densest - 0.4, .high = critical + 0.1}, 0.6}});
  const auto draws = draw_parameters(c.space, c.space.start_point(), c.sure, 200, 1);
  REQUIRE(draws.points.size() == 200);
  CHECK(draws.refused > 5);
  for (const Unknowns& x : draws.points) CHECK(c.space.possible(x));
}

TEST_CASE("the best set has the domain that triax domain maps") {
  const Calibrated c(kSandByName, {friction(0)});
  const ImpliedDomain found = c.domain(2, 12);
  REQUIRE(found.none.empty());
  CHECK(found.void_ratio == 0.95);
  CHECK(found.of_collapsed);  // the undrained one
  for (const ImpliedBoundary& at : found.compression) {
    const double p_kPa = at.p / 1e3;
    const auto grid = asked_grid(c.space.start(),
                                 {.p = {p_kPa, p_kPa, 1},
                                  .q = {0, 1.3 * p_kPa, 60},
                                  .void_ratio = 0.95,
                                  .plane = "axisymmetric",
                                  .directions = 360},
                                 {});
    const auto mapped = run_domain({.material = c.space.start(), .grid = grid, .threads = 1})
                            .columns[0]
                            .compression;
    INFO(p_kPa << " kPa");
    CHECK(at.first_unstable.best.value() == Approx(mapped.first_unstable->eta).epsilon(1e-6));
    CHECK(sim::degrees(*at.first_angle.best) ==
          Approx(*mapped.first_unstable->alpha_deg).epsilon(1e-4));
    CHECK(at.isotropic_unloading.best.value() ==
          Approx(mapped.isotropic_unloading->eta).epsilon(1e-6));
    CHECK(at.limit.best.value() == Approx(mapped.limit->eta).epsilon(1e-6));
    // Without error of the parameters all draws are the best set.
    CHECK(at.first_unstable.share == 1);
    CHECK(*at.first_unstable.high - *at.first_unstable.low < 1e-12);
  }
  REQUIRE_FALSE(found.cones.empty());
  for (const ImpliedCone& cone : found.cones) {
    const auto grid = asked_grid(c.space.start(),
                                 {.p = {cone.p / 1e3, cone.p / 1e3, 1},
                                  .q = {cone.q / 1e3, cone.q / 1e3 + 1, 2},
                                  .void_ratio = 0.95,
                                  .plane = "axisymmetric",
                                  .directions = 360},
                                 {});
    const auto mapped =
        run_domain({.material = c.space.start(), .grid = grid, .threads = 1}).columns[0].states[0];
    REQUIRE(mapped.cones_deg.size() == 1);
    CHECK(sim::degrees(*cone.from.best) == Approx(mapped.cones_deg[0].first).epsilon(1e-6));
    CHECK(sim::degrees(*cone.to.best) == Approx(mapped.cones_deg[0].second).epsilon(1e-6));
    CHECK(*cone.opening.best == Approx(*cone.to.best - *cone.from.best));
    CHECK(*cone.opening.high - *cone.opening.low < 1e-12);
  }
}

TEST_CASE("the interval of a number that one parameter decides is the image of its interval") {
  // The plastic limit of Mohr-Coulomb, M = 6 sin phi/(3 - sin phi), whatever e and p' are.
  const double error = 0.05;
  const Calibrated c("mohr_coulomb/Hostun-loose",
                     {{{.key = "friction_angle_deg", .low = 20, .high = 45}, error}});
  const ImpliedDomain found = c.domain(2, 150);
  CHECK_THAT(found.none, Contains("before the plastic limit"));
  CHECK(found.cones.empty());
  const double best = *value_of(c.space.start(), "friction_angle_deg");
  const double half = student_quantile(30, 0.95) * error * 25;
  for (const ImpliedBoundary& at : found.compression) {
    CHECK_FALSE(at.first_unstable.best);
    CHECK(at.first_unstable.share == 0);
    CHECK(at.limit.share == 1);
    CHECK(*at.limit.best == Approx(ratio_of(best)).epsilon(1e-6));
    // The quantiles of 150 draws are known to about a tenth of the width.
    const double wide = ratio_of(best + half) - ratio_of(best - half);
    CHECK(*at.limit.low == Approx(ratio_of(best - half)).margin(0.15 * wide));
    CHECK(*at.limit.high == Approx(ratio_of(best + half)).margin(0.15 * wide));
  }
}

TEST_CASE("cones and domain do not depend on the number of threads, and stop when asked") {
  const Calibrated c(kSandByName, {friction(0.05)});
  const auto one = implied_domain_json(c.domain(1)), two = implied_domain_json(c.domain(2));
  CHECK(one.dump() == two.dump());
  CHECK(one["compression"][0]["first_unstable"]["high"].get<double>() >
        one["compression"][0]["first_unstable"]["low"].get<double>());
  const Misfit misfit(c.space, c.paths, 2, {});
  int asked = 0;
  CHECK_FALSE(implied_domain(misfit, c.space.start_point(), c.sure, {.seed = 3},
                             [&](double) { return ++asked < 4; }));
  CHECK(asked == 4);
}

TEST_CASE("each law that ships with ranges has a domain or says why not") {
  const std::vector<std::pair<std::string, std::string>> said = {
      {"sanisand/Toyoura-DM04", ""},
      {"cam_clay/check", "before the plastic limit (η = 1.000"},
      {"norsand/S28-true-state", "gives no result in some directions"}};
  for (const auto& [name, why] : said) {
    INFO(name);
    const Calibrated c(name, {{{.key = "critical_stress_ratio", .low = 0.8, .high = 1.5}, 0.02}});
    const ImpliedDomain found = c.domain(2, 12);
    if (why.empty())
      CHECK(found.none.empty());
    else
      CHECK_THAT(found.none, Contains(why));
    CHECK(found.none.find('\n') == std::string::npos);
  }
}

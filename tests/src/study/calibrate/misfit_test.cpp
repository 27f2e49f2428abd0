// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/study/calibrate/misfit.hpp"

#include <catch2/catch.hpp>
#include <map>

#include "bench/calibrate/virtual_tests.hpp"
#include "lab/base/bad_input.hpp"
#include "src/study/calibrate/global_search.hpp"
#include "src/study/calibrate/least_squares.hpp"

using namespace triax;
using namespace triax::study;

namespace {

const lab::MaterialSet& toyoura() {
  static const lab::MaterialSet set = lab::find_material("hypoplastic/Toyoura-HG99");
  return set;
}

std::vector<MeasuredPath> two_tests(const lab::MaterialSet& set) {
  std::mt19937_64 dice(1);
  return {bench::virtual_path(set, {Imposed::drained, 100, 0.75}, {}, dice),
          bench::virtual_path(set, {Imposed::undrained, 200, 0.90}, {}, dice)};
}

}  // namespace

TEST_CASE("the true parameters have no misfit, and each knot counts by its weight") {
  const auto paths = two_tests(toyoura());
  const SearchSpace space(toyoura(), lab::shipped_search("hypoplastic"));
  const Misfit misfit(space, paths, 2, {.tolerance = 1e-8, .step_limit = 20000});
  const double at_truth = misfit.sum_of_squares(space.start_point(), 1e9);
  CHECK(at_truth < 1e-8);
  CHECK(misfit.residuals_of({space.start_point()}).squaredNorm() == Approx(at_truth));

  // Off by one scale everywhere: Σ r² is 1 for each series.
  ComputedPath off{.knots = paths[0].knots, .reached = static_cast<double>(paths[0].knots.size())};
  for (auto& knot : off.knots) {
    knot.q += paths[0].scale[0];
    knot.volumetric_strain -= paths[0].scale[1];
  }
  CHECK(residuals(paths[0], off).squaredNorm() == Approx(2));
}

TEST_CASE("the further a law comes before it refuses, the smaller the sum, without steps") {
  const MeasuredPath path = two_tests(toyoura()).front();
  double before = 1e300;
  for (double reached = 0; reached <= static_cast<double>(path.knots.size()); reached += 0.25) {
    ComputedPath part{
        .knots = {path.knots.begin(), path.knots.begin() + static_cast<std::ptrdiff_t>(reached)},
        .reached = reached,
        .last = reached < 1 ? path.start : path.knots[static_cast<std::size_t>(reached) - 1]};
    const double sum = residuals(path, part).squaredNorm();
    CHECK(sum <= before);
    before = sum;
  }
  CHECK(before == 0);
}

TEST_CASE(
    "beside a path that ends where the law refuses, slopes are the law's and not the penalty's") {
  lab::MaterialSet set = lab::find_material("sanisand/Toyoura-DM04");
  // Loosens until its hardening vanishes at e = 1/c_h, where the law ends and so does the test.
  for (const auto& [key, value] :
       std::map<std::string, double>{{"shear_modulus_factor", 112.74},
                                     {"critical_stress_ratio", 1.21108},
                                     {"critical_void_ratio", 1.05189},
                                     {"critical_slope", 0.0135057},
                                     {"critical_exponent", 0.708924},
                                     {"hardening_factor", 3.54517},
                                     {"hardening_void_ratio_factor", 1.05792},
                                     {"bounding_exponent", 1.60613},
                                     {"dilatancy_factor", 0.807467},
                                     {"dilatancy_exponent", 4.22102}})
    set.parameters.numbers.at(key) = value;
  set.material = set.law->make(set.parameters, {});
  std::mt19937_64 dice(1);
  const std::vector<MeasuredPath> paths = {
      bench::virtual_path(set, {Imposed::drained, 100, 0.787286}, {}, dice)};
  const SearchSpace space(set, {{"critical_void_ratio", 0.6, 1.4}});
  const Misfit misfit(space, paths, 1, {.tolerance = 1e-7, .step_limit = 4000});
  const Unknowns x = space.start_point();
  const auto beside = [&](double step) { return Unknowns::Constant(1, x(0) + step); };
  const Driven driven = misfit.driven({x, beside(1e-3), beside(-1e-3), beside(-1e-4)});
  REQUIRE(driven.whole(0, 0));
  REQUIRE_FALSE(driven.whole(0, 1));
  REQUIRE(driven.whole(0, 2));
  const Eigen::VectorXd slopes = (driven.residuals.col(0) - driven.residuals.col(3)) / 1e-4;
  const auto found = residuals_with_slopes(misfit, x);
  CHECK((found.jacobian.topRows(slopes.size()) - slopes).norm() < 0.02 * slopes.norm());
}

TEST_CASE("what the law refuses is brought back to where it does not, towards the start") {
  const SearchSpace space(toyoura(), lab::shipped_search("hypoplastic"));
  Unknowns x = space.start_point();
  x(3) = 2;   // e_d0 beyond its bound, and so above e_c0
  x(0) = -1;  // below its bound
  const Unknowns near = space.possible_near(x);
  CHECK(space.possible(near));
  CHECK(near.minCoeff() >= 0);
  CHECK(near.maxCoeff() <= 1);
  CHECK(near(3) > space.start_point()(3));  // as far as it goes
  CHECK(space.possible_near(space.start_point()) == space.start_point());
}

TEST_CASE("values and unknowns are each other's inverse, in ratios where a range is wide") {
  const SearchSpace space(toyoura(), lab::shipped_search("hypoplastic"));
  CHECK(space.ranges()[1].in_logarithm);
  for (const double x : {0.0, 0.3, 1.0})
    for (Eigen::Index i = 0; i < space.size(); ++i) {
      CHECK(space.unknown(i, space.value(i, x)) == Approx(x).margin(1e-12));
      CHECK(space.slope(i, x) ==
            Approx((space.value(i, x + 1e-6) - space.value(i, x - 1e-6)) / 2e-6).epsilon(1e-4));
    }
  CHECK(space.value(1, 0) == Approx(1e5));
  CHECK(space.value(1, 1) == Approx(1e8));
  CHECK_THROWS_WITH(SearchSpace(toyoura(), {{"speed", 0, 1}}),
                    Catch::Contains("hypoplastic/Toyoura-HG99 has no number 'speed'"));
}

TEST_CASE("NorSand has a pore fluid in undrained tests and none in drained ones") {
  const auto set = lab::find_material("norsand/S28-MT-drained");
  const auto modulus = [&](Imposed imposed) {
    return for_drainage(set.parameters, *set.law, imposed)
        .numbers.at("pore_fluid_bulk_modulus_kPa");
  };
  CHECK(modulus(Imposed::drained) == 0);
  CHECK(modulus(Imposed::undrained) == 1e6);
  CHECK_FALSE(for_drainage(toyoura().parameters, *toyoura().law, Imposed::drained)
                  .numbers.contains("pore_fluid_bulk_modulus_kPa"));
}

TEST_CASE("a search is the same for any number of threads, and stops where it is told to") {
  const auto paths = two_tests(toyoura());
  const SearchSpace space(toyoura(),
                          {{"peak_exponent", 0.01, 0.8}, {"stiffness_exponent", 0.2, 5}});
  const GlobalOptions options{.seed = 7, .members = 12, .generations = 3};
  std::vector<std::vector<Candidate>> found;
  for (const int threads : {1, 4}) {
    const Misfit misfit(space, paths, threads, {.tolerance = 1e-4, .step_limit = 400});
    found.push_back(global_search(misfit, options, [](double) { return true; }));
  }
  REQUIRE(found[0].size() == 12);
  for (std::size_t k = 0; k < found[0].size(); ++k) {
    CHECK(found[0][k].x == found[1][k].x);
    CHECK(found[0][k].sum == found[1][k].sum);
  }
  const Misfit misfit(space, paths, 1, {});
  int asked = 0;
  const auto stopped =
      least_squares(misfit, Unknowns::Constant(2, 0.4), 50, [&] { return ++asked < 3; });
  CHECK(asked == 3);
  CHECK(stopped.sum <= misfit.sum_of_squares(Unknowns::Constant(2, 0.4), 1e300));
}

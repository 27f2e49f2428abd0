// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/study/element/point_arrays.hpp"

#include <catch2/catch.hpp>

#include "lab/materials/material_library.hpp"

using namespace triax;
using sim::Axisymmetric;
using sim::Tensor;

namespace {

template <class Space>
study::PointConditions<Space> strains(std::vector<double> rows) {
  study::PointConditions<Space> conditions;
  conditions.strain.setIdentity();
  conditions.rows = std::move(rows);
  return conditions;
}

}  // namespace

TEST_CASE("a point in arrays goes where advance_point goes") {
  const auto set = lab::find_material("sanisand/S28-general");
  const auto& law = *set.material.axisymmetric;
  const sim::PointTolerance tolerance{.relative = 1e-8};
  auto state = law.isotropic(100e3, 0.8);
  auto points = study::start_points(law, {100, 100, 100, 100}, {0.8, 0.9});
  REQUIRE(points.memories == static_cast<std::size_t>(state.memory.size()));
  const auto control = sim::MixedControl<Axisymmetric>::strain_path(2e-4);
  double work = 0;
  for (int i = 0; i < 50; ++i) {
    const auto step = sim::advance_point(law, state, control, tolerance);
    state = step.state;
    const auto steps =
        study::advance_points(law, strains<Axisymmetric>({2e-4, -1e-4}), tolerance, points);
    REQUIRE(steps.stopped_at == 2);
    REQUIRE(steps.outcome == std::vector<std::uint8_t>{0, 0});
    work = step.second_order_work();
    CHECK(steps.work_kPa[0] == Approx(work / 1e3).epsilon(1e-6));
  }
  CHECK(points.stress_kPa[0] == Approx(state.stress(0) / 1e3).epsilon(1e-8));
  CHECK(points.stress_kPa[1] == Approx(state.stress(1) / std::sqrt(2) / 1e3).epsilon(1e-8));
  CHECK(points.void_ratio[0] == Approx(state.void_ratio).epsilon(1e-12));
  for (std::size_t k = 0; k < points.memories; ++k)
    CHECK(points.memory[k] == Approx(state.memory(static_cast<Eigen::Index>(k))).margin(1e-7));
  CHECK(points.stress_kPa[2] != points.stress_kPa[0]);
}

TEST_CASE("work is dσ′:dε of the components of the tensor") {
  const auto set = lab::find_material("elastic/linear");
  auto points = study::start_points(*set.material.tensor, {100, 90, 80, 5, 6, 7}, {0.8});
  const auto steps = study::advance_points(
      *set.material.tensor, strains<Tensor>({1e-4, -2e-5, 3e-5, 4e-5, 5e-5, -6e-5}), {}, points);
  const auto& s = steps.stress_kPa;
  const auto& e = steps.strain;
  CHECK(e[3] == Approx(4e-5));
  CHECK(steps.work_kPa[0] == Approx(s[0] * e[0] + s[1] * e[1] + s[2] * e[2] +
                                    2 * (s[3] * e[3] + s[4] * e[4] + s[5] * e[5])));
  CHECK(points.stress_kPa[5] == Approx(7 + s[5]));
}

TEST_CASE("points that were not reached when it was stopped stay as they were") {
  const auto set = lab::find_material("elastic/linear");
  const std::size_t count = 2500;
  auto points = study::start_points(*set.material.axisymmetric, std::vector<double>(2 * count, 50),
                                    std::vector<double>(count, 0.8));
  int asked = 0;
  const auto steps =
      study::advance_points(*set.material.axisymmetric, strains<Axisymmetric>({1e-5, 0}), {},
                            points, [&] { return ++asked > 2; });
  CHECK(steps.stopped_at == 2000);
  CHECK(points.stress_kPa[2 * 1999] > 50);
  CHECK(points.stress_kPa[2 * 2000] == 50);
}

TEST_CASE("only the first hundred refusals are told") {
  const auto set = lab::find_material("cam_clay/Hostun-like");
  auto points = study::start_points(*set.material.axisymmetric, std::vector<double>(300, -5),
                                    std::vector<double>(150, 0.8));
  const auto steps = study::advance_points(*set.material.axisymmetric,
                                           strains<Axisymmetric>({1e-5, 0}), {}, points);
  CHECK(steps.messages.size() == 100);
  CHECK(steps.messages.back().first == 99);
  for (const auto outcome : steps.outcome)
    CHECK(static_cast<sim::StepOutcome>(outcome) == sim::StepOutcome::failed);
}

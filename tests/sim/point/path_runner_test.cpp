// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/point/path_runner.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "sim/materials/sanisand.hpp"
#include "tests/sim/materials/parameter_sets.hpp"
#include "tests/sim/point/triaxial_segment.hpp"

using namespace triax::sim;
using triax::sim::test::kRadial;

namespace {

const Eigen::RowVector2d kQ(1, -kRadial), kCell(0, kRadial), kAxial(1, 0);

using TriaxialPath = Path<Axisymmetric>;
using TriaxialSegment = Segment<Axisymmetric>;

TriaxialPath from_isotropic(double p_pa, double void_ratio) {
  TriaxialPath path;
  path.stress = isotropic<Axisymmetric>(p_pa);
  path.void_ratio = void_ratio;
  return path;
}

/// Axial strain at constant cell pressure.
TriaxialSegment compression(double axial_strain, bool undrained) {
  TriaxialSegment s;
  s.labels = {"axial_strain", "radial_stress_kPa"};
  s.conditions.strain.row(0) = kAxial;
  s.conditions.stress.row(1) = kCell;
  s.conditions.increment << axial_strain, 0;
  s.undrained = undrained;
  s.rows = 50;
  return s;
}

/// q by weights at constant cell pressure.
TriaxialSegment loading(double q_pa, bool undrained) {
  TriaxialSegment s = compression(0, undrained);
  s.labels[0] = "q_kPa";
  s.conditions.strain.row(0).setZero();
  s.conditions.stress.row(0) = kQ;
  s.conditions.increment(0) = q_pa;
  return s;
}

/// q constant, the mean stress lowered.
TriaxialSegment unloading_at_constant_q(double dp_pa) {
  TriaxialSegment s = loading(0, false);
  s.labels = {"q_kPa", "p_kPa"};
  s.conditions.stress.row(1) << 1.0 / 3, 2 * kRadial / 3;
  s.conditions.increment << 0, dp_pa;
  return s;
}

template <class Space>
const PathEvent<Space>* find(const PathResult<Space>& result, PathEventKind kind) {
  for (const auto& event : result.events)
    if (event.kind == kind) return &event;
  return nullptr;
}

const Sanisand<Axisymmetric> kSand(test::s28_general());

}  // namespace

TEST_CASE("undrained compression: peak of q and zero of the second-order work coincide") {
  auto path = from_isotropic(100e3, 1.086);
  path.segments = {compression(0.05, true)};
  const auto result = run_path(kSand, path);
  REQUIRE(result.outcome == StepOutcome::accepted);
  CHECK(result.rows.size() == 51);
  // dσ′:dε = dq dε_q where dε_v = 0: both events at one state.
  const auto* peak = find(result, PathEventKind::peak);
  const auto* work = find(result, PathEventKind::second_order_work);
  REQUIRE(peak);
  REQUIRE(work);
  CHECK(peak->at.strain(0) == Approx(work->at.strain(0)).epsilon(1e-7));
  CHECK(peak->what == "q");
  CHECK(peak->at.q() / 1e3 == Approx(37.21).margin(0.006));
  CHECK(*peak->at.stress_ratio() == Approx(0.5878).margin(5e-4));
  CHECK(result.peak->q() == Approx(peak->at.q()).epsilon(1e-10));
  CHECK(std::abs(*work->at.second_order_work) < 1e-8);
  for (const auto& row : result.rows) {
    CHECK(trace<Axisymmetric>(row.strain) == Approx(0).margin(1e-15));
    CHECK(row.void_ratio == Approx(1.086));
    // The cell pressure is constant: u rises as σ₃′ falls.
    CHECK(row.pore_pressure == Approx(100e3 - row.stress(1) * kRadial).margin(1e-6));
  }
}

TEST_CASE("neither rows nor parts change the result") {
  std::vector<PathResult<Axisymmetric>> results;
  for (const int rows : {1, 7, 400}) {
    auto path = from_isotropic(100e3, 1.086);
    path.segments = {compression(0.05, true)};
    path.segments[0].rows = rows;
    results.push_back(run_path(kSand, path, {.tolerance = {.relative = 1e-9}}));
    CHECK(results.back().rows.size() == static_cast<std::size_t>(rows) + 1);
  }
  for (const auto& result : results) {
    CHECK(result.last.q() == Approx(results[0].last.q()).epsilon(1e-5));
    CHECK(result.peak->q() == Approx(results[0].peak->q()).epsilon(1e-8));
    CHECK(find(result, PathEventKind::peak)->at.strain(0) ==
          Approx(find(results[0], PathEventKind::peak)->at.strain(0)).epsilon(1e-5));
  }
}

TEST_CASE("a load beyond the peak: control of q is lost, with name and state") {
  for (const bool undrained : {true, false}) {
    auto path = from_isotropic(100e3, 1.086);
    path.segments = {loading(undrained ? 60e3 : 400e3, undrained)};
    const auto result = run_path(kSand, path);
    INFO(result.message);
    CHECK(result.outcome == StepOutcome::lost_control);
    CHECK(result.limiting_variable == "q_kPa");
    CHECK_FALSE(result.message.empty());
    REQUIRE(find(result, PathEventKind::control_limit));
    CHECK(*find(result, PathEventKind::control_limit)->at.determinant == 0);
    CHECK(std::isfinite(result.last.q()));
    if (undrained) CHECK(result.last.q() / 1e3 == Approx(37.21).margin(0.006));
    CHECK(result.rows.back().q() == result.last.q());
    REQUIRE(result.failed);

    TriaxialPath again;
    again.stress = result.failed->from.stress;
    again.void_ratio = result.failed->from.void_ratio;
    again.memory = result.failed->from.memory;
    again.segments = {result.failed->segment};
    const auto repeated = run_path(kSand, again);
    CHECK(repeated.outcome == StepOutcome::lost_control);
    CHECK(repeated.limiting_variable == "q_kPa");
    CHECK(repeated.last.q() == result.last.q());  // the same step, to the bit
  }
}

TEST_CASE("constant shear drained: the second-order work vanishes long before the limit") {
  auto path = from_isotropic(100e3, 1.086);
  auto load = loading(60e3, false);
  load.end = {{.quantity = PathQuantity::deviator_stress, .above = 30e3, .label = "q"}};
  path.segments = {load, unloading_at_constant_q(-105e3)};
  const auto result = run_path(kSand, path);
  CHECK(result.outcome == StepOutcome::lost_control);
  CHECK(result.limiting_variable == "p_kPa");
  CHECK(*result.last.stress_ratio() > 1);
  const auto* work = find(result, PathEventKind::second_order_work);
  REQUIRE(work);
  // The instability line of the law is that of the undrained peak, to 0.01.
  CHECK(*work->at.stress_ratio() == Approx(0.588).margin(0.015));
  const auto* end = find(result, PathEventKind::end_condition);
  REQUIRE(end);
  CHECK(end->at.q() == Approx(30e3).epsilon(1e-10));
  CHECK(end->at.segment == 0);
  CHECK(end->at.progress == Approx(0.5).epsilon(1e-9));
  CHECK(result.last.segment == 1);
  CHECK(result.last.q() == Approx(30e3).epsilon(1e-9));
}

TEST_CASE("an end condition is isolated inside a part, and one that is met ends at once") {
  auto path = from_isotropic(200e3, 1.0);
  auto first = compression(0.1, false);
  first.rows = 3;
  first.end = {{.quantity = PathQuantity::stress_ratio, .above = 0.3, .label = "stress_ratio"},
               {.quantity = PathQuantity::axial_strain, .above = 0.05, .label = "axial_strain"}};
  path.segments = {first, first, compression(0.001, false)};
  const auto result = run_path(kSand, path);
  REQUIRE(result.outcome == StepOutcome::accepted);
  REQUIRE(result.events.size() == 2);
  CHECK(*result.events[0].at.stress_ratio() == Approx(0.3).epsilon(1e-10));
  CHECK(result.events[1].at.segment == 1);
  CHECK(result.events[1].at.progress == 0);
  CHECK(result.last.strain(0) == Approx(result.events[0].at.strain(0) + 0.001));
}

TEST_CASE("raising the cell pressure undrained changes the pore pressure and nothing else") {
  auto path = from_isotropic(100e3, 1.0);
  path.pore_pressure = 300e3;
  path.segments = {loading(0, true)};
  path.segments[0].conditions.increment << 0, 50e3;
  path.segments[0].end = {
      {.quantity = PathQuantity::pore_pressure, .above = 320e3, .label = "pore_pressure_kPa"}};
  const auto result = run_path(kSand, path);
  REQUIRE(result.outcome == StepOutcome::accepted);
  CHECK(result.last.pore_pressure == Approx(320e3));
  CHECK(result.last.progress == Approx(0.4));
  CHECK(result.last.p() == 100e3);
  CHECK(result.last.strain.isZero(0));
}

TEST_CASE("the same triaxial path as a tensor") {
  const Sanisand<Tensor> tensor_law(test::s28_general());
  auto path = from_isotropic(100e3, 1.086);
  path.segments = {compression(0.02, true)};
  Path<Tensor> lifted;
  lifted.stress = as_tensor(path.stress);
  lifted.void_ratio = path.void_ratio;
  lifted.segments = {as_tensor_segment(path.segments[0])};
  const auto flat = run_path(kSand, path);
  const auto full = run_path(tensor_law, lifted);
  REQUIRE(full.outcome == StepOutcome::accepted);
  CHECK(full.peak->q() == Approx(flat.peak->q()).epsilon(1e-7));
  CHECK(full.last.p() == Approx(flat.last.p()).epsilon(1e-5));
  CHECK(full.last.pore_pressure == Approx(flat.last.pore_pressure).epsilon(1e-5));
  CHECK(value_of(PathQuantity::effective_radial_stress, 0, full.last).value() ==
        Approx(full.last.stress(2)));
}

TEST_CASE("a start outside the law is a failure in words; memory must be the law's") {
  auto path = from_isotropic(100e3, 9.0);
  path.segments = {compression(0.01, false)};
  const auto result = run_path(kSand, path);
  CHECK(result.outcome == StepOutcome::failed);
  CHECK_FALSE(result.message.empty());
  CHECK(result.rows.size() == 1);
  path.memory = {1, 2, 3};
  CHECK_THROWS_AS(run_path(kSand, path), std::invalid_argument);
}

TEST_CASE("a run can be stopped, and hears how far it is") {
  auto path = from_isotropic(100e3, 1.0);
  path.segments = {compression(0.01, false)};
  double last = -1;
  const auto stopped = run_path(kSand, path, {.progress = [&](double share) {
                                  CHECK(share >= last);
                                  last = share;
                                  return share < 0.5;
                                }});
  CHECK(stopped.outcome == StepOutcome::failed);
  CHECK(last == Approx(0.5));
  CHECK(stopped.last.strain(0) == Approx(0.005));
}

TEST_CASE("a stress that vanishes is a failure that says so, and large strains are warned of") {
  auto path = from_isotropic(100e3, 1.0);
  path.segments = {unloading_at_constant_q(-150e3)};
  const auto gone = run_path(kSand, path);
  CHECK(gone.outcome == StepOutcome::failed);
  CHECK(gone.message.find("vanished") != std::string::npos);
  CHECK(std::isfinite(gone.last.q()));
  CHECK(gone.last.p() >= 0);
  for (const auto& warning : gone.warnings) CHECK(warning.find("strain") == std::string::npos);

  // Strains alone that take the stress away: no strain is to blame.
  auto dilated = compression(0.05, false);
  dilated.labels[1] = "volumetric_strain";
  dilated.conditions.stress.setZero();
  dilated.conditions.strain.row(1) << 1, 2 * kRadial;
  dilated.conditions.increment(1) = -0.05;
  path.segments = {dilated};
  const auto loose = run_path(kSand, path);
  CHECK(loose.outcome == StepOutcome::failed);
  CHECK(loose.message.find("vanished") != std::string::npos);
  CHECK(loose.limiting_variable.empty());
  CHECK(find(loose, PathEventKind::control_limit) == nullptr);
  CHECK(loose.failed);

  path.segments = {compression(1.9, false)};
  const auto far = run_path(kSand, path);
  CHECK(far.outcome == StepOutcome::accepted);
  REQUIRE(far.warnings.size() == 1);
  CHECK(far.warnings[0].find("strains above 100 %") != std::string::npos);
}

TEST_CASE("a path that begins at its largest q has its peak at the start") {
  TriaxialPath path;
  path.stress = components(AxisymmetricStress{160e3, 80e3});
  path.void_ratio = 0.8;
  path.segments = {loading(-60e3, false), loading(20e3, false)};
  const auto result = run_path(kSand, path);
  REQUIRE(result.outcome == StepOutcome::accepted);
  REQUIRE(result.peak);
  CHECK(result.peak->q() == Approx(80e3).epsilon(1e-12));
  CHECK(result.peak->segment == 0);
  CHECK(result.peak->progress == 0);
  CHECK(result.peak->strain.isZero(0));
  // In extension the largest |q| counts; a larger one later is the peak again.
  path.segments = {loading(-60e3, false), loading(75e3, false)};
  CHECK(run_path(kSand, path).peak->q() == Approx(95e3).epsilon(1e-9));
}

TEST_CASE("a deviator stress of round-off is no peak") {
  auto path = from_isotropic(100e3, 1.0);
  auto swelling = compression(-1e-3, false);
  swelling.conditions.stress.setZero();
  swelling.conditions.strain.row(1) << 1, -kRadial;
  path.segments = {swelling};
  const auto isotropic_path = run_path(kSand, path);
  REQUIRE(isotropic_path.outcome == StepOutcome::accepted);
  CHECK(std::abs(isotropic_path.last.q()) < 1e-6);
  CHECK_FALSE(isotropic_path.peak);
  path.segments = {swelling, compression(1e-5, false)};
  const auto sheared = run_path(kSand, path);
  REQUIRE(sheared.peak);
  CHECK(sheared.peak->q() == sheared.last.q());
}

TEST_CASE("a stretch of several segments is left as a whole when a condition ends it") {
  auto path = from_isotropic(100e3, 1.0);
  auto step = compression(0.002, false);
  step.rows = 1;
  step.end = {{.quantity = PathQuantity::axial_strain, .above = 0.003, .label = "axial_strain"}};
  auto more = step;
  more.goes_on = true;
  path.segments = {step, more, more, compression(0.001, false)};
  const auto result = run_path(kSand, path);
  REQUIRE(result.events.size() == 1);
  CHECK(result.events[0].at.segment == 1);
  CHECK(result.last.strain(0) == Approx(0.004));
}

TEST_CASE("cycles return the repetitions' rows, and a reversal is no peak") {
  auto path = from_isotropic(300e3, 0.9);
  auto up = loading(10e3, true), down = loading(-10e3, true);
  up.rows = down.rows = 4;
  down.repeat = 5;
  down.repeat_from = 0;
  path.segments = {up, down};
  const auto result = run_path(kSand, path);
  CHECK(result.outcome == StepOutcome::accepted);
  CHECK(result.rows.size() == 41);
  CHECK(result.last.q() == Approx(0).margin(1));
  CHECK(result.events.empty());
}

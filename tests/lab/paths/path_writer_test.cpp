// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/paths/path_writer.hpp"

#include <catch2/catch.hpp>

#include "lab/paths/path_reader.hpp"
#include "tests/lab/paths/path_text.hpp"

using namespace triax::lab;
using namespace triax;

namespace {

/// Runs the path to its failure, writes that out, reads it back and runs it again.
template <class Space>
void check_failure_repeats(const std::string& toml) {
  const auto description = read_path(toml, "p.toml");
  const auto& path = std::get<sim::Path<Space>>(description.path);
  const auto& law = *description.material.material.law<Space>();
  const auto result = sim::run_path(law, path);
  REQUIRE(result.outcome == sim::StepOutcome::lost_control);
  REQUIRE(result.failed);
  const std::string text = failed_increment_toml(description, *result.failed, "a\nmessage");
  INFO(text);
  const auto again = read_path(text, "again.toml");
  CHECK_NOTHROW(check_start(again));
  const auto& short_path = std::get<sim::Path<Space>>(again.path);
  CHECK(short_path.segments.size() == 1);
  const auto repeated = sim::run_path(*again.material.material.law<Space>(), short_path);
  CHECK(repeated.outcome == result.outcome);
  CHECK(repeated.limiting_variable == result.limiting_variable);
  CHECK(repeated.last.q() == Approx(result.last.q()).epsilon(1e-9));
  CHECK(repeated.last.pore_pressure == Approx(result.last.pore_pressure).epsilon(1e-9));
  CHECK(repeated.last.void_ratio == Approx(result.last.void_ratio).epsilon(1e-9));
}

}  // namespace

TEST_CASE("a failed increment is a path of its own that fails in the same way") {
  const std::string load = test::with(test::kPath, "axial_strain = 0.02", "q_kPa = 300");
  check_failure_repeats<sim::Axisymmetric>(test::with(load, "1.0", "1.086"));
  check_failure_repeats<sim::Axisymmetric>(test::with(load, "1.0", "1.086") +
                                           "[parameters]\nhardening_factor = 1.5\n");
}

TEST_CASE("the same of a tensor, also where rows came by another way than text") {
  const std::string load =
      test::with(test::with(test::kPath, "axial_strain = 0.02", "q_kPa = 300"), "1.0", "1.086");
  check_failure_repeats<sim::Tensor>(
      test::with(load, "p_eff_kPa = 100.0", "stress_kPa = [100.0, 100.0, 100.0, 0, 0, 0]"));

  const auto description = read_path(test::kPath, "p.toml");
  sim::FailedIncrement<sim::Axisymmetric> failed;
  failed.from.stress = sim::isotropic<sim::Axisymmetric>(50e3);
  failed.from.void_ratio = 1;
  failed.segment = std::get<TriaxialPath>(description.path).segments[0];
  failed.segment.labels = {"row 1", "row 2"};
  failed.segment.conditions.strain.row(0) << -2, 3;
  const auto again = read_path(failed_increment_toml(description, failed, ""), "p.toml");
  const auto& read = std::get<TriaxialPath>(again.path).segments[0].conditions;
  CHECK(read.strain.isApprox(failed.segment.conditions.strain));
  CHECK(read.stress.isApprox(failed.segment.conditions.stress));
  CHECK(read.increment == failed.segment.conditions.increment);
}

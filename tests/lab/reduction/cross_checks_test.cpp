// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/reduction/cross_checks.hpp"

#include <catch2/catch.hpp>

#include "tests/lab/reduction/raw_record.hpp"

using namespace triax::lab;

namespace {

std::vector<CheckKind> kinds(const std::vector<Check>& checks) {
  std::vector<CheckKind> all;
  for (const Check& c : checks) all.push_back(c.kind);
  return all;
}

/// 200 s of consolidation and 200 s of shear.
CrossChecks checked(Drainage shear, double lag_kPa, std::optional<double> strain_path_R = {}) {
  RecordHeader header = triax::lab::testing::raw_header();
  header.stages[2].drainage = shear;
  header.stages[2].strain_path_R = strain_path_R;
  CrossChecks checks(header);
  for (int i = 0; i < 400; ++i) {
    const bool sheared = i >= 200;
    Reading r = triax::lab::testing::reading(
        {sheared ? 3 : 2, 0, 0, 400, 300 + (sheared ? lag_kPa : 0), 0}, i);
    r[Quantity::back_pressure] = 300e3;
    State s;
    s.reading = i;
    s.p_eff = 100e3;
    checks.add(r, s);
  }
  return checks;
}

}  // namespace

TEST_CASE("drained shear is checked for its rate, undrained for its valve") {
  CHECK(kinds(checked(Drainage::open, 0).checks({})) ==
        std::vector{CheckKind::consolidation, CheckKind::zero_difference, CheckKind::rate});
  CHECK(kinds(checked(Drainage::closed, 0).checks({})) == std::vector{CheckKind::consolidation,
                                                                      CheckKind::zero_difference,
                                                                      CheckKind::undrained_volume});
}

TEST_CASE("where the controller drives the volume, u need not stay near u_b") {
  CHECK(kinds(checked(Drainage::open, 9, 0.7).checks({})) ==
        std::vector{CheckKind::consolidation, CheckKind::zero_difference});
}

TEST_CASE("what failed becomes a warning, what came after the onset does not") {
  const CrossChecks checks = checked(Drainage::open, 9);
  const auto warnings = warnings_of(checks.checks({}));
  REQUIRE(warnings.size() == 1);
  CHECK(warnings[0].text.find("rate: at reading 215") == 0);
  CHECK(warnings_of(checks.checks(210)).empty());
}

TEST_CASE("a record that says nothing of its stages is not checked") {
  RecordHeader header = triax::lab::testing::raw_header();
  header.stages.clear();
  CrossChecks checks(header);
  checks.add(triax::lab::testing::reading({1, 0, 0, 400, 300, 0}), State());
  CHECK(checks.checks({}).empty());
}

// SPDX-License-Identifier: GPL-3.0-or-later
// Paths that ask for more than the material carries: every law, every control. The stop is in words
// and finite numbers everywhere; where mechanics says which condition must go, that one is named.
#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "tests/lab/materials/each_law.hpp"

using namespace triax;
using namespace triax::sim;
using namespace triax::lab::test;

namespace {

/// A control, and what it is called where it fails.
struct Limit {
  const char* name;
  MixedControl<Axisymmetric> control;
};

/// Controls that no frictional law can follow to the end from p′ = 100 kPa.
std::vector<Limit> limits() {
  const double r = 1 / std::numbers::sqrt2;  // of a₃ in terms of √2 a₃
  std::vector<Limit> all;
  all.push_back({"q raised, drained", MixedControl<Axisymmetric>::stress_path(1000e3, 3000e3)});
  all.push_back({"q lowered, drained", MixedControl<Axisymmetric>::stress_path(-90e3, -270e3)});
  all.push_back({"q raised, constant p'", MixedControl<Axisymmetric>::stress_path(0, 600e3)});
  all.push_back({"p' lowered to tension", MixedControl<Axisymmetric>::stress_path(-150e3, 0)});
  MixedControl<Axisymmetric> undrained;
  undrained.stress << 1, -r, 0, 0;
  undrained.strain << 0, 0, 1, std::numbers::sqrt2;
  undrained.increment << 3000e3, 0;
  all.push_back({"q raised, undrained", undrained});
  MixedControl<Axisymmetric> axial;
  axial.stress << 1, 0, 0, r;
  axial.increment << 3000e3, 0;
  all.push_back({"axial stress raised alone", axial});
  for (const double R : {0.4, 0.7, 1.5}) {
    MixedControl<Axisymmetric> path;
    path.stress << 1, -r / R, 0, 0;
    path.strain << 0, 0, 1, 2 * R * r;
    path.increment << 3000e3, 0;
    all.push_back({R < 0.5 ? "R = 0.4" : R < 1 ? "R = 0.7" : "R = 1.5", path});
  }
  return all;
}

/// Row i of an axisymmetric control as one on a tensor whose axes 2 and 3 stay equal.
MixedControl<Tensor> widened(const MixedControl<Axisymmetric>& c) {
  MixedControl<Tensor> wide;
  for (int i = 0; i < 2; ++i) {
    wide.stress.row(i).head<3>() << c.stress(i, 0), c.stress(i, 1) / std::numbers::sqrt2,
        c.stress(i, 1) / std::numbers::sqrt2;
    wide.strain.row(i).head<3>() << c.strain(i, 0), c.strain(i, 1) / std::numbers::sqrt2,
        c.strain(i, 1) / std::numbers::sqrt2;
    wide.increment(i) = c.increment(i);
  }
  wide.strain.row(2) << 0, 1, -1, 0, 0, 0;
  for (int i = 3; i < 6; ++i) wide.strain(i, i) = 1;
  return wide;
}

/// Loose enough for hundreds of runs, fine enough to see where a path ends.
const PointTolerance kQuick{.relative = 1e-6, .smallest_step = 1e-8, .step_limit = 20000};

template <class Space>
void check_end(const Law<Space>& law, const PointState<Space>& from,
               const MixedControl<Space>& control) {
  const auto step = advance_point(law, from, control, kQuick);
  INFO("outcome " << static_cast<int>(step.outcome) << ", done " << step.done
                  << ", limiting_variable " << step.limiting_variable << ", " << step.message);
  CHECK(step.state.stress.allFinite());
  CHECK(step.strain_increment.allFinite());
  CHECK(std::isfinite(step.state.void_ratio));
  CHECK(step.state.memory.allFinite());
  CHECK((step.state.p() > 0 || law.carries_tension()));
  if (step.outcome == StepOutcome::accepted) {
    CHECK(step.done == 1);
    return;
  }
  CHECK_FALSE(step.message.empty());
  CHECK_FALSE(law.objection(step.state));
  if (step.outcome != StepOutcome::lost_control) return;
  REQUIRE(step.limiting_variable >= 0);
  REQUIRE(step.limiting_variable < Space::kSize);
  CHECK(control.increment(step.limiting_variable) != 0);  // a row that asks for nothing can be held
  CHECK(step.done < 1);
}

/// A limit of which mechanics says what gives way. All conditions ask for something, so that a
/// wrong one could be named.
struct ClearLimit {
  const char* name;
  MixedControl<Axisymmetric> control;
  int limiting_variable;
};

std::vector<ClearLimit> clear_limits() {
  const double r = 1 / std::numbers::sqrt2;  // of a₃ in terms of √2 a₃
  std::vector<ClearLimit> all;
  // p' could be raised for ever, q/p' cannot.
  all.push_back(
      {"q raised, constant p'", MixedControl<Axisymmetric>::stress_path(0.1e3, 600e3), 1});
  MixedControl<Axisymmetric> undrained;
  undrained.stress << 1, -r, 0, 0;
  undrained.strain << 0, 0, 1, std::numbers::sqrt2;
  undrained.increment << 3000e3, 1e-6;
  all.push_back({"q raised, undrained", undrained, 0});
  MixedControl<Axisymmetric> axial;
  axial.stress << 1, 0, 0, r;
  axial.increment << 3000e3, 0.1e3;
  all.push_back({"axial stress raised alone", axial, 0});
  return all;
}

/// Why a set has no such limit; empty where it has one.
std::string why_no_limit(const std::string& set, const std::string& limit) {
  const bool undrained = limit == "q raised, undrained";
  if (set.starts_with("elastic/")) return "elasticity has no strength";
  if (undrained && (set == "mohr_coulomb/Hostun-dense" || set == "drucker_prager/Hostun-dense"))
    return "dilatant at constant dilatancy: undrained, p' and with it the strength grow for ever";
  const std::vector<std::string> of_undrained_loading = {"norsand/S28-MT", "norsand/S28-true-state",
                                                         "norsand/Nerlerk-270"};
  if (!undrained && std::ranges::find(of_undrained_loading, set) != of_undrained_loading.end())
    return "a set for undrained loading is refused for drained paths";
  return {};
}

/// The conditions in the opposite order, or of a tensor the first two exchanged.
template <class Space>
MixedControl<Space> exchanged(MixedControl<Space> control) {
  control.stress.row(0).swap(control.stress.row(1));
  control.strain.row(0).swap(control.strain.row(1));
  std::swap(control.increment(0), control.increment(1));
  return control;
}

template <class Space>
void check_limiting(const Law<Space>& law, const MixedControl<Space>& control,
                    int limiting_variable, const std::string& why_none) {
  // Full tensors come near their limit in many small steps.
  const PointTolerance tolerance{.relative = 1e-6, .smallest_step = 1e-8, .step_limit = 400000};
  for (const bool exchange : {false, true}) {
    const auto start = isotropic_state(law);
    const auto asked = exchange ? exchanged(control) : control;
    const auto step = advance_point(law, start, asked, tolerance);
    INFO("exchanged " << exchange << ", outcome " << static_cast<int>(step.outcome) << ", done "
                      << step.done << ", limiting_variable " << step.limiting_variable << ", "
                      << step.message);
    if (!why_none.empty()) {
      INFO(why_none);
      const bool refused = law.refusal(start, point_rate(law, start, asked)).has_value();
      CHECK(step.outcome == (refused ? StepOutcome::failed : StepOutcome::accepted));
      continue;
    }
    CHECK(step.outcome == StepOutcome::lost_control);
    CHECK(step.limiting_variable == (exchange ? 1 - limiting_variable : limiting_variable));
    CHECK(step.done < 1);
  }
}

}  // namespace

TEMPLATE_TEST_CASE(
    "every law: where mechanics is clear, the right limiting variable is named at the limit", "",
    Axisymmetric, Tensor) {
  for (const ClearLimit& limit : clear_limits()) {
    INFO(limit.name);
    Counted limits_of;
    each_law<TestType>([&](const lab::MaterialSet& set, const Law<TestType>& law) {
      const std::string why_none = why_no_limit(set.name, limit.name);
      if (why_none.empty() || set.law->name == "elastic") ++limits_of[set.law->name];
      if constexpr (TestType::kSize == 2)
        check_limiting(law, limit.control, limit.limiting_variable, why_none);
      else
        check_limiting(law, widened(limit.control), limit.limiting_variable, why_none);
    });
    limits_of.require_all<TestType>();
  }
}

TEST_CASE("every law, every control: a path beyond the limit ends in words and finite numbers",
          "[slow]") {
  for (const Limit& limit : limits()) {
    INFO(limit.name);
    each_law<Axisymmetric>([&](const lab::MaterialSet&, const Law<Axisymmetric>& law) {
      check_end(law, isotropic_state(law), limit.control);
      // The same after some shear, so that the memory is not that of the start.
      const auto sheared = advance_point(law, isotropic_state(law),
                                         MixedControl<Axisymmetric>::drained_compression(0.002));
      if (sheared.outcome == StepOutcome::accepted) check_end(law, sheared.state, limit.control);
    });
    each_law<Tensor>([&](const lab::MaterialSet&, const Law<Tensor>& law) {
      check_end(law, isotropic_state(law), widened(limit.control));
    });
  }
}

TEST_CASE("every law: plane strain, simple shear and a lone shear stress end in words too",
          "[slow]") {
  each_law<Tensor>([&](const lab::MaterialSet&, const Law<Tensor>& law) {
    for (const double size : {0.05, -0.05}) {
      Vector<Tensor> strain = Vector<Tensor>::Zero();
      strain << size, 0, -0.5 * size, 0, 0, 0;
      check_end(law, isotropic_state(law), MixedControl<Tensor>::strains(strain));
    }
    if (std::holds_alternative<InterpolatedForm<Tensor>>(law.response(isotropic_state(law))))
      return;
    Vector<Tensor> shear = Vector<Tensor>::Zero();
    shear(3) = 0.05;
    check_end(law, isotropic_state(law), MixedControl<Tensor>::strains(shear));
    shear(3) = 500e3;
    check_end(law, isotropic_state(law), MixedControl<Tensor>::stresses(shear));
  });
}

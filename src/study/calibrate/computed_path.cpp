// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/study/calibrate/computed_path.hpp"

#include <cmath>
#include <numbers>
#include <stdexcept>

#include "sim/point/point_driver.hpp"

namespace triax::study {
namespace {

using Space = sim::Axisymmetric;
using State = sim::PointState<Space>;
using Control = sim::MixedControl<Space>;

constexpr double kRoot2 = std::numbers::sqrt2;

State start_of(const sim::Law<Space>& law, const MeasuredPath& path) {
  const double radial = path.start.radial_stress();
  return law.start({radial + path.start.q, kRoot2 * radial}, path.void_ratio);
}

/// The state of the law as a knot; `strain` in the space's components.
PathKnot knot_at(const State& state, const sim::Vector<Space>& strain) {
  PathKnot knot;
  knot.axial_strain = strain(0);
  knot.volumetric_strain = sim::trace<Space>(strain);
  knot.p_eff = state.p();
  knot.q = state.q();
  return knot;
}

/// From where the law is to what was measured, so that no error of a step is carried on.
Control towards(const PathKnot& target, const PathKnot& now, Imposed imposed) {
  Control c;
  if (imposed == Imposed::stress_path) {
    c.stress << 1, -1 / kRoot2, 1.0 / 3, kRoot2 / 3;
    c.increment << target.q - now.q, target.p_eff - now.p_eff;
    return c;
  }
  c.strain(0, 0) = 1;
  c.increment(0) = target.axial_strain - now.axial_strain;
  if (imposed == Imposed::undrained) {
    c.strain.row(1) = sim::identity<Space>().transpose();
    c.increment(1) = -now.volumetric_strain;
  } else {
    c.stress(1, 1) = 1 / kRoot2;
    c.increment(1) = target.radial_stress() - now.radial_stress();
  }
  return c;
}

/// A law on its way through the knots.
class Way {
 public:
  Way(const sim::Law<Space>& law, const MeasuredPath& path, const DrivingOptions& options)
      : law_(law), path_(path), state_(start_of(law, path)) {
    tolerance_.relative = options.tolerance;
    tolerance_.step_limit = options.step_limit;
    tolerance_.runaway_strain = 0.5;
    strain_ << path.start.axial_strain,
        (path.start.volumetric_strain - path.start.axial_strain) / kRoot2;
    if (const auto why = law.objection(state_)) refusal_ = *why;
  }

  const std::string& refusal() const { return refusal_; }
  const State& state() const { return state_; }
  PathKnot here() const { return knot_at(state_, strain_); }
  Control control_to(const PathKnot& target) const {
    return towards(target, here(), path_.imposed);
  }

  /// The share that was done; less than 1 with a refusal.
  double advance(const Control& control) {
    if (!refusal_.empty()) return 0;
    if (control.increment.isZero(0)) return 1;
    sim::PointStep<Space> step;
    try {
      step = sim::advance_point(law_, state_, control, tolerance_);
    } catch (const std::runtime_error& error) {  // a plug-in that fails
      refusal_ = error.what();
      return 0;
    }
    const bool done =
        step.outcome == sim::StepOutcome::accepted || step.outcome == sim::StepOutcome::inaccurate;
    const bool finite =
        std::isfinite(step.strain_increment.sum() + step.state.stress.sum() + step.done);
    if (!done || !finite)
      refusal_ = step.message.empty() ? "the conditions cannot be held" : step.message;
    if (!finite) return 0;  // the way ends where it was
    state_ = step.state;
    strain_ += step.strain_increment;
    return done ? 1 : step.done;
  }

 private:
  const sim::Law<Space>& law_;
  const MeasuredPath& path_;
  State state_;
  sim::Vector<Space> strain_;
  sim::PointTolerance tolerance_;
  std::string refusal_;
};

/// Empty where a plug-in fails.
std::optional<double> work_of(const sim::Law<Space>& law, const Way& way, const Control& control) {
  if (law.objection(way.state())) return 1;
  try {
    const auto rate = sim::point_rate(law, way.state(), control);
    return rate.controllable ? rate.normalised_work() : -1;
  } catch (const std::runtime_error&) {
    return std::nullopt;
  }
}

}  // namespace

ComputedPath drive(const sim::Law<Space>& law, const MeasuredPath& path,
                   const DrivingOptions& options) {
  ComputedPath computed;
  Way way(law, path, options);
  computed.knots.reserve(path.knots.size());
  for (const PathKnot& target : path.knots) {
    const double share = way.advance(way.control_to(target));
    computed.reached += share;
    if (!way.refusal().empty()) break;
    computed.knots.push_back(way.here());
  }
  computed.last = way.here();
  computed.refusal = way.refusal();
  return computed;
}

std::optional<double> onset_eta(const sim::Law<Space>& law, const MeasuredPath& path,
                                const DrivingOptions& options) {
  Way way(law, path, options);
  const auto eta = [](const Way& at) -> std::optional<double> {
    const PathKnot now = at.here();
    return now.p_eff > 0 ? std::optional(now.q / now.p_eff) : std::nullopt;
  };
  for (const PathKnot& target : path.knots) {
    const Way before = way;
    const Control control = way.control_to(target);
    way.advance(control);
    if (!way.refusal().empty())
      return path.imposed == Imposed::stress_path ? eta(way) : std::nullopt;
    const auto work = work_of(law, way, control);
    if (!work) return std::nullopt;
    if (*work >= 0) continue;
    double low = 0, high = 1;  // share of the step; positive at `low`
    for (int i = 0; i < 40; ++i) {
      const double middle = (low + high) / 2;
      Control part = control;
      part.increment *= middle;
      Way probe = before;
      probe.advance(part);
      const auto of_probe =
          probe.refusal().empty() ? work_of(law, probe, control) : std::optional<double>();
      (of_probe && *of_probe >= 0 ? low : high) = middle;
    }
    Control part = control;
    part.increment *= high;
    Way found = before;
    found.advance(part);
    return eta(found);
  }
  return std::nullopt;
}

}  // namespace triax::study

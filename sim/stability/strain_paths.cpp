// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/stability/strain_paths.hpp"

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "sim/point/point_driver.hpp"

namespace triax::sim {
namespace {

constexpr int kLeastParts = 500;

/// A place of the path and how it goes on.
struct Place {
  PointState<Axisymmetric> state;
  double axial_strain = 0;
  PointRate<Axisymmetric> rate;
};

/// One path under integration, in equal parts.
class Run {
 public:
  Run(const Law<Axisymmetric>& law, double R, double part, const PointTolerance& tolerance)
      : law_(law), R_(R), part_(part), tolerance_(tolerance) {}

  Place begin(const PointState<Axisymmetric>& state) const { return place(state, 0); }

  /// The place a share of a part further; `message` says why it is nearer than that.
  Place after(const Place& from, double share, std::string& message) const {
    const auto step = advance_point(law_, from.state, control(share * part_), tolerance_);
    if (step.done < 1) {
      message = step.message;
      if (message.empty()) message = "the path cannot be followed any further";
    }
    return place(step.state, from.axial_strain + step.done * share * part_);
  }

  /// d(σ₁′ − σ₃′/R) of the way on; 0 where there is none.
  double growth(const Place& at) const {
    if (!at.rate.controllable) return 0;
    const AxisymmetricStress d = axisymmetric_stress(at.rate.stress);
    return d.axial - d.radial / R_;
  }

  StrainPathPoint point(const Place& at) const {
    const AxisymmetricStress s = axisymmetric_stress(at.state.stress);
    StrainPathPoint p{.axial_strain = at.axial_strain,
                      .control_stress = s.axial - s.radial / R_,
                      .p = at.state.p(),
                      .q = at.state.q(),
                      .void_ratio = at.state.void_ratio,
                      .normalised_work = {}};
    if (at.rate.controllable) p.normalised_work = at.rate.normalised_work();
    return p;
  }

  /// The last place of a part, begun at `from`, at which a witness is still positive.
  template <class Witness>
  Place isolate(const Place& from, const Witness& witness) const {
    double low = 0, high = 1;
    Place last = from;
    std::string message;
    while (high - low > 1e-10) {
      const double middle = (low + high) / 2;
      const Place here = after(from, middle, message);
      if (witness(here) > 0) {
        low = middle;
        last = here;
      } else {
        high = middle;
      }
    }
    return last;
  }

 private:
  MixedControl<Axisymmetric> control(double axial_strain) const {
    return MixedControl<Axisymmetric>::strain_path(axial_strain, R_);
  }
  Place place(const PointState<Axisymmetric>& state, double axial_strain) const {
    Place at{state, axial_strain, {}};
    if (!law_.objection(state)) at.rate = point_rate(law_, state, control(part_));
    return at;
  }

  const Law<Axisymmetric>& law_;
  double R_, part_;
  PointTolerance tolerance_;
};

double work(const Place& at) { return at.rate.controllable ? at.rate.second_order_work() : 0; }

/// A number that turns negative, but not by the round-off of a plateau.
class Fall {
 public:
  /// `value` at the next place; whether it is the first there that is below zero.
  bool met(double value) {
    largest_ = std::max(largest_, std::abs(value));
    const bool below = value < -kRoundOff * largest_;
    return below && !std::exchange(met_, true);
  }

 private:
  static constexpr double kRoundOff = 1e-9;
  double largest_ = 0;
  bool met_ = false;
};

/// Looks for the peak and for W₂ = 0 while the stress has not vanished.
class Turns {
 public:
  Turns(const Run& run, double least_p) : run_(run), least_p_(least_p) {}

  void look_at(const Place& start, StrainPath& path) {
    if (above(start) <= 0) {
      path.vanished = run_.point(start);
      return;
    }
    stress_falls_.met(run_.growth(start));
    if (work_falls_.met(work(start))) path.first_unstable = run_.point(start);
  }

  void look_between(const Place& from, const Place& to, StrainPath& path) {
    if (path.vanished) return;
    const auto growth = [this](const Place& at) { return run_.growth(at); };
    if (stress_falls_.met(growth(to))) path.peak = isolated(from, growth);
    if (work_falls_.met(work(to))) path.first_unstable = isolated(from, work);
    if (above(to) <= 0)
      path.vanished = run_.point(run_.isolate(from, [this](const Place& at) { return above(at); }));
  }

 private:
  double above(const Place& at) const { return at.state.p() - least_p_; }

  template <class Witness>
  std::optional<StrainPathPoint> isolated(const Place& from, const Witness& witness) const {
    const Place at = run_.isolate(from, witness);
    return above(at) > 0 ? std::optional(run_.point(at)) : std::nullopt;
  }

  const Run& run_;
  double least_p_;
  Fall stress_falls_, work_falls_;
};

}  // namespace

StrainPath strain_path(const Law<Axisymmetric>& law, const PointState<Axisymmetric>& start,
                       double R, const StrainPathOptions& options) {
  if (!(R > 0)) throw std::invalid_argument("R must be above 0");
  if (!(options.axial_strain > 0)) throw std::invalid_argument("axial_strain must be above 0");
  if (options.rows < 1) throw std::invalid_argument("rows must be at least 1");
  const int to_a_row = (kLeastParts + options.rows - 1) / options.rows;
  const int parts = options.rows * to_a_row;
  const Run run(law, R, options.axial_strain / parts, {.relative = options.tolerance});
  StrainPath path{.R = R};
  Place at = run.begin(start);
  path.points.push_back(run.point(at));
  Turns turns(run, options.least_p);
  turns.look_at(at, path);
  for (int i = 1; i <= parts && path.message.empty(); ++i) {
    const Place next = run.after(at, 1, path.message);
    turns.look_between(at, next, path);
    at = next;
    if (i % to_a_row == 0 || !path.message.empty()) path.points.push_back(run.point(at));
  }
  return path;
}

}  // namespace triax::sim

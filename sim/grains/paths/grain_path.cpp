// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/grains/paths/grain_path.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "sim/grains/engine/calming.hpp"
#include "sim/grains/engine/grains.hpp"
#include "sim/grains/engine/guarded_steps.hpp"
#include "sim/grains/state/grain_measures.hpp"
#include "sim/grains/state/triaxial_axes.hpp"

namespace triax::sim {
namespace {

using Kind = GrainPathKind;
constexpr std::int64_t kSettlingCheck = 500;

void check(const GrainPath& path) {
  const auto positive = [](double x) { return x > 0 && std::isfinite(x); };
  if (!positive(path.ratio)) throw std::invalid_argument("grain path: R must be above 0");
  if (path.kind != Kind::strain_path && !positive(path.pressure_pa))
    throw std::invalid_argument("grain path: the pressure must be above 0");
  const bool driven = path.load_rate_pa_per_s != 0 ? std::isfinite(path.load_rate_pa_per_s)
                                                   : positive(std::abs(path.strain_rate_per_s));
  if (path.kind != Kind::isotropic && !(positive(path.axial_strain) && driven))
    throw std::invalid_argument(
        "grain path: a rate of strain or load and an axial strain to end at are needed");
  if (path.samples < 1 || path.check_every < 1)
    throw std::invalid_argument("grain path: samples and steps between checks must be at least 1");
}

/// A goal that no specimen reaches: the path ends before.
constexpr double kBeyond = 1e12;

bool by_load(const GrainPath& path) {
  return path.kind != Kind::isotropic && path.load_rate_pa_per_s != 0;
}

AxisDrive axial_drive(const GrainPath& path) {
  if (!by_load(path)) return strain_rate_drive(path.strain_rate_per_s);
  AxisDrive drive = stress_drive(std::copysign(kBeyond, path.load_rate_pa_per_s));
  drive.stress_rate_pa_per_s = std::abs(path.load_rate_pa_per_s);
  return drive;
}

std::array<AxisDrive, 3> drives_of(const GrainPath& path) {
  const AxisDrive axial = axial_drive(path);
  AxisDrive servo = stress_drive(path.pressure_pa);
  servo.stress_rate_pa_per_s = path.kind == Kind::isotropic ? path.stress_rate_pa_per_s : 0;
  if (path.kind == Kind::isotropic) return triaxial_drives(servo, servo);
  if (path.kind == Kind::drained) return triaxial_drives(axial, servo);
  return strain_path_drives(axial, path.ratio);
}

/// Samples are as far apart in time as makes them as many as asked for.
double sample_interval(const GrainState& s, const GrainPath& path) {
  if (path.kind != Kind::isotropic && !by_load(path))
    return path.axial_strain / std::abs(path.strain_rate_per_s) / path.samples;
  const double step = s.time_step_s * static_cast<double>(kSettlingCheck);
  if (by_load(path) || !(path.stress_rate_pa_per_s > 0)) return step;
  const double rise = std::abs(path.pressure_pa - mean_stress(axisymmetric_stress(s)));
  return std::max(step, rise / path.stress_rate_pa_per_s / path.samples);
}

class Marks {
 public:
  Marks(const GrainPath& path, GrainPathResult& result)
      : path_(path), result_(result), above_(path.marks.size()) {
    result.marked.resize(path.marks.size());
  }
  void look(const GrainState& state, const AxisymmetricStress& stress, double axial_strain) {
    for (std::size_t k = 0; k < path_.marks.size(); ++k) {
      if (result_.marked[k]) continue;
      const PathMark& mark = path_.marks[k];
      const bool above = value(mark, stress, axial_strain) >= mark.value;
      if (mark.falling ? above_[k] && !above : above) result_.marked[k] = state;
      above_[k] = above_[k] || above;
    }
  }

 private:
  double value(const PathMark& mark, const AxisymmetricStress& stress, double axial_strain) const {
    if (mark.quantity == PathMark::Quantity::axial_strain) return axial_strain;
    if (mark.quantity == PathMark::Quantity::path_stress_pa)
      return path_stress(stress, path_.ratio);
    const double p = mean_stress(stress);
    return p > 0 ? deviator_stress(stress) / p : 0;
  }
  const GrainPath& path_;
  GrainPathResult& result_;
  std::vector<bool> above_;
};

class Follower {
 public:
  Follower(const GrainState& state, const GrainPath& path, int threads, const GrainPathWatch& watch)
      : path_(path),
        watch_(watch),
        grains_(state, threads),
        start_(state.box),
        start_time_(state.time_s),
        start_p_(mean_stress(axisymmetric_stress(state))),
        interval_(sample_interval(state, path)),
        marks_(path, result_) {
    grains_.drive(drives_of(path));
    grains_.keep_ledger();
  }

  GrainPathResult run(const GrainProgress& progress) {
    keep();
    std::int64_t steps = 0;
    std::optional<GrainPathEnd> end;
    while (!end) {
      advance(grains_, path_.check_every);
      steps += path_.check_every;
      const GrainState& s = grains_.state();
      most_kinetic_ = std::max(most_kinetic_, kinetic_energy(s));
      const AxisymmetricStress stress = axisymmetric_stress(s);
      const double axial = axisymmetric_strain(start_, s.box).axial;
      marks_.look(s, stress, axial);
      end = end_of(stress, axial, steps);
      if (!end && s.time_s - start_time_ >= next_sample_) {
        keep();
        if (!goes_on(progress, done(stress, axial), "following the path"))
          end = GrainPathEnd::stopped;
      }
    }
    keep();
    result_.end = *end;
    result_.state = grains_.state();
    result_.ledger = grains_.ledger().value();
    return std::move(result_);
  }

 private:
  void keep() {
    const GrainState& s = grains_.state();
    require_inside(s);
    GrainPathPoint point = path_point(s, start_, path_.ratio);
    point.time_s = s.time_s - start_time_;
    point.kinetic_energy_j = std::max(most_kinetic_, point.kinetic_energy_j);
    most_kinetic_ = 0;
    next_sample_ += interval_;
    if (static_cast<int>(result_.points.size()) > path_.samples) thin();
    result_.points.push_back(point);
    if (watch_) watch_(s, point);
  }
  /// Paths whose duration is not known beforehand: every other point goes, the interval doubles.
  void thin() {
    std::size_t kept = 1;
    for (std::size_t k = 2; k < result_.points.size(); k += 2)
      result_.points[kept++] = result_.points[k];
    result_.points.resize(kept);
    interval_ *= 2;
  }

  std::optional<GrainPathEnd> end_of(const AxisymmetricStress& stress, double axial,
                                     std::int64_t steps) {
    const double p = mean_stress(stress);
    if (steps >= path_.most_steps) return GrainPathEnd::most_steps;
    if (path_.kind == Kind::isotropic) return at_rest(steps);
    if (p < path_.collapse_share * start_p_) return GrainPathEnd::collapse;
    const double way = by_load(path_) ? path_.load_rate_pa_per_s : path_.strain_rate_per_s;
    if (path_.stress_ratio && p > 0 &&
        way * (deviator_stress(stress) / p - *path_.stress_ratio) >= 0)
      return GrainPathEnd::stress_ratio;
    if (std::abs(axial) >= path_.axial_strain) return GrainPathEnd::axial_strain;
    return {};
  }
  std::optional<GrainPathEnd> at_rest(std::int64_t steps) const {
    const bool due = steps / kSettlingCheck > (steps - path_.check_every) / kSettlingCheck;
    if (!due || stress_error(grains_.state()) > path_.pressure_share * path_.pressure_pa) return {};
    if (measure(grains_.state()).unbalanced > path_.unbalanced) return {};
    return GrainPathEnd::at_rest;
  }
  double done(const AxisymmetricStress& stress, double axial) const {
    const double share = path_.kind == Kind::isotropic ? (mean_stress(stress) - start_p_) /
                                                             (path_.pressure_pa - start_p_ + 1e-300)
                                                       : std::abs(axial) / path_.axial_strain;
    return std::clamp(share, 0.0, 0.99);
  }

  const GrainPath& path_;
  const GrainPathWatch& watch_;
  Grains grains_;
  GrainBox start_;
  double start_time_, start_p_, interval_;
  double next_sample_ = 0, most_kinetic_ = 0;
  GrainPathResult result_;
  Marks marks_;
};

}  // namespace

GrainPathPoint path_point(const GrainState& state, const GrainBox& start, double ratio) {
  const GrainMeasures m = measure(state);
  GrainPathPoint point;
  point.strain = axisymmetric_strain(start, state.box);
  point.volumetric_strain = volumetric_strain(point.strain);
  point.stress = axisymmetric_stress(state);
  point.p_pa = mean_stress(point.stress);
  point.q_pa = deviator_stress(point.stress);
  point.path_stress_pa = path_stress(point.stress, ratio);
  point.kinetic_energy_j = m.kinetic_energy_j;
  point.unbalanced = m.unbalanced;
  point.porosity = m.porosity;
  point.coordination = m.coordination;
  if (m.grain_contacts > 0)
    point.sliding_share =
        static_cast<double>(m.sliding_contacts) / static_cast<double>(m.grain_contacts);
  return point;
}

GrainPathResult follow(const GrainState& state, const GrainPath& path, int threads,
                       const GrainProgress& progress, const GrainPathWatch& watch) {
  check(path);
  return Follower(state, path, threads, watch).run(progress);
}

}  // namespace triax::sim

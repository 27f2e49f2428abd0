// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/grains/probes/grain_probe.hpp"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <exception>
#include <mutex>
#include <numbers>
#include <stdexcept>
#include <string>
#include <thread>

#include "sim/grains/engine/calming.hpp"
#include "sim/grains/engine/grains.hpp"
#include "sim/grains/engine/guarded_steps.hpp"
#include "sim/grains/probes/boundary_term.hpp"
#include "sim/grains/probes/sliding_record.hpp"
#include "sim/grains/state/grain_measures.hpp"
#include "sim/grains/state/grain_rotations.hpp"
#include "sim/grains/state/triaxial_axes.hpp"

namespace triax::sim {
namespace {

void check(const GrainProbing& how) {
  for (const double norm : {how.norm_pa, how.norm_strain})
    if (!(norm >= 0 && std::isfinite(norm)))
      throw std::invalid_argument("probe: the norm must not be below 0");
  if (how.ramp_steps < 2 || how.check_every < 1 || how.sample_every < 1)
    throw std::invalid_argument(
        "probe: a ramp of at least 2 steps and a step between checks are needed");
  if (!(how.unbalanced > 0) || !(how.stress_error_pa > 0) || !(how.speed_limit_m_per_s > 0))
    throw std::invalid_argument("probe: limits must be above 0");
}

/// (x, y) of the Rendulic plane as axial and radial components.
template <class Components>
Components rendulic_increment(double norm, double angle) {
  return {norm * std::sin(angle), norm * std::cos(angle) / std::numbers::sqrt2};
}

/// Drives every axis from what it carries now to that and its increment.
std::array<AxisDrive, 3> to_stress(const GrainState& s, const AxisymmetricStress& increment,
                                   const GrainProbing& how) {
  const double duration = static_cast<double>(how.ramp_steps) * s.time_step_s;
  std::array<AxisDrive, 3> drives;
  for (int a = 0; a < 3; ++a) {
    const double change = a == kAxial ? increment.axial : increment.radial;
    drives[a] = stress_drive(wall_stress(s.walls, s.box, a) + change, how.speed_limit_m_per_s);
    drives[a].stress_rate_pa_per_s = std::abs(change) / duration;
  }
  return drives;
}

/// Strains every axis steadily so that the ramp ends at its increment.
std::array<AxisDrive, 3> to_strain(const GrainState& s, const AxisymmetricStrain& increment,
                                   const GrainProbing& how) {
  const double duration = static_cast<double>(how.ramp_steps) * s.time_step_s;
  return triaxial_drives(strain_rate_drive(increment.axial / duration),
                         strain_rate_drive(increment.radial / duration));
}

/// Steps one by one and keeps what end points cannot tell.
class Watch {
 public:
  Watch(Grains& grains, GrainProbe& result, std::int64_t sample_every)
      : grains_(grains),
        result_(result),
        sample_every_(sample_every),
        rotations_(grains.state().grains.size()),
        sliding_(grains.state()) {}

  void step(std::int64_t n) {
    for (std::int64_t s = 0; s < n; ++s) {
      advance(grains_, 1);
      rotations_.add(grains_.state());
      if (++result_.steps % sample_every_ != 0) continue;
      result_.most_kinetic_j = std::max(result_.most_kinetic_j, kinetic_energy(grains_.state()));
      sliding_.add(grains_.state());
    }
  }
  const GrainRotations& rotations() const { return rotations_; }
  std::int64_t slid() const { return sliding_.count(); }

 private:
  Grains& grains_;
  GrainProbe& result_;
  std::int64_t sample_every_;
  GrainRotations rotations_;
  SlidingRecord sliding_;
};

}  // namespace

GrainProbe probe(const GrainState& state, double angle, const GrainProbing& how,
                 const GrainProgress& progress) {
  check(how);
  GrainProbe result;
  result.angle = angle;
  const bool by_stress = how.kind == ProbeKind::stress;
  (by_stress ? result.norm_pa : result.norm_strain) = by_stress ? how.norm_pa : how.norm_strain;
  Grains grains(state);
  grains.drive(
      by_stress
          ? to_stress(state, rendulic_increment<AxisymmetricStress>(how.norm_pa, angle), how)
          : to_strain(state, rendulic_increment<AxisymmetricStrain>(how.norm_strain, angle), how));
  grains.keep_ledger();
  Watch watch(grains, result, how.sample_every);
  const std::int64_t half = how.ramp_steps / 2;
  watch.step(half);
  const GrainBox middle = grains.state().box;
  watch.step(how.ramp_steps - half);
  const double boundary =
      boundary_term(state, middle, static_cast<double>(half) / static_cast<double>(how.ramp_steps),
                    grains.state().box);
  if (!by_stress) grains.drive({});
  while (!result.at_rest && !result.stopped && result.steps < how.most_steps) {
    watch.step(std::min(how.check_every, how.most_steps - result.steps));
    result.unbalanced = measure(grains.state()).unbalanced;
    result.stress_error_pa = stress_error(grains.state());
    result.at_rest =
        result.unbalanced < how.unbalanced && result.stress_error_pa < how.stress_error_pa;
    result.stopped = !result.at_rest && !goes_on(progress, 0, "probing");
  }
  require_inside(grains.state());
  result.ledger = grains.ledger().value();
  result.work = grain_work(state, grains.state(), watch.rotations().turned());
  result.work.boundary_part = boundary;
  const auto &change = result.work.stress_change_pa, &strain = result.work.strain;
  result.stress = {change[kAxial], 0.5 * (change[kRadial[0]] + change[kRadial[1]])};
  result.strain = {strain[kAxial], 0.5 * (strain[kRadial[0]] + strain[kRadial[1]])};
  result.sliding_share =
      static_cast<double>(watch.slid()) /
      static_cast<double>(std::max<std::int64_t>(1, result.work.contacts_before));
  return result;
}

namespace {

/// Probes handed out to threads; the first failure ends all.
class Handout {
 public:
  Handout(const GrainState& state, const std::vector<double>& angles,
          const std::vector<int>& numbers, const GrainProbing& how, const GrainProgress& progress,
          SomeProbes& result)
      : state_(state),
        angles_(angles),
        numbers_(numbers),
        how_(how),
        progress_(progress),
        result_(result) {}

  void work() {
    for (;;) {
      const std::size_t next = next_++;
      if (next >= numbers_.size() || result_stopped_) return;
      try {
        one(next);
      } catch (...) {
        const std::lock_guard lock(mutex_);
        if (!failure_) failure_ = std::current_exception();
        result_stopped_ = true;
      }
    }
  }
  void finish() {
    if (failure_) std::rethrow_exception(failure_);
    result_.stopped = result_stopped_;
  }

 private:
  void one(std::size_t place) {
    const int number = numbers_[place];
    GrainProbing how = how_;
    if (number == 0) how.norm_pa = how.norm_strain = 0;
    const double angle = number == 0 ? 0 : angles_[number - 1];
    result_.probes[place] =
        probe(state_, angle, how, [this](double, const std::string&) { return tell(0); });
    tell(1);
  }
  bool tell(int more) {
    const std::lock_guard lock(mutex_);
    made_ += more;
    const auto all = static_cast<double>(numbers_.size());
    if (!result_stopped_ && !goes_on(progress_, made_ / all, "probing")) result_stopped_ = true;
    return !result_stopped_;
  }

  const GrainState& state_;
  const std::vector<double>& angles_;
  const std::vector<int>& numbers_;
  const GrainProbing how_;
  const GrainProgress& progress_;
  SomeProbes& result_;
  std::atomic<std::size_t> next_{0};
  std::atomic<bool> result_stopped_{false};
  std::mutex mutex_;
  double made_ = 0;
  std::exception_ptr failure_;
};

}  // namespace

SomeProbes some_probes(const GrainState& state, const std::vector<double>& angles,
                       const std::vector<int>& numbers, const GrainProbing& how, int threads,
                       const GrainProgress& progress) {
  check(how);
  if (threads < 1) throw std::invalid_argument("directional probes: at least one thread is needed");
  for (const int number : numbers)
    if (number < 0 || static_cast<std::size_t>(number) > angles.size())
      throw std::invalid_argument("directional probes: no probe has that number");
  SomeProbes result;
  GrainProbe not_made;
  not_made.stopped = true;
  result.probes.assign(numbers.size(), not_made);
  Handout handout(state, angles, numbers, how, progress, result);
  std::vector<std::thread> others;
  for (int t = 1; t < threads; ++t) others.emplace_back([&] { handout.work(); });
  handout.work();
  for (std::thread& t : others) t.join();
  handout.finish();
  return result;
}

ProbeRose probe_rose(const GrainState& state, const std::vector<double>& angles,
                     const GrainProbing& how, int threads, const GrainProgress& progress) {
  SomeProbes all =
      some_probes(state, angles, numbers_of_piece(static_cast<int>(angles.size()), 1, 1), how,
                  threads, progress);
  ProbeRose rose;
  rose.null_probe = all.probes.front();
  rose.probes.assign(all.probes.begin() + 1, all.probes.end());
  rose.stopped = all.stopped;
  return rose;
}

std::vector<int> numbers_of_piece(int directions, int index, int count) {
  std::vector<int> numbers;
  for (int k = index - 1; k <= directions; k += count) numbers.push_back(k);
  return numbers;
}

std::vector<double> rose_angles(int count) {
  std::vector<double> angles;
  for (int k = 0; k < count; ++k) angles.push_back(2 * std::numbers::pi * k / count);
  return angles;
}

}  // namespace triax::sim

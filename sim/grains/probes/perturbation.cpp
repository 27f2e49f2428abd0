// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/grains/probes/perturbation.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "sim/grains/engine/grains.hpp"
#include "sim/grains/engine/guarded_steps.hpp"
#include "sim/grains/state/grain_measures.hpp"
#include "sim/grains/state/random.hpp"
#include "sim/grains/state/triaxial_axes.hpp"

namespace triax::sim {
namespace {

constexpr int kChecksAtRest = 3;
/// Share of its largest value below which the kinetic energy of a load step has passed it.
constexpr double kPassed = 0.5;

void check(const Perturbation& how) {
  const auto positive = [](double x) { return x > 0 && std::isfinite(x); };
  if (!positive(how.ratio)) throw std::invalid_argument("perturbation: R must be above 0");
  if (!(how.kinetic_energy_j >= 0))
    throw std::invalid_argument("perturbation: the energy must not be below 0");
  if (!(how.floating_share > 0 && how.floating_share <= 1))
    throw std::invalid_argument(
        "perturbation: the floating fraction must be above 0 and at most 1");
  if (!positive(how.longest_s) || how.samples < 3 || how.check_every < 1)
    throw std::invalid_argument(
        "perturbation: a time above 0, three samples and a step between checks are needed");
}

std::vector<std::int32_t> floating(const GrainState& state) {
  std::vector<bool> touched(state.grains.size());
  for (const GrainContact& c : contacts_of(state)) {
    touched[c.i] = true;
    if (c.j >= 0) touched[c.j] = true;
  }
  // By their numbers of the description: the choice does not depend on how grains are sorted.
  std::vector<std::int32_t> index;
  for (std::size_t i = 0; i < touched.size(); ++i)
    if (!touched[i]) index.push_back(static_cast<std::int32_t>(i));
  std::sort(index.begin(), index.end(),
            [&](std::int32_t a, std::int32_t b) { return state.ids[a] < state.ids[b]; });
  return index;
}

class Perturbed {
 public:
  Perturbed(const GrainState& state, const Perturbation& how, int threads)
      : how_(how), grains_(state, threads), start_(state.box), start_time_(state.time_s) {
    const AxisymmetricStress stress = axisymmetric_stress(state);
    start_stress_ = path_stress(stress, how.ratio);
    start_p_ = mean_stress(stress);
    if (start_stress_ == 0)
      throw std::invalid_argument("perturbation: the state carries no stress");
    held_ = start_stress_ + how.load_step_pa;
    grains_.keep_ledger();
    grains_.drive(strain_path_drives(stress_drive(held_, how.speed_limit_m_per_s), how.ratio));
    if (how.kinetic_energy_j > 0)
      result_.grains_hit = give_energy(grains_, how.kinetic_energy_j, how.floating_share, how.seed);
  }

  PerturbationResult run(const GrainProgress& progress) {
    keep(now());
    double next = 0;
    int at_rest = 0;
    for (;;) {
      advance(grains_, how_.check_every);
      const PerturbationPoint point = now();
      most_ = std::max(most_, point.kinetic_energy_j);
      result_.most_kinetic_j = std::max(result_.most_kinetic_j, point.kinetic_energy_j);
      at_rest = rests(point) ? at_rest + 1 : 0;
      const bool over = ends(point, at_rest, progress);
      if (!over && point.time_s < next) continue;
      next = point.time_s + interval_;
      keep(point);
      if (over) break;
    }
    require_inside(grains_.state());
    result_.state = grains_.state();
    result_.ledger = grains_.ledger().value();
    return std::move(result_);
  }

 private:
  PerturbationPoint now() const {
    const GrainState& s = grains_.state();
    const AxisymmetricStress stress = axisymmetric_stress(s);
    PerturbationPoint point;
    point.time_s = s.time_s - start_time_;
    point.path_stress_pa = path_stress(stress, how_.ratio);
    point.stress_share = point.path_stress_pa / start_stress_;
    point.p_pa = mean_stress(stress);
    point.axial_strain = axisymmetric_strain(start_, s.box).axial;
    point.kinetic_energy_j = kinetic_energy(s);
    return point;
  }
  void keep(PerturbationPoint point) {
    point.kinetic_energy_j = std::max(most_, point.kinetic_energy_j);
    most_ = 0;
    point.unbalanced = measure(grains_.state()).unbalanced;
    if (static_cast<int>(result_.points.size()) >= how_.samples) thin();
    result_.points.push_back(point);
  }
  /// Nobody knows how long it takes: every other point goes, and the interval doubles.
  void thin() {
    std::size_t kept = 1;
    for (std::size_t k = 2; k < result_.points.size(); k += 2) {
      result_.points[kept] = result_.points[k];
      result_.points[kept].kinetic_energy_j =
          std::max(result_.points[k - 1].kinetic_energy_j, result_.points[k].kinetic_energy_j);
      ++kept;
    }
    result_.points.resize(kept);
    interval_ = std::max(2 * interval_,
                         2 * static_cast<double>(how_.check_every) * grains_.state().time_step_s);
  }
  bool rests(const PerturbationPoint& point) const {
    if (std::abs(point.path_stress_pa - held_) > how_.stress_error_pa) return false;
    const double most = how_.kinetic_energy_j > 0 ? how_.energy_share * how_.kinetic_energy_j
                                                  : kPassed * result_.most_kinetic_j;
    if (point.kinetic_energy_j > most) return false;
    return measure(grains_.state()).unbalanced < how_.unbalanced;
  }
  bool ends(const PerturbationPoint& point, int at_rest, const GrainProgress& progress) {
    auto& end = result_.end;
    if (point.p_pa < how_.collapse_share * start_p_ ||
        std::abs(point.axial_strain) > how_.collapse_strain)
      end = PerturbationEnd::collapsed;
    else if (at_rest >= kChecksAtRest)
      end = PerturbationEnd::at_rest;
    else if (!goes_on(progress, std::min(0.99, point.time_s / how_.longest_s), "perturbed"))
      end = PerturbationEnd::stopped;
    else
      return point.time_s >= how_.longest_s;
    return true;
  }

  const Perturbation& how_;
  Grains grains_;
  GrainBox start_;
  double start_time_, start_stress_ = 0, start_p_ = 0, held_ = 0, most_ = 0, interval_ = 0;
  PerturbationResult result_;
};

}  // namespace

Equilibrium equilibrium_at(const GrainState& state, double ratio, const Settling& settling,
                           int threads, const GrainProgress& progress) {
  if (!(ratio > 0)) throw std::invalid_argument("equilibrium: R must be above 0");
  Grains grains(state, threads);
  grains.keep_ledger();
  grains.drive({});
  calm(grains);
  Equilibrium result;
  result.rest = settle(grains, settling, progress);
  calm(grains);
  result.state = grains.state();
  result.ledger = grains.ledger().value();
  result.path_stress_pa = path_stress(axisymmetric_stress(result.state), ratio);
  return result;
}

std::int64_t give_energy(Grains& grains, double energy_j, double share, std::uint64_t seed) {
  Random random(seed);
  std::vector<std::int32_t> chosen = floating(grains.state());
  if (chosen.empty()) throw std::invalid_argument("no grain floats that could be given energy");
  random.shuffle(chosen);
  const double wanted = share * static_cast<double>(chosen.size());
  chosen.resize(std::max<std::size_t>(1, static_cast<std::size_t>(std::lround(wanted))));
  double mass = 0;
  for (const std::int32_t i : chosen) mass += 1 / grains.state().grains[i].inverse_mass;
  const double speed = std::sqrt(2 * energy_j / mass);
  for (const std::int32_t i : chosen) {
    std::array<double, 3> velocity = random.direction();
    for (double& v : velocity) v *= speed;
    grains.set_velocity(static_cast<std::size_t>(i), velocity);
  }
  return static_cast<std::int64_t>(chosen.size());
}

PerturbationResult perturb(const GrainState& equilibrium, const Perturbation& how, int threads,
                           const GrainProgress& progress) {
  check(how);
  return Perturbed(equilibrium, how, threads).run(progress);
}

}  // namespace triax::sim

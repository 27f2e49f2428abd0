// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/specimen/step_work.hpp"

#include <cmath>

namespace triax::sim {
namespace {

void add(StepWork& sum, const StepWork& part) {
  sum.axial += part.axial;
  sum.cell += part.cell;
  sum.drainage += part.drainage;
  sum.skeleton += part.skeleton;
  sum.membrane += part.membrane;
  sum.water += part.water;
  sum.damping += part.damping;
  sum.stop += part.stop;
  sum.kinetic += part.kinetic;
  sum.impulse += part.impulse;
}

}  // namespace

StepWork work_between(const Specimen& specimen, const SpecimenState& before,
                      const SpecimenStep& step, double back_pressure_pa) {
  const SpecimenState& after = step.state;
  const auto mean = [&](auto&& of) { return 0.5 * (of(before) + of(after)); };
  const auto change = [&](auto&& of) { return of(after) - of(before); };
  const Membrane& skin = specimen.membrane();
  const auto volume = [&](const SpecimenState& s) { return specimen.volume_m3(s); };
  const auto pocket = [&](const SpecimenState& s) { return skin.pocket_m3(radial_effective(s)); };

  const auto& e = step.strain_increment;
  const double v = mean(volume);
  const double pockets = change(pocket), enclosed = change(volume) + pockets;
  const double cell = mean([](const SpecimenState& s) { return s.cell_pressure; });
  const double pore = mean([](const SpecimenState& s) { return s.pore_pressure; });
  const double axial = mean([](const SpecimenState& s) { return s.material.stress(0); });
  const double radial = mean([](const SpecimenState& s) { return radial_effective(s); });

  StepWork work;
  work.axial = mean([&](const SpecimenState& s) { return specimen.axial_force(s); }) *
               (before.height_m - after.height_m);
  work.cell = -cell * enclosed;
  work.drainage = -back_pressure_pa * (after.drained_volume_m3 - before.drained_volume_m3);
  work.skeleton = v * (axial * e.axial + 2 * radial * e.radial);
  const double hoop = mean([&](const SpecimenState& s) { return skin.radial_pa(volume(s)); });
  const double along = mean([&](const SpecimenState& s) { return skin.axial_pa(s.height_m); });
  work.membrane = v * (along * e.axial + hoop * volumetric_strain(e)) - (cell - pore) * pockets;
  work.water = work.drainage - pore * enclosed;
  return work;
}

bool exhausted(SpecimenStep& whole, const SpecimenTolerance& tolerance) {
  if (whole.law_steps <= tolerance.law_steps) return false;
  whole.outcome = StepOutcome::failed;
  whole.law_ended = true;
  whole.message =
      "it needs ever shorter steps, p' = " + std::to_string(std::lround(whole.state.material.p())) +
      " Pa";
  return true;
}

void append(SpecimenStep& whole, const SpecimenStep& part) {
  whole.state = part.state;
  whole.done_s += part.done_s;
  whole.stress_increment.axial += part.stress_increment.axial;
  whole.stress_increment.radial += part.stress_increment.radial;
  whole.strain_increment.axial += part.strain_increment.axial;
  whole.strain_increment.radial += part.strain_increment.radial;
  add(whole.work, part.work);
  const bool inaccurate = whole.outcome == StepOutcome::inaccurate && went_on(part);
  if (!inaccurate) {
    whole.outcome = part.outcome;
    whole.message = part.message;
  }
  whole.law_ended = part.law_ended;
  whole.at_stop = part.at_stop;
  whole.ran_away = whole.ran_away || part.ran_away;
  whole.substeps += part.substeps;
  whole.law_steps += part.law_steps;
}

}  // namespace triax::sim

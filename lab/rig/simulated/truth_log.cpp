// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/rig/simulated/truth_log.hpp"

namespace triax::lab {
namespace {

TruthWatch::Lengths truth_lengths(const sim::Specimen::MaterialLaw& law) {
  if (law.self_driven() == nullptr) return {};
  return {.increment = 5e-4, .lasting = 1e-3};
}

}  // namespace

TruthLog::TruthLog(const sim::Specimen::MaterialLaw& law) : watch_(truth_lengths(law)) {}

void TruthLog::add_work(const TrueStep& one) {
  watch_.watch(one.time_s, one.dt_s, one.before, one.step, one.sheared, one.height_at_shear_m);
}

std::string TruthLog::add_run_away(const TrueStep& one) {
  const sim::SpecimenState& after = one.step.state;
  const double end_s = one.time_s + one.dt_s;
  const bool began = one.sheared && after.run_away.count != one.before.run_away.count;
  if (began)
    lost_ = lost_equilibrium(end_s - after.run_away.elapsed_s, one.before, one.height_at_shear_m);
  return run_aways_.watch(end_s, after, began ? lost_ : std::nullopt);
}

Truth TruthLog::truth(const sim::SpecimenState& last) const {
  Truth truth = watch_.truth();
  if (lost_ && fell(last)) truth = earlier_of(truth, *lost_);
  truth.run_aways = run_aways_.all();
  return truth;
}

}  // namespace triax::lab

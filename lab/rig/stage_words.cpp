// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/rig/stage_words.hpp"

#include <fmt/format.h>

namespace triax::lab {

std::string out_of_time(const Stage& stage) {
  return fmt::format("stage \"{}\" did not reach its end within {:g} min; the test was ended",
                     stage.name, stage.time_limit_s / 60);
}

std::string ended_by_guard(const Stage& stage, double time_s, const std::string& what_it_did) {
  return fmt::format("stage \"{}\" was ended at {:.6g} s by the intervention: {}", stage.name,
                     time_s, what_it_did);
}

std::string ended_in_safe_state(const Stage& stage, double time_s, const std::string& why) {
  return fmt::format("safe state from {:.6g} s on, in stage \"{}\": {}", time_s, stage.name, why);
}

std::string ended_by_law(const Stage& stage, double time_s, const sim::SpecimenStep& step) {
  return fmt::format("stage \"{}\" ended at {:.6g} s: the law gives no result from there on: {}",
                     stage.name, time_s, step.message);
}

std::string control_lost(const Stage& stage, double time_s, const sim::SpecimenStep& step) {
  return fmt::format(
      "stage \"{}\" ended at {:.6g} s: the specimen cannot follow the prescribed path "
      "(q = {:.4g} kPa, p' = {:.4g} kPa)",
      stage.name, time_s + step.done_s, step.state.material.q() / 1e3,
      step.state.material.p() / 1e3);
}

std::string travel_reached(const Stage& stage, double time_s, double travel_m, double displaced_m) {
  return fmt::format("stage \"{}\" ended at {:.6g} s: travel limit of {:g} mm reached{}",
                     stage.name, time_s, travel_m * 1e3, displaced_m < 0 ? " in extension" : "");
}

}  // namespace triax::lab

// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/collapse/fall_work.hpp"

#include <fmt/format.h>

namespace triax::lab {

std::optional<FallWork> work_of_fall(const State& before, const State& after,
                                     const PathPoint& near) {
  const PathStep step{after.q - before.q, after.p_eff - before.p_eff,
                      after.strain.axial - before.strain.axial,
                      after.volumetric_strain - before.volumetric_strain};
  // A parabola's value at the middle of a window has a third of the variance of one of its blocks.
  const double of_a_reading = 3 * static_cast<double>(near.window_readings) / BlockPyramid::kBlocks;
  FallWork work;
  work.normalised = normalised_second_order_work(step);
  work.error = direction_error(step, 2 * of_a_reading * near.stress_variance,
                               2 * of_a_reading * near.strain_variance);
  if (!(work.normalised < -3 * work.error)) return std::nullopt;
  work.evidence = fmt::format(
      "normalised second-order work {:.3f} ± {:.3f} of the increment from reading {} to {}, during "
      "which q fell",
      work.normalised, work.error, before.reading, after.reading);
  return work;
}

}  // namespace triax::lab

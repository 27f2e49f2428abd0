// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The result of an assessment, from everything that was found.
#include <optional>
#include <vector>

#include "lab/collapse/criterion.hpp"
#include "lab/collapse/descent.hpp"
#include "lab/collapse/fall_work.hpp"
#include "lab/collapse/limit_surface.hpp"
#include "lab/collapse/loss_and_return.hpp"
#include "lab/measured/axis_rest.hpp"
#include "lab/measured/backbone.hpp"
#include "lab/measured/cycles.hpp"

namespace triax::lab {

/// Everything that was found by the end of a test.
struct Evidence {
  std::optional<Descent> worst;      ///< descent that cost most strength
  std::optional<Descent> at_held_q;  ///< descent that lasted while q was held
  std::optional<Descent> latest;     ///< the one under way when the record ended
  std::optional<Finding> loss_of_control;
  const LossAndReturn* loss = nullptr;  ///< what that took and gave back; null: nobody says
  std::optional<Finding> zero_stress;   ///< under a prescribed displacement (ZeroStress)
  /// The specimen fell from one reading to the next, and this is where it lost its equilibrium.
  /// Whatever turned before, until then it carried the programme, the second-order work of whose
  /// slow trend is hundreds of times smaller than that of the servo's search.
  std::optional<Instant> fall;
  std::optional<FallWork> fall_work;  ///< its second-order work, where readings prove it
  std::optional<Finding> control_peak;
  bool turned_at_held_q = false;  ///< control_peak is the turn of the volume, or of u, at held q
  /// Second-order work is negative at the last readings of the record: softens_at_end(), at
  /// constant q contracts_at_end().
  std::optional<Instant> negative_at_end;
  /// At held q with the valve closed the measured volume stands still and second-order work is zero
  /// within its error until q is lost; the pore pressure, gauge of the volume, gives the onset.
  bool volume_by_pore_pressure = false;
  std::int64_t states = 0;                  ///< that the monitor watched in shear
  std::int64_t points = 0;                  ///< of second-order work that came of them
  std::optional<std::int64_t> first_state;  ///< reading of the first of them
  std::optional<Nearest> nearest;
  std::optional<AxisRest::Fall> fall_at_rest;  ///< that no relaxation explains
  /// Strength lost from reading to reading: counts where nothing else explains it.
  std::optional<BackboneFall> backbone;
  const CycleCounter* cycles = nullptr;  ///< null: not counted
  const LimitSurface& limit;
  bool has_time = true;
};

/// The result of all evidence by the table of rules (assessment_rules.hpp), which `triax about
/// --rules` prints. `criteria` are those of Criteria::criteria(). The result has them, with the
/// evidence of a fall or the limit surface in the first, second-order work.
Collapse assess(const Evidence& evidence, std::vector<Criterion> criteria);

}  // namespace triax::lab

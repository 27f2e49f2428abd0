// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/reduction/cross_checks.hpp"

#include <numbers>

namespace triax::lab {

CrossChecks::CrossChecks(const RecordHeader& header) : header_(header) {
  const auto& [height, diameter] = std::pair(header.specimen.height_m, header.specimen.diameter_m);
  if (height && diameter) volume_m3_ = std::numbers::pi / 4 * *diameter * *diameter * *height;
}

void CrossChecks::add(const Reading& reading, const State& state) {
  const StageInfo* stage = header_.stage(reading.stage);
  if (!stage || !header_.is_raw()) return;
  const bool shear = stage->role == StageRole::shear;
  const bool open = stage->drainage == Drainage::open;
  sheared_ = sheared_ || shear;
  consolidation_.add(reading, state, !sheared_ && open && stage->role == StageRole::consolidation,
                     volume_m3_);
  // Along a strain path the controller pumps: u_b is what it takes to move the water.
  const bool drains = shear && open && !stage->strain_path_R;
  rate_.add(reading, state, drains, consolidation_.difference());
  valve_.add(reading, shear && stage->drainage == Drainage::closed, volume_m3_);
}

std::vector<Check> CrossChecks::checks(std::optional<std::int64_t> onset) const {
  std::vector<Check> all = consolidation_.checks();
  if (auto rate = rate_.check(onset)) all.push_back(std::move(*rate));
  if (auto valve = valve_.check()) all.push_back(std::move(*valve));
  return all;
}

std::vector<Warning> warnings_of(const std::vector<Check>& checks) {
  std::vector<Warning> all;
  for (const Check& check : checks)
    if (!check.ok) all.push_back({0, std::string(to_string(check.kind)) + ": " + check.note});
  return all;
}

}  // namespace triax::lab

// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/ags/specimen_match.hpp"

#include <optional>
#include <utility>

namespace triax::lab {
namespace {

bool fits(const std::string& a, const std::string& b) { return a.empty() || b.empty() || a == b; }

bool fits(const std::optional<double>& a, const std::optional<double>& b) {
  return !a || !b || *a == *b;
}

/// A location of its own is a part of every key in a delivery that can be read at all.
bool fits(const ReferenceSpecimen& a, const ReferenceSpecimen& b) {
  return a.location == b.location && fits(a.sample_reference, b.sample_reference) &&
         fits(a.sample_type, b.sample_type) && fits(a.sample_id, b.sample_id) &&
         fits(a.specimen_reference, b.specimen_reference) && fits(a.sample_top_m, b.sample_top_m) &&
         fits(a.specimen_depth_m, b.specimen_depth_m);
}

}  // namespace

void SpecimenMatch::add(ReferenceResult general) {
  by_location_.emplace(general.specimen.location, generals_.size());
  generals_.push_back(std::move(general));
  matched_.push_back(false);
}

const ReferenceResult* SpecimenMatch::find(const ReferenceSpecimen& specimen) {
  const auto [begin, end] = by_location_.equal_range(specimen.location);
  std::optional<std::size_t> same, alike;
  std::size_t all_alike = 0;
  for (auto at = begin; at != end; ++at) {
    const ReferenceSpecimen& candidate = generals_[at->second].specimen;
    if (candidate == specimen && (!same || at->second < *same)) same = at->second;
    if (!fits(candidate, specimen)) continue;
    alike = at->second;
    ++all_alike;
  }
  const auto found = same ? same : all_alike == 1 ? alike : std::nullopt;
  if (!found) return nullptr;
  matched_[*found] = true;
  return &generals_[*found];
}

void SpecimenMatch::append_unmatched(std::vector<ReferenceResult>& results) const {
  for (std::size_t i = 0; i < generals_.size(); ++i)
    if (!matched_[i]) results.push_back(generals_[i]);
}

}  // namespace triax::lab

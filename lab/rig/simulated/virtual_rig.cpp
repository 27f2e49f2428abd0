// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/rig/simulated/virtual_rig.hpp"

#include <fmt/format.h>

#include <utility>

#include "lab/rig/rig_header.hpp"

namespace triax::lab {
namespace {

RecordHeader header_of(const Programme& given, const Programme& used, std::uint64_t seed) {
  RecordHeader header = rig_header(used, seed);
  for (const auto& row : raw_channels())
    if (given.fitted[index(row.quantity)] && !used.fitted[index(row.quantity)])
      header.warnings.push_back(
          {0,
           fmt::format("{} is not recorded: the virtual specimen has no such channel", row.name)});
  return header;
}

}  // namespace

VirtualRig::VirtualRig(const Programme& programme, std::optional<std::uint64_t> seed)
    : VirtualRig(programme, with_guard_stages(as_far_as_simulated(programme)),
                 seed.value_or(programme.seed)) {}

VirtualRig::VirtualRig(const Programme& given, const GuardedProgramme& used, std::uint64_t seed)
    : RigSoftware(used, header_of(given, used.programme, seed),
                  std::make_unique<VirtualApparatus>(used.programme, seed)) {}

const Plant& VirtualRig::plant() const {
  return static_cast<const VirtualApparatus&>(apparatus()).plant();
}

}  // namespace triax::lab

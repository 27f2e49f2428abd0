// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The first state of a path that some direction makes unstable.
#include <optional>
#include <vector>

#include "lab/materials/material_library.hpp"
#include "src/study/probe/probing.hpp"
#include "src/study/probe/state_to_probe.hpp"

namespace triax::study {

/// A state at which some direction is unstable.
struct FirstUnstable {
  double p = 0, q = 0, void_ratio = 0;  ///< Pa; Pa; 1
  std::optional<double> axial_strain;   ///< since the start of a path
  double angle = 0;                     ///< α of the least normalised W₂, rad
  double eta() const { return q / p; }
};

/// The first state with an unstable direction on the way along rows of a path, isolated between two
/// of them by integrating a part of their strain increment from the earlier one; the first row
/// where that is unstable already. Empty: none of the rows is unstable. Pre-condition: the material
/// has a law in this space, which is that of the plane.
template <class Space>
std::optional<FirstUnstable> first_unstable(const lab::MaterialSet& material,
                                            const std::vector<PassedRow<Space>>& rows,
                                            const Probing& probing);

extern template std::optional<FirstUnstable> first_unstable(
    const lab::MaterialSet&, const std::vector<PassedRow<sim::Axisymmetric>>&, const Probing&);
extern template std::optional<FirstUnstable> first_unstable(
    const lab::MaterialSet&, const std::vector<PassedRow<sim::Tensor>>&, const Probing&);

}  // namespace triax::study

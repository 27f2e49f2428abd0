// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The criteria of other kinds that are looked for in a domain, as rows of one list: from a row
// follow the keys of JSON, CSV and piece files, the column of the text, the line of the figure and,
// for one that has to be asked for, its option. A new criterion is a file pair and a row.
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "sim/stability/domain.hpp"

namespace triax::sim {

struct DomainCriterionKind {
  std::string_view name;       ///< "determinant"; asked for as --NAME
  std::string_view legend;     ///< of its line in the figure
  std::string_view help = {};  ///< of its option; empty: looked for always
  bool dots =
      false;  ///< drawn on top, where it may lie on the line of the first unstable direction
  std::size_t most_rows = std::numeric_limits<std::size_t>::max();  ///< as in DomainCriterion
  /// Computed from the state alone. Empty where the law has none. The material must outlive it.
  DomainWitness (*witness)(const Material& material, const DomainGrid& grid);

  bool on_request() const { return !help.empty(); }
};

/// determinant    det Mˢ of the compliance in the plane, in a zone that holds its null vector:
///                octolinear in closed form (octolinear_cones.hpp), other laws by the half Hessian
///                of W₂ (stability_determinant.hpp). Not of laws that integrate themselves.
/// localisation   the least det of an acoustic tensor of the tangents in the plane
///                (localisation.hpp). Of laws with a tensor form, and only where asked for: some
///                milliseconds a state.
std::span<const DomainCriterionKind> domain_criterion_kinds();

/// Those that go with a material and a grid: all that are looked for always, and those `asked` for
/// by name. The material must outlive them; ask them from one thread at a time.
DomainCriteria domain_criteria(const Material& material, const DomainGrid& grid,
                               const std::vector<std::string>& asked = {});

}  // namespace triax::sim

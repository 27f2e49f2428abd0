// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/study/domain/domain_counts.hpp"

#include <algorithm>

namespace triax::study {

KindCounts counts_of_kinds(const ReportedDomain& domain) {
  KindCounts all{};
  for (const auto& column : domain.columns)
    for (const auto& state : column.states) ++all[static_cast<std::size_t>(state.kind)];
  return all;
}

bool any_answer(const ReportedDomain& domain) {
  return std::ranges::any_of(domain.columns, [](const ReportedColumn& column) {
    return std::ranges::any_of(column.states, [](const ReportedDomainState& state) {
      return state.kind != sim::DomainStateKind::refused;
    });
  });
}

}  // namespace triax::study

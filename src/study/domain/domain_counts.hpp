// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// How many states of a domain are of which kind.
#include <array>

#include "src/study/domain/domain_report.hpp"

namespace triax::study {

/// By the place of the kind in sim::kDomainStateKinds.
using KindCounts = std::array<int, sim::kDomainStateKinds.size()>;

KindCounts counts_of_kinds(const ReportedDomain& domain);

/// Whether the law answers any state at all: a map of refusals is no result.
bool any_answer(const ReportedDomain& domain);

}  // namespace triax::study

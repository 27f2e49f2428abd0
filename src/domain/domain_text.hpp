// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// A bifurcation domain as text and CSV.
#include <string>

#include "src/study/domain/domain_report.hpp"

namespace triax::src {

/// A short table by p′, the shares of the kinds of states, and what was refused.
std::string domain_text(const study::ReportedDomain& domain);
/// All states, and all boundaries; what is unknown is empty.
std::string domain_states_csv(const study::ReportedDomain& domain);
std::string domain_boundaries_csv(const study::ReportedDomain& domain);

}  // namespace triax::src

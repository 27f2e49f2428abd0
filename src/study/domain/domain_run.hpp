// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// A bifurcation domain, or a piece of one, computed on several threads.
#include "src/study/domain/domain_report.hpp"
#include "src/study/progress.hpp"

namespace triax::study {

struct DomainRequest {
  lab::MaterialSet material;
  DomainSettings::Grid grid;  ///< as asked_grid() gives it
  int threads = 0;            ///< 0: all cores; the result does not depend on it
  int piece = 1, pieces = 1;  ///< every `pieces`-th column from this one on, which is from 1
};

/// "domain" is what is under way. Pre-condition: the material has a law for the plane of the grid,
/// and pieces ≤ grid.columns.
ReportedDomain run_domain(const DomainRequest& request, const Progress& progress = {});

}  // namespace triax::study

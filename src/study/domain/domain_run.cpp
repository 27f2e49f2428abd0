// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/study/domain/domain_run.hpp"

#include "sim/stability/domain_criteria.hpp"
#include "sim/stability/domain_run.hpp"

namespace triax::study {

ReportedDomain run_domain(const DomainRequest& request, const Progress& progress) {
  const sim::DomainGrid grid = domain_grid(request.grid);
  const auto worker = [&] {
    sim::DomainWorker made{lab::made_anew(request.material), {}};
    made.criteria = sim::domain_criteria(made.material, grid, request.grid.criteria);
    return made;
  };
  const auto columns =
      sim::run_domain(grid, sim::columns_of_piece(grid, request.piece, request.pieces), worker,
                      {.threads = request.threads, .progress = [&](double share) {
                         show(progress, "domain", share);
                         return true;
                       }});
  ReportedDomain domain{.settings = domain_settings(request.material, request.grid)};
  for (const auto& column : columns) domain.columns.push_back(reported_column(column));
  return domain;
}

}  // namespace triax::study

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "lab/materials/material_library.hpp"
#include "src/study/domain/domain_report.hpp"

// A small domain of INL2, both sides, with states of every kind but refused ones.
namespace triax::study {

inline lab::MaterialSet sample_material() { return lab::find_material("inl2/S28-general"); }

inline ReportedDomain sample_domain(std::vector<int> columns = {0, 1, 2}) {
  const lab::MaterialSet material = sample_material();
  ReportedDomain domain{domain_settings(material, {.p_from_kPa = 50,
                                                   .p_to_kPa = 150,
                                                   .q_from_kPa = -140,
                                                   .q_to_kPa = 190,
                                                   .columns = 3,
                                                   .rows = 12,
                                                   .void_ratio = 1.086,
                                                   .plane = "axisymmetric",
                                                   .directions = 36}),
                        {}};
  for (const int column : columns)
    domain.columns.push_back(reported_column(sim::domain_column(
        *material.material.axisymmetric, domain_grid(domain.settings.grid), column)));
  return domain;
}

}  // namespace triax::study

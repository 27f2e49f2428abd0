// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/probe/strain_paths_text.hpp"

#include <fmt/format.h>

#include "src/output/simulated_head.hpp"
#include "src/output/table.hpp"
#include "src/output/words.hpp"

namespace triax::src {
namespace {

void put_point(const std::optional<sim::StrainPathPoint>& at, std::vector<std::string>& row) {
  if (!at) return void(row.insert(row.end(), 4, kUnknown));
  row.insert(row.end(), {in_percent(at->axial_strain, 4), in_kPa(at->control_stress, 2),
                         in_kPa(at->q, 2), number(at->eta(), 4)});
}

Table peaks_table(const study::StrainPathsResult& result) {
  Table table;
  for (const char* heading :
       {"R", "peak at ε₁ (%)", "σ₁′−σ₃′/R (kPa)", "q (kPa)", "η", "W₂ = 0 at ε₁ (%)",
        "σ₁′−σ₃′/R (kPa)", "q (kPa)", "η", "ended at ε₁ (%)"})
    table.columns.push_back({heading, Align::right});
  for (const auto& path : result.paths) {
    std::vector<std::string> row = {fmt::format("{:g}", path.R)};
    put_point(path.peak, row);
    put_point(path.first_unstable, row);
    row.push_back(in_percent(path.points.back().axial_strain, 3));
    table.rows.push_back(std::move(row));
  }
  return table;
}

}  // namespace

std::string strain_paths_text(const study::StrainPathsResult& result) {
  std::string out = simulated_head("Proportional strain paths dε₁ + 2R dε₃ = 0", result.material);
  out += fact("start", fmt::format("p′ {} kPa, isotropic, e {}", in_kPa(result.p, 2),
                                   number(result.void_ratio, 4)));
  out += '\n' + indented(to_text(peaks_table(result))) + '\n';
  for (const auto& warning : result.warnings) out += fact("warning", warning);
  return without_controls(out);
}

}  // namespace triax::src

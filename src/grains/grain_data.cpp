// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/grains/grain_data.hpp"

#include <fmt/format.h>

#include <cctype>

#include "sim/mechanics/axisymmetric.hpp"
#include "src/study/grains/grain_curves.hpp"
#include "src/study/grains/grain_rose_findings.hpp"

namespace triax::src {
namespace {

using Row = std::vector<std::optional<double>>;

FigureData titled(const lab::GrainReport& report, const std::string& what,
                  const std::vector<const lab::ReportedGrainStage*>& stages) {
  FigureData data;
  data.title = fmt::format("{}, {}", what, report.about());
  data.origin = "simulated";
  if (!report.source.empty()) data.remarks.push_back("programme: " + report.source);
  for (const auto* stage : stages)
    data.remarks.push_back(fmt::format("stage {}: {}, {} from {}", stage - report.stages.data() + 1,
                                       stage->name, stage->action,
                                       stage->from.empty() ? "the specimen as made" : stage->from));
  return data;
}

double number_of(const lab::GrainReport& report, const lab::ReportedGrainStage& stage) {
  return static_cast<double>(&stage - report.stages.data() + 1);
}

const std::vector<DataColumn> kPathColumns = {{"stage", ""},
                                              {"time_s", "s"},
                                              {"axial_strain", ""},
                                              {"radial_strain", ""},
                                              {"volumetric_strain", ""},
                                              {"axial_stress_kPa", "kPa"},
                                              {"radial_stress_kPa", "kPa"},
                                              {"p_kPa", "kPa"},
                                              {"q_kPa", "kPa"},
                                              {"eta", ""},
                                              {"R", ""},
                                              {"path_stress_kPa", "kPa"},
                                              {"w2_J_per_m3", "J/m³"},
                                              {"porosity", ""},
                                              {"coordination", ""},
                                              {"sliding_share", ""},
                                              {"kinetic_energy_J", "J"},
                                              {"unbalanced", ""}};

void add_points(FigureData& data, double stage, const lab::ReportedGrainPath& path) {
  const auto works = study::works_along(path);
  for (std::size_t i = 0; i < works.size(); ++i) {
    const sim::GrainPathPoint& at = path.points[i];
    data.rows.push_back({stage, at.time_s, at.strain.axial, at.strain.radial, at.volumetric_strain,
                         at.stress.axial / 1e3, at.stress.radial / 1e3, at.p_pa / 1e3,
                         at.q_pa / 1e3,
                         at.p_pa > 0 ? std::optional(at.stress_ratio()) : std::nullopt,
                         path.path.ratio, at.path_stress_pa / 1e3, works[i], at.porosity,
                         at.coordination, at.sliding_share, at.kinetic_energy_j, at.unbalanced});
  }
}

const std::vector<DataColumn> kProbeColumns = {{"alpha_deg", "°"},
                                               {"norm_kPa", "kPa"},
                                               {"norm_strain", ""},
                                               {"axial_stress_increment_kPa", "kPa"},
                                               {"radial_stress_increment_kPa", "kPa"},
                                               {"axial_strain_increment", ""},
                                               {"radial_strain_increment", ""},
                                               {"w2_lagrangian_J_per_m3", "J/m³"},
                                               {"w2_eulerian_J_per_m3", "J/m³"},
                                               {"w2_stress_part_J_per_m3", "J/m³"},
                                               {"w2_volume_part_J_per_m3", "J/m³"},
                                               {"w2_transport_part_J_per_m3", "J/m³"},
                                               {"w2_microscopic_J_per_m3", "J/m³"},
                                               {"w2_normal_part_J_per_m3", "J/m³"},
                                               {"w2_tangential_part_J_per_m3", "J/m³"},
                                               {"w2_non_permanent_part_J_per_m3", "J/m³"},
                                               {"w2_fixed_frame_J_per_m3", "J/m³"},
                                               {"boundary_part_J_per_m3", "J/m³"},
                                               {"gap_grains_turning_J_per_m3", "J/m³"},
                                               {"gap_contacts_turning_J_per_m3", "J/m³"},
                                               {"gap_out_of_balance_J_per_m3", "J/m³"},
                                               {"gap_left_J_per_m3", "J/m³"},
                                               {"micro_over_macro", ""},
                                               {"w2_normalised", ""},
                                               {"sliding_share", ""},
                                               {"non_permanent_share", ""},
                                               {"kinetic_energy_J", "J"},
                                               {"at_rest", ""},
                                               {"steps", ""},
                                               {"unbalanced", ""},
                                               {"stress_error_Pa", "Pa"},
                                               {"walls_J", "J"},
                                               {"elastic_change_J", "J"},
                                               {"kinetic_change_J", "J"},
                                               {"friction_J", "J"},
                                               {"damping_J", "J"},
                                               {"ledger_error_J", "J"},
                                               {"momentum_error_kg_m_per_s", "kg m/s"}};

Row probe_row(const sim::GrainProbe& p, std::optional<double> angle,
              const lab::ReportedGrainRose& rose) {
  const bool null_probe = !angle, parts_stored = rose.parts_stored;
  const bool by_stress = rose.kind == sim::ProbeKind::stress;
  const auto part = [&](double value) {
    return parts_stored ? std::optional(value) : std::nullopt;
  };
  Row row = {angle, by_stress ? std::optional(p.norm_pa / 1e3) : std::nullopt,
             by_stress ? std::nullopt : std::optional(p.norm_strain)};
  if (!p.stopped) {
    const auto& w = p.work;
    const auto& l = p.ledger;
    row.insert(row.end(), {p.stress.axial / 1e3,
                           p.stress.radial / 1e3,
                           p.strain.axial,
                           p.strain.radial,
                           w.lagrangian,
                           w.eulerian(),
                           w.stress_part,
                           w.volume_part,
                           w.transport_part,
                           w.microscopic(),
                           part(w.normal_part),
                           part(w.tangential_part),
                           part(w.non_permanent_part),
                           w.fixed_frame,
                           w.boundary_part,
                           w.grains_turning,
                           w.contacts_turning,
                           w.out_of_balance,
                           w.gap_left(),
                           null_probe ? std::nullopt : study::micro_over_macro(p),
                           null_probe ? std::nullopt : std::optional(w.normalised),
                           p.sliding_share,
                           w.non_permanent_share(),
                           p.most_kinetic_j,
                           p.at_rest ? 1.0 : 0.0,
                           static_cast<double>(p.steps),
                           p.unbalanced,
                           p.stress_error_pa,
                           l.walls_j,
                           l.elastic_end_j - l.elastic_start_j,
                           l.kinetic_end_j - l.kinetic_start_j,
                           l.friction_j,
                           l.damping_j,
                           l.energy_error_j(),
                           l.momentum_error()});
  }
  row.resize(kProbeColumns.size());
  return row;
}

struct Csv {
  const lab::GrainReport& report;
  const lab::ReportedGrainStage& stage;

  std::optional<NamedBytes> operator()(const lab::ReportedGrainPath& /*came*/) const {
    return named("_points.csv", paths_data(report, {&stage}));
  }
  std::optional<NamedBytes> operator()(const lab::ReportedGrainRest& /*came*/) const { return {}; }
  std::optional<NamedBytes> operator()(const lab::ReportedGrainRose& /*came*/) const {
    return named("_probes.csv", rose_data(report, stage));
  }
  std::optional<NamedBytes> operator()(const lab::ReportedPerturbation& /*came*/) const {
    return named("_points.csv", perturbations_data(report, {&stage}));
  }

 private:
  NamedBytes named(const char* ending, const FigureData& data) const {
    return {'_' + lab::in_file_name(stage.name) + ending, to_csv(data)};
  }
};

}  // namespace

FigureData paths_data(const lab::GrainReport& report,
                      const std::vector<const lab::ReportedGrainStage*>& stages) {
  FigureData data = titled(report, "paths of a specimen of grains", stages);
  data.columns = kPathColumns;
  data.remarks.emplace_back("w2: of the increment from the point before, Eq. (30)");
  for (const auto* stage : stages)
    add_points(data, number_of(report, *stage), std::get<lab::ReportedGrainPath>(stage->came));
  return data;
}

FigureData rose_data(const lab::GrainReport& report, const lab::ReportedGrainStage& stage) {
  FigureData data = titled(report, "stress probes of a specimen of grains", {&stage});
  const auto& rose = std::get<lab::ReportedGrainRose>(stage.came);
  const lab::GrainRose& made = rose.made;
  data.columns = kProbeColumns;
  data.remarks.push_back(fmt::format("state: axial stress {} kPa, radial stress {} kPa",
                                     made.stress.axial / 1e3, made.stress.radial / 1e3));
  data.remarks.emplace_back("the row without an angle is the null probe");
  for (std::size_t i = 0; i < made.rose.probes.size(); ++i)
    data.rows.push_back(probe_row(made.rose.probes[i], sim::degrees(made.angles[i]), rose));
  data.rows.push_back(probe_row(made.rose.null_probe, {}, rose));
  return data;
}

FigureData perturbations_data(const lab::GrainReport& report,
                              const std::vector<const lab::ReportedGrainStage*>& stages) {
  FigureData data = titled(report, "perturbations of a specimen of grains", stages);
  data.columns = {{"stage", ""},
                  {"time_s", "s"},
                  {"R", ""},
                  {"path_stress_kPa", "kPa"},
                  {"chi", ""},
                  {"p_kPa", "kPa"},
                  {"axial_strain", ""},
                  {"kinetic_energy_J", "J"},
                  {"unbalanced", ""}};
  for (const auto* stage : stages) {
    const auto& came = std::get<lab::ReportedPerturbation>(stage->came);
    for (const auto& at : came.points)
      data.rows.push_back({number_of(report, *stage), at.time_s, came.how.ratio,
                           at.path_stress_pa / 1e3, at.stress_share, at.p_pa / 1e3, at.axial_strain,
                           at.kinetic_energy_j, at.unbalanced});
  }
  return data;
}

std::vector<NamedBytes> grain_csvs(const lab::GrainReport& report) {
  std::vector<NamedBytes> all;
  for (const auto& stage : report.stages)
    if (auto one = std::visit(Csv{report, stage}, stage.came)) all.push_back(std::move(*one));
  return all;
}

}  // namespace triax::src

#include "src/probe/strain_paths_report.hpp"

#include <fmt/format.h>

#include "lab/base/bad_input.hpp"
#include "src/output/simulated_head.hpp"
#include "src/output/table.hpp"
#include "src/output/words.hpp"
#include "src/probe/strain_paths_figure.hpp"
#include "src/study/json_parts.hpp"

namespace triax::src {
namespace {

double eta(const sim::StrainPathPoint& at) { return at.q / at.p; }

study::Json point_json(const std::optional<sim::StrainPathPoint>& at) {
  if (!at) return nullptr;
  return {{"axial_strain", study::json_number(at->axial_strain)},
          {"control_stress_kPa", study::json_kPa(at->control_stress)},
          {"p_eff_kPa", study::json_kPa(at->p)},
          {"q_kPa", study::json_kPa(at->q)},
          {"eta", study::json_number(eta(*at))},
          {"void_ratio", study::json_number(at->void_ratio)},
          {"w2_normalised", study::json_number(at->normalised_work)}};
}

void put_point(const std::optional<sim::StrainPathPoint>& at, std::vector<std::string>& row) {
  if (!at) return void(row.insert(row.end(), 4, kUnknown));
  row.insert(row.end(), {in_percent(at->axial_strain, 4), in_kPa(at->control_stress, 2),
                         in_kPa(at->q, 2), number(eta(*at), 4)});
}

Table peaks_table(const StrainPathsReport& report) {
  Table table;
  for (const char* heading :
       {"R", "peak at ε₁ (%)", "σ₁′−σ₃′/R (kPa)", "q (kPa)", "η", "W₂ = 0 at ε₁ (%)",
        "σ₁′−σ₃′/R (kPa)", "q (kPa)", "η", "ended at ε₁ (%)"})
    table.columns.push_back({heading, Align::right});
  for (const auto& path : report.paths) {
    std::vector<std::string> row = {fmt::format("{:g}", path.R)};
    put_point(path.peak, row);
    put_point(path.first_unstable, row);
    row.push_back(in_percent(path.points.back().axial_strain, 3));
    table.rows.push_back(std::move(row));
  }
  return table;
}

}  // namespace

StrainPathsReport strain_paths(const lab::MaterialSet& material, double p, double void_ratio,
                               const std::vector<double>& R, double axial_strain) {
  const auto* law = material.material.axisymmetric.get();
  if (law == nullptr)
    throw lab::BadInput(material.name + " has no form in axisymmetry, which strain paths need");
  const auto start = law->isotropic(p, void_ratio);
  if (const auto objection = law->objection(start))
    throw lab::BadInput(fmt::format("p' {:.6g} kPa, void ratio {:.6g}: out of range for {}: {}", p / 1e3,
                                    void_ratio, material.name, *objection));
  StrainPathsReport report{.material = material,
                           .p = p,
                           .void_ratio = void_ratio,
                           .axial_strain = axial_strain,
                           .paths = {},
                           .warnings = {}};
  for (const auto& words :
       {lab::void_ratio_outside(material, void_ratio), lab::p_eff_outside(material, p)})
    if (words) report.warnings.push_back(*words);
  for (const double one : R) {
    report.paths.push_back(sim::strain_path(*law, start, one, {.axial_strain = axial_strain}));
    if (!report.paths.back().message.empty())
      report.warnings.push_back(fmt::format("R {:g}: {}", one, report.paths.back().message));
  }
  return report;
}

std::string strain_paths_json(const StrainPathsReport& report) {
  study::Json document = {{"origin", "simulated"},
                          {"material", study::json_material(report.material)},
                          {"start",
                           {{"p_eff_kPa", study::json_kPa(report.p)},
                            {"q_kPa", 0.0},
                            {"void_ratio", study::json_number(report.void_ratio)}}},
                          {"axial_strain", report.axial_strain}};
  study::Json paths = study::Json::array();
  for (const auto& path : report.paths) {
    study::Json points = study::Json::array();
    for (const auto& point : path.points) points.push_back(point_json(point));
    paths.push_back({{"R", path.R},
                     {"peak", point_json(path.peak)},
                     {"first_unstable", point_json(path.first_unstable)},
                     {"message", study::json_text(path.message)},
                     {"points", std::move(points)}});
  }
  document["strain_paths"] = std::move(paths);
  document["warnings"] = report.warnings;
  return study::json_document(document);
}

std::string strain_paths_text(const StrainPathsReport& report) {
  std::string out = simulated_head("Proportional strain paths dε₁ + 2R dε₃ = 0", report.material);
  out += fact("start", fmt::format("p′ {} kPa, isotropic, e {}", in_kPa(report.p, 2),
                                   number(report.void_ratio, 4)));
  out += '\n' + indented(to_text(peaks_table(report))) + '\n';
  for (const auto& warning : report.warnings) out += fact("warning", warning);
  return without_controls(out);
}

FigureData strain_paths_data(const StrainPathsReport& report) {
  FigureData data{.title = "proportional strain paths, " + report.material.name,
                  .origin = "simulated",
                  .remarks = {"law: " + report.material.law->title,
                              fmt::format("start: p' {:.6g} kPa, isotropic, void ratio {:.6g}",
                                          report.p / 1e3, report.void_ratio)},
                  .columns = {{"R", ""},
                              {"axial_strain", ""},
                              {"control_stress_kPa", "kPa"},
                              {"p_eff_kPa", "kPa"},
                              {"q_kPa", "kPa"},
                              {"eta", ""},
                              {"void_ratio", ""},
                              {"w2_normalised", ""}},
                  .rows = {}};
  for (const auto& path : report.paths)
    for (const auto& at : path.points)
      data.rows.push_back({path.R, at.axial_strain, at.control_stress / 1e3, at.p / 1e3, at.q / 1e3,
                           eta(at), at.void_ratio, at.normalised_work});
  return data;
}

Drawing strain_paths_drawing(const StrainPathsReport& report) {
  return strain_paths_figure(report.paths, {.material = report.material.name,
                                            .state = fmt::format("from p′ = {:.4g} kPa, e = {:.4g}",
                                                                 report.p / 1e3, report.void_ratio),
                                            .plane = sim::ProbePlane::axisymmetric,
                                            .kind = sim::ProbeKind::strain});
}

}  // namespace triax::src

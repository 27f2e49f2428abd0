// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/grains/grain_figures.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "lab/grains/grain_words.hpp"
#include "src/grains/figures/grain_paths_figures.hpp"
#include "src/grains/figures/grain_perturbations_figure.hpp"
#include "src/grains/figures/grain_rose_figures.hpp"
#include "src/grains/grain_data.hpp"
#include "src/output/words.hpp"
#include "src/study/grains/grain_curves.hpp"

namespace triax::src {
namespace {

using Stages = std::vector<const lab::ReportedGrainStage*>;

Subject subject_of(const lab::GrainReport& report, const std::string& state = {},
                   sim::ProbeKind kind = sim::ProbeKind::stress) {
  return {.material = report.about(),
          .state = state,
          .plane = sim::ProbePlane::axisymmetric,
          .kind = kind};
}

template <class Kind, class Such>
Stages stages_of(const lab::GrainReport& report, const Such& such) {
  Stages found;
  for (const auto& stage : report.stages)
    if (const auto* came = std::get_if<Kind>(&stage.came); came && such(*came))
      found.push_back(&stage);
  return found;
}

Stages paths_of(const lab::GrainReport& report, sim::GrainPathKind kind) {
  return stages_of<lab::ReportedGrainPath>(
      report, [&](const auto& came) { return came.path.kind == kind; });
}

/// R of strain paths, the stage's name where two have one R.
std::string label_of(const lab::ReportedGrainStage& stage, const Stages& all) {
  const auto ratio = [](const lab::ReportedGrainStage* s) {
    return std::get<lab::ReportedGrainPath>(s->came).path.ratio;
  };
  const auto& path = std::get<lab::ReportedGrainPath>(stage.came).path;
  if (path.kind != sim::GrainPathKind::strain_path) return stage.name;
  const auto same = std::ranges::count(all, path.ratio, ratio);
  return fmt::format("R = {:g}", path.ratio) + (same > 1 ? " " + stage.name : "");
}

std::vector<study::GrainCurve> labelled_curves(const Stages& stages) {
  auto curves = study::curves_together(stages);
  for (std::size_t k = 0; k < curves.size(); ++k) curves[k].label = label_of(*stages[k], stages);
  return curves;
}

std::string start_of(const Stages& stages) {
  for (const auto* stage : stages)
    if (const auto& points = std::get<lab::ReportedGrainPath>(stage->came).points; !points.empty())
      return fmt::format("from p = {} kPa", in_kPa(points.front().p_pa));
  return {};
}

std::string title_of(const lab::ReportedGrainStage& stage) {
  const auto& came = std::get<lab::ReportedPerturbation>(stage.came);
  std::string title = stage.from.empty() ? stage.name : stage.from;
  if (came.how.load_step_pa != 0) title += fmt::format(", {:+.4g} Pa", came.how.load_step_pa);
  if (came.how.kinetic_energy_j != 0)
    title += fmt::format(", {:.4g} mJ", 1e3 * came.how.kinetic_energy_j);
  return title + ": " + lab::word(came.end);
}

std::string rose_state(const lab::ReportedGrainStage& stage) {
  const auto& stress = std::get<lab::ReportedGrainRose>(stage.came).made.stress;
  return fmt::format("probes at σ₁ = {} kPa, σ₃ = {} kPa", in_kPa(stress.axial),
                     in_kPa(stress.radial));
}

class Figures {
 public:
  explicit Figures(const lab::GrainReport& report) : report_(report) {}

  void add_roses() {
    for (const auto* stage :
         stages_of<lab::ReportedGrainRose>(report_, [](const auto&) { return true; })) {
      const auto& rose = std::get<lab::ReportedGrainRose>(stage->came);
      const Subject subject = subject_of(report_, rose_state(*stage), rose.kind);
      const FigureData data = rose_data(report_, *stage);
      const std::string name = lab::in_file_name(stage->name);
      add(name + "_envelope", grain_envelope_figure(rose.made.rose, rose.norm(), subject), data);
      add(name + "_work", grain_work_figure(rose.made.rose, subject), data);
      add(name + "_contacts", grain_contacts_figure(rose.made.rose, subject), data);
    }
  }

  void add_paths(const char* name, sim::GrainPathKind kind,
                 Drawing (*draw)(const std::vector<study::GrainCurve>&, const Subject&)) {
    const Stages stages = paths_of(report_, kind);
    add(name, draw(labelled_curves(stages), subject_of(report_, start_of(stages))),
        paths_data(report_, stages));
  }

  void add_perturbations(const char* name, bool load, bool energy) {
    const Stages stages = stages_of<lab::ReportedPerturbation>(report_, [&](const auto& came) {
      return (came.how.load_step_pa != 0) == load && (came.how.kinetic_energy_j > 0) == energy;
    });
    std::vector<DrawnPerturbation> drawn;
    for (const auto* stage : stages)
      drawn.push_back({title_of(*stage), std::get<lab::ReportedPerturbation>(stage->came).points});
    add(name, grain_perturbations_figure(drawn, subject_of(report_)),
        perturbations_data(report_, stages));
  }

  std::vector<NamedFigure> take() { return std::move(figures_); }

 private:
  void add(const std::string& name, Drawing drawing, const FigureData& data) {
    if (drawing.plot) figures_.push_back({name, std::move(drawing), data});
  }

  const lab::GrainReport& report_;
  std::vector<NamedFigure> figures_;
};

}  // namespace

std::vector<NamedFigure> grain_figures(const lab::GrainReport& report) {
  Figures figures(report);
  figures.add_paths("isotropic", sim::GrainPathKind::isotropic, grain_compression_figure);
  figures.add_paths("drained", sim::GrainPathKind::drained, grain_shear_figure);
  figures.add_roses();
  figures.add_paths("strain_paths", sim::GrainPathKind::strain_path, grain_strain_paths_figure);
  figures.add_perturbations("load_steps", true, false);
  figures.add_perturbations("energies", false, true);
  figures.add_perturbations("loads_and_energies", true, true);
  figures.add_perturbations("unperturbed", false, false);
  return figures.take();
}

}  // namespace triax::src

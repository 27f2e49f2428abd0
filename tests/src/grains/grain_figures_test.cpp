// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/grains/grain_figures.hpp"

#include <catch2/catch.hpp>

#include "tests/src/plot/plot_contents.hpp"
#include "tests/src/sample_grains.hpp"

using namespace triax;
using namespace triax::src;

namespace {

const NamedFigure& figure(const std::vector<NamedFigure>& figures, const std::string& name) {
  const auto found = std::ranges::find(figures, name, &NamedFigure::name);
  REQUIRE(found != figures.end());
  return *found;
}

}  // namespace

TEST_CASE("a run has the figures of the paper, each with the word simulated and the specimen") {
  const auto figures = grain_figures(test::sample_run());
  std::vector<std::string> names;
  for (const auto& one : figures) names.push_back(one.name);
  CHECK(names == std::vector<std::string>{"isotropic", "drained", "probes_envelope", "probes_work",
                                          "probes_contacts", "strain_paths", "load_steps",
                                          "energies"});
  for (const auto& one : figures) {
    INFO(one.name);
    CHECK(test::contains(to_svg(*one.drawing.plot), ">simulated: sample, 4 grains, n = 0.9948"));
    CHECK(test::contains(one.drawing.caption, "Simulated with sample, 4 grains, n = 0.9948"));
    CHECK(one.data.origin == "simulated");
    CHECK_FALSE(one.data.rows.empty());
  }
}

TEST_CASE("paths are named by R, perturbations by where they start and how they end") {
  lab::GrainReport report = test::sample_run();
  auto figures = grain_figures(report);
  CHECK(test::in_legend(*figure(figures, "strain_paths").drawing.plot, "R = 0.8"));
  CHECK(test::in_legend(*figure(figures, "drained").drawing.plot, "shear"));
  const auto& caption = figure(figures, "load_steps").drawing.caption;
  CHECK(test::contains(caption, "ES_a, +500 Pa: at rest; ES_b, +500 Pa: collapsed"));
  CHECK(test::contains(figure(figures, "energies").drawing.caption, "ES_b, 0.1 mJ: collapsed"));
  // Two paths of one R are told apart by their stages.
  report.stages.push_back(report.stages[2]);
  report.stages.back().name = "again";
  figures = grain_figures(report);
  CHECK(test::in_legend(*figure(figures, "strain_paths").drawing.plot, "R = 0.8 again"));
}

TEST_CASE("a peak that was not passed is not marked") {
  lab::GrainReport report = test::sample_run();
  for (const int stage : {2, 3})
    std::get<lab::ReportedGrainPath>(report.stages[stage].came).points.resize(20);
  const auto figures = grain_figures(report);
  CHECK_FALSE(test::in_legend(*figure(figures, "strain_paths").drawing.plot, "peak"));
  CHECK(test::contains(figure(figures, "strain_paths").drawing.caption, "on 0 of 2 paths"));
}

TEST_CASE("without stages there are no figures; a stage without points has none") {
  lab::GrainReport report{"sample", "sample.toml", {}, {}};
  CHECK(grain_figures(report).empty());
  report = test::sample_run();
  for (auto& stage : report.stages) {
    if (auto* path = std::get_if<lab::ReportedGrainPath>(&stage.came))
      *path = {path->path, {}, {}, {}};
    if (auto* one = std::get_if<lab::ReportedPerturbation>(&stage.came)) one->points.clear();
    if (auto* rose = std::get_if<lab::ReportedGrainRose>(&stage.came))
      for (auto& probe : rose->made.rose.probes) probe.stopped = true;
  }
  CHECK(grain_figures(report).empty());
}

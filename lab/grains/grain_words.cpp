// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/grains/grain_words.hpp"

#include <algorithm>

namespace triax::lab {
namespace {

bool all_settled(const sim::ProbeRose& rose) {
  return rose.null_probe.settled && std::all_of(rose.probes.begin(), rose.probes.end(),
                                                [](const auto& probe) { return probe.settled; });
}

}  // namespace

std::string word(sim::StiffnessReading reading) {
  return reading == sim::StiffnessReading::literal ? "literal" : "in_series";
}

std::string word(sim::GrainPathEnd end) {
  switch (end) {
    case sim::GrainPathEnd::axial_strain:
      return "axial_strain";
    case sim::GrainPathEnd::stress_ratio:
      return "stress_ratio";
    case sim::GrainPathEnd::settled:
      return "settled";
    case sim::GrainPathEnd::collapse:
      return "collapse";
    case sim::GrainPathEnd::most_steps:
      return "most_steps";
    case sim::GrainPathEnd::stopped:
      break;
  }
  return "stopped";
}

std::string word(sim::GrainPathKind kind) {
  switch (kind) {
    case sim::GrainPathKind::isotropic:
      return "isotropic";
    case sim::GrainPathKind::drained:
      return "drained";
    case sim::GrainPathKind::strain_path:
      break;
  }
  return "strain_path";
}

std::string word(sim::PerturbationEnd end) {
  switch (end) {
    case sim::PerturbationEnd::settled:
      return "settled";
    case sim::PerturbationEnd::collapsed:
      return "collapsed";
    case sim::PerturbationEnd::undecided:
      return "undecided";
    case sim::PerturbationEnd::stopped:
      break;
  }
  return "stopped";
}

std::string ending(const GrainStageResult& result) {
  struct {
    std::string operator()(const sim::GrainPathResult& r) const { return word(r.end); }
    std::string operator()(const GrainRest& r) const {
      return r.settled ? "settled" : "not at rest";
    }
    std::string operator()(const GrainRose& r) const {
      return all_settled(r.rose) ? "all at rest" : "some not at rest";
    }
    std::string operator()(const sim::PerturbationResult& r) const { return word(r.end); }
  } const of;
  return std::visit(of, result.outcome);
}

std::optional<bool> settled(const GrainStageResult& result) {
  if (const auto* path = std::get_if<sim::GrainPathResult>(&result.outcome)) {
    const auto& work = std::get<GrainPathStage>(result.stage->work);
    if (work.path.kind != sim::GrainPathKind::isotropic) return std::nullopt;
    return path->end == sim::GrainPathEnd::settled;
  }
  if (const auto* rest = std::get_if<GrainRest>(&result.outcome)) return rest->settled;
  if (const auto* rose = std::get_if<GrainRose>(&result.outcome)) return all_settled(rose->rose);
  return std::get<sim::PerturbationResult>(result.outcome).end == sim::PerturbationEnd::settled;
}

}  // namespace triax::lab

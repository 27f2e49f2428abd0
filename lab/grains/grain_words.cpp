// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/grains/grain_words.hpp"

#include <algorithm>

namespace triax::lab {
namespace {

bool all_at_rest(const sim::ProbeRose& rose) {
  return rose.null_probe.at_rest && std::all_of(rose.probes.begin(), rose.probes.end(),
                                                [](const auto& probe) { return probe.at_rest; });
}

}  // namespace

std::string word(sim::StiffnessReading reading) {
  return reading == sim::StiffnessReading::literal ? "literal" : "in_series";
}

std::string word(sim::ProbeKind kind) {
  return kind == sim::ProbeKind::strain ? "strain" : "stress";
}

std::string word(sim::GrainPathEnd end) {
  switch (end) {
    case sim::GrainPathEnd::axial_strain:
      return "axial_strain";
    case sim::GrainPathEnd::stress_ratio:
      return "stress_ratio";
    case sim::GrainPathEnd::at_rest:
      return "at rest";
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
    case sim::PerturbationEnd::at_rest:
      return "at rest";
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
      return r.at_rest ? "at rest" : "not at rest";
    }
    std::string operator()(const GrainRose& r) const {
      return all_at_rest(r.rose) ? "all at rest" : "some not at rest";
    }
    std::string operator()(const sim::PerturbationResult& r) const { return word(r.end); }
  } const of;
  return std::visit(of, result.outcome);
}

std::optional<bool> at_rest(const GrainStageResult& result) {
  struct {
    const decltype(GrainStage::work)& work;
    std::optional<bool> operator()(const sim::GrainPathResult& r) const {
      if (std::get<GrainPathStage>(work).path.kind != sim::GrainPathKind::isotropic)
        return std::nullopt;
      return r.end == sim::GrainPathEnd::at_rest;
    }
    std::optional<bool> operator()(const GrainRest& r) const { return r.at_rest; }
    std::optional<bool> operator()(const GrainRose& r) const { return all_at_rest(r.rose); }
    std::optional<bool> operator()(const sim::PerturbationResult& r) const {
      return r.end == sim::PerturbationEnd::at_rest;
    }
  } const of{result.stage->work};
  return std::visit(of, result.outcome);
}

}  // namespace triax::lab

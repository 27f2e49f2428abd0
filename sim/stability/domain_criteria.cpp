// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/stability/domain_criteria.hpp"

#include <algorithm>
#include <utility>

#include "sim/stability/localisation.hpp"
#include "sim/stability/octolinear_cones.hpp"
#include "sim/stability/stability_determinant.hpp"

namespace triax::sim {
namespace {

template <class Space>
std::optional<double> determinant(const Law<Space>& law, const PointState<Space>& state) {
  if (law.objection(state)) return std::nullopt;
  const auto response = law.response(state);
  if (const auto* form = std::get_if<InterpolatedForm<Space>>(&response); form && !form->quadratic)
    return least_determinant(octolinear_zones(*form));
  const auto found = stability_determinant(IncrementalResponse<Space>(law, state));
  return found ? std::optional(found->value) : std::nullopt;
}

template <class Space>
DomainWitness determinant_of(const Law<Space>* law, double void_ratio) {
  if (law == nullptr || law->finite()) return {};
  return [law, void_ratio](double p, double q) {
    return determinant(*law, law->start(domain_stress<Space>(p, q), void_ratio));
  };
}

DomainWitness determinant_witness(const Material& material, const DomainGrid& grid) {
  return grid.plane == ProbePlane::axisymmetric
             ? determinant_of(material.axisymmetric.get(), grid.void_ratio)
             : determinant_of(material.tensor.get(), grid.void_ratio);
}

DomainWitness localisation_witness(const Material& material, const DomainGrid& grid) {
  const Law<Tensor>* law = material.tensor.get();
  if (law == nullptr || law->finite()) return {};
  return [law, plane = grid.plane, e = grid.void_ratio](double p, double q) {
    const auto state = law->start(domain_stress<Tensor>(p, q), e);
    if (law->objection(state)) return std::optional<double>();
    const auto found = state_localisation(IncrementalResponse<Tensor>(*law, state), plane);
    return found ? std::optional(found->determinant) : std::nullopt;
  };
}

constexpr DomainCriterionKind kKinds[] = {
    {.name = "determinant",
     .legend = "vanishing determinant",
     .dots = true,
     .witness = determinant_witness},
    {.name = "localisation",
     .legend = "localisation (acoustic tensor)",
     .help = "also search for shear band modes (singular acoustic tensor); takes ten times as long",
     .most_rows = 25,
     .witness = localisation_witness},
};

}  // namespace

std::span<const DomainCriterionKind> domain_criterion_kinds() { return kKinds; }

DomainCriteria domain_criteria(const Material& material, const DomainGrid& grid,
                               const std::vector<std::string>& asked) {
  DomainCriteria criteria;
  for (const DomainCriterionKind& kind : kKinds) {
    if (kind.on_request() && std::ranges::find(asked, kind.name) == asked.end()) continue;
    if (auto witness = kind.witness(material, grid))
      criteria.push_back({std::string(kind.name), std::move(witness), kind.most_rows});
  }
  return criteria;
}

}  // namespace triax::sim

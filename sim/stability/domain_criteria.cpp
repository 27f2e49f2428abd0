#include "sim/stability/domain_criteria.hpp"

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
DomainWitness determinant_witness(const Law<Space>* law, double void_ratio) {
  if (law == nullptr || law->finite()) return {};
  return [law, void_ratio](double p, double q) {
    return determinant(*law, law->start(domain_stress<Space>(p, q), void_ratio));
  };
}

DomainWitness localisation_witness(const Law<Tensor>* law, const DomainGrid& grid) {
  if (law == nullptr || law->finite()) return {};
  return [law, plane = grid.plane, e = grid.void_ratio](double p, double q) {
    const auto state = law->start(domain_stress<Tensor>(p, q), e);
    if (law->objection(state)) return std::optional<double>();
    const auto found = state_localisation(IncrementalResponse<Tensor>(*law, state), plane);
    return found ? std::optional(found->determinant) : std::nullopt;
  };
}

}  // namespace

DomainCriteria domain_criteria(const Material& material, const DomainGrid& grid,
                               bool localisation) {
  DomainCriteria criteria;
  criteria.determinant = grid.plane == ProbePlane::axisymmetric
                             ? determinant_witness(material.axisymmetric.get(), grid.void_ratio)
                             : determinant_witness(material.tensor.get(), grid.void_ratio);
  if (localisation) criteria.localisation = localisation_witness(material.tensor.get(), grid);
  return criteria;
}

}  // namespace triax::sim

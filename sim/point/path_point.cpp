// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/point/path_point.hpp"

#include <numbers>

namespace triax::sim {
namespace {

template <class Space>
double radial(const Vector<Space>& a) {
  if constexpr (Space::kSize == 2)
    return a(1) / std::numbers::sqrt2;
  else
    return (a(1) + a(2)) / 2;
}

template <class Space>
double component_of(const Vector<Space>& a, int component) {
  if constexpr (Space::kSize == 2)
    return component == 0 ? a(0) : component < 3 ? radial<Space>(a) : 0;
  else
    return component < 3 ? a(component) : a(component) / std::numbers::sqrt2;
}

}  // namespace

template <class Space>
std::optional<double> value_of(PathQuantity quantity, int component, const PathPoint<Space>& at) {
  using enum PathQuantity;
  const double u = at.pore_pressure;
  switch (quantity) {
    case axial_strain:
      return at.strain(0);
    case radial_strain:
      return radial<Space>(at.strain);
    case volumetric_strain:
      return trace<Space>(at.strain);
    case shear_strain:
      return 2 * (at.strain(0) - radial<Space>(at.strain)) / 3;
    case mean_effective_stress:
      return at.p();
    case mean_total_stress:
      return at.p() + u;
    case deviator_stress:
      return at.q();
    case stress_ratio:
      return at.stress_ratio();
    case axial_stress:
      return at.stress(0) + u;
    case radial_stress:
      return radial<Space>(at.stress) + u;
    case effective_axial_stress:
      return at.stress(0);
    case effective_radial_stress:
      return radial<Space>(at.stress);
    case pore_pressure:
      return u;
    case PathQuantity::void_ratio:
      return at.void_ratio;
    case strain_component:
      return component_of<Space>(at.strain, component);
    case stress_component:
      return component_of<Space>(at.stress, component) + (component < 3 ? u : 0);
    case effective_stress_component:
      return component_of<Space>(at.stress, component);
  }
  return std::nullopt;
}

template std::optional<double> value_of(PathQuantity, int, const PathPoint<Axisymmetric>&);
template std::optional<double> value_of(PathQuantity, int, const PathPoint<Tensor>&);

}  // namespace triax::sim

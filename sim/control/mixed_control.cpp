// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/control/mixed_control.hpp"

namespace triax::sim {
MixedControl<Tensor> as_tensor(const MixedControl<Axisymmetric>& c) {
  // The radial coefficient r of √2 a₃ is shared: r √2 a₃ = r (a₂ + a₃)/√2.
  const auto spread = [](const Eigen::RowVector2d& row) {
    const double half = row(1) / std::numbers::sqrt2;
    return (Eigen::Matrix<double, 1, 6>() << row(0), half, half, 0, 0, 0).finished();
  };
  MixedControl<Tensor> t;
  for (int i = 0; i < 2; ++i) {
    t.stress.row(i) = spread(c.stress.row(i));
    t.strain.row(i) = spread(c.strain.row(i));
    t.increment(i) = c.increment(i);
  }
  // Equal stresses in the radial plane where they are controlled, equal strains where those are.
  if (c.strain.isZero(0))
    t.stress.row(2) << 0, 1, -1, 0, 0, 0;
  else
    t.strain.row(2) << 0, 1, -1, 0, 0, 0;
  for (int i = 3; i < 6; ++i) t.strain(i, i) = 1;
  return t;
}

namespace {

template <class Space>
MixedControl<Space> in_space(const MixedControl<Axisymmetric>& c) {
  if constexpr (Space::kSize == 2)
    return c;
  else
    return as_tensor(c);
}

constexpr double kRadial = 1 / std::numbers::sqrt2;  // of a₃ in terms of √2 a₃

}  // namespace

template <class Space>
MixedControl<Space> MixedControl<Space>::strains(const Vector<Space>& increment) {
  return {Matrix<Space>::Zero(), Matrix<Space>::Identity(), increment};
}

template <class Space>
MixedControl<Space> MixedControl<Space>::stresses(const Vector<Space>& increment) {
  return {Matrix<Space>::Identity(), Matrix<Space>::Zero(), increment};
}

template <class Space>
MixedControl<Space> MixedControl<Space>::strain_path(double axial_strain, double R) {
  MixedControl<Axisymmetric> c;
  c.strain << 1, 0, 1, 2 * R * kRadial;
  c.increment << axial_strain, 0;
  return in_space<Space>(c);
}

template <class Space>
MixedControl<Space> MixedControl<Space>::stress_path(double dp, double dq) {
  MixedControl<Axisymmetric> c;
  c.stress << 1.0 / 3, 2 * kRadial / 3, 1, -kRadial;
  c.increment << dp, dq;
  return in_space<Space>(c);
}

template <class Space>
MixedControl<Space> MixedControl<Space>::drained_compression(double axial_strain) {
  MixedControl<Axisymmetric> c;
  c.strain << 1, 0, 0, 0;
  c.stress << 0, 0, 0, kRadial;
  c.increment << axial_strain, 0;
  return in_space<Space>(c);
}

template struct MixedControl<Axisymmetric>;
template struct MixedControl<Tensor>;

}  // namespace triax::sim

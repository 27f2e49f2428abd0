// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <Eigen/Geometry>
#include <random>

#include "sim/control/mixed_control.hpp"
#include "sim/law/law.hpp"

// Random states, increments and rotations for tests of properties.
namespace triax::sim::test {

class RandomTensors {
 public:
  double uniform(double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(engine_);
  }
  template <class Space>
  Vector<Space> direction() {
    Vector<Space> v;
    for (int i = 0; i < Space::kSize; ++i) v(i) = std::normal_distribution<double>()(engine_);
    return v.normalized();
  }
  /// Stress at p with |s|/p = ratio.
  template <class Space>
  Vector<Space> stress(double p_pa, double ratio) {
    Vector<Space> s = deviator<Space>(direction<Space>());
    if (s.norm() > 0) s *= ratio * p_pa / s.norm();
    return s + isotropic<Space>(p_pa);
  }
  Eigen::Matrix3d turn() {
    Eigen::Quaterniond q(uniform(-1, 1), uniform(-1, 1), uniform(-1, 1), uniform(-1, 1));
    return q.normalized().toRotationMatrix();
  }

 private:
  std::mt19937 engine_{20240607};
};

/// The same conditions in axes turned by Q; `turned` is rotation(Q).
inline MixedControl<Tensor> turned_control(const MixedControl<Tensor>& control,
                                           const Matrix<Tensor>& turned) {
  return {control.stress * turned.transpose(), control.strain * turned.transpose(),
          control.increment};
}

/// Tangent of the mechanisms in `set` loading together.
template <class Space>
Matrix<Space> tangent_of(const Response<Space>& response, unsigned set) {
  const auto& form = std::get<StiffnessForm<Space>>(response);
  std::vector<std::size_t> loading;
  for (unsigned k = 0; k < static_cast<unsigned>(form.mechanisms); ++k)
    if (set >> k & 1U) loading.push_back(k);
  const auto n = static_cast<Eigen::Index>(loading.size());
  Eigen::MatrixXd c(Space::kSize, n), m(Space::kSize, n), h(n, n);
  for (Eigen::Index i = 0; i < n; ++i) {
    const std::size_t k = loading[static_cast<std::size_t>(i)];
    c.col(i) = form.relaxation[k];
    m.col(i) = form.trigger[k];
    for (Eigen::Index j = 0; j < n; ++j)
      h(i, j) = form.hardening(static_cast<int>(k),
                               static_cast<int>(loading[static_cast<std::size_t>(j)]));
  }
  if (n == 0) return form.stiffness;
  return form.stiffness - c * h.inverse() * m.transpose();
}

}  // namespace triax::sim::test

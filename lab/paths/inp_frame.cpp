// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/paths/inp_frame.hpp"

#include <Eigen/LU>
#include <cmath>

#include "lab/base/text.hpp"

namespace triax::lab {
namespace {

constexpr double kRootTwo = std::numbers::sqrt2, kRootThree = std::numbers::sqrt3;

struct Definition {
  const char* keyword;
  Eigen::Matrix3d direct;
  std::array<const char*, 3> stress, strain;
};

std::array<Definition, 4> definitions() {
  const double third = 1.0 / 3, half = 0.5;
  const double p = 1 / kRootThree, q = 1 / (kRootTwo * kRootThree), z = 1 / kRootTwo;
  std::array<Definition, 4> all{
      {{"*cartesian",
        Eigen::Matrix3d::Identity(),
        {"stress_11_kPa", "stress_22_kPa", "stress_33_kPa"},
        {"strain_11", "strain_22", "strain_33"}},
       {"*roscoe",
        {},
        {"p_kPa", "q_kPa", "z_kPa"},
        {"volumetric_strain", "shear_strain", "z strain"}},
       {"*roscoeisomorph", {}, {"P_kPa", "Q_kPa", "Z_kPa"}, {"P strain", "Q strain", "Z strain"}},
       {"*rendulic",
        {},
        {"stress_11_kPa", "(stress_22_kPa + stress_33_kPa)/sqrt 2",
         "(stress_22_kPa - stress_33_kPa)/sqrt 2"},
        {"strain_11", "(strain_22 + strain_33)/sqrt 2", "(strain_22 - strain_33)/sqrt 2"}}}};
  all[1].direct << -third, -third, -third, -1, half, half, 0, -1, 1;
  all[2].direct << -p, -p, -p, -2 * q, q, q, 0, -z, z;
  all[3].direct << -1, 0, 0, 0, -z, -z, 0, -z, z;
  return all;
}

}  // namespace

Eigen::Matrix<double, 1, 6> inp_stress_row(int k) {
  Eigen::Matrix<double, 1, 6> row = Eigen::Matrix<double, 1, 6>::Zero();
  row(k) = -1e-3 * (k < 3 ? 1 : 1 / kRootTwo);
  return row;
}

Eigen::Matrix<double, 1, 6> inp_strain_row(int k) {
  Eigen::Matrix<double, 1, 6> row = Eigen::Matrix<double, 1, 6>::Zero();
  row(k) = -(k < 3 ? 1 : kRootTwo);
  return row;
}

std::optional<InpFrame> find_inp_frame(std::string_view keyword) {
  static const std::array<Definition, 4> all = definitions();
  for (const Definition& one : all) {
    if (folded(keyword) != one.keyword) continue;
    InpFrame frame;
    const Eigen::Matrix3d conjugate = one.direct.inverse().transpose();
    for (int i = 0; i < 6; ++i) {
      frame.stress.row(i) = inp_stress_row(i);
      frame.strain.row(i) = inp_strain_row(i);
    }
    frame.stress.topRows<3>() = (one.direct * frame.stress.topRows<3>()).eval();
    frame.strain.topRows<3>() = (conjugate * frame.strain.topRows<3>()).eval();
    for (std::size_t i = 0; i < 3; ++i) {
      static constexpr std::array<const char*, 3> kShear{"12", "13", "23"};
      frame.stress_labels[i] = one.stress[i];
      frame.strain_labels[i] = one.strain[i];
      frame.stress_labels[i + 3] = std::string("stress_") + kShear[i] + "_kPa";
      frame.strain_labels[i + 3] = std::string("strain_") + kShear[i];
    }
    return frame;
  }
  return std::nullopt;
}

}  // namespace triax::lab

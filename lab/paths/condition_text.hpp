// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// A condition of a path as people write it: a linear combination of named increments and its total,
//
//   axial_strain = 0.10        q_kPa - 3 p_kPa = 0        axial_strain + 1.3*radial_strain = 0
#include <string>
#include <string_view>
#include <vector>

#include "sim/mechanics/space.hpp"

namespace triax::lab {

/// Coefficients of the increments of total stress (per Pa) and strain, on the orthonormal
/// components of the space, in the units of the text.
template <class Space>
struct Combination {
  Eigen::Matrix<double, 1, Space::kSize> stress = Eigen::Matrix<double, 1, Space::kSize>::Zero();
  Eigen::Matrix<double, 1, Space::kSize> strain = Eigen::Matrix<double, 1, Space::kSize>::Zero();
};

template <class Space>
struct Condition {
  Combination<Space> left;
  std::string label;  ///< the left side as it was written, blanks tidied
  double total = 0;   ///< over the segment
};

/// The names known in the space. In axisymmetry those of all triaxial frames; for a tensor the
/// components besides, and axial is 11, radial the mean of 22 and 33.
template <class Space>
std::vector<std::string> increment_names();

/// The left side alone, as a heading of a table has it. Throws std::invalid_argument: the column
/// (from 1), what was found and what is known.
template <class Space>
Combination<Space> read_combination(std::string_view text);

/// "LEFT = TOTAL". Throws the same; also where the total is of a size that no test has (a strain
/// above 2, a stress above 100 MPa).
template <class Space>
Condition<Space> read_condition(std::string_view text);

/// Throws std::invalid_argument where `total` is beyond what a test can have.
template <class Space>
void check_total(const Combination<Space>& left, double total);

}  // namespace triax::lab

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Kinetic energies, which lie decades apart.
#include <qcustomplot.h>

namespace triax::src {

/// Gathers energies and gives an axis their range: logarithmic where they span two decades or more,
/// linear from 0 otherwise. An energy of 0 has no place on a logarithmic axis and is not counted.
class EnergyRange {
 public:
  void add(double energy_j);
  bool logarithmic() const;
  /// Sets range, scale, ticks and format of the numbers. After style_axes().
  void apply(QCPAxis& axis) const;

 private:
  double least_ = 0, most_ = 0;
};

}  // namespace triax::src

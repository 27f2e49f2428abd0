// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// What a specimen answers along its driven path, by least squares over the readings themselves:
//
//   y = c + f₀∫g dx + f₁∫gξ dx + f₂∫gξ² dx,   ξ = (η − now)/distance,
//
// so that dy/dx = g (f₀ + f₁ξ + f₂ξ²) and nothing is differentiated; likewise p′ along a strain
// path, ε₁ at held q (PathMean::beside). Signs and units as in DrivenPath.
//
// With a pore fluid of compliance c the volume goes with u along a strain path: dε_v = −dε₁/R + dε₁
// + c du, du = −dσ₃′ where the cell pressure stands still. Second-order work is then dy dε₁ − c
// du², and what vanishes with it dy/dx − c (dσ₃′/dx)². give_way() puts that in the place of dy/dx.
#include <Eigen/Dense>
#include <optional>
#include <vector>

#include "lab/warning/driven_path.hpp"

namespace triax::lab {

struct DrivenFit {
  using Columns = Eigen::Matrix<double, 4, 1>;
  double now = 0, distance = 0;  ///< η, and of η
  double fluid = 0, taken = 0;   ///< c g, and what it took of f₀ (give_way)
  Columns y = Columns::Zero(), beside = Columns::Zero();  ///< c, f₀, f₁, f₂
  Eigen::Matrix4d variance = Eigen::Matrix4d::Zero();     ///< of y's

  /// f₀ + f₁ξ + f₂ξ²
  static double at(const Columns& c, double xi) { return c[1] + xi * (c[2] + xi * c[3]); }
  /// ξ at the root of dy/dx nearest to now at which it falls, beyond −1; empty where there is none.
  std::optional<double> root() const;
  /// The same of −(dy/dp′) √η along a strain path, by its tangent; empty where p′ does not fall or
  /// y does.
  std::optional<double> root_of_slope() const;
  /// Of normalised work at held q, which falls along a straight line over p′ = q/η.
  std::optional<double> root_of_work() const;
  /// Standard error of a root of dy/dx, in η.
  double error(double xi) const;
  /// d²W/(|dσ′||dε|) at held q, the drainage open, where it is dp′dε_v.
  double normalised_work(double xi) const;
  /// Along a strain path, once: the pore fluid takes its part of y. `c_g`: c g, `sign`: −1 in
  /// extension.
  void give_way(double c_g, double ratio, double sign);
  /// Normalised work now, where dε₁ + 2R dε₃ = c du is kept. `sign`: −1 in extension.
  double work_along_path(double ratio, double sign) const;
};

/// Over the means from `first` on, weighted by their readings, with that many of the four terms.
/// Empty where they do not tell the terms apart.
std::optional<DrivenFit> fit_driven(const std::vector<PathMean>& means, std::size_t first,
                                    double now, double distance, int terms);

}  // namespace triax::lab

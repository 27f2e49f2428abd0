// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Parameters of a law as numbers from 0 to 1.
#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

#include "lab/materials/material_library.hpp"
#include "lab/materials/search_ranges.hpp"
#include "src/study/calibrate/measured_path.hpp"

namespace triax::study {

/// A point of the space: entry i is 0 at the low end of unknown i, 1 at its high end.
using Unknowns = Eigen::VectorXd;

class SearchSpace {
 public:
  /// `start` gives what is not searched and the point to begin at; it has to be possible, and each
  /// of `ranges` has to name one of its numbers (or of its lists, "properties.3"). Throws
  /// lab::BadInput.
  SearchSpace(lab::MaterialSet start, std::vector<lab::SearchRange> ranges);

  const lab::MaterialSet& start() const { return start_; }
  const std::vector<lab::SearchRange>& ranges() const { return ranges_; }
  Eigen::Index size() const { return static_cast<Eigen::Index>(ranges_.size()); }

  /// In the units of the parameter file.
  double value(Eigen::Index unknown, double x) const;
  double unknown(Eigen::Index unknown, double value) const;
  /// d value/dx
  double slope(Eigen::Index unknown, double x) const;
  Unknowns start_point() const;

  sim::ParameterSet parameters(const Unknowns& x) const;
  /// The law at a point, for paths of this drainage: NorSand has one bulk modulus of the pore fluid
  /// for each. Empty where the law refuses the parameters.
  std::optional<sim::Material> material(const Unknowns& x, Imposed imposed) const;
  /// Whether the law has such a modulus: else one material serves all paths.
  bool drainage_matters() const { return drainage_matters_; }
  /// Whether the law takes the parameters.
  bool possible(const Unknowns& x) const;
  /// The nearest point within the bounds, and from there towards the start until the law takes it.
  Unknowns possible_near(const Unknowns& x) const;

 private:
  lab::MaterialSet start_;
  std::vector<lab::SearchRange> ranges_;
  bool drainage_matters_;
  Unknowns anchor_;
};

/// The number of a set that a range's key names; empty where there is none.
std::optional<double> value_of(const lab::MaterialSet& set, const std::string& key);
/// The parameters with what belongs to a drainage (a bulk modulus of the pore fluid that is 0 for
/// drained loading only).
sim::ParameterSet for_drainage(sim::ParameterSet parameters, const sim::LawDescription& law,
                               Imposed imposed);

}  // namespace triax::study

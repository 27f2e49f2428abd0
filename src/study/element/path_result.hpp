// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// What a run of a path of one material point came to, without the space it was made in.
#include <optional>
#include <string>
#include <vector>

#include "lab/paths/path_description.hpp"
#include "sim/point/path_runner.hpp"

namespace triax::study {

/// A point of the path; values in the order of PathResult::columns, in their units.
struct ResultPoint {
  std::string segment;
  std::vector<std::optional<double>> values;
};

struct ResultEvent {
  sim::PathEventKind kind = sim::PathEventKind::end_condition;
  std::string what;
  ResultPoint at;
};

struct PathResult {
  std::string name, source;
  double tolerance = 0;
  lab::MaterialSet material;
  std::vector<std::string> columns;  ///< "progress", "axial_strain", "q_kPa"...; the memory last
  ResultPoint start, last;
  std::optional<ResultPoint> peak;  ///< largest |q|; empty where there was none but round-off
  sim::StepOutcome outcome = sim::StepOutcome::accepted;
  std::string limiting_variable;  ///< label of the condition that was lost; empty: none
  std::string message;  ///< of an outcome that is not `accepted`, one sentence with the state
  double error = 0;     ///< largest estimated error of an integration step, relative
  std::vector<ResultEvent> events;
  std::vector<std::string> warnings;
  std::vector<ResultPoint> rows;

  /// The increment that could not be done, as a path file; empty: there is none, or the material
  /// has no name that a path file could give.
  std::string failed_increment;

  bool went_to_the_end() const;
  /// Value of a column at a point; empty where it is unknown or there is no such column.
  std::optional<double> value(const ResultPoint& at, const std::string& column) const;
  /// η for people: empty too where p′ has all but vanished, and the ratio is that of two
  /// round-offs.
  std::optional<double> told_eta(const ResultPoint& at) const;
};

/// Pre-condition: the result is that of the description's path.
template <class Space>
PathResult path_result(const lab::PathDescription& description,
                       const sim::PathResult<Space>& result);

extern template PathResult path_result(const lab::PathDescription&,
                                       const sim::PathResult<sim::Axisymmetric>&);
extern template PathResult path_result(const lab::PathDescription&,
                                       const sim::PathResult<sim::Tensor>&);

}  // namespace triax::study

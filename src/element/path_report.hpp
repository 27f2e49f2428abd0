#pragma once
// What a run of a path came to, as text, JSON and CSV.
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "lab/paths/path_description.hpp"
#include "sim/point/path_runner.hpp"

namespace triax::src {

/// A point of the path; values in the order of ReportedPath::columns, in their units.
struct ReportedPoint {
  std::string segment;
  std::vector<std::optional<double>> values;
};

struct ReportedEvent {
  std::string kind;  ///< "end_condition", "second_order_work", "peak", "control_limit"
  std::string what;
  ReportedPoint at;
};

/// A run without the space it was made in.
struct ReportedPath {
  std::string name, source;
  double tolerance = 0;
  lab::MaterialSet material;
  std::vector<std::string> columns;  ///< "progress", "axial_strain", "q_kPa"...; the memory last
  ReportedPoint start, last;
  std::optional<ReportedPoint> peak;  ///< largest |q|; empty where there was none but round-off
  std::string outcome;                ///< "accepted", "inaccurate", "lost_control", "failed"
  std::string culprit;                ///< label of the condition that was lost; empty: none
  std::string message;  ///< of an outcome that is not "accepted", one sentence with the state
  double error = 0;     ///< largest estimated error of an integration step, relative
  std::vector<ReportedEvent> events;
  std::vector<std::string> warnings;
  std::vector<ReportedPoint> rows;

  bool went_to_the_end() const { return outcome == "accepted" || outcome == "inaccurate"; }
  /// Value of a column at a point; empty where it is unknown or there is no such column.
  std::optional<double> value(const ReportedPoint& at, const std::string& column) const;
  /// η for people: empty too where p′ has all but vanished, and the ratio is that of two
  /// round-offs.
  std::optional<double> told_eta(const ReportedPoint& at) const;
};

template <class Space>
ReportedPath reported_path(const lab::PathDescription& description,
                           const sim::PathResult<Space>& result);

/// One JSON document; what is unknown is null.
std::string path_json(const ReportedPath& path);
/// A short table, the events and the verdict, for people.
std::string path_text(const ReportedPath& path);
/// All rows, one column a quantity, behind remarks that say what it is; what is unknown is empty.
std::string path_csv(const ReportedPath& path);

}  // namespace triax::src

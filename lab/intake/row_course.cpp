// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/intake/row_course.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <initializer_list>
#include <optional>
#include <set>
#include <string_view>
#include <utility>

#include "lab/intake/names/labels.hpp"
#include "lab/intake/restart_finder.hpp"
#include "lab/intake/row_direction.hpp"

namespace triax::lab {
namespace {

using Values = std::vector<double>;

/// The cells of a column as texts, one a row; numbers as they are.
std::vector<std::string> words_of(const TableColumn& column) {
  if (!column.texts.empty()) return column.texts;
  std::vector<std::string> out;
  for (const double value : column.all)
    out.push_back(std::isnan(value) ? std::string() : std::to_string(value));
  return out;
}

/// The first row of each run of equal words. Empty cells continue a run.
std::vector<std::size_t> runs_of(const std::vector<std::string>& words) {
  std::vector<std::size_t> begins;
  const std::string* before = nullptr;
  for (std::size_t row = 0; row < words.size(); ++row) {
    if (words[row].empty() || (before && *before == words[row])) continue;
    begins.push_back(before ? row : 0);
    before = &words[row];
  }
  return begins;
}

class CourseSearch {
 public:
  CourseSearch(const TableColumns& table, const Meaning& meaning)
      : table_(table), meaning_(meaning) {}

  RowCourse find() const {
    RowCourse out;
    const auto runs = running_columns();
    out.is_reversed = is_reversed(runs);
    if (find_named_tests(out) || out.is_reversed) return out;
    std::set<std::size_t> begins{0};
    for (const Values& values : runs) add_restarts(begins, values);
    if (runs.empty()) add_restarts(begins, {});
    out.test_begins.assign(begins.begin(), begins.end());
    return out;
  }

 private:
  std::size_t rows() const { return table_.row_lines.size(); }

  /// In the canonical unit.
  Values values_of(std::string_view quantity) const {
    const ColumnMeaning* found = meaning_.of(quantity);
    if (!found) return {};
    const TableColumn& column =
        table_.columns[static_cast<std::size_t>(found - meaning_.columns.data())];
    if (column.clock) return column.clock_values;
    Values out = column.all;
    for (double& value : out) value *= found->reading.sign * found->reading.factor;
    return out;
  }
  Values first_of(std::initializer_list<std::string_view> quantities) const {
    for (const std::string_view quantity : quantities)
      if (Values values = values_of(quantity); !values.empty()) return values;
    return {};
  }
  Values difference(std::string_view a, std::string_view b) const {
    Values out = values_of(a);
    const Values less = values_of(b);
    if (less.empty()) return {};
    for (std::size_t row = 0; row < out.size(); ++row) out[row] -= less[row];
    return out;
  }

  /// Empty if one is missing.
  Values sum_of(std::string_view a, std::string_view b) const {
    Values out = values_of(a);
    const Values more = values_of(b);
    if (more.empty()) return {};
    for (std::size_t row = 0; row < out.size(); ++row) out[row] += more[row];
    return out;
  }

  /// Columns that grow from the first reading to the last.
  std::vector<Values> running_columns() const {
    std::vector<Values> out;
    for (const char* quantity : {"clock", "time", "date", "reading_number", "time_of_day"})
      if (Values values = values_of(quantity); !values.empty()) out.push_back(std::move(values));
    if (Values clock = sum_of("date", "time_of_day"); !clock.empty())
      out.push_back(std::move(clock));
    return out;
  }

  static RowDirection direction_of(const Values& values) {
    RowDirection direction;
    for (const double value : values) direction.add(value);
    return direction;
  }
  bool is_reversed(const std::vector<Values>& runs) const {
    if (!runs.empty())
      return std::ranges::any_of(
          runs, [](const Values& values) { return direction_of(values).runs_back(); });
    return direction_of(first_of({"axial_strain", "axial_displacement"})).runs_to_zero();
  }

  bool find_named_tests(RowCourse& out) const {
    constexpr std::size_t kMinRowsOfTest = 3;
    for (std::size_t i = 0; i < table_.columns.size(); ++i) {
      const LexiconQuantity* quantity = meaning_.columns[i].reading.quantity;
      const TableColumn& column = table_.columns[i];
      if (column.clock || !names_tests(column.heading)) continue;
      if (quantity && quantity->dimension != "text" && quantity->dimension != "any") continue;
      const auto words = words_of(column);
      auto begins = runs_of(words);
      std::set<std::string> kinds;
      for (const std::size_t begin : begins) kinds.insert(words[begin]);
      const bool is_long = std::ranges::adjacent_find(begins, [](std::size_t a, std::size_t b) {
                             return b < a + kMinRowsOfTest;
                           }) == begins.end();
      if (begins.size() < 2 || kinds.size() < begins.size() || !is_long) continue;
      out.test_column = column.position;
      out.test_begins = std::move(begins);
      return true;
    }
    return false;
  }

  Values loads() const {
    Values out =
        first_of({"deviator_stress", "half_deviator_stress", "deviator_stress_uncorrected"});
    if (out.empty()) out = difference("effective_axial_stress", "effective_radial_stress");
    if (out.empty()) out = difference("axial_stress", "radial_stress");
    if (out.empty()) out = difference("axial_stress", "cell_pressure");
    if (out.empty())
      out = first_of({"stress_ratio", "axial_force", "force_reading", "axial_stress"});
    return out;
  }

  /// The rows whose stage no row had before.
  std::vector<bool> new_stages() const {
    std::vector<bool> out(rows());
    const ColumnMeaning* found = meaning_.of("stage");
    if (!found) return out;
    const auto words =
        words_of(table_.columns[static_cast<std::size_t>(found - meaning_.columns.data())]);
    std::set<std::string> kinds;
    for (std::size_t row = 0; row < words.size() && row < out.size(); ++row)
      out[row] = !words[row].empty() && kinds.insert(words[row]).second && row > 0;
    return out;
  }

  void add_restarts(std::set<std::size_t>& begins, const Values& times) const {
    const std::array<Values, kRowValueCount> values{
        first_of({"axial_strain", "axial_displacement", "dial_reading", "shear_strain"}), loads(),
        first_of({"mean_effective_stress", "mean_effective_stress_2d", "effective_radial_stress",
                  "excess_pore_pressure", "pore_pressure"}),
        values_of("cycle"), times};
    const std::vector<bool> begins_stage = new_stages();
    RestartFinder finder;
    for (std::size_t row = 0; row < rows(); ++row) {
      RowState now{};
      for (std::size_t i = 0; i < kRowValueCount; ++i)
        now[i] = row < values[i].size() ? values[i][row] : NAN;
      const auto found = finder.add(now, table_.row_lines[row], begins_stage[row]);
      if (found) begins.insert(static_cast<std::size_t>(found->reading));
    }
  }

  const TableColumns& table_;
  const Meaning& meaning_;
};

}  // namespace

bool names_tests(const std::string& heading) {
  const auto labels = find_labels({{heading, "1"}});
  return !labels.empty() && labels.front().name == "name";
}

RowCourse find_course(const TableColumns& table, const Meaning& meaning) {
  return CourseSearch(table, meaning).find();
}

}  // namespace triax::lab

// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/records/rows/row_order.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>

#include <fmt/format.h>

#include "lab/base/bad_input.hpp"

namespace triax::lab {
namespace {

using enum Quantity;

double strain_in(const Row& row) {
  const double strain = row.si[index(axial_strain)];
  return std::isnan(strain) ? row.si[index(axial_displacement)] : strain;
}

double deviator_in(const Row& row) {
  const double q = row.si[index(deviator_stress)];
  if (!std::isnan(q)) return q;
  const double difference =
      row.si[index(effective_axial_stress)] - row.si[index(effective_radial_stress)];
  return std::isnan(difference) ? row.si[index(axial_force)] : difference;
}

/// Sum of the absolute second differences of one value.
template <class Points, class Value>
double roughness(const Points& points, Value value) {
  double sum = 0;
  for (std::size_t i = 2; i < points.size(); ++i)
    sum += std::fabs(points[i].*value - 2 * points[i - 1].*value + points[i - 2].*value);
  return sum;
}

}  // namespace

void RowOrder::add(const Row& row, bool begins_stage, Findings& findings) {
  if (first_line_ == 0) first_line_ = row.line;
  last_line_ = row.line;
  const double time = std::isnan(row.time_s) ? row.stage_time_s : row.time_s;
  time_.add(time);
  if (!time_.is_empty()) return;
  const double strain = strain_in(row);
  strain_.add(strain);
  if (std::isnan(strain)) return;
  if (begins_stage) {
    window_ = {};
    forward_rows_ = 0;
  }
  std::shift_left(window_.begin(), window_.end(), 1);
  window_.back() = {std::fabs(strain - strain_.first()), deviator_in(row), row.line};
  if (changed_places())
    findings.note(
        "rows changed places", window_[3].line,
        "this row and the previous row seem to be swapped: the axial strain decreases only here");
  if (is_out_of_place())
    findings.note("row out of place", window_[4].line,
                  "the axial strain decreases only in this row: rows are out of order");
}

/// Rows 2 and 3 of the window.
bool RowOrder::changed_places() const {
  auto exchanged = window_;
  std::swap(exchanged[2], exchanged[3]);
  for (std::size_t i = 1; i < exchanged.size(); ++i)
    if (!(exchanged[i].strain > exchanged[i - 1].strain)) return false;
  const auto ratio = [&](double Point::*value) {
    return roughness(exchanged, value) / roughness(window_, value);
  };
  const double of_q = ratio(&Point::q);
  return ratio(&Point::strain) * (std::isfinite(of_q) ? of_q : 1) <= kSmooth_fraction;
}

/// The last row but one, now that the row after it is known.
bool RowOrder::is_out_of_place() {
  const Point &before = window_[2], &last = window_[3], &row = window_[4], &next = window_[5];
  const double back = last.strain - row.strain;
  if (back < 0) {
    forward_rows_ = std::min(forward_rows_ + 1, kRows_before);
    mean_step_ += (-back - mean_step_) / forward_rows_;
  }
  if (!(back > 0)) return false;
  const bool unloads =
      row.q < std::min(before.q, last.q) && std::fabs(next.q - last.q) < std::fabs(next.q - row.q);
  const bool q_goes_on = (row.q - last.q) * (last.q - before.q) >= 0;
  return std::exchange(forward_rows_, 0) >= kRows_before && next.strain > row.strain &&
         back >= kBack_steps * mean_step_ && !unloads && !q_goes_on;
}

std::string RowOrder::reversed() const {
  if (time_.runs_back())
    return fmt::format("the time decreases from {:g} s in this line to {:g} s in line {}",
                       time_.first(), time_.last(), last_line_);
  if (time_.is_empty() && strain_.runs_to_zero())
    return fmt::format(
        "the axial strain decreases from its largest value in this line to {:.2g} % of "
        "that value in line {}",
        100 * std::fabs(strain_.last() / strain_.first()), last_line_);
  return {};
}

void RowOrder::finish() const {
  const auto found = reversed();
  if (found.empty()) return;
  throw BadInput(file_, first_line_,
                 fmt::format("the rows are in reverse order: {}; {}", found,
                             time_.is_empty() ? "sort them, or add a column of time if the "
                                                "specimen was unloaded"
                                              : "sort them by time"));
}

}  // namespace triax::lab

// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/intake/course_evidence.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>
#include <vector>

#include "lab/base/statistics.hpp"
#include "lab/intake/series_math.hpp"

namespace triax::lab {
namespace {

/// The value that is farthest from the first.
double farthest_change(const std::vector<double>& values) {
  double out = 0;
  for (const double value : values)
    if (std::fabs(value - values.front()) > std::fabs(out)) out = value - values.front();
  return out;
}

/// Median of the second differences, which a smooth curve does not have, between rows that follow
/// each other.
double noise_of(const std::vector<double>& rows) {
  std::vector<double> bends;
  for (std::size_t i = 2; i < rows.size(); ++i) {
    const double bend = std::fabs(rows[i] - 2 * rows[i - 1] + rows[i - 2]) / 2;
    if (!std::isnan(bend)) bends.push_back(bend);
  }
  return bends.empty() ? 0 : median(std::move(bends));
}

/// Values of a volume from the row before the axis first moves.
struct CommonCourse {
  std::vector<double> values;
  std::size_t early_count = 0;  ///< of the values, before the specimen can have dilated
};

/// `series`: the volume and the axis, or the volume alone, all of which counts. Water that flows in
/// before the axis moves (saturation) fills the pores and is no change of the specimen.
CommonCourse course_of_movement(SeriesSpan series) {
  // In a test to 20 %: a strain of 0.05 %, more than of saturation and less than of consolidation.
  constexpr double kMoved = 0.0025;
  // And 1 %: before that, no shear dilates a specimen by more than it contracted it.
  constexpr double kEarly = 0.05;
  constexpr double kRelevant = 3;
  CommonCourse out;
  // If its first readings are missing, the axis may have moved before.
  if (series.size() > 1 && std::isnan(series[1]->values.front())) {
    out.values = known_values(*series[0]);
    return out;
  }
  std::vector<double> axis;
  for (std::size_t row = 0; row < series[0]->values.size(); ++row) {
    if (!is_complete(series, row)) continue;
    out.values.push_back(series[0]->values[row]);
    if (series.size() > 1) axis.push_back(series[1]->values[row]);
  }
  if (axis.empty()) return out;
  const double travel = std::fabs(farthest_change(axis));
  const auto is_beyond = [&](double fraction) {
    const double limit = std::max(kRelevant * series[1]->half_unit, fraction * travel);
    return [&axis, limit](double value) { return std::fabs(value - axis.front()) > limit; };
  };
  const auto moved = std::ranges::find_if(axis, is_beyond(kMoved));
  if (moved == axis.end()) return {};
  const auto start = std::max<std::ptrdiff_t>(moved - axis.begin() - 1, 0);
  out.values.erase(out.values.begin(), out.values.begin() + start);
  const auto early_end = std::find_if(moved, axis.end(), is_beyond(kEarly));
  out.early_count = static_cast<std::size_t>(early_end - axis.begin() - start);
  return out;
}

bool are_whole(const std::vector<double>& values) {
  return std::ranges::all_of(values, [](double value) { return value == std::round(value); });
}

}  // namespace

double common_direction_evidence(const Identity& identity, SeriesSpan s,
                                 const SpecimenValues& /*specimen*/) {
  constexpr double kRelevant = 3;
  constexpr double kUnloaded = 0.05;  // of the largest load
  std::vector<double> x, y;
  for (std::size_t row = 0; row < s[0]->values.size(); ++row)
    if (is_complete(s, row)) {
      x.push_back(s[0]->values[row]);
      y.push_back(s[1]->values[row]);
    }
  if (x.size() < kMinRows) return 0;
  // Without the first readings of the load it is compared with 0, which it has at first.
  const bool is_whole = !std::isnan(s[1]->values.front());
  const double y_first = is_whole ? y.front() : 0;
  const double x_first = is_whole ? x.front() : known_values(*s[0]).front();
  const auto at =
      std::ranges::max_element(y, {}, [&](double value) { return std::fabs(value - y_first); });
  const double dy = *at - y_first;
  // Consolidation shortens a specimen that is then extended.
  const auto is_unloaded = [&](double value) {
    return std::fabs(value - y_first) <= kUnloaded * std::fabs(dy);
  };
  const auto loads = std::find_if(std::make_reverse_iterator(at), y.rend(), is_unloaded);
  const double x_unloaded =
      loads == y.rend() ? x_first : x[static_cast<std::size_t>(loads.base() - y.begin()) - 1];
  const double dx = x[static_cast<std::size_t>(at - y.begin())] - x_unloaded;
  if (std::fabs(dy) <= kRelevant * s[1]->half_unit || std::fabs(dx) <= kRelevant * s[0]->half_unit)
    return 0;
  return dx * dy > 0 ? identity.highest : identity.lowest;
}

double compression_evidence(const Identity& identity, SeriesSpan s,
                            const SpecimenValues& /*specimen*/) {
  const auto values = known_values(*s[0]);
  if (values.empty()) return 0;
  return *std::ranges::max_element(values, {}, [](double v) { return std::fabs(v); }) > 0
             ? identity.highest
             : identity.lowest;
}

double first_contraction_evidence(const Identity& identity, SeriesSpan s,
                                  const SpecimenValues& /*specimen*/) {
  constexpr double kRelevant = 3, kFraction = 0.04;
  const CommonCourse course = course_of_movement(s);
  const std::vector<double>& values = course.values;
  if (values.size() <= kMinRows) return 0;
  const double range = std::fabs(farthest_change(values));
  const double rounding = std::max(s[0]->half_unit, noise_of(s[0]->values));
  if (range <= 2 * kRelevant * rounding) return 0;
  const double relevant = std::max(kRelevant * rounding, kFraction * range);
  const auto first = std::ranges::find_if(
      values, [&](double value) { return std::fabs(value - values.front()) > relevant; });
  if (first == values.end()) return 0;
  const double change = *first - values.front();
  const auto early_end = values.begin() + static_cast<std::ptrdiff_t>(course.early_count);
  const bool is_contradicted =
      first < early_end && std::any_of(first, early_end, [&](double value) {
        return std::copysign(1.0, change) * (values.front() - value) > relevant;
      });
  if (is_contradicted) return 0;
  return identity.factor * change > 0 ? identity.highest : identity.lowest;
}

double start_at_zero_evidence(const Identity& identity, SeriesSpan s,
                              const SpecimenValues& /*specimen*/) {
  constexpr double kFraction = 0.03, kPressure = 1, kDigits = 10;
  const auto values = known_values(*s[0]);
  if (values.empty()) return 0;
  return std::fabs(values.front()) <=
                 std::max({kDigits * s[0]->half_unit, kFraction * largest(values), kPressure})
             ? identity.highest
             : identity.lowest;
}

double start_above_zero_evidence(const Identity& identity, SeriesSpan s,
                                 const SpecimenValues& /*specimen*/) {
  constexpr double kFraction = 0.01, kPressure = 0.5, kSome = 1;
  const auto values = known_values(*s[0]);
  if (values.empty()) return 0;
  const bool is_zero = std::fabs(values.front()) <=
                       std::max({2 * s[0]->half_unit, kFraction * largest(values), kPressure});
  return is_zero && largest(values) > kSome ? identity.lowest : identity.highest;
}

double same_start_evidence(const Identity& identity, SeriesSpan s,
                           const SpecimenValues& /*specimen*/) {
  constexpr double kFraction = 0.02, kPressure = 3;
  const auto a = known_values(*s[0]), b = known_values(*s[1]);
  if (a.empty() || b.empty()) return 0;
  return std::fabs(a.front() - b.front()) <= std::max(kPressure, kFraction * std::fabs(b.front()))
             ? identity.highest
             : identity.lowest;
}

double order_evidence(const Identity& identity, SeriesSpan s, const SpecimenValues& /*specimen*/) {
  double below = 0, rows = 0;
  for (std::size_t row = 0; row < s[0]->values.size(); ++row) {
    if (!is_complete(s, row)) continue;
    ++rows;
    if (s[0]->values[row] + s[0]->half_unit < s[1]->values[row] - s[1]->half_unit) ++below;
  }
  constexpr double kMaxFraction = 0.5;
  return below > kMaxFraction * rows ? identity.lowest : identity.highest;
}

double no_tension_evidence(const Identity& identity, SeriesSpan s,
                           const SpecimenValues& /*specimen*/) {
  constexpr double kPressure = 5, kMaxFraction = 0.5;
  const auto values = known_values(*s[0]);
  const auto below = std::ranges::count_if(values, [](double value) { return value < -kPressure; });
  return static_cast<double>(below) > kMaxFraction * static_cast<double>(values.size())
             ? identity.lowest
             : identity.highest;
}

double strain_range_evidence(const Identity& identity, SeriesSpan s,
                             const SpecimenValues& /*specimen*/) {
  constexpr double kOfATest = 0.015, kWhole = 1;
  const double most = largest(known_values(*s[0]));
  return most < kOfATest || most > kWhole ? identity.lowest : identity.highest;
}

double displacement_range_evidence(const Identity& identity, SeriesSpan s,
                                   const SpecimenValues& /*specimen*/) {
  constexpr double kOfATest_mm = 0.5;
  return largest(known_values(*s[0])) < kOfATest_mm ? identity.lowest : identity.highest;
}

double volume_range_evidence(const Identity& identity, SeriesSpan s,
                             const SpecimenValues& /*specimen*/) {
  constexpr double kOfATest_mm3 = 50, kMinChange_half_units = 6;
  const auto values = known_values(*s[0]);
  const double most = largest(values);
  return most > kMinChange_half_units * s[0]->half_unit && most < kOfATest_mm3 ? identity.lowest
                                                                               : identity.highest;
}

double one_direction_evidence(const Identity& identity, SeriesSpan s,
                              const SpecimenValues& /*specimen*/) {
  constexpr double kAgainst = 0.1;  // of the steps: several tests or stages follow each other
  const auto values = known_values(*s[0]);
  if (values.size() < kMinRows) return 0;
  double forward = 0, back = 0;
  for (std::size_t i = 1; i < values.size(); ++i) {
    if (values[i] > values[i - 1]) ++forward;
    if (values[i] < values[i - 1]) ++back;
  }
  return std::min(forward, back) <= kAgainst * (forward + back) ? identity.highest
                                                                : identity.lowest;
}

double row_numbers_evidence(const Identity& identity, SeriesSpan s,
                            const SpecimenValues& /*specimen*/) {
  const auto values = known_values(*s[0]);
  if (values.size() < kMinRows) return 0;
  const bool grows = std::ranges::adjacent_find(values, std::greater_equal<>()) == values.end();
  const bool falls = std::ranges::adjacent_find(values, std::less_equal<>()) == values.end();
  return are_whole(values) && (grows || falls) ? identity.highest : identity.lowest;
}

double counter_evidence(const Identity& identity, SeriesSpan s,
                        const SpecimenValues& /*specimen*/) {
  const auto values = known_values(*s[0]);
  if (values.empty()) return 0;  // stages have names, too
  if (!are_whole(values)) return identity.lowest;
  const bool repeats = std::ranges::adjacent_find(values) != values.end();
  return repeats && std::ranges::is_sorted(values) ? identity.highest : 0;
}

double held_value_evidence(const Identity& identity, SeriesSpan s,
                           const SpecimenValues& /*specimen*/) {
  const auto values = known_values(*s[0]);
  if (values.empty()) return 0;
  const auto [low, high] = std::ranges::minmax(values);
  return high - low <= 2 * s[0]->half_unit ? identity.highest : identity.lowest;
}

double mixture_evidence(const Identity& identity, SeriesSpan /*s*/,
                        const SpecimenValues& /*specimen*/) {
  return identity.lowest;
}

double definition_evidence(const Identity& identity, SeriesSpan /*s*/,
                           const SpecimenValues& /*specimen*/) {
  return identity.highest;
}

}  // namespace triax::lab

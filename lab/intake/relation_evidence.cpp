// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/intake/relation_evidence.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>
#include <utility>
#include <vector>

#include "lab/base/statistics.hpp"
#include "lab/intake/series_math.hpp"

namespace triax::lab {
namespace {

/// Identity::evidence from the deviations of the rows, the rounding and the variation.
double weighed(const Identity& identity, const std::vector<double>& deviations, double rounding,
               double signal) {
  constexpr double kRelevant = 3, kNeutral = 0.1, kTiny = 1e-12;
  constexpr double kRows = 3;  // a few independent rows: readings follow each other
  if (deviations.size() < kMinRows || signal < kRelevant * rounding) return 0;
  const double deviation = std::max({root_mean_square(deviations), rounding, kTiny});
  return std::clamp(kRows * std::log(kNeutral * signal / deviation), identity.lowest,
                    identity.highest);
}

/// True for rows in which the specimen is sheared, or for all if no series is a deviator.
std::vector<bool> rows_of_shear(const Identity& identity, SeriesSpan series) {
  constexpr double kMinFraction = 0.05;
  std::vector<bool> out(series[0]->values.size(), true);
  for (std::size_t i = 0; i < series.size(); ++i) {
    if (!identity.quantities[i].ends_with("deviator_stress")) continue;
    double largest_value = 0;
    for (const double value : series[i]->values)
      if (!std::isnan(value)) largest_value = std::max(largest_value, std::fabs(value));
    for (std::size_t row = 0; row < out.size(); ++row)
      out[row] = std::fabs(series[i]->values[row]) > kMinFraction * largest_value;
  }
  return out;
}

/// The terms of a sum in the rows that have all of them.
struct SumTerms {
  std::vector<double> sums;
  std::vector<std::vector<double>> of_series;
};
SumTerms terms_of(const Identity& identity, SeriesSpan series) {
  // The constant is that of the shear stage: another one was held before it.
  const bool is_of_shear = identity.is_constant;
  const std::vector<bool> is_sheared =
      is_of_shear ? rows_of_shear(identity, series) : std::vector<bool>();
  SumTerms out{{}, std::vector<std::vector<double>>(series.size())};
  for (std::size_t row = 0; row < series[0]->values.size(); ++row) {
    if (!is_complete(series, row) || (is_of_shear && !is_sheared[row])) continue;
    double sum = 0;
    for (std::size_t i = 0; i < series.size(); ++i) {
      out.of_series[i].push_back(identity.coefficients[i] * series[i]->values[row]);
      sum += out.of_series[i].back();
    }
    out.sums.push_back(sum);
  }
  return out;
}

/// y = k x + c by least squares.
struct Line {
  double slope = 0;
  double y_variation = 0;
  std::vector<double> deviations;
};
std::optional<Line> fit(const std::vector<double>& x, const std::vector<double>& y) {
  if (x.size() < kMinRows) return std::nullopt;
  const double mean_x = mean_of(x), mean_y = mean_of(y);
  double sxx = 0, sxy = 0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    sxx += (x[i] - mean_x) * (x[i] - mean_x);
    sxy += (x[i] - mean_x) * (y[i] - mean_y);
  }
  if (!(sxx > 0)) return std::nullopt;
  Line line{sxy / sxx, variation(y), {}};
  for (std::size_t i = 0; i < x.size(); ++i)
    line.deviations.push_back(y[i] - mean_y - line.slope * (x[i] - mean_x));
  return line;
}

/// The factor against a value that is known.
double of_known_factor(double slope, double known) {
  constexpr double kClose = 0.03, kSure = 3, kPerUnit = 30, kLowest = -6;
  const double off = slope > 0 ? std::fabs(std::log(slope / known)) : 1;
  return off <= kClose ? kSure : std::max(kLowest, kSure - kPerUnit * off);
}

/// Evidence of the factor of a proportion: against `known`, or within the range of the identity.
double of_factor(const Identity& identity, double slope, std::optional<double> known,
                 double (*of_usual)(double)) {
  constexpr double kOutside = -5, kOpposite = -4;
  const double of_direction = slope > 0 ? 0 : kOpposite;
  if (known) return of_direction + of_known_factor(slope, *known);
  const double size = std::fabs(slope);
  if (size < identity.from || size > identity.to) return of_direction + kOutside;
  return of_direction + (of_usual ? of_usual(slope) : 0);
}

/// The first series is proportional, but for a constant, to a function of the others.
template <class Function>
double of_proportion(const Identity& identity, SeriesSpan series, const Function& function,
                     std::optional<double> known = {}, double (*of_usual)(double) = nullptr) {
  std::vector<double> x, y, argument;
  for (std::size_t row = 0; row < series[0]->values.size(); ++row) {
    if (!is_complete(series, row)) continue;
    x.push_back(identity.factor * function(row));
    y.push_back(series[0]->values[row]);
    argument.push_back(series[1]->values[row]);
  }
  const auto line = fit(x, y);
  if (!line) return 0;
  const double of_argument = variation(std::move(argument));
  const double per_unit = of_argument > 0 ? variation(x) / of_argument : 0;
  const double rounding =
      series[0]->half_unit + std::fabs(line->slope) * per_unit * series[1]->half_unit;
  const double evidence = weighed(identity, line->deviations, rounding, line->y_variation);
  return evidence > 0 ? evidence + of_factor(identity, line->slope, known, of_usual) : evidence;
}

/// Loss of height at most: beyond it a strain is none.
double shortened(double strain) {
  constexpr double kLargest = 0.9;
  return 1 - std::min(kLargest, strain);
}

constexpr double kSquareMetres = 1e-6;

/// Specimens have round diameters.
double of_usual_area(double slope) {
  constexpr std::array kUsual_mm{35.0, 35.6, 36.0, 38.0, 38.1,  39.1,  50.0,  50.8,  54.0,
                                 61.8, 63.5, 70.0, 71.1, 100.0, 101.6, 102.0, 150.0, 152.4};
  constexpr double kClose = 0.008, kUsual = 1;
  const double diameter_mm = std::sqrt(4 / std::numbers::pi * std::fabs(slope) / kSquareMetres);
  return std::ranges::any_of(
             kUsual_mm, [&](double usual) { return std::fabs(diameter_mm / usual - 1) < kClose; })
             ? kUsual
             : 0;
}

}  // namespace

double sum_evidence(const Identity& identity, SeriesSpan series,
                    const SpecimenValues& /*specimen*/) {
  const SumTerms terms = terms_of(identity, series);
  std::vector<double> sums = terms.sums;
  if (sums.size() < kMinRows) return 0;
  // A printed value that does not change is off by a constant, at most by its rounding.
  double rounding = 0, largest_offset = identity.is_constant ? HUGE_VAL : 0;
  std::vector<double> variations;
  for (std::size_t i = 0; i < series.size(); ++i) {
    variations.push_back(variation(terms.of_series[i]));
    const double half_unit = std::fabs(identity.coefficients[i]) * series[i]->half_unit;
    (variations.back() > half_unit ? rounding : largest_offset) += half_unit;
  }
  const double offset = std::clamp(median(sums), -largest_offset, largest_offset);
  for (double& sum : sums) sum -= offset;
  std::ranges::sort(variations);
  return weighed(identity, sums, rounding, variations[variations.size() - 2]);
}

double direct_evidence(const Identity& identity, SeriesSpan s, const SpecimenValues& /*specimen*/) {
  return of_proportion(identity, s, [&](std::size_t row) { return s[1]->values[row]; });
}

double height_evidence(const Identity& identity, SeriesSpan s, const SpecimenValues& specimen) {
  return of_proportion(
      identity, s, [&](std::size_t row) { return s[1]->values[row]; }, specimen.height_mm);
}

double current_height_evidence(const Identity& identity, SeriesSpan s,
                               const SpecimenValues& /*specimen*/) {
  const auto heights = known_values(*s[0]);
  if (heights.empty()) return 0;
  return of_proportion(
      identity, s, [&](std::size_t row) { return s[1]->values[row]; }, heights.front());
}

double area_evidence(const Identity& identity, SeriesSpan s, const SpecimenValues& /*specimen*/) {
  return of_proportion(identity, s,
                       [&](std::size_t row) { return 1 / shortened(s[1]->values[row]); });
}

double force_over_area_evidence(const Identity& identity, SeriesSpan s,
                                const SpecimenValues& /*specimen*/) {
  return of_proportion(identity, s, [&](std::size_t row) {
    return s[1]->values[row] * s[2]->values[row] * kSquareMetres;
  });
}

double force_over_strain_evidence(const Identity& identity, SeriesSpan s,
                                  const SpecimenValues& specimen) {
  std::optional<double> area;
  if (specimen.diameter_mm)
    area = std::numbers::pi / 4 * *specimen.diameter_mm * *specimen.diameter_mm * kSquareMetres;
  const auto stress_in_area = [&](std::size_t row) {
    return s[1]->values[row] / shortened(s[2]->values[row]);
  };
  return of_proportion(identity, s, stress_in_area, area, of_usual_area);
}

double quotient_evidence(const Identity& identity, SeriesSpan s,
                         const SpecimenValues& /*specimen*/) {
  constexpr double kNothing = 1e-9;
  return of_proportion(identity, s, [&](std::size_t row) {
    const double below = s[2]->values[row];
    return s[1]->values[row] / (below == 0 ? kNothing : below);
  });
}

}  // namespace triax::lab

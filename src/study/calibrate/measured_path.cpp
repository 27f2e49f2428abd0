// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/study/calibrate/measured_path.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "lab/base/statistics.hpp"

namespace triax::study {
namespace {

constexpr double kLeastPressure = 0.01;  // of p′ at the start
constexpr std::size_t kFewestKnots = 5;

PathKnot knot_of(const ShearReading& r) {
  return {r.axial_strain, r.volumetric_strain, r.p_eff, r.q, 0};
}

/// Noise of single values from differences of third order, which a smooth curve hardly has: their
/// variance is 20 σ². The median of their size keeps jumps out.
template <class Value>
double noise_of(const std::vector<ShearReading>& r, const Value& value) {
  std::vector<double> sizes;
  for (std::size_t i = 3; i < r.size(); ++i)
    sizes.push_back(
        std::abs(value(r[i]) - 3 * value(r[i - 1]) + 3 * value(r[i - 2]) - value(r[i - 3])));
  constexpr double kMedianOfNormal = 0.6745;
  return sizes.empty() ? 0 : lab::median(std::move(sizes)) / (kMedianOfNormal * std::sqrt(20.0));
}

template <class Values, class Value>
double span_of(const Values& values, const Value& value) {
  const auto [low, high] =
      std::minmax_element(values.begin(), values.end(),
                          [&](const auto& a, const auto& b) { return value(a) < value(b); });
  return value(*high) - value(*low);
}

/// Without those that only the noise of the strain brought back; the first is the start's own.
std::vector<ShearReading> onward(const MeasuredPath& path, const std::vector<ShearReading>& all) {
  const double noise = noise_of(all, [](const ShearReading& r) { return r.axial_strain; });
  const double turn = 6 * noise + 1e-9;
  std::vector<ShearReading> kept;
  double last = path.start.axial_strain;
  double direction = 1;
  for (const ShearReading& r : all) {
    if (r.p_eff < kLeastPressure * path.start.p_eff) break;
    const double step = r.axial_strain - last;
    if (path.imposed != Imposed::stress_path) {
      if (std::abs(step) < 1e-12) continue;
      if (kept.empty()) direction = step > 0 ? 1 : -1;
      if (step * direction < 0 && std::abs(step) < turn) continue;
      direction = step > 0 ? 1 : -1;
    }
    last = r.axial_strain;
    kept.push_back(r);
  }
  return kept;
}

/// Means over as many readings as a knot stands for: where knots lie must not depend on the noise
/// of single readings, or outliers would be chosen.
std::vector<PathKnot> smoothed(const std::vector<ShearReading>& readings, int knots) {
  const auto count = static_cast<std::ptrdiff_t>(readings.size());
  const std::ptrdiff_t half = count / std::max(knots, 1);
  std::vector<PathKnot> means;
  for (std::ptrdiff_t i = 0; i < count; ++i) {
    const std::ptrdiff_t side = std::min({half, i, count - 1 - i});
    PathKnot sum;
    for (std::ptrdiff_t k = i - side; k <= i + side; ++k) {
      const ShearReading& r = readings[static_cast<std::size_t>(k)];
      sum.axial_strain += r.axial_strain, sum.volumetric_strain += r.volumetric_strain;
      sum.p_eff += r.p_eff, sum.q += r.q;
    }
    const auto n = static_cast<double>(2 * side + 1);
    means.push_back({sum.axial_strain / n, sum.volumetric_strain / n, sum.p_eff / n, sum.q / n, 0});
  }
  return means;
}

/// Arc length up to each reading, every part of it over its span.
std::vector<double> arc_lengths(const MeasuredPath& path, const std::vector<ShearReading>& readings,
                                int knots) {
  const auto quantities = compared_in(path.imposed);
  const double strain_span =
      std::max(span_of(readings, [](const ShearReading& r) { return r.axial_strain; }), 1e-9);
  std::vector<double> lengths;
  PathKnot before = path.start;
  double sum = 0;
  for (const PathKnot& now : smoothed(readings, knots)) {
    double square = std::pow((now.axial_strain - before.axial_strain) / strain_span, 2);
    for (std::size_t k = 0; k < 2; ++k)
      square +=
          std::pow((now.value(quantities[k]) - before.value(quantities[k])) / path.span[k], 2);
    sum += std::sqrt(square);
    lengths.push_back(sum);
    before = now;
  }
  return lengths;
}

/// The last readings before equal steps of arc length, each once.
std::vector<std::size_t> even_steps(const std::vector<double>& lengths, int count) {
  std::vector<std::size_t> chosen;
  for (int k = 1; k <= count; ++k) {
    const double at = lengths.back() * k / count;
    const auto found = std::ranges::lower_bound(lengths, at * (1 - 1e-12));
    const auto index = static_cast<std::size_t>(
        std::min(found - lengths.begin(), static_cast<std::ptrdiff_t>(lengths.size()) - 1));
    if (chosen.empty() || index > chosen.back()) chosen.push_back(index);
  }
  return chosen;
}

}  // namespace

std::string_view to_string(Imposed imposed) {
  switch (imposed) {
    case Imposed::undrained:
      return "undrained";
    case Imposed::drained:
      return "drained";
    case Imposed::stress_path:
      return "stress path";
  }
  return "";
}

std::string_view to_string(Compared quantity) {
  switch (quantity) {
    case Compared::q:
      return "q_kPa";
    case Compared::p_eff:
      return "p_eff_kPa";
    case Compared::volumetric_strain:
      return "volumetric_strain";
    case Compared::axial_strain:
      return "axial_strain";
  }
  return "";
}

std::array<Compared, 2> compared_in(Imposed imposed) {
  switch (imposed) {
    case Imposed::undrained:
      return {Compared::q, Compared::p_eff};
    case Imposed::drained:
      return {Compared::q, Compared::volumetric_strain};
    case Imposed::stress_path:
      break;
  }
  return {Compared::axial_strain, Compared::volumetric_strain};
}

double PathKnot::value(Compared quantity) const {
  switch (quantity) {
    case Compared::q:
      return q;
    case Compared::p_eff:
      return p_eff;
    case Compared::volumetric_strain:
      return volumetric_strain;
    case Compared::axial_strain:
      break;
  }
  return axial_strain;
}

void lay_knots(MeasuredPath& path, const std::vector<ShearReading>& readings,
               const PathOptions& options) {
  const auto kept = onward(path, readings);
  if (kept.size() < kFewestKnots)
    throw std::invalid_argument("shear has too few readings with increasing strain");
  const auto quantities = compared_in(path.imposed);
  for (std::size_t k = 0; k < 2; ++k) {
    const auto value = [&](const ShearReading& r) { return knot_of(r).value(quantities[k]); };
    path.noise[k] = noise_of(readings, value);
    path.span[k] = std::max(span_of(kept, value), 1e-12);
    path.scale[k] = std::hypot(path.noise[k], kAccuracy * path.span[k]);
  }
  const auto lengths = arc_lengths(path, kept, options.knots);
  const auto chosen = even_steps(lengths, options.knots);
  if (chosen.size() < kFewestKnots)
    throw std::invalid_argument("shear has too few different readings");
  path.knots.clear();
  for (std::size_t k = 0; k < chosen.size(); ++k) {
    const double before = k == 0 ? 0 : lengths[chosen[k - 1]];
    const double after = k + 1 < chosen.size() ? lengths[chosen[k + 1]] : lengths[chosen[k]];
    PathKnot knot = knot_of(kept[chosen[k]]);
    knot.weight = (after - before) / 2;
    path.knots.push_back(knot);
  }
  double sum = 0;
  for (const PathKnot& knot : path.knots) sum += knot.weight;
  for (PathKnot& knot : path.knots) knot.weight /= sum;
}

std::optional<PathKnot> onset_knot(const MeasuredPath& path) {
  if (!path.onset_eta || path.knots.empty()) return std::nullopt;
  return *std::ranges::min_element(path.knots, {}, [&](const PathKnot& knot) {
    return std::abs(knot.q / knot.p_eff - *path.onset_eta);
  });
}

}  // namespace triax::study

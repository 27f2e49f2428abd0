// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/study/sheet/root_time.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <tuple>
#include <utility>

namespace triax::study {
namespace {

using enum DrainageBoundary;
constexpr std::array<std::pair<DrainageBoundary, std::string_view>, 5> kBoundaries = {
    {{one_end, "one end"},
     {both_ends, "both ends"},
     {sides, "sides"},
     {sides_and_one_end, "sides and one end"},
     {sides_and_both_ends, "sides and both ends"}}};

constexpr int kSteps = 400;             // of √t: the curve as its figure shows it
constexpr double kStraightTo = 0.5;     // of the outflow: Terzaghi's series is straight to 0.6
constexpr double kStraightFrom = 0.05;  // what jumped at once, behind the valve, is no part of it
constexpr double kTaylor = 1.15;
constexpr std::size_t kFewest = 5;

struct RootPoint {
  double root = 0, outflow = 0;
};

/// At even steps of √t, so that late readings, which are many, do not outweigh the early ones.
std::vector<RootPoint> over_root(const std::vector<ConsolidationPoint>& points) {
  std::vector<RootPoint> out;
  const double end = std::sqrt(points.back().time_s);
  std::size_t next = 1;
  for (int i = 0; i <= kSteps; ++i) {
    const double root = end * i / kSteps;
    const double time = root * root;
    while (next + 1 < points.size() && points[next].time_s < time) ++next;
    const auto& [t0, v0] = points[next - 1];
    const auto& [t1, v1] = points[next];
    const double r0 = std::sqrt(t0), r1 = std::sqrt(t1);
    if (root < r0) continue;
    out.push_back({root, r1 > r0 ? v0 + (v1 - v0) * std::min((root - r0) / (r1 - r0), 1.0) : v1});
  }
  return out;
}

/// Line of least squares through the part of the curve between these shares of the way from `zero`
/// to the end.
std::optional<std::pair<double, double>> straight_part(const std::vector<RootPoint>& curve,
                                                       double zero) {
  const double all = curve.back().outflow - zero;
  double n = 0, x = 0, y = 0, xx = 0, xy = 0;
  for (const auto& p : curve) {
    const double share = (p.outflow - zero) / all;
    if (share > kStraightTo) break;
    if (share < kStraightFrom) continue;
    n += 1, x += p.root, y += p.outflow, xx += p.root * p.root, xy += p.root * p.outflow;
  }
  const double spread = n * xx - x * x;
  if (n < 3 || !(spread > 0)) return std::nullopt;
  const double slope = (n * xy - x * y) / spread;
  return std::pair((y - slope * x) / n, slope);
}

template <class Reached>
std::optional<double> time_at(const std::vector<RootPoint>& curve, const Reached& excess) {
  for (std::size_t i = 1; i < curve.size(); ++i) {
    const double before = excess(curve[i - 1]), here = excess(curve[i]);
    if (!(before < 0) || !(here >= 0)) continue;
    const double root =
        curve[i - 1].root + (curve[i].root - curve[i - 1].root) * before / (before - here);
    return root * root;
  }
  return std::nullopt;
}

}  // namespace

std::string_view to_string(DrainageBoundary boundary) {
  for (const auto& [value, text] : kBoundaries)
    if (value == boundary) return text;
  return "";
}

std::optional<DrainageBoundary> drainage_boundary_from(std::string_view text) {
  for (const auto& [value, name] : kBoundaries)
    if (name == text) return value;
  return std::nullopt;
}

BoundaryFactors factors_of(DrainageBoundary boundary) {
  switch (boundary) {
    case one_end:
      break;
    case both_ends:
      return {4, 8.5, 2.1};
    case sides:
      return {64, 12.7, 1.43};
    case sides_and_one_end:
      return {80, 14.2, 1.8};
    case sides_and_both_ends:
      return {100, 15.8, 2.3};
  }
  return {1, 8.5, 0.53};
}

std::optional<RootTime> root_time(const std::vector<ConsolidationPoint>& points) {
  if (points.size() < kFewest || !(points.back().time_s > points.front().time_s))
    return std::nullopt;
  const auto curve = over_root(points);
  if (curve.size() < kFewest) return std::nullopt;
  RootTime fit{.zero = points.front().outflow, .final = points.back().outflow};
  for (int pass = 0; pass < 20; ++pass) {
    const auto line = straight_part(curve, fit.zero);
    if (!line) return std::nullopt;
    std::tie(fit.zero, fit.slope) = *line;
  }
  const double all = fit.final - fit.zero;
  const auto in_line = std::ranges::count_if(
      points, [&](const auto& p) { return (p.outflow - fit.zero) / all <= kStraightTo; });
  if (static_cast<std::size_t>(in_line) < kFewest || !(all / fit.slope > 0)) return std::nullopt;
  fit.t100_s = std::pow(all / fit.slope, 2);
  const double sign = fit.slope > 0 ? 1 : -1;
  fit.t90_s = time_at(curve, [&](const RootPoint& p) {
    if ((p.outflow - fit.zero) / all < kStraightTo) return -1.0;
    return sign * (fit.zero + fit.slope / kTaylor * p.root - p.outflow);
  });
  if (fit.t90_s) {
    const double at_90 = fit.zero + fit.slope / kTaylor * std::sqrt(*fit.t90_s);
    const double middle = fit.zero + 0.5 / 0.9 * (at_90 - fit.zero);
    fit.t50_s = time_at(curve, [&](const RootPoint& p) { return sign * (p.outflow - middle); });
  }
  return fit;
}

double coefficient_of_consolidation(double diameter_m, DrainageBoundary boundary, double t100_s) {
  return std::numbers::pi * diameter_m * diameter_m / (factors_of(boundary).lambda * t100_s);
}

}  // namespace triax::study

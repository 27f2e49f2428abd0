// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/study/calibrate/implied_states.hpp"

#include <algorithm>
#include <cmath>

#include "lab/base/statistics.hpp"

namespace triax::study {
namespace {

constexpr int kColumns = 7, kColumnsOfFinite = 3;
constexpr double kRow = 0.05, kRowOfFinite = 0.2;  // of η
constexpr int kDirections = 36;
constexpr double kExtension = -0.1;  // η of a test that went into extension

/// To three digits in kPa, so that a reader can ask triax domain for the same.
double rounded(double pa) {
  const double kPa = pa / 1e3;
  const double unit = std::pow(10.0, std::floor(std::log10(kPa)) - 2);
  return std::round(kPa / unit) * unit * 1e3;
}

sim::DomainGrid grid_of(double p, double void_ratio, double q_from, double q_to, int rows) {
  return {.p_from = p,
          .p_to = p,
          .columns = 1,
          .q_from = q_from,
          .q_to = q_to,
          .rows = rows,
          .void_ratio = void_ratio,
          .directions = kDirections};
}

}  // namespace

ImpliedStates implied_states(const std::vector<MeasuredPath>& paths, bool finite) {
  ImpliedStates states;
  std::vector<double> collapsed, all;
  double least = paths.front().start.p_eff, largest = least;
  for (const MeasuredPath& path : paths) {
    all.push_back(path.void_ratio);
    least = std::min(least, path.start.p_eff);
    if (const auto onset = onset_knot(path)) {
      collapsed.push_back(path.void_ratio);
      least = std::min(least, onset->p_eff);
    }
    for (const PathKnot& knot : path.knots) {
      largest = std::max(largest, knot.p_eff);
      states.extension = states.extension || knot.q < kExtension * knot.p_eff;
    }
  }
  states.of_collapsed = !collapsed.empty();
  const double median = lab::median(states.of_collapsed ? collapsed : all);
  states.void_ratio = std::round(1e4 * median) / 1e4;
  constexpr double kNarrow = 0.8;  // all tests at about one p′
  if (least > kNarrow * largest) least = largest / 2;
  const int columns = finite ? kColumnsOfFinite : kColumns;
  for (int k = 0; k < columns; ++k)
    states.pressures.push_back(
        rounded(std::lerp(least, largest, static_cast<double>(k) / (columns - 1))));
  return states;
}

sim::DomainColumn implied_column(const sim::Law<sim::Axisymmetric>& law, double p,
                                 double void_ratio, double ratio) {
  const int rows =
      1 + static_cast<int>(std::lround(std::abs(ratio) / (law.finite() ? kRowOfFinite : kRow)));
  return sim::domain_column(
      law, grid_of(p, void_ratio, std::min(ratio, 0.0) * p, std::max(ratio, 0.0) * p, rows), 0);
}

std::string refused_direction(const sim::Law<sim::Axisymmetric>& law,
                              const sim::DomainColumn& column, double void_ratio) {
  std::vector<double> where;
  for (const sim::DomainState& state : column.states) {
    if (state.kind == sim::DomainStateKind::beyond_limit || !state.cones.empty()) break;
    if (state.refused_directions > 0) where.push_back(state.q);
  }
  if (where.empty()) return "";
  // Well inside, where what is refused is no matter of the isotropic state.
  const double q = where[where.size() / 2];
  return sim::domain_column(law, grid_of(column.p, void_ratio, q, q + column.p, 1), 0).refusal;
}

}  // namespace triax::study

#include "src/triaxial/figures/shear_states.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>

namespace triax::src {

bool is_shear(const lab::RecordHeader& header, int stage) {
  const auto* info = header.stage(stage);
  return info == nullptr || info->role == lab::StageRole::shear ||
         info->role == lab::StageRole::unknown;
}

std::vector<QPointF> shear_points(const study::TestResult& test, StateValue x, StateValue y) {
  constexpr double kAny = std::numeric_limits<double>::infinity();
  return shear_points_within(test, x, y, kAny, kAny);
}

std::vector<QPointF> shear_points_within(const study::TestResult& test, StateValue x, StateValue y,
                                         double x_most, double y_most) {
  std::vector<QPointF> points;
  for (const auto& state : test.curves.states) {
    if (!is_shear(test.stored.header, state.stage)) continue;
    const QPointF point(x(state), y(state));
    if (!std::isfinite(point.x()) || !std::isfinite(point.y())) continue;
    if (point.x() > x_most || point.y() > y_most) break;
    points.push_back(point);
  }
  return points;
}

std::optional<lab::State> state_at_onset(const study::TestResult& test) {
  const auto onset = study::collapse_onset(test.stored);
  const auto& states = test.curves.states;
  if (!onset || states.empty()) return std::nullopt;
  return *std::min_element(states.begin(), states.end(), [&](const auto& a, const auto& b) {
    return std::llabs(a.reading - onset->reading) < std::llabs(b.reading - onset->reading);
  });
}

}  // namespace triax::src

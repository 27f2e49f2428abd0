// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/plot/directions.hpp"

#include <algorithm>
#include <cmath>

namespace triax::src {
namespace {

constexpr double kTurn = 2 * std::numbers::pi;
constexpr double kEdge = 1e-9;

class Runs {
 public:
  /// A point of the polyline. The way to it from the point before is straight.
  void add(const AngleValue& next) {
    const bool negative = next.value < 0;
    if (!open_) {
      runs_.push_back({negative, {}});
      open_ = true;
    } else if (next.value != 0 && negative != runs_.back().negative) {
      change_sign(next);
    }
    runs_.back().points.push_back(next);
  }
  void gap() { open_ = false; }
  std::vector<SignedRun> take() {
    std::erase_if(runs_, [](const SignedRun& run) { return run.points.size() < 2; });
    return std::move(runs_);
  }

 private:
  void change_sign(const AngleValue& next) {
    SignedRun& run = runs_.back();
    const AngleValue last = run.points.back();
    if (last.value == 0 && run.points.size() == 1) {
      run.negative = !run.negative;
      return;
    }
    const double part = last.value / (last.value - next.value);
    const AngleValue zero{std::lerp(last.angle, next.angle, part), 0};
    if (last.value != 0) run.points.push_back(zero);
    runs_.push_back({!run.negative, {zero}});
  }

  std::vector<SignedRun> runs_;
  bool open_ = false;
};

}  // namespace

std::vector<SignedRun> signed_runs(const std::vector<sim::Probe>& probes, const ProbeValue& value,
                                   double step) {
  if (probes.empty()) return {};
  const auto point = [&](std::size_t i) {
    const sim::Probe& probe = probes[i % probes.size()];
    const double v = value(probe);
    return AngleValue{probe.angle + (i < probes.size() ? 0 : kTurn), std::abs(v) < kEdge ? 0 : v};
  };
  Runs runs;
  if (probes.front().answered) runs.add(point(0));
  for (std::size_t i = 1; i <= probes.size(); ++i) {
    if (!probes[i % probes.size()].answered) {
      runs.gap();
      continue;
    }
    const AngleValue to = point(i);
    if (probes[i - 1].answered) {
      const AngleValue from = point(i - 1);
      const int steps = std::max(1, static_cast<int>(std::ceil((to.angle - from.angle) / step)));
      for (int k = 1; k < steps; ++k)
        runs.add({std::lerp(from.angle, to.angle, static_cast<double>(k) / steps),
                  std::lerp(from.value, to.value, static_cast<double>(k) / steps)});
    }
    runs.add(to);
  }
  return runs.take();
}

}  // namespace triax::src

// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/study/soil/critical_state.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <vector>

#include "src/study/soil/line_fit.hpp"

namespace triax::study {
namespace {

constexpr int kWindows = 6;
constexpr double kLastPart = 0.4, kLeastStrain = 0.05;
constexpr double kFalling = 0.75, kDeviations = 3;
constexpr double kNearE = 0.005, kNearLogP = 0.05, kNearEta = 0.02;
constexpr double kFarE = 0.06, kFarLogP = 0.7, kFarEta = 0.15;
/// Rates, of volume and of ln p′: as good as none; and, not falling, so slow that the state is
/// close all the same.
struct Limits {
  double none = 0, slow = 0;
};
constexpr Limits kDrained{0.003, 0.02}, kUndrained{0.1, 0.5};

using Value = std::function<double(const CurvePoint&)>;

struct Window {
  LocalFit rate, eta, log_p;  ///< over ε_q, at the middle
  std::optional<LocalFit> void_ratio;
};

std::optional<LocalFit> fitted(const std::vector<CurvePoint>& points, double middle,
                               const Value& value) {
  std::vector<double> x, y;
  for (const auto& p : points) x.push_back(p.shear_strain), y.push_back(value(p));
  return local_fit(x, y, middle);
}

double log_p(const CurvePoint& p) { return std::log(p.p_eff_kPa); }

std::optional<Window> window_of(const std::vector<CurvePoint>& points, bool drained) {
  if (points.size() < 3) return std::nullopt;
  const double middle = (points.front().shear_strain + points.back().shear_strain) / 2;
  const auto eta = fitted(points, middle, [](const auto& p) { return p.eta(); });
  const auto lp = fitted(points, middle, log_p);
  const auto ev = fitted(points, middle, [](const auto& p) { return p.volumetric_strain; });
  if (!eta || !lp || !ev) return std::nullopt;
  Window w{drained ? *ev : *lp, *eta, *lp, {}};
  if (std::ranges::all_of(points, [](const auto& p) { return p.void_ratio.has_value(); }))
    w.void_ratio = fitted(points, middle, [](const auto& p) { return *p.void_ratio; });
  return w;
}

/// From where the last part begins.
std::vector<CurvePoint> last_part(const ShearCurve& curve) {
  const double end = curve.points.back().axial_strain;
  double largest = 0, at = 0;
  for (const auto& p : curve.points)
    if (p.axial_strain > 0.002 && p.eta() > largest) largest = p.eta(), at = p.axial_strain;
  const double from = std::max(kLastPart * end, at < 0.8 * end ? at : 0.0);
  std::vector<CurvePoint> part;
  std::ranges::copy_if(curve.points, std::back_inserter(part),
                       [&](const auto& p) { return p.axial_strain >= from; });
  return part;
}

std::vector<Window> windows_of(const std::vector<CurvePoint>& part, bool drained) {
  const double from = part.front().axial_strain, to = part.back().axial_strain;
  std::array<std::vector<CurvePoint>, kWindows> pieces;
  for (const auto& p : part)
    pieces[static_cast<std::size_t>(
               std::min(kWindows - 1.0, kWindows * (p.axial_strain - from) / (to - from)))]
        .push_back(p);
  std::vector<Window> windows;
  for (const auto& piece : pieces)
    if (const auto w = window_of(piece, drained)) windows.push_back(*w);
  return windows;
}

/// The mean of the last two windows; half of what changed between them is in the error.
Estimate at_rest(const LocalFit& before, const LocalFit& last) {
  const double value = (before.at + last.at) / 2;
  return measured(
      value, std::hypot(std::hypot(before.at_error, last.at_error) / 2, (last.at - before.at) / 2));
}

std::vector<FitPoint> over_rate(const std::vector<Window>& windows,
                                const std::function<LocalFit(const Window&)>& of) {
  std::vector<FitPoint> points;
  for (const auto& w : windows) {
    const LocalFit fit = of(w);
    points.push_back({w.rate.slope, fit.at, w.rate.slope_error, fit.at_error, 0});
  }
  return points;
}

/// Where the line over the rate comes to 0.
std::optional<Estimate> at_no_rate(const std::vector<Window>& windows,
                                   const std::function<LocalFit(const Window&)>& of) {
  const auto line = fit_line(over_rate(windows, of));
  if (!line) return std::nullopt;
  const double way = line->a - of(windows.back()).at;
  return measured(line->a, std::hypot(line->error_at(0), kOfTheWay * way));
}

LocalFit eta_of(const Window& w) { return w.eta; }
LocalFit log_p_of(const Window& w) { return w.log_p; }
LocalFit void_ratio_of(const Window& w) { return *w.void_ratio; }

CriticalState none(std::string reason, double rate = 0) {
  CriticalState state;
  state.reason = std::move(reason);
  state.rate = rate;
  return state;
}

CriticalState rest(const std::vector<Window>& windows, bool with_e) {
  const Window &before = windows[windows.size() - 2], &last = windows.back();
  CriticalState state{CriticalKind::reached,
                      {},
                      at_rest(before.eta, last.eta),
                      at_rest(before.log_p, last.log_p),
                      {},
                      last.rate.slope};
  if (with_e) state.void_ratio = at_rest(*before.void_ratio, *last.void_ratio);
  return state;
}

CriticalState extrapolated(const std::vector<Window>& windows, bool with_e) {
  const Window& last = windows.back();
  const auto eta = at_no_rate(windows, eta_of), lp = at_no_rate(windows, log_p_of);
  const auto e = with_e ? at_no_rate(windows, void_ratio_of) : std::nullopt;
  if (!eta || !lp) return none("too few readings in the last part of shear", last.rate.slope);
  CriticalState state{CriticalKind::extrapolated, {}, *eta, *lp, e, last.rate.slope};
  state.eta_way = eta->value - last.eta.at;
  const double eta_way = std::abs(state.eta_way) / last.eta.at;
  const double p_way = std::abs(lp->value - last.log_p.at);
  const double e_way = e ? std::abs(e->value - last.void_ratio->at) : 0;
  if (eta_way > kFarEta || p_way > kFarLogP || e_way > kFarE || eta->value <= 0)
    return none("too far from the critical state at its end to extrapolate", last.rate.slope);
  if (eta_way < kNearEta && p_way < kNearLogP && e_way < kNearE)
    state.kind = CriticalKind::reached;
  else
    state.reason =
        fmt::format("extrapolated by {:.3f} in η{}, {:.0f} % of p′", eta->value - last.eta.at,
                    e ? fmt::format(", {:.3f} in e", e->value - last.void_ratio->at) : "",
                    100 * std::expm1(lp->value - last.log_p.at));
  return state;
}

CriticalState of_windows(const ShearCurve& curve, bool drained) {
  if (curve.points.empty() || curve.points.back().axial_strain < kLeastStrain)
    return none(fmt::format("sheared to {:.1f} % only; at least {:.0f} % are needed",
                            curve.points.empty() ? 0 : 100 * curve.points.back().axial_strain,
                            100 * kLeastStrain));
  const auto windows = windows_of(last_part(curve), drained);
  if (windows.size() < 4) return none("too few readings in the last part of shear");
  const bool with_e =
      std::ranges::all_of(windows, [](const auto& w) { return w.void_ratio.has_value(); });
  const LocalFit& rate = windows.back().rate;
  const Limits& limits = drained ? kDrained : kUndrained;
  const double now = std::abs(rate.slope);
  if (now <= std::max(limits.none, kDeviations * rate.slope_error) &&
      rate.slope_error < limits.slow)
    return rest(windows, with_e);
  double largest = 0;
  for (const auto& w : windows) largest = std::max(largest, std::abs(w.rate.slope));
  if (now > kFalling * largest && now > limits.slow)
    return none(drained ? fmt::format("its volume still changes: dε_v/dε_q = {:.3f} at the end, "
                                      "and not falling",
                                      rate.slope)
                        : fmt::format("p′ still changes by {:.1f} % for 1 % of strain at the end, "
                                      "and not less than before",
                                      std::abs(rate.slope)),
                rate.slope);
  return extrapolated(windows, with_e);
}

}  // namespace

std::string_view to_string(CriticalKind kind) {
  switch (kind) {
    case CriticalKind::reached:
      return "reached";
    case CriticalKind::extrapolated:
      return "extrapolated";
    case CriticalKind::none:
      break;
  }
  return "none";
}

CriticalState critical_state(const ShearCurve& curve, bool drained, double stress_error_kPa) {
  CriticalState state = of_windows(curve, drained);
  if (state.kind == CriticalKind::none) return state;
  const double share = stress_error_kPa / std::exp(state.log_p.value);
  const double of_eta = std::hypot(1.0, state.eta.value) * share;
  state.eta = measured(state.eta.value, std::hypot(state.eta.error, of_eta));
  state.log_p = measured(state.log_p.value, std::hypot(state.log_p.error, share));
  return state;
}

}  // namespace triax::study

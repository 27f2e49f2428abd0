// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/detection/statistics.hpp"

#include <algorithm>
#include <cmath>

namespace triax::bench {
namespace {

Spread spread(const std::vector<double>& values) {
  return {quantile(values, 0.5), quantile(values, 0.95), quantile(values, 1)};
}

}  // namespace

std::optional<double> quantile(std::vector<double> values, double share) {
  if (values.empty()) return std::nullopt;
  const auto n = static_cast<double>(values.size());
  // Shares such as 0.95 are not exact: a hair above a whole rank is that rank.
  const auto rank = static_cast<std::ptrdiff_t>(std::ceil(share * n - 1e-9));
  const auto at = values.begin() + std::clamp<std::ptrdiff_t>(rank - 1, 0, std::ssize(values) - 1);
  std::nth_element(values.begin(), at, values.end());
  return *at;
}

double Summary::detection() const {
  return collapsing > 0 ? static_cast<double>(detected) / collapsing : 1.0;
}

double Summary::false_alarm() const {
  return controls > 0 ? static_cast<double>(false_alarms) / controls : 0.0;
}

Summary summarise(const std::vector<Outcome>& outcomes) {
  Summary s;
  std::vector<double> eta_errors, delays, notice_delays;
  for (const Outcome& o : outcomes) {
    ++(o.collapses ? s.collapsing : s.controls);
    if (o.collapses && !o.notice_delay) ++s.unnoticed;
    if (!o.detected) continue;
    ++(o.collapses ? s.detected : s.false_alarms);
    if (!o.collapses) continue;
    if (o.eta_error) eta_errors.push_back(*o.eta_error);
    if (o.delay) delays.push_back(static_cast<double>(std::abs(*o.delay)));
    if (o.notice_delay) notice_delays.push_back(static_cast<double>(*o.notice_delay));
  }
  s.eta_error = spread(eta_errors);
  s.delay = spread(delays);
  s.notice_delay = spread(notice_delays);
  return s;
}

}  // namespace triax::bench

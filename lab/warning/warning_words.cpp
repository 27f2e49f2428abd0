// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/warning/warning_words.hpp"

#include <fmt/format.h>

namespace triax::lab {
namespace {

std::string describe(const LeftToOnset& left) {
  std::string text;
  if (left.quantity == Quantity::axial_strain)
    text = fmt::format("{:.3f} % of axial strain", left.value * 100);
  if (left.quantity == Quantity::deviator_stress)
    text = fmt::format("{:.2f} kPa of q", left.value / 1e3);
  if (left.quantity == Quantity::mean_effective_stress)
    text = fmt::format("{:.2f} kPa of p'", left.value / 1e3);
  if (left.time_s) text += fmt::format(" and {:.0f} s", *left.time_s);
  return text + " left at the present rate";
}

}  // namespace

std::string describe(const Forecast& forecast) {
  if (forecast.cyclic)
    return fmt::format(
        "the probability of failure within one load cycle is {:.0f} % after {:.1f} cycles",
        forecast.cyclic->probability * 100, forecast.cyclic->load_cycles);
  std::string text = fmt::format("onset forecast at η {:.3f} ({:.3f} to {:.3f})", forecast.eta,
                                 forecast.eta_low, forecast.eta_high);
  if (forecast.left) text += ", " + describe(*forecast.left);
  return text;
}

std::string restart_words(const CyclicWarning& warning) {
  if (warning.restart() == CyclicWarning::Restart::none) return "";
  return fmt::format("; cycles are compared again since cycle {:.1f}: {}",
                     warning.restarted_at_cycles(), describe(warning.restart()));
}

std::string describe(const GuardOutcome& g) {
  std::string text = fmt::format("on {}: {}", to_string(g.level), g.done);
  if (g.at.axial_strain) text += fmt::format("; axial strain {:.3f} %", *g.at.axial_strain * 100);
  if (g.at.q_pa) text += fmt::format(", q {:.2f} kPa", *g.at.q_pa / 1e3);
  if (g.second_order_work_normalised)
    text += fmt::format(", normalised second-order work {:.3f}", *g.second_order_work_normalised);
  return text;
}

Event level_event(WarningLevel level, const Forecast& forecast) {
  return {.reading = forecast.reading,
          .time_s = forecast.time_s,
          .kind = level == WarningLevel::imminent ? EventKind::imminent : EventKind::approaching,
          .detail = describe(forecast)};
}

Event withdrawal_event(const State& now, bool has_time, const std::optional<Forecast>& forecast,
                       const std::string& reason) {
  Event event{
      .reading = now.reading, .time_s = {}, .kind = EventKind::warning_withdrawn, .detail = reason};
  if (has_time) event.time_s = now.time_s;
  if (reason.empty()) event.detail = forecast ? describe(*forecast) : "no onset is forecast";
  event.detail = "warning withdrawn: " + event.detail;
  return event;
}

}  // namespace triax::lab

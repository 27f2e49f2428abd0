#include "src/report/control_report.hpp"

#include <fmt/format.h>

#include <variant>

#include "sim/stability/plane_rate.hpp"
#include "src/report/words.hpp"

namespace triax::src {
namespace {

using sim::Axisymmetric;
using sim::Tensor;

/// Of zone (−, −, −), which the moduli of the paper's equations belong to.
sim::PlaneCompliance zone_of(const sim::InterpolatedForm<Axisymmetric>& form) {
  return sim::plane_compliance(sim::zone_compliance(form, sim::ZoneSigns{}));
}
sim::PlaneCompliance zone_of(const sim::InterpolatedForm<Tensor>& form) {
  return sim::plane_compliance(sim::principal_moduli(sim::zone_compliance(form, sim::ZoneSigns{})));
}

template <class Space>
std::optional<sim::PlaneCompliance> compliance_of(const sim::IncrementalResponse<Space>& response,
                                                  const sim::Probe& least, std::string& whose) {
  const auto form = response.law().response(response.state());
  if (const auto* interpolated = std::get_if<sim::InterpolatedForm<Space>>(&form)) {
    whose = interpolated->quadratic ? "zone (-, -) of the octolinear law with these moduli"
                                    : "zone (-, -)";
    return zone_of(*interpolated);
  }
  if (!least.answered) return std::nullopt;
  const auto rate = sim::stress_rate(response, sim::angle_of(least.stress));
  if (!rate.controllable) return std::nullopt;
  whose = "tangent of the least direction";
  return sim::plane_compliance(response, rate);
}

const char* words_of(sim::ControlState state) {
  switch (state) {
    case sim::ControlState::held:
      return "held";
    case sim::ControlState::lost:
      return "lost";
    case sim::ControlState::unanswered:
      break;
  }
  return "no answer";
}

std::string unit_free(double value) { return fmt::format("{:.4g}", value); }

}  // namespace

std::vector<double> usual_ratios() {
  std::vector<double> ratios;
  for (int i = 1; i <= 30; ++i) ratios.push_back(i / 10.0);
  return ratios;
}

template <class Space>
ControlReport control_of(const sim::IncrementalResponse<Space>& response, const sim::Probe& least,
                         const std::vector<double>& R,
                         const std::vector<sim::NamedControl>& conditions) {
  ControlReport report;
  report.scan = sim::scan_control(response, R);
  auto search = sim::lost_control(response, kLeastRatio, kLargestRatio);
  report.lost = std::move(search.lost);
  report.asked = search.asked;
  report.unanswered = search.unanswered;
  if constexpr (Space::kSize == 2) {
    report.named = sim::control_indices(response, sim::triaxial_controls());
    report.conditions = sim::control_indices(response, conditions);
  }
  const auto compliance = compliance_of(response, least, report.compliance);
  if (!compliance) {
    report.compliance.clear();
    return report;
  }
  report.symmetric_determinant = compliance->symmetric_determinant();
  for (const double root : sim::control_quadratic(*compliance).roots())
    report.roots.push_back({root, sim::failure_angle(compliance->plane, root) + std::numbers::pi,
                            sim::failure_rule(*compliance, root)});
  return report;
}

template ControlReport control_of(const sim::IncrementalResponse<Axisymmetric>&, const sim::Probe&,
                                  const std::vector<double>&,
                                  const std::vector<sim::NamedControl>&);
template ControlReport control_of(const sim::IncrementalResponse<Tensor>&, const sim::Probe&,
                                  const std::vector<double>&,
                                  const std::vector<sim::NamedControl>&);

const char* sense_words(sim::ControlSense sense) {
  return sense == sim::ControlSense::loading ? "loading" : "unloading";
}

std::string lost_in_words(const ControlReport& control) {
  if (control.asked > 0 && control.unanswered == control.asked) return "unknown, no R was answered";
  const auto beyond = [](bool isolated, double R, double end, const char* word) {
    if (isolated) return std::string();
    return R == end ? fmt::format(" (and {})", word) : fmt::format(" (no answer {})", word);
  };
  std::string words;
  for (const auto sense : {sim::ControlSense::loading, sim::ControlSense::unloading}) {
    std::string ranges;
    for (const auto& at : control.lost)
      if (at.sense == sense)
        ranges += fmt::format("{}{}{} to {}{}", ranges.empty() ? "" : ", ", unit_free(at.from),
                              beyond(at.begins, at.from, kLeastRatio, "below"), unit_free(at.to),
                              beyond(at.ends, at.to, kLargestRatio, "above"));
    if (!ranges.empty())
      words +=
          fmt::format("{}{} lost for R {}", words.empty() ? "" : "; ", sense_words(sense), ranges);
  }
  if (words.empty())
    words = fmt::format("held for R {} to {}, loading and unloading", unit_free(kLeastRatio),
                        unit_free(kLargestRatio));
  if (control.unanswered > 0)
    words += fmt::format("; no answer to {} of {} controls", control.unanswered, control.asked);
  return words;
}

std::string roots_in_words(const ControlReport& control) {
  if (control.compliance.empty()) return "no compliance to write it with";
  std::string words;
  for (const auto& root : control.roots)
    words += fmt::format("{}R {} (α {}°, dε₁/dσ₃ {:.3e} 1/kPa)", words.empty() ? "" : ", ",
                         unit_free(root.R), in_degrees(root.angle), 1e3 * root.failure_rule);
  return (words.empty() ? "no real root" : words) + ", " + control.compliance;
}

Table scan_table(const ControlReport& control) {
  Table table;
  table.columns = {{"R", Align::right},           {"loading", Align::left},
                   {"index", Align::right},       {"unloading", Align::left},
                   {"index", Align::right},       {"mode α (°)", Align::right},
                   {"its W₂ norm.", Align::right}};
  for (const auto& at : control.scan)
    table.rows.push_back(
        {unit_free(at.R), words_of(at.loading.state), number(at.loading.index, 4),
         words_of(at.unloading.state), number(at.unloading.index, 4),
         in_degrees(at.mode.answered ? std::optional(at.mode.angle) : std::nullopt),
         number(at.mode.answered ? std::optional(at.mode.normalised) : std::nullopt, 4)});
  return table;
}

Table named_controls_table(const ControlReport& control) {
  Table table;
  table.columns = {{"programme", Align::left}, {"control", Align::left}, {"index", Align::right}};
  for (const auto& at : control.named)
    table.rows.push_back({at.name, words_of(at.answer.state), number(at.answer.index, 4)});
  return table;
}

std::string condition_words(const sim::ControlIndex& at) {
  std::string words = at.name + ": " + words_of(at.answer.state);
  if (at.answer.index) words += ", index " + number(at.answer.index, 4);
  if (!at.culprit.empty()) words += ", " + at.culprit + " cannot be held";
  return words;
}

std::string state_name(sim::ControlState state) {
  return state == sim::ControlState::unanswered ? "unanswered" : words_of(state);
}

}  // namespace triax::src

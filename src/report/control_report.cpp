#include "src/report/control_report.hpp"

#include <fmt/format.h>

#include <variant>

#include "sim/stability/proportional_control.hpp"
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

sim::PointRate<Axisymmetric> rate_of(const sim::IncrementalResponse<Axisymmetric>& response,
                                     const sim::PlaneVector& stress) {
  return response.to_stress({stress.y(), stress.x()});
}
sim::PointRate<Tensor> rate_of(const sim::IncrementalResponse<Tensor>& response,
                               const sim::PlaneVector& stress) {
  sim::MixedControl<Tensor> control;
  control.stress(0, 0) = control.stress(2, 2) = 1;
  control.increment << stress.y(), 0, stress.x(), 0, 0, 0;
  for (const int fixed : {1, 3, 4, 5}) control.strain(fixed, fixed) = 1;
  return response.to(control);
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
  const auto rate = rate_of(response, least.stress.normalized());
  if (!rate.controllable) return std::nullopt;
  whose = "tangent of the least direction";
  return sim::plane_compliance(response, rate);
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
                         const std::vector<double>& R) {
  ControlReport report;
  report.scan = sim::scan_control(response, R);
  report.lost = sim::lost_control(response, kLeastRatio, kLargestRatio);
  if constexpr (Space::kSize == 2)
    report.named = sim::control_indices(response, sim::triaxial_controls());
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
                                  const std::vector<double>&);
template ControlReport control_of(const sim::IncrementalResponse<Tensor>&, const sim::Probe&,
                                  const std::vector<double>&);

std::string lost_in_words(const ControlReport& control) {
  std::string words;
  for (const auto& [from, to, begins, ends] : control.lost)
    words += fmt::format("{}{}{} to {}{}", words.empty() ? "lost for R " : ", ", unit_free(from),
                         begins ? "" : " (and below)", unit_free(to), ends ? "" : " (and above)");
  return words.empty()
             ? fmt::format("held for R {} to {}", unit_free(kLeastRatio), unit_free(kLargestRatio))
             : words;
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
  table.columns = {{"R", Align::right},
                   {"control", Align::left},
                   {"index", Align::right},
                   {"mode α (°)", Align::right},
                   {"its W₂ norm.", Align::right}};
  for (const auto& at : control.scan)
    table.rows.push_back(
        {unit_free(at.R), at.controllable ? "held" : "lost", number(at.index, 4),
         in_degrees(at.mode.answered ? std::optional(at.mode.angle) : std::nullopt),
         number(at.mode.answered ? std::optional(at.mode.normalised) : std::nullopt, 4)});
  return table;
}

Table named_controls_table(const ControlReport& control) {
  Table table;
  table.columns = {{"programme", Align::left}, {"control", Align::left}, {"index", Align::right}};
  for (const auto& at : control.named)
    table.rows.push_back({at.name, at.controllable ? "held" : "lost", number(at.index, 4)});
  return table;
}

}  // namespace triax::src

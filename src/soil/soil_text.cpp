// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/soil/soil_text.hpp"

#include <fmt/format.h>

#include <cmath>

#include "src/output/table.hpp"
#include "src/output/terminal.hpp"
#include "src/output/words.hpp"
#include "src/output/wrapping.hpp"
#include "src/soil/soil_values.hpp"

namespace triax::src {
namespace {

std::string value_of(const std::optional<study::Estimate>& e, int decimals) {
  return number(e ? std::optional(e->value) : std::nullopt, decimals);
}

std::string critical_word(const study::TestPoints& t) {
  if (t.cyclic) return kUnknown;
  return std::string(to_string(t.critical.kind));
}

Table tests_table(const study::Soil& soil) {
  Table table;
  table.columns = {{"Test"},
                   {"Shear"},
                   {"e", Align::right},
                   {"p′₀ (kPa)", Align::right},
                   {"ψ₀", Align::right},
                   {"η peak", Align::right},
                   {"φ peak (°)", Align::right},
                   {"Critical state"},
                   {"η_c", Align::right},
                   {"p′_c (kPa)", Align::right},
                   {"e_c", Align::right},
                   {"Collapse"},
                   {"η onset", Align::right}};
  for (const auto& t : soil.tests) {
    if (!t.used) continue;
    const auto& c = t.critical;
    const bool critical = !t.cyclic && c.kind != study::CriticalKind::none;
    std::optional<double> peak, angle;
    if (t.peak_eta) {
      peak = t.peak_eta->eta();
      angle = study::friction_angle(study::measured(*peak, 0), t.extension).value;
    }
    table.rows.push_back(
        {t.name,
         fmt::format("{}{}",
                     t.cyclic    ? "cyclic"
                     : t.drained ? "drained"
                                 : "undrained",
                     t.extension ? ", extension" : ""),
         number(t.void_ratio, 3), number(t.p_eff_kPa, 0), value_of(t.state_parameter, 3),
         number(peak, 3), number(angle, 1), critical_word(t),
         number(critical ? std::optional(c.eta.value) : std::nullopt, 3),
         number(critical ? std::optional(std::exp(c.log_p.value)) : std::nullopt, 1),
         critical ? value_of(c.void_ratio, 3) : kUnknown,
         t.collapse ? spaced(std::string(lab::to_string(*t.collapse))) : kUnknown,
         value_of(t.onset_eta, 3)});
  }
  return table;
}

Table values_table(const study::Soil& soil) {
  Table table;
  table.columns = {{"Value"}, {"", Align::right}, {"95 % interval"}, {"Tests", Align::right}};
  for (const auto& v : soil_values(soil)) {
    const bool held = v.estimate.low == v.estimate.high;
    table.rows.push_back({v.name, number(v.estimate.value, v.decimals),
                          held ? "held"
                               : fmt::format("{} to {}", number(v.estimate.low, v.decimals),
                                             number(v.estimate.high, v.decimals)),
                          fmt::format("{}", v.estimate.tests)});
  }
  return table;
}

/// Hanging behind its dash.
std::string item(const std::string& text) {
  std::string out;
  for (const auto& line : wrapped(text, text_width() - 4))
    out += (out.empty() ? "  - " : "    ") + line + "\n";
  return out;
}

}  // namespace

std::string with_interval(const study::Estimate& e, int decimals) {
  return fmt::format("{} ({} to {})", number(e.value, decimals), number(e.low, decimals),
                     number(e.high, decimals));
}

std::string soil_text(const study::Soil& soil) {
  std::size_t used = 0, simulated = 0;
  for (const auto& t : soil.tests) used += t.used, simulated += t.used && t.simulated;
  const std::string title = fmt::format(
      "{}: {} test{}{}", soil.group.empty() ? "Soil" : soil.group, used, used == 1 ? "" : "s",
      simulated == 0      ? ""
      : simulated == used ? ", all simulated"
                          : fmt::format(", {} simulated", simulated));
  std::string out = on_one_line(title) + "\n" + std::string(display_width(title), '=') + "\n\n";
  if (const Table values = values_table(soil); !values.rows.empty())
    out += indented(to_text(values)) + "\n";
  out += indented(to_text(tests_table(soil)));
  std::string notes;
  for (const auto& t : soil.tests)
    if (!t.used) notes += item(fmt::format("{} (test {}) is not used: {}", t.name, t.id, t.reason));
  for (const auto& note : soil.notes) notes += item(note);
  if (!notes.empty()) out += "\n" + notes;
  return out;
}

}  // namespace triax::src

// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/calibrate/calibrate_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "src/calibrate/implied_domain_text.hpp"
#include "src/output/table.hpp"
#include "src/output/words.hpp"

namespace triax::src {
namespace {

using study::Calibration;

constexpr double kStrong = 0.9;  // correlation that is told

std::string symbol_of(const Calibration& c, const std::string& key) {
  for (const auto& p : c.material.law->parameters)
    if (p.key == key) return p.symbol;
  return "";
}

std::string parameters(const Calibration& c) {
  Table table{{{"Parameter"},
               {"symbol"},
               {"value", Align::right},
               {"from", Align::right},
               {"to", Align::right},
               {"remark"}},
              {}};
  for (const auto& p : c.parameters)
    table.rows.push_back({p.key, symbol_of(c, p.key), fmt::format("{:.5g}", p.value),
                          p.determined ? fmt::format("{:.5g}", p.low) : kUnknown,
                          p.determined ? fmt::format("{:.5g}", p.high) : kUnknown,
                          std::string(p.determined ? "" : "not determined") +
                              (p.at_bound ? " (at its bound)" : "")});
  return fmt::format("Parameters, with {:.0f} % intervals\n", 100 * c.confidence) +
         indented(to_text(table));
}

std::string correlations(const Calibration& c) {
  std::string out;
  for (std::size_t i = 0; i < c.parameters.size(); ++i)
    for (std::size_t j = i + 1; j < c.parameters.size(); ++j) {
      const double r = c.correlation(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j));
      if (std::abs(r) >= kStrong)
        out += fmt::format("  {} and {}: {:.2f}\n", c.parameters[i].key, c.parameters[j].key, r);
    }
  return out.empty() ? "" : "\nCorrelated beyond 0.9\n" + out;
}

std::string searches(const Calibration& c) {
  std::string out = fmt::format("  cost        {:.4g}", c.cost);
  if (c.start_cost) out += fmt::format("; of the start {}: {:.4g}", c.start.name, *c.start_cost);
  out += fmt::format("\n              (1: each quantity deviates by 2 % of its span)\n");
  out += fmt::format("  searches    {} of {} ended at this optimum\n", c.ended_at_best, c.searches);
  for (std::size_t k = 1; k < c.optima.size(); ++k) {
    out += fmt::format("  as good     cost {:.4g} at", c.optima[k].cost);
    for (std::size_t i = 0; i < c.parameters.size(); ++i)
      out += fmt::format(" {}={:.4g}", c.parameters[i].key, c.optima[k].values[i]);
    out += "\n";
  }
  return out;
}

std::string in_own_unit(const study::SeriesMisfit& m, double value) {
  const bool stress = m.quantity == study::Compared::q || m.quantity == study::Compared::p_eff;
  return stress ? fmt::format("{:.2f} kPa", value / 1e3) : fmt::format("{:.3f} %", 100 * value);
}

std::string misfits(const Calibration& c) {
  Table table{{{"Test"},
               {"quantity"},
               {"misfit (rms)", Align::right},
               {"noise", Align::right},
               {"cost", Align::right},
               {"remark"}},
              {}};
  for (const auto& m : c.misfits)
    table.rows.push_back(
        {m.test, std::string(to_string(m.quantity)), in_own_unit(m, m.rms), in_own_unit(m, m.noise),
         fmt::format("{:.3g}", m.cost),
         m.refusal.empty() ? "" : fmt::format("ends at {:.0f} %: {}", 100 * m.reached, m.refusal)});
  return "\nMisfit\n" + indented(to_text(table));
}

std::string predictions(const Calibration& c) {
  if (c.predictions.empty()) return "";
  Table table{{{"Test"},
               {"η measured", Align::right},
               {"η predicted", Align::right},
               {"from", Align::right},
               {"to", Align::right},
               {""}},
              {}};
  for (const auto& p : c.predictions)
    table.rows.push_back({p.test, number(p.measured, 3), number(p.predicted, 3),
                          p.predicted ? number(p.low, 3) : kUnknown,
                          p.predicted ? number(p.high, 3) : kUnknown,
                          !p.predicted ? "the law does not collapse there"
                          : p.holds()  ? ""
                                       : "outside"});
  return "\nη at collapse, each test from the others, with 90 % intervals\n" +
         indented(to_text(table));
}

}  // namespace

std::string calibrate_text(const Calibration& c) {
  const std::string title = fmt::format("{} from {} test{}", c.material.law->name,
                                        c.measured.size(), c.measured.size() == 1 ? "" : "s");
  std::string out = fmt::format("{}\n{}\n", title, std::string(title.size(), '='));
  if (c.interrupted)
    out +=
        "INTERRUPTED: the best result so far; a complete search can find a better one, and values "
        "missing below were not computed\n";
  out += searches(c) + "\n" + parameters(c) + correlations(c) + misfits(c) + predictions(c);
  if (c.domain) out += implied_domain_text(*c.domain);
  if (!c.notes.empty()) out += "\nNotes\n";
  for (const auto& note : c.notes) out += "  " + note + "\n";
  return out;
}

}  // namespace triax::src

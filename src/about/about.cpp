// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/about/about.hpp"

#include <fmt/format.h>

#include <memory>
#include <span>

#include "lab/collapse/assessment_rules.hpp"
#include "lab/health/sensor_limits.hpp"
#include "lab/measured/assessment_limits.hpp"
#include "lab/warning/warning_limits.hpp"
#include "sim/mechanics/units.hpp"
#include "src/output/output.hpp"
#include "src/output/table.hpp"
#include "src/output/terminal.hpp"
#include "src/output/wrapping.hpp"
#include "src/study/version.hpp"

namespace triax::src {
namespace {

std::string about_text() {
  return fmt::format(
      "triax {}\nTriaxial tests on soil: records, simulation, rigs, instability.\n"
      "Science:  F. Darve, L. Sibille, A. Daouadji, F. Nicot, Bifurcations in granular media,\n"
      "          C. R. Mecanique 335 (2007)\n"
      "Licence:  GPL-3.0-or-later, without any warranty\n",
      study::version());
}

std::string part_of_rule(const char* label, std::string_view text) {
  constexpr std::size_t kIndent = 10;
  std::string out;
  for (const std::string& line : wrapped(std::string(text), text_width() - kIndent))
    out += fmt::format("    {:<4}  {}\n", out.empty() ? label : "", line);
  return out;
}

std::string value_of(const lab::Limit& limit) {
  const auto unit = sim::find_unit(limit.unit);
  return fmt::format("{:.4g}{}{}", limit.value / (unit ? unit->scale : 1),
                     limit.unit.empty() ? "" : " ", limit.unit);
}

std::string reason_of(const lab::Limit& limit) {
  return limit.origin.empty() ? std::string(limit.reason)
                              : fmt::format("{} ({})", limit.reason, limit.origin);
}

std::string limits_text(const char* title, std::span<const lab::Limit> limits) {
  Table table{.columns = {{"limit"}, {"value", Align::right}, {"reason (origin)"}}};
  for (const lab::Limit& limit : limits)
    table.rows.push_back({std::string(limit.name), value_of(limit), reason_of(limit)});
  return fmt::format("\n{}\n\n{}", title, to_text(table));
}

}  // namespace

std::string rules_text() {
  std::string out =
      "Rules of an assessment, applied once from top to bottom, each to the result of those "
      "above.\n\n";
  int number = 0;
  for (const lab::AssessmentRule& rule : lab::assessment_rules()) {
    out += fmt::format("{:2}  {}\n", ++number, rule.name);
    out += part_of_rule("if", rule.condition);
    out += part_of_rule("then", rule.result);
  }
  return out + limits_text("Limits of the assessment", lab::assessment_limits::kAll) +
         limits_text("Limits of sensors and states", lab::sensor_limits::kAll) +
         limits_text("Limits of warnings", lab::warning_limits::kAll);
}

Command about_command() {
  return {.name = "about",
          .purpose = "Print the version, the licence and the rules of an assessment",
          .description = {"With --rules, prints the table of rules that makes the result of an "
                          "assessment from what was found in a test, and the limits of "
                          "assessments, sensors and warnings."},
          .diagnostics = {{"unexpected argument 'ARGUMENT'; ...", "use no argument but --rules"}},
          .examples = {{"triax about", "print version and licence"},
                       {"triax about --rules", "print the rules of an assessment"}},
          .set_up = [](CLI::App& app) -> std::function<void()> {
            const auto rules = std::make_shared<bool>(false);
            app.add_flag("--rules", *rules, "print the rules of an assessment and all limits");
            return [rules] { print(*rules ? rules_text() : about_text()); };
          }};
}

}  // namespace triax::src

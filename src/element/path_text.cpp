// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/element/path_text.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "src/element/path_words.hpp"
#include "src/output/table.hpp"
#include "src/output/words.hpp"

namespace triax::src {
namespace {

constexpr std::size_t kRowsOfText = 20;

std::string percent_of(const study::PathResult& path, const study::ResultPoint& at,
                       const char* column) {
  const auto value = path.value(at, column);
  return number(value ? std::optional(100 * *value) : std::nullopt, 3);
}

std::string state_line(const study::PathResult& path, const study::ResultPoint& at) {
  const auto eta = path.told_eta(at);
  return fmt::format("ε₁ {} %, q {} kPa, p′ {} kPa, u {} kPa", percent_of(path, at, "axial_strain"),
                     number(path.value(at, "q_kPa"), 2), number(path.value(at, "p_eff_kPa"), 2),
                     number(path.value(at, "pore_pressure_kPa"), 2)) +
         (eta ? ", η " + number(eta, 4) : "");
}

Table rows_table(const study::PathResult& path) {
  Table table;
  table.columns = {
      {"segment", Align::left},  {"ε₁ (%)", Align::right},   {"ε_v (%)", Align::right},
      {"q (kPa)", Align::right}, {"p′ (kPa)", Align::right}, {"u (kPa)", Align::right},
      {"η", Align::right},       {"e", Align::right},        {"W₂ norm.", Align::right}};
  const std::size_t count = path.rows.size(), shown = std::min(count, kRowsOfText);
  for (std::size_t i = 0; i < shown; ++i) {
    // Evenly spread, first and last among them.
    const auto& row = path.rows[shown == 1 ? 0 : i * (count - 1) / (shown - 1)];
    table.rows.push_back(
        {row.segment, percent_of(path, row, "axial_strain"),
         percent_of(path, row, "volumetric_strain"), number(path.value(row, "q_kPa"), 2),
         number(path.value(row, "p_eff_kPa"), 2), number(path.value(row, "pore_pressure_kPa"), 2),
         number(path.told_eta(row), 4), number(path.value(row, "void_ratio"), 5),
         number(path.value(row, "second_order_work_normalised"), 4)});
  }
  return table;
}

std::string event_words(const study::ResultEvent& event) {
  switch (event.kind) {
    case sim::PathEventKind::end_condition:
      return event.what + ": the segment ends";
    case sim::PathEventKind::second_order_work:
      return "second-order work turns negative";
    case sim::PathEventKind::peak:
      return "peak of " + event.what;
    case sim::PathEventKind::control_limit:
      break;
  }
  return "control of " + event.what + " is lost";
}

}  // namespace

std::string path_text(const study::PathResult& path) {
  const std::string title = on_one_line(path.name + " (simulated, one material point)");
  std::string out = title + '\n' + std::string(display_width(title), '=') + '\n';
  const auto fact = [&out](const char* label, const std::string& value) {
    if (!value.empty()) out += fmt::format("  {:<12}{}\n", label, on_one_line(value));
  };
  fact("material", path.material.name);
  fact("based on", path.material.material.based_on);
  fact("source", path.material.source);
  fact("range", path.material.range);
  fact("start",
       fmt::format("p′ {} kPa, q {} kPa, e {}", number(path.value(path.start, "p_eff_kPa"), 2),
                   number(path.value(path.start, "q_kPa"), 2),
                   number(path.value(path.start, "void_ratio"), 4)));
  out += '\n' + indented(to_text(rows_table(path))) + '\n';
  for (const auto& event : path.events)
    out += fmt::format("  {}\n      {}\n", on_one_line(event_words(event)),
                       state_line(path, event.at));
  if (path.peak) out += fmt::format("  largest |q|\n      {}\n", state_line(path, *path.peak));
  if (path.peak || !path.events.empty()) out += '\n';
  for (const auto& warning : path.warnings) fact("warning", warning);
  fact("outcome", path.message.empty() ? "completed" : word_of(path.outcome) + ": " + path.message);
  return without_controls(out);
}

}  // namespace triax::src

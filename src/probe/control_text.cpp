// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/probe/control_text.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "src/output/words.hpp"

namespace triax::src {
namespace {

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

const char* sense_words(sim::ControlSense sense) {
  return sense == sim::ControlSense::loading ? "loading" : "unloading";
}

std::string lost_in_words(const study::Controllability& control) {
  if (control.asked > 0 && control.unanswered == control.asked)
    return "unknown, no result for any R";
  const auto beyond = [](bool isolated, double R, double end, const char* word) {
    if (isolated) return std::string();
    return R == end ? fmt::format(" (and {})", word) : fmt::format(" (no answer {})", word);
  };
  std::string words;
  for (const auto sense : {sim::ControlSense::loading, sim::ControlSense::unloading}) {
    std::string ranges;
    for (const auto& at : control.lost)
      if (at.sense == sense)
        ranges +=
            fmt::format("{}{}{} to {}{}", ranges.empty() ? "" : ", ", unit_free(at.from),
                        beyond(at.begins, at.from, study::kLeastRatio, "below"), unit_free(at.to),
                        beyond(at.ends, at.to, study::kLargestRatio, "above"));
    if (!ranges.empty())
      words +=
          fmt::format("{}{} lost for R {}", words.empty() ? "" : "; ", sense_words(sense), ranges);
  }
  if (words.empty())
    words = fmt::format("held for R {} to {}, loading and unloading", unit_free(study::kLeastRatio),
                        unit_free(study::kLargestRatio));
  if (control.unanswered > 0)
    words += fmt::format("; no result for {} of {} controls", control.unanswered, control.asked);
  return words;
}

std::string roots_in_words(const study::Controllability& control) {
  if (control.asked > 0 && control.unanswered == control.asked)
    return "unknown, no result for any R";
  const auto& roots = control.roots;
  const std::string among =
      control.unanswered_directions > 0 ? " in the directions with a result" : "";
  if (roots.empty()) return "no real root" + among;
  const bool of_one = std::ranges::all_of(
      roots, [&](const auto& root) { return root.compliance == roots.front().compliance; });
  std::string words;
  for (const auto& [root, compliance] : roots)
    words += fmt::format("{}R {} (α {}°, dε₁/dσ₃ {:.3e} 1/kPa{})", words.empty() ? "" : ", ",
                         unit_free(root.R), in_degrees(root.angle), 1e3 * root.failure_rule,
                         of_one ? "" : ", " + compliance);
  return words + (of_one ? ", " + roots.front().compliance : "") + among;
}

Table scan_table(const study::Controllability& control) {
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

Table named_controls_table(const study::Controllability& control) {
  Table table;
  table.columns = {{"programme", Align::left}, {"control", Align::left}, {"index", Align::right}};
  for (const auto& at : control.named)
    table.rows.push_back({at.name, words_of(at.answer.state), number(at.answer.index, 4)});
  return table;
}

std::string condition_words(const sim::ControlIndex& at) {
  std::string words = at.name + ": " + words_of(at.answer.state);
  if (at.answer.index) words += ", index " + number(at.answer.index, 4);
  if (!at.limiting_variable.empty()) words += ", " + at.limiting_variable + " cannot be held";
  return words;
}

std::string state_name(sim::ControlState state) {
  return state == sim::ControlState::unanswered ? "unanswered" : words_of(state);
}

}  // namespace triax::src

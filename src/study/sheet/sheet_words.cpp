// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/study/sheet/sheet_words.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <initializer_list>
#include <utility>

#include "lab/base/bad_input.hpp"
#include "lab/base/text.hpp"
#include "lab/results/labels.hpp"

namespace triax::study {
namespace {

/// Beside the labels that a test can have (lab/results/labels.hpp).
constexpr std::array kOtherWords = {
    SheetWord{"drained_at", "Drained at"},
    SheetWord{"mass_g", "Mass as built (g)"},
    SheetWord{"water_content_pct", "Water content as built (%)"},
    SheetWord{"mass_after_g", "Mass after (g)"},
    SheetWord{"dry_mass_after_g", "Dry mass after (g)"},
    SheetWord{"water_content_after_pct", "Water content after (%)"},
    SheetWord{"failure_mode", "Mode of failure"},
    SheetWord{"top_drain", "Top drain"},
    SheetWord{"base_drain", "Base drain"},
    SheetWord{"side_drains", "Side drains"},
    SheetWord{"drain_load_kN_m", "K_fp of the side drains (kN/m)"},
    SheetWord{"drain_cover_pct", "Circumference under side drains (%)"},
    SheetWord{"load_cell", "Load cell"},
    SheetWord{"load_zero_kPa", "Cell pressure at which the load was zeroed (kPa)"},
    SheetWord{"piston_diameter_mm", "Diameter of the piston (mm)"},
    SheetWord{"piston_mass_g", "Mass below the load cell (g)"},
    SheetWord{"piston_friction_N", "Friction of the piston (N)"},
};

/// Labels of preambles, folded and without a bracket at their end.
constexpr std::array<std::pair<std::string_view, std::string_view>, 50> kLabels{
    {{"project", "project"},
     {"projekt", "project"},
     {"job reference", "project"},
     {"job ref", "project"},
     {"job number", "project"},
     {"job", "project"},
     {"job location", "location"},
     {"location", "location"},
     {"site", "location"},
     {"borehole", "borehole"},
     {"bohrung", "borehole"},
     {"sample name", "sample"},
     {"sample", "sample"},
     {"probe", "sample"},
     {"depth", "depth"},
     {"tiefe", "depth"},
     {"description of sample", "description"},
     {"soil", "description"},
     {"boden", "description"},
     {"bodenart", "description"},
     {"material", "description"},
     {"specimen type", "specimen_type"},
     {"preparation method", "specimen_type"},
     {"laboratory", "laboratory"},
     {"lab", "laboratory"},
     {"labor", "laboratory"},
     {"operator", "operator"},
     {"technician", "operator"},
     {"tested by", "operator"},
     {"bearbeiter", "operator"},
     {"date test started", "date"},
     {"date of test", "date"},
     {"test date", "date"},
     {"date", "date"},
     {"datum", "date"},
     {"date test finished", "date_end"},
     {"checked by", "checked"},
     {"initial mass", "mass_g"},
     {"initial moisture content", "water_content_pct"},
     {"final mass", "mass_after_g"},
     {"final dry mass", "dry_mass_after_g"},
     {"final moisture content", "water_content_after_pct"},
     {"failure mode", "failure_mode"},
     {"mode of failure", "failure_mode"},
     {"remarks", "remarks"},
     {"auftraggeber", "client"},
     {"top drain used", "top_drain"},
     {"base drain used", "base_drain"},
     {"side drains used", "side_drains"},
     {"ram diameter", "piston_diameter_mm"}}};

std::string_view key_of_label(const std::string& label) {
  auto text = lab::folded(label.substr(0, label.find('(')));
  if (text.ends_with(':')) text.pop_back();
  const auto* const found =
      std::ranges::find(kLabels, text, [](const auto& row) { return row.first; });
  return found == kLabels.end() ? std::string_view() : found->second;
}

/// A number that a correction rests on, and its bounds.
struct Bound {
  std::string_view key;
  double least, most;
};
constexpr std::array kBounds = {
    Bound{"drain_load_kN_m", 0, 10}, Bound{"drain_cover_pct", 0, 50},
    Bound{"load_zero_kPa", 0, 1e5},  Bound{"piston_diameter_mm", 0, 300},
    Bound{"piston_mass_g", 0, 1e5},  Bound{"piston_friction_N", 0, 1e4},
};

/// Empty where nothing is.
std::string what_is_wrong(const SaidWord& said) {
  const auto is_one_of = [&](std::initializer_list<std::string_view> words) {
    return std::ranges::find(words, lab::folded(said.value)) != words.end();
  };
  if (said.key == "drained_at" && !drainage_boundary_from(said.value))
    return "must be one of: one end, both ends, sides, sides and one end, sides and both ends";
  if (said.key == "load_cell" && !is_one_of({"inside", "outside"}))
    return "must be one of: inside, outside";
  if (said.key == "side_drains" && !is_one_of({"yes", "no", "y", "n", "vertical", "spiral"}))
    return "must be one of: yes, no, vertical, spiral";
  for (const auto& bound : kBounds) {
    if (said.key != bound.key) continue;
    const auto number = number_of({{said.key, said.value}}, said.key);
    if (!number || !(*number >= bound.least && *number <= bound.most))
      return fmt::format("expected a number from {:g} to {:g}", bound.least, bound.most);
  }
  return {};
}

}  // namespace

std::span<const SheetWord> sheet_word_list() {
  static const std::vector<SheetWord> words = [] {
    std::vector<SheetWord> all(lab::label_keys().begin(), lab::label_keys().end());
    all.insert(all.end(), kOtherWords.begin(), kOtherWords.end());
    return all;
  }();
  return words;
}

SaidWord said_word(const std::string& key, const std::string& value) {
  SaidWord said{.test = {}, .key = key, .value = value};
  if (const auto slash = key.rfind('/'); slash != std::string::npos)
    said = {key.substr(0, slash), key.substr(slash + 1), value};
  std::vector<std::string> known;
  known.reserve(sheet_word_list().size());
  for (const auto& word : sheet_word_list()) known.emplace_back(word.key);
  if (std::ranges::find(known, said.key) == known.end())
    throw lab::BadInput(
        fmt::format("--set {}: unknown key; {}", key, lab::suggestion(said.key, known)));
  if (const auto wrong = what_is_wrong(said); !wrong.empty())
    throw lab::BadInput(fmt::format("--set {}={}: {}", key, value, wrong));
  return said;
}

SheetWords sheet_words(const db::StoredTest& test, const std::vector<SaidWord>& said) {
  SheetWords words;
  for (const auto& note : test.header.notes) {
    const auto key = key_of_label(note.label);
    if (!key.empty() && !note.text.empty()) words.emplace(key, note.text);
  }
  if (!test.header.specimen.material.empty()) words["description"] = test.header.specimen.material;
  for (const lab::LabelKey& label : lab::label_keys())
    if (auto text = lab::label_text(test.header, label); !text.empty())
      words[std::string(label.key)] = std::move(text);
  for (const auto& one : said)
    if (one.test.empty() || one.test == test.header.name || one.test == std::to_string(test.id))
      words[one.key] = one.value;
  return words;
}

std::string word_of(const SheetWords& words, std::string_view key) {
  const auto found = words.find(key);
  return found == words.end() ? std::string() : found->second;
}

std::optional<double> number_of(const SheetWords& words, std::string_view key) {
  auto text = word_of(words, key);
  std::ranges::replace(text, ',', '.');
  const auto value = lab::whole_text_as<double>(text);
  return value && std::isfinite(*value) ? value : std::nullopt;
}

bool says_yes(const SheetWords& words, std::string_view key) {
  const auto text = lab::folded(word_of(words, key));
  return text.starts_with('y') || text.starts_with('j') || text == "1" || text == "true";
}

std::optional<DrainageBoundary> drained_at(const SheetWords& words) {
  if (const auto said = drainage_boundary_from(word_of(words, "drained_at"))) return said;
  const int ends = (says_yes(words, "top_drain") ? 1 : 0) + (says_yes(words, "base_drain") ? 1 : 0);
  using enum DrainageBoundary;
  if (says_yes(words, "side_drains"))
    return ends == 2 ? sides_and_both_ends : ends == 1 ? sides_and_one_end : sides;
  if (ends == 0) return std::nullopt;
  return ends == 2 ? both_ends : one_end;
}

}  // namespace triax::study

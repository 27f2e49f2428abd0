// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/study/handover/ags_references.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>
#include <utility>

#include "lab/ags/ags_data_type.hpp"
#include "lab/base/bad_input.hpp"
#include "lab/base/text.hpp"
#include "lab/results/labels.hpp"

namespace triax::study {
namespace {

/// Groups that can be told something by --set.
constexpr std::array kToldGroups{"PROJ", "TRAN", "LOCA", "SAMP", "TREG",
                                 "TRET", "TRIG", "TRIT", "CTRG", "CTRC"};

/// Labels of preambles beside the names of AGS4 themselves, folded.
constexpr std::array<std::pair<std::string_view, std::string_view>, 8> kLabels{
    {{"borehole", "LOCA_ID"},
     {"bohrung", "LOCA_ID"},
     {"sample name", "SAMP_REF"},
     {"sample", "SAMP_REF"},
     {"probe", "SAMP_REF"},
     {"depth", "SAMP_TOP"},
     {"tiefe", "SAMP_TOP"},
     {"test number", "SPEC_REF"}}};

/// Labels of a test, stronger than a preamble.
constexpr std::array<std::pair<std::string_view, std::string_view>, 3> kOfLabels{
    {{"borehole", "LOCA_ID"}, {"sample", "SAMP_REF"}, {"depth", "SAMP_TOP"}}};

constexpr std::array kKeys{"LOCA_ID", "SAMP_TOP", "SAMP_REF", "SAMP_TYPE",
                           "SAMP_ID", "SPEC_REF", "SPEC_DPTH"};

std::string heading_of_label(std::string_view label) {
  const auto text = lab::folded(label);
  for (const char* const key : kKeys)
    if (lab::folded(key) == text) return key;
  for (const auto& [word, heading] : kLabels)
    if (word == text) return std::string(heading);
  return {};
}

bool is_depth(const std::string& heading) {
  return heading == "SAMP_TOP" || heading == "SPEC_DPTH";
}

/// Metres of a preamble's depth: "4.55", "4,55", "4.55 m"; as it stands where it is no number.
std::string depth(std::string text) {
  if (text.ends_with("m")) text = lab::trimmed(std::string_view(text).substr(0, text.size() - 1));
  std::ranges::replace(text, ',', '.');
  const auto metres = lab::whole_text_as<double>(text);
  return metres && std::isfinite(*metres) ? ags_cell(text, "2DP") : std::string();
}

}  // namespace

std::string ags_cell(const std::string& value, const std::string& type) {
  const auto number = lab::whole_text_as<double>(value);
  if (!number || !std::isfinite(*number)) return value;
  const auto as_typed = lab::ags_number(number, type);
  return lab::whole_text_as<double>(as_typed) == number && type.ends_with("DP") ? as_typed : value;
}

AgsSaid ags_said(const std::string& key, const std::string& value) {
  AgsSaid said{.heading = key, .value = value};
  if (const auto slash = key.rfind('/'); slash != std::string::npos)
    said = {.test = key.substr(0, slash), .heading = key.substr(slash + 1), .value = value};
  std::vector<std::string> known;
  for (const char* const group : kToldGroups) {
    if (ags_heading(group, said.heading) != nullptr) return said;
    for (const auto& one : lab::ags_definition(group)->headings)
      if (std::ranges::find(known, one.heading) == known.end()) known.push_back(one.heading);
  }
  const auto near = lab::nearest(said.heading, known);
  throw lab::BadInput(
      fmt::format("--set {}: unknown key; expected a heading of PROJ, TRAN, LOCA, SAMP or the "
                  "triaxial groups of AGS4 4.1.1{}",
                  key, near.empty() ? "" : "; did you mean '" + near + "'?"));
}

bool is_of(const AgsSaid& said, const db::StoredTest& test) {
  return said.test.empty() || said.test == test.header.name || said.test == std::to_string(test.id);
}

AgsCells ags_references(const db::StoredTest& test, const std::vector<AgsSaid>& said) {
  AgsCells keys;
  for (const lab::Note& note : test.header.notes) {
    const auto heading = heading_of_label(note.label);
    if (heading.empty() || note.text.empty()) continue;
    keys[heading] = is_depth(heading) ? depth(note.text) : note.text;
  }
  for (const auto& [key, heading] : kOfLabels)
    if (auto text = lab::label_text(test.header, *lab::find_label(key)); !text.empty())
      keys[std::string(heading)] = is_depth(std::string(heading)) ? depth(text) : std::move(text);
  keys.try_emplace("SPEC_REF", lab::ags_ascii(test.header.name));
  for (const AgsSaid& one : said)
    if (is_of(one, test) && std::ranges::find(kKeys, one.heading) != kKeys.end())
      keys[one.heading] = is_depth(one.heading) ? ags_cell(one.value, "2DP") : one.value;
  return keys;
}

}  // namespace triax::study

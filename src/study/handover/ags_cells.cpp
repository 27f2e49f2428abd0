// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/study/handover/ags_cells.hpp"

#include <algorithm>
#include <array>
#include <utility>

namespace triax::study {
namespace {

constexpr std::array kOrder{"PROJ", "TRAN", "UNIT", "TYPE", "ABBR", "DICT", "LOCA", "SAMP",
                            "TREG", "TRET", "TRIG", "TRIT", "CTRG", "CTRC", "CTRP", "CTRD"};

std::vector<lab::AgsDefinition> headings_of(const std::string& group) {
  std::vector<lab::AgsDefinition> headings = lab::ags_definition(group)->headings;
  for (const AgsUserHeading& own : ags_user_headings())
    if (own.group == group) headings.push_back(own.definition);
  return headings;
}

std::string value_of(const AgsCells& cells, const std::string& heading) {
  const auto found = cells.find(heading);
  return found == cells.end() ? std::string() : found->second;
}

}  // namespace

const std::vector<AgsUserHeading>& ags_user_headings() {
  static const std::vector<AgsUserHeading> headings = [] {
    std::vector<AgsUserHeading> all;
    for (const std::string group : {"TRET", "CTRG"}) {
      all.push_back({group,
                     {.heading = group + "_ETAC", .type = "3DP"},
                     "Stress ratio q/p' at which second-order work vanished (onset of collapse)"});
      all.push_back({group,
                     {.heading = group + "_ETAL", .type = "3DP"},
                     "Stress ratio q/p' at the loss of control (start of the runaway)"});
      all.push_back({group,
                     {.heading = group + "_KIND", .type = "X"},
                     "Collapse: flow, partial, limited, cyclic_mobility, none, or not assessed"});
    }
    return all;
  }();
  return headings;
}

const lab::AgsDefinition* ags_heading(const std::string& group, const std::string& heading) {
  const lab::AgsGroupDefinition* const definition = lab::ags_definition(group);
  if (definition == nullptr) return nullptr;
  if (const auto* const found = definition->find(heading)) return found;
  for (const AgsUserHeading& own : ags_user_headings())
    if (own.group == group && own.definition.heading == heading) return &own.definition;
  return nullptr;
}

void AgsRows::add(const std::string& group, AgsCells cells) {
  rows_[group].push_back(std::move(cells));
}

void AgsRows::add_once(const std::string& group, AgsCells cells) {
  const auto headings = headings_of(group);
  const bool there = std::ranges::any_of(rows_[group], [&](const AgsCells& row) {
    return std::ranges::all_of(headings, [&](const lab::AgsDefinition& one) {
      return !one.key || value_of(row, one.heading) == value_of(cells, one.heading);
    });
  });
  if (!there) add(group, std::move(cells));
}

lab::AgsDocument AgsRows::document() const {
  lab::AgsDocument document;
  for (const char* const name : kOrder) {
    const auto found = rows_.find(name);
    if (found == rows_.end() || found->second.empty()) continue;
    lab::AgsTable table{.name = name};
    for (const lab::AgsDefinition& one : headings_of(name)) {
      const bool filled = std::ranges::any_of(
          found->second, [&](const AgsCells& row) { return !value_of(row, one.heading).empty(); });
      if (one.key || one.required || filled)
        table.headings.push_back({one.heading, one.unit, one.type});
    }
    for (const AgsCells& cells : found->second) {
      lab::AgsRow row;
      for (const auto& heading : table.headings) row.push_back(value_of(cells, heading.name));
      table.rows.push_back(std::move(row));
    }
    document.tables.push_back(std::move(table));
  }
  return document;
}

}  // namespace triax::study

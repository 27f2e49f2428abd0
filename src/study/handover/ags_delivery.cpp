// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/study/handover/ags_delivery.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <set>
#include <sstream>

#include "lab/ags/ags_rules.hpp"
#include "lab/base/bad_input.hpp"
#include "src/study/handover/ags_codes.hpp"

namespace triax::study {
namespace {

/// Groups whose rows a test brings, its specimen's own first.
constexpr std::array kTestGroups{"LOCA", "SAMP", "TREG", "TRET", "TRIG", "TRIT", "CTRG", "CTRC"};

AgsCells project_cells() { return {{"PROJ_ID", "not stated"}}; }

AgsCells transmission_cells(const std::string& date) {
  return {{"TRAN_ISNO", "1"},     {"TRAN_DATE", date},   {"TRAN_PROD", "not stated"},
          {"TRAN_STAT", "Draft"}, {"TRAN_AGS", "4.1.1"}, {"TRAN_RECV", "not stated"},
          {"TRAN_DLIM", "|"},     {"TRAN_RCON", "+"}};
}

AgsCells picked(const AgsCells& keys, const std::vector<std::string>& names) {
  AgsCells out;
  for (const auto& name : names)
    if (const auto found = keys.find(name); found != keys.end()) out.insert(*found);
  return out;
}

void put_said(AgsCells& cells, const std::string& group, const AgsSaid& said) {
  const auto* const definition = ags_heading(group, said.heading);
  if (definition != nullptr) cells[said.heading] = ags_cell(said.value, definition->type);
}

/// A heading that several groups have as a key is of the specimen; any other of each group that has
/// it.
void add_test(AgsRows& all, const AgsTest& test, const std::vector<AgsSaid>& said) {
  const AgsCells keys = ags_references(test.stored, said);
  AgsRows rows;
  rows.add("LOCA", picked(keys, {"LOCA_ID"}));
  rows.add("SAMP", picked(keys, {"LOCA_ID", "SAMP_TOP", "SAMP_REF", "SAMP_TYPE", "SAMP_ID"}));
  if (test.stored.summary.cyclic)
    add_cyclic_rows(rows, test, keys);
  else if (test.stored.header.is_total_stress())
    add_total_stress_rows(rows, test, keys);
  else
    add_triaxial_rows(rows, test, keys);
  for (const auto& [group, list] : rows.all())
    for (AgsCells cells : list) {
      if (std::ranges::find(kTestGroups, group) != kTestGroups.end())
        for (const AgsSaid& one : said)
          if (is_of(one, test.stored) && !keys.contains(one.heading)) put_said(cells, group, one);
      if (group == "LOCA" || group == "SAMP")
        all.add_once(group, std::move(cells));
      else
        all.add(group, std::move(cells));
    }
}

/// Two tests of one specimen, or two whose references nobody said, keep apart by SPEC_REF.
void make_keys_unique(std::vector<AgsTest>& tests) {
  std::set<std::string> seen;
  for (AgsTest& test : tests) {
    std::string& name = test.stored.header.name;
    if (!seen.insert(name).second) {
      name = fmt::format("{} ({})", name, test.stored.id);
      seen.insert(name);
    }
  }
}

void add_declarations(AgsRows& rows) {
  for (const AgsUserHeading& own : ags_user_headings())
    if (rows.has(own.group))
      rows.add("DICT", {{"DICT_TYPE", "HEADING"},
                        {"DICT_GRP", own.group},
                        {"DICT_HDNG", own.definition.heading},
                        {"DICT_STAT", "OTHER"},
                        {"DICT_DTYP", own.definition.type},
                        {"DICT_DESC", own.description},
                        {"DICT_UNIT", own.definition.unit}});
}

void add_abbreviations(AgsRows& rows) {
  const auto document = rows.document();
  for (const lab::AgsTable& table : document.tables)
    for (std::size_t i = 0; i < table.headings.size(); ++i) {
      const auto& [name, unit, type] = table.headings[i];
      if (type != "PA") continue;
      for (const lab::AgsRow& row : table.rows) {
        std::istringstream codes(row[i]);
        for (std::string code; std::getline(codes, code, '+');) {
          if (code.empty()) continue;
          const auto meaning = ags_code_meaning(name, code);
          rows.add_once("ABBR", {{"ABBR_HDNG", name},
                                 {"ABBR_CODE", code},
                                 {"ABBR_DESC", meaning.empty() ? code + " (as given)" : meaning}});
        }
      }
    }
}

/// The lists of units and types are of the whole file, themselves too.
void add_lists(AgsRows& rows) {
  rows.add_once("TYPE", {{"TYPE_TYPE", "X"}, {"TYPE_DESC", ags_type_meaning("X")}});
  rows.add_once("UNIT", {{"UNIT_UNIT", "m"}, {"UNIT_DESC", ags_unit_meaning("m")}});
  const auto document = rows.document();
  for (const lab::AgsTable& table : document.tables)
    for (const lab::AgsHeading& heading : table.headings) {
      rows.add_once("TYPE",
                    {{"TYPE_TYPE", heading.type}, {"TYPE_DESC", ags_type_meaning(heading.type)}});
      if (!heading.unit.empty())
        rows.add_once("UNIT",
                      {{"UNIT_UNIT", heading.unit}, {"UNIT_DESC", ags_unit_meaning(heading.unit)}});
    }
}

void hold_to_rules(const lab::AgsDocument& document) {
  const auto source = lab::open_memory("AGS4", lab::ags_text(document));
  const auto check = lab::check_ags(*source);
  if (check.findings.empty()) return;
  const auto more = check.findings.size() - 1;
  throw lab::BadInput(fmt::format(
      "the AGS4 file would violate {}{}; give another value with --set HEADING=VALUE; nothing was "
      "written",
      in_words(check.findings.front()), more > 0 ? fmt::format(" (and {} more)", more) : ""));
}

}  // namespace

lab::AgsDocument ags_delivery(const std::vector<AgsTest>& tests, const std::vector<AgsSaid>& said,
                              const std::string& date) {
  std::vector<AgsTest> named = tests;
  make_keys_unique(named);
  AgsRows rows;
  AgsCells project = project_cells(), transmission = transmission_cells(date);
  for (const AgsSaid& one : said) {
    put_said(project, "PROJ", one);
    put_said(transmission, "TRAN", one);
  }
  rows.add("PROJ", project);
  rows.add("TRAN", transmission);
  for (const AgsTest& test : named) add_test(rows, test, said);
  add_declarations(rows);
  add_abbreviations(rows);
  add_lists(rows);
  lab::AgsDocument document = rows.document();
  hold_to_rules(document);
  return document;
}

}  // namespace triax::study

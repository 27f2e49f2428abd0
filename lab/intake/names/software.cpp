// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/intake/names/software.hpp"

#include <QSet>
#include <algorithm>

#include "lab/intake/names/heading_form.hpp"
#include "lab/intake/names/lexicon.hpp"
#include "lab/intake/names/lexicon_file.hpp"

namespace triax::lab {
namespace {

SoftwareColumn read_software_column(const TomlTable& row, const char* heading) {
  const auto sign = row.integer("sign", -1, 1);
  return {.heading = row.required_text(heading),
          .sign = sign ? std::optional(static_cast<int>(*sign)) : std::nullopt,
          .factor = row.number("factor").value_or(1),
          .unit = row.text("unit").value_or(""),
          .quantity = row.text("quantity").value_or(""),
          .note = row.text("note").value_or("")};
}

Software read_software(const TomlTable& row) {
  Software software{
      .name = row.required_text("name"),
      .note = row.text("note").value_or(""),
      .headings = row.texts("headings"),
      .any = row.texts("any"),
      .first_cell = row.text("first_cell").value_or(""),
      .contains = row.text("contains").value_or(""),
      .stage_column = row.text("stage_column").value_or(""),
      .drainage =
          drainage_from(row.text("drainage").value_or("unknown")).value_or(Drainage::unknown),
      .strain_is_logarithmic = row.text("strain").value_or("") == "logarithmic",
      .holds_readings = row.flag("holds_readings").value_or(true)};
  for (const TomlTable& column : row.tables("columns"))
    software.columns.push_back(read_software_column(column, "heading"));
  for (const TomlTable& label : row.tables("labels"))
    software.labels.push_back(read_software_column(label, "label"));
  return software;
}

const std::vector<Software>& all_software() {
  static const std::vector<Software> rows = [] {
    std::vector<Software> read;
    for (const TomlTable& row : read_lexicon_file("software").tables("software"))
      read.push_back(read_software(row));
    return read;
  }();
  return rows;
}

QString whole_key(std::string_view heading) { return heading_key(repair_heading(heading)); }

/// Keys of a heading as a whole and without its unit.
QSet<QString> keys_of_heading(std::string_view heading) {
  return {whole_key(heading), whole_key(find_names(heading).name)};
}

/// True if the file can be of this software. Rows without any condition do not exist.
bool fits(const Software& software, const QSet<QString>& keys, std::string_view head) {
  const auto has = [&](const std::string& heading) { return keys.contains(whole_key(heading)); };
  const std::string_view first =
      head.substr(std::min(head.find_first_not_of("\"\xEF\xBB\xBF \t"), head.size()));
  return std::ranges::all_of(software.headings, has) &&
         (software.any.empty() || std::ranges::any_of(software.any, has)) &&
         first.starts_with(software.first_cell) &&
         head.find(software.contains) != std::string_view::npos;
}

}  // namespace

const Software* find_software(const std::vector<std::string>& headings, std::string_view head) {
  QSet<QString> keys;
  for (const std::string& heading : headings) keys.unite(keys_of_heading(heading));
  const Software* best = nullptr;
  for (const Software& software : all_software())
    if (fits(software, keys, head) && (!best || software.headings.size() > best->headings.size()))
      best = &software;
  return best;
}

const SoftwareColumn* find_software_column(const Software& software, std::string_view heading) {
  const auto keys = keys_of_heading(heading);
  const auto found = std::ranges::find_if(software.columns, [&](const SoftwareColumn& column) {
    return keys.contains(whole_key(column.heading));
  });
  return found == software.columns.end() ? nullptr : &*found;
}

}  // namespace triax::lab

// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/ags/ags_document.hpp"

#include <algorithm>
#include <array>
#include <utility>

namespace triax::lab {
namespace {

constexpr std::array<std::pair<std::string_view, std::string_view>, 33> kSpelled{
    {{"ä", "ae"}, {"ö", "oe"},  {"ü", "ue"},  {"Ä", "Ae"},    {"Ö", "Oe"},   {"Ü", "Ue"},
     {"ß", "ss"}, {"é", "e"},   {"è", "e"},   {"ç", "c"},     {"°", " deg"}, {"²", "2"},
     {"³", "3"},  {"·", "*"},   {"×", "x"},   {"–", "-"},     {"—", "-"},    {"−", "-"},
     {"‘", "'"},  {"’", "'"},   {"“", "\""},  {"”", "\""},    {"′", "'"},    {"₁", "1"},
     {"₃", "3"},  {"ε", "eps"}, {"η", "eta"}, {"σ", "sigma"}, {"φ", "phi"},  {"Δ", "delta "},
     {"≥", ">="}, {"≤", "<="},  {"μ", "u"}}};

void append_row(std::string& out, std::string_view kind, const std::vector<std::string>& cells) {
  out.append("\"").append(kind).append("\"");
  for (const std::string& cell : cells) {
    out += ",\"";
    for (const char c : cell) out.append(c == '"' ? 2 : 1, c);
    out += '"';
  }
  out += "\r\n";
}

std::size_t length_of(char first) {
  const auto c = static_cast<unsigned char>(first);
  return c < 0x80 ? 1 : c < 0xE0 ? 2 : c < 0xF0 ? 3 : 4;
}

}  // namespace

AgsTable* AgsDocument::find(std::string_view name) {
  const auto found = std::ranges::find(tables, name, &AgsTable::name);
  return found == tables.end() ? nullptr : &*found;
}

const AgsTable* AgsDocument::find(std::string_view name) const {
  const auto found = std::ranges::find(tables, name, &AgsTable::name);
  return found == tables.end() ? nullptr : &*found;
}

AgsDocument read_ags_document(ByteSource& source) {
  AgsDocument document;
  AgsReader reader(source);
  while (reader.next()) {
    if (document.tables.empty() || document.tables.back().name != reader.group().name)
      document.tables.push_back({reader.group().name, reader.group().headings, {}});
    document.tables.back().rows.push_back(reader.cells());
  }
  return document;
}

std::string ags_text(const AgsDocument& document) {
  std::string out;
  for (const AgsTable& table : document.tables) {
    std::vector<std::string> names, units, types;
    for (const AgsHeading& heading : table.headings) {
      names.push_back(heading.name);
      units.push_back(heading.unit);
      types.push_back(heading.type);
    }
    append_row(out, "GROUP", {table.name});
    append_row(out, "HEADING", names);
    append_row(out, "UNIT", units);
    append_row(out, "TYPE", types);
    for (const AgsRow& row : table.rows) append_row(out, "DATA", row);
    out += "\r\n";
  }
  return out;
}

std::string ags_ascii(std::string_view utf8) {
  std::string out;
  for (std::size_t i = 0; i < utf8.size();) {
    const auto bytes = std::min(length_of(utf8[i]), utf8.size() - i);
    const std::string_view sign = utf8.substr(i, bytes);
    i += bytes;
    if (const char c = sign.front(); bytes == 1 && static_cast<unsigned char>(c) < 0x80) {
      out += c < 0x20 || c == 0x7F ? ' ' : c;
      continue;
    }
    const auto* const spelled =
        std::ranges::find(kSpelled, sign, &std::pair<std::string_view, std::string_view>::first);
    out += spelled == kSpelled.end() ? std::string_view("?") : spelled->second;
  }
  return out;
}

}  // namespace triax::lab

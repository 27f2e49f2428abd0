// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/study/intake/dialect_writer.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <string_view>

#include "lab/base/bad_input.hpp"
#include "lab/base/text.hpp"
#include "lab/base/toml_reader.hpp"

namespace triax::study {
namespace {

/// Behind "# " up to the end of the line.
std::string comment_text(std::string text) {
  constexpr unsigned char kFirstPrintable = 0x20, kDelete = 0x7f;
  std::ranges::replace_if(
      text, [](unsigned char c) { return c < kFirstPrintable || c == kDelete; }, ' ');
  return text;
}

void check_key(const std::string& quantity) {
  const bool is_bare = !quantity.empty() && std::ranges::all_of(quantity, [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '_';
  });
  if (!is_bare) throw lab::BadInput(lab::excerpt(quantity) + " is not a quantity of a record");
}

void check_quantities(const WrittenDialect& dialect) {
  std::map<std::string, std::size_t> places;
  for (const WrittenColumn& column : dialect.columns) {
    if (column.is_commented) continue;
    check_key(column.quantity);
    const auto [at, is_new] = places.emplace(column.quantity, column.position);
    if (!is_new)
      throw lab::BadInput(fmt::format("{} is chosen for columns {} and {}; choose one of them",
                                      column.quantity, at->second, column.position));
  }
  for (const WrittenConstant& constant : dialect.constants) {
    check_key(constant.quantity);
    if (!places.emplace(constant.quantity, 0).second)
      throw lab::BadInput(constant.quantity + " has a column and a value; leave one out");
  }
}

std::string column_text(const WrittenColumn& column) {
  std::string out = column.is_commented ? "# " : "";
  out += fmt::format("{} = {{ column = {}", column.quantity, column.position);
  if (!column.unit.empty()) out += fmt::format(", unit = {}", lab::toml_quoted(column.unit));
  if (column.factor != 1) out += fmt::format(", factor = {}", column.factor);
  if (column.sign < 0) out += ", sign = -1";
  if (column.date_order && *column.date_order != lab::DateOrder::none)
    out += fmt::format(", date_order = \"{}\"", lab::name(*column.date_order));
  out += " }";
  if (!column.remark.empty()) out += "  # " + comment_text(column.remark);
  return out + '\n';
}

/// Tables [specimen] and [test].
std::string values_text(const std::vector<WrittenValue>& values) {
  std::string out;
  for (const std::string_view group : {"specimen", "test"}) {
    std::string lines;
    for (const WrittenValue& one : values) {
      const auto dot = one.key.find('.');
      if (one.key.substr(0, dot) != group) continue;
      check_key(one.key.substr(dot + 1));
      lines += fmt::format("{} = {}\n", one.key.substr(dot + 1), one.value);
    }
    if (!lines.empty()) out += fmt::format("\n[{}]\n{}", group, lines);
  }
  return out;
}

}  // namespace

std::string write_dialect(const WrittenDialect& dialect) {
  check_quantities(dialect);
  std::string out;
  if (!dialect.remark.empty()) out += "# " + comment_text(dialect.remark) + '\n';
  out += fmt::format("name = {}\n\n[table]\n", lab::toml_quoted(dialect.name));
  const auto put = [&out](std::string_view key, const std::string& value) {
    if (!value.empty()) out += fmt::format("{} = {}\n", key, lab::toml_quoted(value));
  };
  put("encoding", dialect.encoding);
  put("separator", dialect.separator);
  put("decimal", dialect.decimal);
  put("thousands", dialect.thousands);
  put("sheet", dialect.sheet);
  if (dialect.block > 0) out += fmt::format("block = {}\n", dialect.block);
  if (dialect.has_toml_preamble) out += "comment = \"#\"\ncomment_is_toml = true\n";
  out += "\n[columns]\n";
  for (const WrittenColumn& column : dialect.columns) out += column_text(column);
  for (const WrittenConstant& constant : dialect.constants)
    out += fmt::format("{} = {{ value = {}, unit = {} }}\n", constant.quantity, constant.value,
                       lab::toml_quoted(constant.unit));
  for (const std::string& remark : dialect.remarks) out += "# " + comment_text(remark) + '\n';
  out += values_text(dialect.values);
  if (!dialect.programme.empty())
    out += fmt::format("\n[defaults]\nprogramme = {}\n", lab::toml_quoted(dialect.programme));
  return out;
}

}  // namespace triax::study

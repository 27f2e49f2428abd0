// SPDX-License-Identifier: GPL-3.0-or-later
// JSON values as TOML: tables of the first two levels under headings, deeper ones in line.
#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "lab/base/toml_number.hpp"
#include "lab/base/toml_reader.hpp"
#include "src/study/soil/soil_json.hpp"

namespace triax::study {
namespace {

bool is_estimate(const Json& value) { return value.is_object() && value.contains("low"); }

bool list_of_tables(const Json& value) {
  if (!value.is_array() || value.empty()) return false;
  const auto tables = std::ranges::count_if(value, [](const Json& v) { return v.is_object(); });
  if (tables != 0 && tables != static_cast<std::ptrdiff_t>(value.size()))
    throw std::invalid_argument("a list that mixes tables with other values");
  return tables != 0;
}

std::string inline_value(const Json& value) {
  if (value.is_string()) return lab::toml_quoted(value.get<std::string>());
  if (value.is_boolean()) return value.get<bool>() ? "true" : "false";
  if (value.is_number_integer()) return fmt::format("{}", value.get<std::int64_t>());
  if (value.is_number()) return lab::toml_number(value.get<double>());
  std::string parts;
  const auto add = [&](const std::string& part) { parts += (parts.empty() ? "" : ", ") + part; };
  if (value.is_array()) {
    for (const auto& one : value) add(inline_value(one));
    return "[" + parts + "]";
  }
  for (const auto& [key, one] : value.items())
    if (!one.is_null()) add(key + " = " + inline_value(one));
  return parts.empty() ? "{}" : "{ " + parts + " }";
}

void write_table(const Json& table, const std::string& path, std::string& out) {
  const auto heading = [&](const Json& v) { return v.is_object() && !is_estimate(v); };
  for (const auto& [key, value] : table.items())
    if (!value.is_null() && !heading(value) && !list_of_tables(value) &&
        !(value.is_array() && value.empty()))
      out += fmt::format("{} = {}\n", key, inline_value(value));
  for (const auto& [key, value] : table.items()) {
    const std::string below = path.empty() ? key : fmt::format("{}.{}", path, key);
    if (heading(value) && !value.empty()) {
      out += fmt::format("\n[{}]\n", below);
      write_table(value, below, out);
    }
    if (list_of_tables(value))
      for (const auto& one : value) {
        out += fmt::format("\n[[{}]]\n", below);
        write_table(one, below, out);
      }
  }
}

}  // namespace

std::string toml_document(const Json& document) {
  std::string out;
  write_table(document, {}, out);
  return out;
}

}  // namespace triax::study

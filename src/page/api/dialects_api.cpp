// SPDX-License-Identifier: GPL-3.0-or-later
// Dialects that a user chose in the dialog of an import.
#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "lab/base/bad_input.hpp"
#include "lab/base/text.hpp"
#include "lab/records/dialect.hpp"
#include "lab/records/dialect_memory.hpp"
#include "src/page/api/changes_api.hpp"
#include "src/page/api/json_body.hpp"
#include "src/study/intake/dialect_writer.hpp"

namespace triax::src {
namespace {

using study::Json;

constexpr std::size_t kMaxChosenColumns = 256;

/// Empty where it is not there, or null.
std::string optional_text(const Json& body, const char* key) {
  const auto found = body.find(key);
  return found == body.end() || found->is_null() ? std::string() : text_in(body, key);
}

/// A place from 0 to 16384.
std::size_t place_in(const Json& body, const char* key) {
  constexpr double kLastPlace = 16'384;
  const double place = number_in(body, key).value_or(0);
  if (place < 0 || place > kLastPlace || std::floor(place) != place)
    throw Refused(400, std::string(key) + ": expected an integer from 0 to 16384");
  return static_cast<std::size_t>(place);
}

study::WrittenColumn chosen_column(const Json& json) {
  if (!json.is_object()) throw Refused(400, "columns: expected a list of objects");
  study::WrittenColumn column{.quantity = text_in(json, "quantity"),
                              .position = place_in(json, "position"),
                              .unit = optional_text(json, "unit"),
                              .sign = number_in(json, "sign").value_or(1) < 0 ? -1 : 1,
                              .factor = number_in(json, "factor").value_or(1)};
  const std::string order = optional_text(json, "date_order");
  if (order.empty()) return column;
  column.date_order = lab::find_date_order(order);
  if (!column.date_order)
    throw Refused(400, "date_order: " +
                           lab::invalid_value(order, {"year first", "day first", "month first"}));
  return column;
}

std::vector<study::WrittenColumn> chosen_columns(const Json& body) {
  const auto found = body.find("columns");
  if (found == body.end() || !found->is_array() || found->size() > kMaxChosenColumns)
    throw Refused(400, "columns: expected a list of at most 256");
  std::vector<study::WrittenColumn> columns;
  for (const Json& one : *found) columns.push_back(chosen_column(one));
  return columns;
}

std::vector<study::WrittenConstant> chosen_values(const Json& body) {
  std::vector<study::WrittenConstant> values;
  const auto found = body.find("values");
  if (found == body.end() || found->is_null()) return values;
  if (!found->is_object()) throw Refused(400, "values: expected an object of numbers");
  for (const auto& [key, value] : found->items())
    if (const auto number = number_in(*found, key.c_str()))
      values.push_back({.quantity = key, .value = *number, .unit = "kPa"});
  return values;
}

study::WrittenDialect chosen_dialect(const Json& body) {
  const std::string name = optional_text(body, "name");
  return {.name = lab::trimmed(name).empty() ? "table" : name,
          .encoding = optional_text(body, "encoding"),
          .separator = optional_text(body, "separator"),
          .decimal = optional_text(body, "decimal"),
          .thousands = optional_text(body, "thousands"),
          .sheet = optional_text(body, "worksheet"),
          .block = place_in(body, "block"),
          .columns = chosen_columns(body),
          .programme = optional_text(body, "programme")};
}

}  // namespace

PageAnswer write_chosen_dialect(PageLaboratory& laboratory, const std::string& body) {
  const Json json = json_body(body);
  study::WrittenDialect dialect = chosen_dialect(json);
  const std::string key = optional_text(json, "key");
  try {
    Json answer = {{"dialect", nullptr}, {"file", nullptr}};
    const std::string for_all = key.empty() ? std::string() : study::write_dialect(dialect);
    dialect.constants = chosen_values(json);
    std::string text = study::write_dialect(dialect);
    static_cast<void>(lab::parse_dialect(text, "dialect"));
    if (!key.empty())
      answer["file"] =
          lab::DialectMemory(lab::DialectMemory::folder_of(laboratory.db)).store(key, for_all);
    answer["dialect"] = std::move(text);
    return json_answer(study::json_line(answer));
  } catch (const lab::BadInput& error) {
    throw Refused(400, error.what());
  }
}

}  // namespace triax::src

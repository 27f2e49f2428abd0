// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/records/dialect.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "lab/base/bad_input.hpp"
#include "lab/base/embedded.hpp"
#include "lab/base/text.hpp"
#include "lab/base/toml_reader.hpp"
#include "lab/intake/names/record_units.hpp"
#include "lab/intake/names/unit_names.hpp"
#include "lab/records/metadata.hpp"

namespace triax::lab {
namespace {

constexpr std::int64_t kLastPosition = 16'384;

constexpr std::array<std::pair<std::string_view, ColumnRole>, 6> kRoleKeys{
    {{"time", ColumnRole::time},
     {"stage_time", ColumnRole::stage_time},
     {"stage", ColumnRole::stage},
     {"test", ColumnRole::test},
     {"date", ColumnRole::date},
     {"time_of_day", ColumnRole::time_of_day}}};

std::vector<std::string> column_names() {
  std::vector<std::string> names;
  names.reserve(kRoleKeys.size() + quantities().size() + source_quantities().size());
  for (const auto& [key, role] : kRoleKeys) names.emplace_back(key);
  for (const QuantityInfo& row : quantities()) names.emplace_back(row.name);
  for (const SourceInfo& row : source_quantities()) names.emplace_back(row.name);
  return names;
}

Separator read_separator(const TomlTable& table, const char* key) {
  constexpr std::array kAll{Separator::automatic, Separator::comma,  Separator::semicolon,
                            Separator::tab,       Separator::blanks, Separator::wide_blanks,
                            Separator::pipe};
  const auto text = table.text(key).value_or("auto");
  for (const Separator one : kAll)
    if (text == separator_name(one) || (text.size() == 1 && text.front() == character(one)))
      return one;
  if (text == " ") return Separator::blanks;
  table.fail(key, excerpt(text) +
                      " is not a separator; expected auto, comma, semicolon, tab, pipe, 'blanks' "
                      "(one space or more) or 'wide blanks' (two spaces or more)");
}

DecimalMark read_decimal(const TomlTable& table) {
  const auto text = table.text("decimal").value_or("auto");
  if (text == "auto") return DecimalMark::open;
  if (text == ".") return DecimalMark::point;
  if (text == ",") return DecimalMark::comma;
  table.fail("decimal", excerpt(text) + " is not a decimal mark; expected auto, . or ,");
}

void read_thousands(Dialect& dialect, const TomlTable& table) {
  const auto text = table.text("thousands");
  if (!text) return;
  constexpr std::string_view kMarks = ",.' ";
  if (text->size() != 1 || kMarks.find(text->front()) == std::string_view::npos)
    table.fail("thousands", invalid_value(*text, {",", ".", "'", " "}));
  dialect.thousands = text->front();
}

/// The dimension of what a column holds.
sim::Dimension dimension_of(const DialectColumn& column) {
  switch (column.role) {
    case ColumnRole::stage:
    case ColumnRole::test:
      return sim::Dimension::none;
    case ColumnRole::quantity:
      return sim::find_unit(info(column.quantity).unit)->dimension;
    case ColumnRole::source:
      return sim::find_unit(source_quantities()[index(column.source)].unit)->dimension;
    default:
      break;
  }
  return sim::Dimension::time;
}

void check_unit(const TomlTable& table, const char* key, const std::string& unit,
                const DialectColumn& column) {
  if (!table.has(key) || find_record_unit(unit, dimension_of(column))) return;
  if (sim::find_unit(unit) || !find_unit_names(unit).empty())
    table.fail(key, excerpt(unit) + " does not fit this column; expected one of " +
                        record_unit_names(dimension_of(column)));
  table.fail(key, excerpt(unit) +
                      " is an unknown unit; known: " + record_unit_names(dimension_of(column)));
}

/// The order of a column with a date.
void read_date_order(DialectColumn& column, const TomlTable& table) {
  if (column.role != ColumnRole::time && column.role != ColumnRole::date) return;
  const auto text = table.text("date_order");
  if (!text) return;
  column.date_order = find_date_order(*text);
  if (!column.date_order)
    table.fail("date_order", invalid_value(*text, {"year first", "day first", "month first"}));
}

DialectColumn read_column(const TomlTable& columns, const std::string& key) {
  DialectColumn column;
  const auto* const role =
      std::ranges::find(kRoleKeys, key, [](const auto& one) { return one.first; });
  if (role != kRoleKeys.end()) {
    column.role = role->second;
  } else if (const auto quantity = find_quantity(key)) {
    column.quantity = *quantity;
  } else if (const auto source = find_source_quantity(key)) {
    column.role = ColumnRole::source;
    column.source = *source;
  } else {
    throw BadInput(columns.file(), columns.line(key),
                   fmt::format("unknown key {} in [columns]; {}", excerpt(key),
                               suggestion(key, column_names())));
  }
  if (columns.is_table(key)) {
    const auto table = *columns.table(key);
    column.names = table.texts("names");
    column.position =
        static_cast<std::size_t>(table.integer("column", 1, kLastPosition).value_or(0));
    column.unit = table.text("unit").value_or("");
    column.true_unit = table.text("true_unit").value_or("");
    column.sign = table.number("sign").value_or(1);
    column.factor = table.number("factor").value_or(1);
    if (!(column.factor > 0) || !std::isfinite(column.factor))
      table.fail("factor", "expected a number above 0");
    read_date_order(column, table);
    check_unit(table, "unit", column.unit, column);
    check_unit(table, "true_unit", column.true_unit, column);
    if (column.sign != 1 && column.sign != -1) table.fail("sign", "expected 1 or -1");
    if (table.has("true_unit") && column.true_unit.empty()) column.true_unit.assign(1, '-');
    table.finish();
  } else {
    column.names = columns.texts(key);
  }
  if (column.names.empty() && column.position == 0)
    columns.fail(key, "needs the heading of the column, as in the file, or its place: column = 3");
  return column;
}

void read_keys(Dialect& dialect, const TomlTable& document, const std::string& group) {
  const auto table = document.table(group);
  if (!table) return;
  const auto known = metadata_keys();
  for (const auto& name : table->keys()) {
    const auto key = fmt::format("{}.{}", group, name);
    std::erase_if(dialect.keys, [&](const DialectKey& one) { return one.key == key; });
    if (std::ranges::find(known, key) == known.end())
      throw BadInput(
          table->file(), table->line(name),
          fmt::format("unknown key {} in [{}]; {}", excerpt(name), group, suggestion(key, known)));
    if (!table->is_number(name)) {
      dialect.keys.push_back({key, table->texts(name), {}});
      continue;
    }
    RecordHeader probe;
    const auto value = *table->scalar(name);
    set_metadata(probe, fmt::format("{}:{}", table->file(), table->line(name)), key, value);
    dialect.keys.push_back({key, {}, value});
  }
}

void read_defaults(Dialect& dialect, const TomlTable& document) {
  const auto table = document.table("defaults");
  if (!table) return;
  dialect.programme = table->text("programme").value_or(dialect.programme);
  RecordHeader probe;
  if (const auto held = table->scalar("cell_pressure_kPa")) {
    set_metadata(probe, fmt::format("{}:{}", table->file(), table->line("cell_pressure_kPa")),
                 "test.cell_pressure_kPa", *held);
    dialect.cell_pressure_pa = probe.cell_pressure_pa;
  }
  for (const char* key : {"role", "drainage", "control"}) {
    const auto text = table->text(key);
    if (!text) continue;
    if (std::string_view(key) == "drainage" && *text == "auto") continue;
    set_metadata(probe, fmt::format("{}:{}", table->file(), table->line(key)),
                 fmt::format("stages.1.{}", key), *text);
    const StageInfo& stage = probe.stages.front();
    if (std::string_view(key) == "role") dialect.stage.role = stage.role;
    if (std::string_view(key) == "control") dialect.stage.control = stage.control;
    if (std::string_view(key) == "drainage") {
      dialect.stage.drainage = stage.drainage;
      dialect.drainage_from_columns = false;
    }
  }
  table->finish();
}

/// What a dialect begins with: nothing but the usual stage, or all of the one that it extends.
Dialect begun_dialect(const TomlTable& document) {
  Dialect dialect;
  dialect.stage.role = StageRole::shear;
  dialect.stage.control = AxialControl::unknown;  // a frame or a dead load: who knows
  const auto base = document.text("extends");
  if (!base) return dialect;
  std::vector<std::string> names;
  for (const Dialect& shipped : shipped_dialects()) {
    if (shipped.name == *base) return shipped;
    names.push_back(shipped.name);
  }
  document.fail("extends",
                fmt::format("unknown dialect {}; {}", excerpt(*base), suggestion(*base, names)));
}

/// cell_pressure = { value = 300, unit = "kPa" }: the same in all rows. False for any other column.
bool put_constant(Dialect& dialect, const TomlTable& columns, const std::string& key) {
  if (!columns.is_table(key)) return false;
  const auto table = *columns.table(key);
  const auto value = table.number("value");
  if (!value) return false;
  const auto quantity = find_quantity(key);
  if (!quantity) columns.fail(key, "is no quantity of a record that can have a value for all rows");
  const auto text = table.text("unit").value_or(std::string(info(*quantity).unit));
  const DialectColumn column{.quantity = *quantity};
  check_unit(table, "unit", text, column);
  table.finish();
  const auto unit = find_record_unit(text, dimension_of(column));
  std::erase_if(dialect.constants,
                [&](const RowConstant& one) { return one.quantity == *quantity; });
  dialect.constants.push_back({*quantity, sim::to_si(*value, *unit)});
  return true;
}

void put_column(Dialect& dialect, const DialectColumn& column) {
  std::erase_if(dialect.columns, [&](const DialectColumn& one) {
    return one.role == column.role && one.quantity == column.quantity &&
           one.source == column.source;
  });
  dialect.columns.push_back(column);
}

}  // namespace

Dialect parse_dialect(std::string_view toml, const std::string& file) {
  const auto document = TomlTable::parse(toml, file);
  Dialect dialect = begun_dialect(document);
  dialect.name = document.text("name").value_or("");
  dialect.about = document.text("about").value_or("");
  if (trimmed(dialect.name).empty())
    throw BadInput(file, 1, "a dialect needs a name: name = \"my_lab\"");
  if (const auto table = document.table("recognise")) {
    if (table->has("headings")) dialect.headings = table->texts("headings");
    if (table->has("contains")) dialect.contains = table->texts("contains");
    dialect.own_headings = table->flag("own_headings").value_or(dialect.own_headings);
    table->finish();
  }
  if (const auto table = document.table("table")) {
    dialect.encoding = table->text("encoding").value_or(dialect.encoding);
    if (table->has("separator")) dialect.separator = read_separator(*table, "separator");
    if (table->has("heading_separator"))
      dialect.heading_separator = read_separator(*table, "heading_separator");
    if (table->has("decimal")) dialect.decimal = read_decimal(*table);
    read_thousands(dialect, *table);
    dialect.block = static_cast<std::size_t>(table->integer("block", 1, kLastPosition).value_or(0));
    dialect.sheet = table->text("sheet").value_or(dialect.sheet);
    dialect.comment = table->text("comment").value_or(dialect.comment);
    dialect.comment_is_toml = table->flag("comment_is_toml").value_or(dialect.comment_is_toml);
    dialect.missing_words = table->flag("missing_words").value_or(dialect.missing_words);
    table->finish();
  }
  if (const auto table = document.table("columns"))
    for (const auto& key : table->keys())
      if (!put_constant(dialect, *table, key)) put_column(dialect, read_column(*table, key));
  if (dialect.columns.empty())
    throw BadInput(file, 0, "a dialect needs [columns], for example axial_strain = \"eps1\"");
  read_keys(dialect, document, "test");
  read_keys(dialect, document, "specimen");
  read_defaults(dialect, document);
  document.finish();
  return dialect;
}

const std::vector<Dialect>& shipped_dialects() {
  static const std::vector<Dialect> dialects = [] {
    std::vector<Dialect> all;
    for (const EmbeddedFile& file : kShippedDialects)
      all.push_back(parse_dialect(file.text, std::string(file.name) + ".toml"));
    std::stable_partition(all.begin(), all.end(), [](const auto& one) { return one.own_headings; });
    return all;
  }();
  return dialects;
}

Dialect find_dialect(const std::string& name_or_file) {
  if (name_or_file.ends_with(".toml")) {
    const auto file = read_text_file(name_or_file);
    return parse_dialect(file, name_or_file);
  }
  std::vector<std::string> names;
  for (const Dialect& dialect : shipped_dialects()) {
    if (dialect.name == name_or_file) return dialect;
    names.push_back(dialect.name);
  }
  throw BadInput(fmt::format("--dialect {}: unknown dialect; {}; or give the path of a .toml file",
                             name_or_file, suggestion(name_or_file, names)));
}

bool may_match(std::string_view heading, std::string_view name) {
  const auto first = [](std::string_view text) {
    text = trimmed(text);
    const char c = text.empty() ? ' ' : text.front();
    return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  };
  const char wanted = first(name);
  return wanted == '*' || wanted == first(heading);
}

bool matches_name(std::string_view heading, std::string_view name) {
  if (!may_match(heading, name)) return false;
  const auto text = folded(heading);
  const auto wanted = folded(name);
  if (!wanted.ends_with('*')) return text == wanted;
  return text.starts_with(std::string_view(wanted).substr(0, wanted.size() - 1));
}

}  // namespace triax::lab

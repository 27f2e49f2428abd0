// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <filesystem>
#include <map>
#include <utility>

#include <fmt/format.h>

#include "lab/base/text.hpp"
#include "lab/base/toml_reader.hpp"
#include "lab/wire/personality.hpp"

namespace triax::lab {
namespace {

constexpr int kLastAddress = 65535;
constexpr auto kForms = std::to_array<std::pair<std::string_view, RegisterForm>>(
    {{"float32", RegisterForm::float32},
     {"float32 low word first", RegisterForm::float32_low_first},
     {"int16", RegisterForm::int16},
     {"uint16", RegisterForm::uint16}});

std::vector<Protocol> read_protocols(const TomlTable& document) {
  std::vector<Protocol> protocols;
  for (const std::string& word : document.texts("protocol")) {
    if (word == "scpi") {
      protocols.push_back(Protocol::scpi);
    } else if (word == "modbus") {
      protocols.push_back(Protocol::modbus);
    } else if (word == "lines") {
      protocols.push_back(Protocol::lines);
    } else {
      document.fail("protocol", invalid_value(word, {"scpi", "modbus", "lines"}));
    }
  }
  if (protocols.empty())
    document.fail("protocol", R"(expected "scpi", "modbus", "lines", or a list of these)");
  return protocols;
}

int address_of(const TomlTable& table, const char* key) {
  const auto address = table.integer(key, 0, kLastAddress);
  if (!address) table.fail("", fmt::format("needs {} = its protocol address, from 0", key));
  return static_cast<int>(*address);
}

RegisterForm read_form(const TomlTable& table, std::string_view usual) {
  const auto text = table.text("form").value_or(std::string(usual));
  std::vector<std::string> names;
  for (const auto& [name, form] : kForms) {
    if (name == text) return form;
    names.emplace_back(name);
  }
  table.fail("form", fmt::format("unknown form {}; {}", excerpt(text), suggestion(text, names)));
}

PointRegister read_register(const TomlTable& table, bool writable, std::string_view usual_form) {
  PointRegister place;
  const int kinds = table.has("register") + table.has("coil") + table.has("discrete");
  if (kinds != 1) table.fail("", "expected one of register, coil and discrete");
  if (table.has("register")) {
    place.address = address_of(table, "register");
    place.form = read_form(table, usual_form);
    place.input = table.flag("input").value_or(!writable);
    const auto factor = table.number("factor", {.above = 0});
    if (factor && place.size() == 2) table.fail("factor", "only int16 and uint16 have a factor");
    place.factor = factor.value_or(1);
    if (place.address + place.size() - 1 > kLastAddress)
      table.fail("register", "a float needs two registers");
    if (writable && place.input) table.fail("input", "an input register cannot be written");
  } else if (table.has("coil")) {
    place.address = address_of(table, "coil");
    place.form = RegisterForm::coil;
  } else {
    place.address = address_of(table, "discrete");
    place.form = RegisterForm::discrete;
    if (writable) table.fail("discrete", "a discrete input cannot be written; expected coil");
  }
  return place;
}

void read_registers(PersonalityPoint& point, const TomlTable& table) {
  const auto modbus = table.table("modbus");
  if (!modbus) return;
  point.registers.push_back(read_register(*modbus, point.writable, "float32"));
  if (const auto scaled = modbus->table("scaled")) {
    point.registers.push_back(read_register(*scaled, point.writable, "int16"));
    scaled->finish();
  }
  modbus->finish();
}

std::optional<std::pair<double, double>> read_range(const TomlTable& table) {
  const auto range = table.numbers("range");
  if (!table.has("range")) return std::nullopt;
  if (range.size() != 2 || !(range[0] < range[1]))
    table.fail("range", "expected [MIN, MAX] in the unit of the instrument");
  return std::pair(range[0], range[1]);
}

PersonalityPoint read_point(const TomlTable& table, const std::string& name) {
  PersonalityPoint point;
  point.name = name;
  point.help = table.text("help").value_or("");
  const auto access = table.text("access").value_or("r");
  if (access != "r" && access != "w" && access != "rw")
    table.fail("access", fmt::format("{} is not valid; must be one of: r, w, rw", excerpt(access)));
  point.readable = access != "w";
  point.writable = access != "r";
  point.scpi = table.text("scpi").value_or("");
  point.range = read_range(table);
  read_registers(point, table);
  table.finish();
  return point;
}

void check_overlap(const TomlTable& points, const Personality& personality) {
  std::map<std::pair<bool, int>, std::string> taken;  // a bit or not, address
  const auto take = [&](bool bit, int address, const std::string& who, const std::string& key) {
    const auto [place, is_new] = taken.try_emplace({bit, address}, who);
    if (!is_new)
      points.fail(key, fmt::format("{} {} is used by {} already", bit ? "bit" : "register", address,
                                   place->second));
  };
  for (int i = 0; i < personality.identity.registers; ++i)
    take(false, *personality.identity.register_ + i, "the identity", "");
  for (const auto& point : personality.points)
    for (const auto& place : point.registers)
      for (int i = 0; i < place.size(); ++i)
        take(place.is_bit(), place.address + i, point.name, point.name);
}

PersonalityIdentity read_identity(const TomlTable& table) {
  PersonalityIdentity identity;
  identity.ask = table.text("ask").value_or("");
  identity.begins = table.text("begins").value_or("");
  identity.holds = table.text("holds").value_or("");
  if (table.has("register")) {
    identity.register_ = address_of(table, "register");
    identity.registers = static_cast<int>(table.integer("registers", 1, 125).value_or(32));
  }
  table.finish();
  return identity;
}

PersonalityScan read_scan(const TomlTable& table) {
  constexpr int kMost = 1000;
  PersonalityScan scan;
  scan.prepare = table.texts("prepare");
  scan.ask = table.text("ask").value_or("");
  scan.lines = static_cast<int>(table.integer("lines", 1, kMost).value_or(1));
  scan.columns = static_cast<int>(table.integer("columns", 1, kMost).value_or(1));
  scan.no_value = table.text("no_value").value_or("");
  scan.stamped = table.flag("stamped").value_or(false);
  scan.range = read_range(table);
  if (scan.chooses() && (table.has("lines") || table.has("columns")))
    table.fail("", "with {at} all channels are in one line; leave out lines and columns");
  if (scan.ask.empty() && scan.lines > 1)
    table.fail("lines", "the first line is unknown if lines are sent without a query; expected 1");
  table.finish();
  return scan;
}

void read_line(Personality& personality, const TomlTable& table) {
  personality.terminator = table.text("terminator").value_or(personality.terminator);
  if (personality.terminator.empty()) table.fail("terminator", R"(expected for example "\r\n")");
  constexpr double kLongest_ms = 60000;
  const auto milliseconds = [&](const char* key, double usual_s) {
    const auto given = table.number(key, {.at_least = 0, .at_most = kLongest_ms});
    return given ? *given * 1e-3 : usual_s;
  };
  personality.deadline_s = milliseconds("deadline_ms", personality.deadline_s);
  if (personality.deadline_s <= 0) table.fail("deadline_ms", "must be above 0");
  personality.pause_s = milliseconds("pause_ms", personality.pause_s);
  personality.compound = table.flag("compound").value_or(false);
  personality.set_check = table.text("set_check").value_or("");
  personality.prepare = table.texts("prepare");
  table.finish();
}

void check_protocols(const TomlTable& document, const Personality& personality) {
  const auto any = [&](auto&& has) { return std::ranges::any_of(personality.points, has); };
  if (personality.speaks(Protocol::modbus) && !any([](auto& p) { return !p.registers.empty(); }))
    document.fail("protocol", "modbus needs a value with registers: modbus = { register = 0 }");
  if (personality.speaks(Protocol::scpi) && !personality.scan &&
      !any([](auto& p) { return !p.scpi.empty(); }))
    document.fail("protocol", "scpi needs [scan] or a value with scpi = its header");
  if (personality.speaks(Protocol::lines) && !personality.scan)
    document.fail("protocol", "lines needs [scan]");
  if (personality.speaks(Protocol::lines) && personality.speaks(Protocol::scpi))
    document.fail("protocol", "scpi and lines use the same links; give one of them");
}

}  // namespace

Personality parse_personality(std::string_view toml, const std::string& file) {
  const auto document = TomlTable::parse(toml, file);
  Personality personality;
  personality.name = std::filesystem::path(file).stem().string();
  personality.file = file;
  personality.title = document.required_text("title");
  personality.about = document.text("about").value_or("");
  personality.protocols = read_protocols(document);
  if (const auto table = document.table("identity")) personality.identity = read_identity(*table);
  if (const auto table = document.table("line")) read_line(personality, *table);
  if (const auto table = document.table("scan")) personality.scan = read_scan(*table);
  if (const auto table = document.table("points")) {
    for (const auto& name : table->keys())
      personality.points.push_back(read_point(table->required_table(name), name));
    check_overlap(*table, personality);
  }
  check_protocols(document, personality);
  document.finish();
  return personality;
}

}  // namespace triax::lab

// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/wire/rig_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <set>
#include <utility>

#include "lab/base/bad_input.hpp"
#include "lab/base/text.hpp"
#include "lab/base/toml_reader.hpp"
#include "lab/devices/spoken_unit.hpp"

namespace triax::lab {
namespace {

constexpr std::array kRoles = {RigRole::reads, RigRole::frame, RigRole::cell, RigRole::back};

/// What `read` throws gets the place at which the text stands.
template <class Read>
auto at_key(const TomlTable& table, std::string_view key, const Read& read) {
  try {
    return read();
  } catch (const BadInput& error) {
    table.fail(key, error.what());
  }
}

LinkAddress read_link(const TomlTable& table) {
  const std::string text = table.required_text("link");
  return at_key(table, "link", [&] { return parse_link(text); });
}

std::optional<LinkAddress> read_served_at(const TomlTable& table, const LinkAddress& link) {
  const auto text = table.text("served_at");
  if (!text) return std::nullopt;
  const LinkAddress end = at_key(table, "served_at", [&] { return parse_link(*text); });
  if (end.kind != link.kind)
    table.fail("served_at", "is the other end of the link, of the same kind");
  return end;
}

AskedValue read_place(const TomlTable& table, const RigInstrument& instrument) {
  const auto text = table.scalar("at");
  if (!text) return {};
  if (const auto number = whole_text_as<int>(*text)) return {.point = {}, .at = *number};
  at_key(table, "at", [&] { return instrument.personality.at(*text); });
  return {.point = *text, .at = {}};
}

void read_unit(const TomlTable& table, RigChannel& channel) {
  channel.unit = table.text("unit").value_or("");
  const auto unit = sim::find_unit(channel.unit);
  if (unit) channel.scale = unit->scale;
  if (!channel.quantity) return;
  const sim::Unit own = spoken_unit(*channel.quantity);
  if (channel.unit.empty()) channel.unit = own.name;
  if (channel.unit == own.name) channel.scale = own.scale;
  if (unit && unit->dimension == own.dimension) return;
  if (channel.unit != own.name)
    table.fail("unit", fmt::format("{} is not a unit of {}; expected for example {}",
                                   excerpt(channel.unit), channel.name, own.name));
}

RigChannel read_channel(const TomlTable& table, const RigInstrument& instrument) {
  RigChannel channel;
  channel.line = table.line();
  channel.name = table.required_text("quantity");
  if (const auto found = find_quantity(channel.name); found && is_raw(*found))
    channel.quantity = found;
  channel.asked = read_place(table, instrument);
  read_unit(table, channel);
  channel.from_start = table.flag("from_start").value_or(false);
  if (const auto calibration = table.table("calibration")) {
    channel.calibration = read_calibration(*calibration);
    calibration->finish();
  }
  table.finish();
  return channel;
}

RigRole read_role(const TomlTable& table) {
  const auto word = table.text("role");
  if (!word) return RigRole::reads;
  std::vector<std::string> known;
  for (const RigRole role : kRoles) {
    if (to_text(role) == *word) return role;
    known.emplace_back(to_text(role));
  }
  table.fail("role", invalid_value(*word, known));
}

/// A personality of the user's own stands beside the rig's file.
Personality read_personality(const TomlTable& table) {
  std::string name = table.required_text("personality");
  if (name.ends_with(".toml"))
    name = (std::filesystem::path(table.file()).parent_path() / name).string();
  return at_key(table, "personality", [&] { return find_personality(name); });
}

void check_protocol(const TomlTable& table, const RigInstrument& one) {
  const bool modbus = one.link.is_modbus();
  const bool speaks =
      modbus ? one.personality.speaks(Protocol::modbus)
             : one.personality.speaks(Protocol::scpi) || one.personality.speaks(Protocol::lines);
  if (!speaks)
    table.fail("link", fmt::format("instrument profile {} has no {}", one.personality.name,
                                   modbus ? "Modbus, which this link needs"
                                          : "SCPI or lines, one of which this link needs"));
}

RigInstrument read_instrument(const TomlTable& table) {
  RigInstrument one;
  one.line = table.line();
  one.name = table.required_text("name");
  one.link = read_link(table);
  one.served_at = read_served_at(table, one.link);
  one.personality = read_personality(table);
  one.role = read_role(table);
  check_protocol(table, one);
  for (const TomlTable& channel : table.tables("channels"))
    one.channels.push_back(read_channel(channel, one));
  table.finish();
  return one;
}

RigPlant read_plant(const TomlTable& table) {
  RigPlant plant;
  plant.programme =
      (std::filesystem::path(table.file()).parent_path() / table.required_text("programme"))
          .string();
  if (const auto seed = table.integer("seed", 0)) plant.seed = static_cast<std::uint64_t>(*seed);
  plant.watchdog_s = table.number("watchdog_s", {.at_least = 0, .at_most = 3600}).value_or(3);
  if (const auto link = table.text("control"))
    plant.control = at_key(table, "control", [&] { return parse_link(*link); });
  table.finish();
  return plant;
}

/// Each name, link, role and quantity once.
void check_once(const RigFile& rig, const std::vector<TomlTable>& tables) {
  std::set<std::string> names, links, measured;
  std::set<RigRole> roles;
  for (std::size_t i = 0; i < tables.size(); ++i) {
    const RigInstrument& one = rig.instruments[i];
    if (!names.insert(one.name).second)
      tables[i].fail("name", fmt::format("another instrument has the name {}", excerpt(one.name)));
    if (!links.insert(to_text(one.link)).second && one.link.port != 0)
      tables[i].fail("link", "another instrument has this link");
    if (one.role != RigRole::reads && !roles.insert(one.role).second)
      tables[i].fail("role", fmt::format("another instrument has the role {}", to_text(one.role)));
    for (const RigChannel& channel : one.channels)
      if (!measured.insert(channel.name).second)
        throw BadInput(rig.file, channel.line,
                       fmt::format("{} is assigned to two channels", excerpt(channel.name)));
  }
}

}  // namespace

std::string_view to_text(RigRole role) {
  switch (role) {
    case RigRole::reads:
      return "reads";
    case RigRole::frame:
      return "frame";
    case RigRole::cell:
      return "cell";
    case RigRole::back:
      return "back";
  }
  return {};
}

const RigPlant& RigFile::served() const {
  if (plant) return *plant;
  throw BadInput(file, 0,
                 "a rig without [plant] cannot be simulated; [plant] names the programme behind "
                 "the instruments");
}

const RigInstrument* RigFile::find(std::string_view instrument) const {
  const auto found = std::ranges::find(instruments, instrument, &RigInstrument::name);
  return found == instruments.end() ? nullptr : &*found;
}

const RigInstrument* RigFile::with(RigRole role) const {
  const auto found = std::ranges::find(instruments, role, &RigInstrument::role);
  return found == instruments.end() ? nullptr : &*found;
}

const RigChannel* RigFile::channel(Quantity quantity) const {
  for (const RigInstrument& one : instruments)
    for (const RigChannel& channel : one.channels)
      if (channel.quantity == quantity) return &channel;
  return nullptr;
}

RigFile parse_rig_file(std::string_view toml, const std::string& file) {
  const TomlTable document = TomlTable::parse(toml, file);
  const TomlTable table = document.required_table("rig");
  RigFile rig;
  rig.file = file;
  rig.name = table.required_text("name");
  rig.interval_s =
      table.number("scan_interval_s", {.at_least = 0.01, .at_most = 86400}).value_or(1);
  table.finish();
  if (const auto plant = document.table("plant")) rig.plant = read_plant(*plant);
  const std::vector<TomlTable> tables = document.tables("instruments");
  if (tables.empty()) document.fail("", "no instrument is given; write [[instruments]]");
  for (const TomlTable& one : tables) rig.instruments.push_back(read_instrument(one));
  document.finish();
  check_once(rig, tables);
  return rig;
}

RigFile load_rig_file(const std::string& path) {
  return parse_rig_file(read_text_file(path), path);
}

}  // namespace triax::lab

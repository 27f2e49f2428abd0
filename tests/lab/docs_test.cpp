// SPDX-License-Identifier: GPL-3.0-or-later
// The pages of docs/ that print descriptions: what they print is what the readers take.
#include <algorithm>
#include <catch2/catch.hpp>
#include <set>
#include <sstream>

#include <fmt/format.h>

#include "lab/base/embedded.hpp"
#include "lab/base/text.hpp"
#include "lab/base/toml_reader.hpp"
#include "lab/grains/grain_programme_reader.hpp"
#include "lab/grains/grain_stage_reader.hpp"
#include "lab/intake/identities.hpp"
#include "lab/paths/condition_text.hpp"
#include "lab/paths/path_quantity.hpp"
#include "lab/paths/path_reader.hpp"
#include "lab/programmes/programme_reader.hpp"
#include "lab/records/dialect.hpp"
#include "lab/records/metadata.hpp"
#include "lab/rig/recorded.hpp"
#include "lab/wire/personality.hpp"
#include "lab/wire/rig_file.hpp"
#include "lab/wire/served/served_rig.hpp"

using namespace triax::lab;
using Catch::Contains;

namespace {

using Lines = std::vector<std::string>;

Lines lines_of(const std::string& path) {
  std::istringstream text(read_text_file(path));
  Lines lines;
  for (std::string line; std::getline(text, line);) lines.push_back(line);
  return lines;
}

/// The indented lines of a page, without their indent, from the one that begins with `first` to
/// the next prose or to the one that begins with `last`; blank lines left out.
Lines printed(const std::string& page, const std::string& first, const std::string& last = "#") {
  Lines block;
  bool inside = false;
  for (const auto& line : lines_of(page)) {
    inside = inside || line.starts_with("    " + first);
    if (!inside || line.empty()) continue;
    if (!line.starts_with("    ") || line.starts_with("    " + last)) break;
    block.emplace_back(line, 4);
  }
  return block;
}

/// The lines of a file that are neither blank nor remarks.
Lines content(const std::string& path) {
  Lines lines = lines_of(path);
  std::erase_if(lines, [](const auto& line) { return line.empty() || line.starts_with('#'); });
  return lines;
}

/// What stands between backticks in a line.
Lines codes(const std::string& line) {
  Lines found;
  std::istringstream text(line);
  std::string piece;
  for (bool code = false; std::getline(text, piece, '`'); code = !code)
    if (code) found.push_back(piece);
  return found;
}

}  // namespace

TEST_CASE("the dialect that the pages print is the sample, and reads its record") {
  const auto sample = content("samples/dialects/my_lab.toml");
  CHECK(sample.size() == 8);
  CHECK(printed("docs/tutorials/own-record.md", "name = \"my_lab\"") == sample);
  const std::string record = "samples/dialects/my_lab_record.txt";
  auto rows = lines_of(record);
  rows.resize(6);
  CHECK(printed("docs/tutorials/own-record.md", "Probe;") == rows);
  CHECK_THROWS_WITH(open_record(record, {}),
                    Contains(":3: the file does not decide: unit of Zeit."));
}

TEST_CASE("what the tutorial says of stranger files is dialect") {
  int found = 0;
  for (const auto& line : lines_of("docs/tutorials/own-record.md")) {
    if (!line.starts_with("| ") || codes(line).empty()) continue;
    auto code = codes(line);
    if (line.starts_with("| means")) code = {"[table]", code.back()};
    std::string toml = "name = \"d\"\n[columns]\n";
    if (code[0].starts_with('[')) toml += "axial_strain = \"e\"\n";
    for (const auto& one : code) toml += one + "\n";
    INFO(toml);
    CHECK_NOTHROW(parse_dialect(toml, "d.toml"));
    ++found;
  }
  CHECK(found == 14);
}

TEST_CASE("the programme that is printed is a programme") {
  const auto toml = joined(printed("docs/reference/programmes.md", "[test]"), "\n");
  const Programme programme = read_programme(toml, "docs/reference/programmes.md");
  CHECK(programme.stages.size() == 2);
  CHECK(programme.seed == 1);
  CHECK(programme.frame.travel_m == Approx(0.05));
  CHECK(programme.cell_controller.range_pa == 3e6);
  CHECK(programme.cell_controller.rate_limit_pa_per_s == Approx(600e3 / 60));
}

TEST_CASE("the fault and the operator that are printed are of a programme") {
  Lines lines = printed("docs/reference/programmes.md", "[test]");
  for (const auto& line : printed("docs/reference/programme-devices.md", "[[faults]]"))
    lines.push_back(line);
  for (const auto& line : printed("docs/reference/programmes.md", "[[operator]]"))
    lines.push_back(line);
  const Programme programme = read_programme(joined(lines, "\n"), "docs/reference/programmes.md");
  REQUIRE(programme.faults.size() == 1);
  CHECK(programme.faults[0].until_s == 5400);
  CHECK(programme.operator_actions.size() == 2);
}

TEST_CASE("the guard that is printed is that of the sample") {
  const auto guard = joined(printed("docs/reference/programmes.md", "[guard]"), "\n");
  const auto by_load = read_text_file("samples/programmes/icu_load.toml");
  const Programme printed_one =
      read_programme(by_load + "\n" + guard, "docs/reference/programmes.md");
  const Programme sample = load_programme("samples/programmes/icu_load_guarded.toml");
  REQUIRE(printed_one.guard);
  REQUIRE(sample.guard);
  CHECK(printed_one.guard->on == sample.guard->on);
  CHECK(printed_one.guard->action == sample.guard->action);
  CHECK(printed_one.guard->rate_m_per_s == sample.guard->rate_m_per_s);
  CHECK(printed_one.guard->further_strain == sample.guard->further_strain);
}

TEST_CASE("the record that is printed is a record") {
  const auto text = joined(printed("docs/reference/record-files.md", "# [test]", "|"), "\n") + "\n";
  const auto record = open_record(open_memory("docs.csv", text), {});
  CHECK(record->header().name == "U-26");
  CHECK(record->header().specimen.height_m == Approx(0.14));
  Reading reading;
  while (record->next(reading)) CHECK(reading.number < 2);
  CHECK(reading.time_s == Approx(0.1));
}

TEST_CASE("every key of a programme that uses all of them is on its page") {
  const auto page = read_text_file("docs/reference/programmes.md") +
                    read_text_file("docs/reference/programme-devices.md");
  for (const auto& line : content("tests/fuzz/seeds/programme_fuzz/instruments.toml")) {
    if (line.starts_with('[')) continue;
    const std::string key = line.substr(0, line.find(' '));
    // Keys of transducers and faults stand there with U for the unit.
    std::string with_u = key;
    for (const std::string unit : {"_kPa", "_N"})
      if (const auto at = with_u.find(unit); at != std::string::npos)
        with_u.replace(at, unit.size(), "_U");
    CHECK_THAT(page, Contains(fmt::format("`{}`", key)) || Contains(fmt::format("`{}`", with_u)));
  }
}

TEST_CASE("the path that is printed is a path") {
  const auto toml = joined(printed("docs/reference/paths.md", "[path]"), "\n");
  const PathDescription description = read_path(toml, "docs/reference/paths.md");
  CHECK_NOTHROW(check_start(description));
  CHECK(std::get<TriaxialPath>(description.path).segments.size() == 2);
  int conditions = 0;
  for (const auto& line : printed("docs/reference/paths.md", "\"axial_strain = ")) {
    std::istringstream pieces(line);
    std::string piece;
    for (bool quoted = false; std::getline(pieces, piece, '"'); quoted = !quoted)
      if (quoted) {
        CHECK_NOTHROW(read_condition<triax::sim::Axisymmetric>(piece));
        ++conditions;
      }
  }
  CHECK(conditions == 4);
}

TEST_CASE("the identities that a page shows are those of the program") {
  // Without spaces and subscripts, which the page and the program write differently.
  const auto plain = [](std::string text) {
    const std::vector<std::pair<std::string, std::string>> forms{{" ", ""},  {"_", ""},  {"₀", "0"},
                                                                 {"₁", "1"}, {"₃", "3"}, {"·", ""}};
    for (const auto& [from, to] : forms)
      for (auto at = text.find(from); at != std::string::npos; at = text.find(from, at))
        text.replace(at, from.size(), to);
    return text;
  };
  const std::string page = plain(read_text_file("docs/explanation/intake.md"));
  for (const char* shown : {"q = σ1 − σ3", "σ3 = σ3′ + u", "p = σ3 + q/3", "p′ = σ3 − u + q/3",
                            "s′ = σ3 − u + q/2", "ε_v = ε_1 + 2 ε_3", "ε_q = ε_1 − ε_v/3",
                            "e = (1 + e0) (1 − ε_v) − 1", "ΔV = V0 · ε_v", "V_b = −V0 · ε_v"}) {
    INFO(shown);
    CHECK(std::ranges::count(identities(), shown, &Identity::text) > 0);
    CHECK_THAT(page, Contains(plain(shown)));
  }
}

TEST_CASE("every key is on its page") {
  const auto paths = read_text_file("docs/reference/paths.md");
  for (const PathQuantityKey& row : path_quantity_keys())
    CHECK_THAT(paths, Contains(fmt::format("`{}`", row.key)));
  for (const auto& name : increment_names<triax::sim::Tensor>())
    if (!name.ends_with("_pct")) CHECK_THAT(paths, Contains(fmt::format("`{}`", name)));
  const auto programmes = read_text_file("docs/reference/programmes.md") +
                          read_text_file("docs/reference/programme-devices.md");
  for (const EndQuantityKey& row : end_quantity_keys())
    CHECK_THAT(programmes, Contains(fmt::format("`{}`", row.key)));
  // A channel that not every rig has is described where its instruments are.
  for (const QuantityInfo& row : raw_channels())
    if (row.raw.standard) CHECK_THAT(programmes, Contains(fmt::format("`{}`", row.name)));
  for (const auto& device : fault_devices()) {
    if (const auto q = find_quantity(device); q && !info(*q).raw.standard) continue;
    CHECK_THAT(programmes, Contains(fmt::format("`{}`", device)));
    for (const FaultKind kind : possible_faults(device))
      CHECK_THAT(programmes, Contains(fmt::format("`{}`", to_string(kind))));
  }
  for (const EmbeddedFile& set : kShippedInstruments)
    CHECK_THAT(programmes, Contains(fmt::format("| `{}` |", set.name)));
  const auto formats = read_text_file("docs/reference/record-files.md") +
                       read_text_file("docs/reference/foreign-tables.md") +
                       read_text_file("docs/how-to/records.md");
  for (const QuantityInfo& row : quantities())
    if (row.raw.standard || !is_raw(row.quantity))
      CHECK_THAT(formats, Contains(fmt::format("`{}", row.name)));
  for (const SourceInfo& row : source_quantities())
    CHECK_THAT(formats, Contains(fmt::format("| `{}` |", row.name)));
  for (const auto& key : metadata_keys())
    CHECK_THAT(formats, Contains(fmt::format("`{}`", key.substr(key.rfind('.') + 1))));
  for (const Dialect& dialect : shipped_dialects())
    CHECK_THAT(formats, Contains(fmt::format("| `{}` |", dialect.name)));
}

TEST_CASE("the page of grains prints a programme, and names every action") {
  std::string text;
  for (const auto& line : printed("docs/how-to/grains.md", "[run]")) text += line + "\n";
  CHECK(read_grain_programme(text, "docs/how-to/grains.md").stages.size() == 1);
  std::set<std::string> named;
  for (const auto& line : lines_of("docs/how-to/grains.md"))
    for (const auto& code : codes(line)) named.insert(code);
  for (const auto& action : grain_actions()) {
    INFO(action);
    CHECK(named.count(action) == 1);
  }
}

TEST_CASE("the page of personalities prints two, and has every key and every shipped one") {
  const std::string page = "docs/how-to/instruments.md";
  const auto old =
      parse_personality(joined(printed(page, "title = \"old controller\""), "\n"), page);
  CHECK(old.points.size() == 4);
  CHECK(old.at("pressure_kPa").registers[0].form == RegisterForm::float32_low_first);
  const auto balance = parse_personality(joined(printed(page, "title = \"balance\""), "\n"), page);
  CHECK(balance.scan->ask == "P");
  const auto text = read_text_file(page);
  const std::function<void(const TomlTable&)> keys_of = [&](const TomlTable& table) {
    for (const auto& key : table.keys()) {
      const bool name = table.name() == "points";
      if (!name)
        CHECK_THAT(text, Contains(fmt::format("`{}`", key)) || Contains(fmt::format("`[{}", key)));
      if (table.is_table(key)) keys_of(*table.table(key));
    }
  };
  for (const EmbeddedFile& file : kShippedPersonalities) {
    CHECK_THAT(
        text, Contains(fmt::format("[`{0}`](../reference/instrument-profiles/{0}.md)", file.name)));
    keys_of(TomlTable::parse(file.text, std::string(file.name)));
  }
}

TEST_CASE("the rig's file that the page of the wire prints is read, and so are the samples") {
  std::string text;
  for (const auto& line : printed("docs/how-to/instruments.md", "[rig]", "socat"))
    text += line + "\n";
  const RigFile rig = parse_rig_file(text, "docs/how-to/instruments.md");
  CHECK(rig.instruments.size() == 2);
  CHECK(rig.channel(Quantity::pore_pressure)->calibration.range->second == 1000);
  std::string plant;
  for (const auto& line : printed("docs/how-to/instruments.md", "[plant]")) plant += line + "\n";
  CHECK(parse_rig_file(text + plant, "docs/how-to/instruments.md").plant->watchdog_s == 5);
  for (const char* name : {"icu_6", "csu_26", "serial_pad"})
    CHECK(load_rig_file(fmt::format("samples/rigs/{}.toml", name)).with(RigRole::frame) != nullptr);
}

TEST_CASE("the page of the wire tells every command of a served rig's control") {
  RigFile rig = load_rig_file("samples/rigs/icu_6.toml");
  for (RigInstrument& one : rig.instruments) one.link.port = 0;
  rig.plant->control->port = 0;
  LineLoop loop;
  const ServedRig served(loop, rig, load_programme(rig.plant->programme), {.lock_step = true});
  const std::string page = read_text_file("docs/how-to/instruments.md");
  int told = 0;
  for (const ScpiRow& row : served.control().rows())
    for (const char* tree : {"CLOCk", "PLANt", "FAULt", "LINE"})
      if (row.pattern.text().starts_with(tree)) {
        CHECK_THAT(page, Contains("`" + row.pattern.text()));
        ++told;
      }
  CHECK(told == 11);
}

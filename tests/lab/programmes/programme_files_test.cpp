// SPDX-License-Identifier: GPL-3.0-or-later
// Keys of a programme that name other files, found by trying all keys that the reader knows.
#include <catch2/catch.hpp>
#include <filesystem>
#include <fstream>
#include <set>
#include <string>
#include <vector>

#include "lab/base/bad_input.hpp"
#include "lab/base/text.hpp"
#include "lab/programmes/programme_reader.hpp"
#include "tests/lab/programmes/programme_text.hpp"

using namespace triax::lab;
namespace fs = std::filesystem;

namespace {

std::string error_of(const std::string& text, const TomlEdit& edit) {
  try {
    read_programme(text, "p.toml", {edit});
  } catch (const BadInput& error) {
    return error.what();
  }
  return "accepted";
}

/// Keys that the reader knows in the table "specimen" or "stages.2", from its message on another.
std::vector<std::string> known_keys(const std::string& text, const std::string& table) {
  std::string message = error_of(text, {table + ".qqqqqqqqqqqq", "1"});
  constexpr std::string_view kBefore = "must be one of: ";
  const auto list = message.find(kBefore);
  INFO(message);
  REQUIRE(list != std::string::npos);
  std::vector<std::string> keys;
  for (std::string_view rest = std::string_view(message).substr(list + kBefore.size());
       !rest.empty();) {
    const auto comma = std::min(rest.find(", "), rest.size());
    keys.push_back(table + '.' + std::string(rest.substr(0, comma)));
    rest.remove_prefix(std::min(comma + 2, rest.size()));
  }
  return keys;
}

/// Every key of every table that a programme may have.
std::set<std::string> all_keys() {
  const std::string text = test::programme_text(R"(
[[stages]]
name = "s"
role = "shear"
drainage = "closed"
axial = "displacement"
axial_rate_mm_per_min = 1.0
end = [{quantity = "axial_strain_pct", above = 1.0}]
[guard]
on = "warning"
action = "hold"
[[operator]]
at_min = 1
action = "abort"
[[faults]]
device = "pore_pressure"
kind = "stuck"
from_min = 1
)",
                                                "back_pressure_kPa = 300.0\n[rig.frame]\n"
                                                "[rig.cell_controller]\n[rig.back_controller]\n"
                                                "[rig.transducers.pore_pressure]\n"
                                                "range_kPa = 1000\n");
  std::set<std::string> keys{"test",  "specimen", "rig",    "stages",
                             "guard", "operator", "faults", "rig.transducers"};
  for (const char* table :
       {"test", "specimen", "rig", "rig.frame", "rig.cell_controller", "rig.back_controller",
        "rig.transducers", "rig.transducers.pore_pressure", "stages.1", "stages.1.end.1", "guard",
        "operator.1", "faults.1"})
    for (std::string& key : known_keys(text, table)) keys.insert(std::move(key));
  return keys;
}

/// A programme whose specimen may be made of a material or of grains.
std::vector<std::string> programmes_to_try() {
  const std::string text = test::programme_text();
  const auto from = text.find("material = "), to = text.find("height_mm");
  std::string open = text;
  open.erase(from, to - from);
  for (const char* line : {"void_ratio = 1.086\n", "initial_effective_stress_kPa = 100.0\n"})
    open = test::replaced(open, line, "");
  return {text, open};
}

}  // namespace

TEST_CASE("read_programme: only keys of kProgrammeFileKeys open a file", "[programmes]") {
  const fs::path folder = fs::temp_directory_path() / "triax_programme_files";
  fs::remove_all(folder);
  fs::create_directories(folder / "is");
  std::ofstream(folder / "of") << "law = 1\n";
  std::set<std::string> opening;
  const auto keys = all_keys();
  CHECK(keys.size() > 60);
  for (const std::string& text : programmes_to_try())
    for (const std::string& key : keys) {
      const auto error_with = [&](const char* name) {
        const std::string path = (folder / name).string();
        std::string error = error_of(text, {key, path});
        for (auto at = error.find(path); at != std::string::npos; at = error.find(path))
          error.replace(at, path.size(), "PATH");
        return error;
      };
      const std::string missing = error_with("no");
      if (error_with("is") != missing || error_with("of") != missing) opening.insert(key);
    }
  fs::remove_all(folder);
  std::set<std::string> listed;
  for (const auto& [table, key] : kProgrammeFileKeys)
    listed.insert(std::string(table) + '.' + std::string(key));
  CHECK(opening == listed);
}

TEST_CASE("find_file_key: every key that names a file is found", "[programmes]") {
  const std::string text = test::programme_text();
  CHECK_FALSE(find_file_key(TomlTable::parse(text, "p.toml")));
  for (const auto& [table, key] : kProgrammeFileKeys) {
    const std::string name = std::string(table) + '.' + std::string(key);
    for (const char* value : {"/etc/passwd", "1", ""})
      CHECK(find_file_key(TomlTable::parse(text, "p.toml", 1, {{name, value}})) == name);
  }
}

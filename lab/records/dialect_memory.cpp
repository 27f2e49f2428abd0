// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/records/dialect_memory.hpp"

#include <algorithm>
#include <filesystem>
#include <system_error>

#include "lab/base/bad_input.hpp"
#include "lab/base/digest.hpp"
#include "lab/base/text.hpp"
#include "lab/base/toml_reader.hpp"
#include "lab/base/whole_file.hpp"

namespace triax::lab {
namespace {

constexpr std::size_t kKeyDigits = 32;
constexpr char kBetweenHeadings = '\x1f';
constexpr char kBeforeUnits = '\x1e';

bool is_key(std::string_view text) {
  return text.size() == kKeyDigits && std::ranges::all_of(text, [](char c) {
           return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'f');
         });
}

}  // namespace

std::string DialectMemory::key_of(const TableStructure& structure) {
  const auto is_empty = [](const std::string& text) { return trimmed(text).empty(); };
  if (structure.heading_lines.empty() || std::ranges::all_of(structure.headings, is_empty))
    return {};
  std::string text;
  for (const std::string& heading : structure.headings)
    text.append(trimmed(heading)).push_back(kBetweenHeadings);
  text.push_back(kBeforeUnits);
  for (const std::string& unit : structure.units)
    text.append(trimmed(unit)).push_back(kBetweenHeadings);
  const auto bytes = open_memory("headings", std::move(text));
  return sha256(*bytes).substr(0, kKeyDigits);
}

std::string DialectMemory::file_of(const std::string& key) const {
  return (std::filesystem::path(folder_) / (key + ".toml")).string();
}

std::string DialectMemory::store(const std::string& key, std::string_view toml) const {
  if (!is_key(key)) throw BadInput(excerpt(key) + " is not the key of a table's headings");
  static_cast<void>(parse_dialect(toml, "dialect"));
  std::error_code error;
  std::filesystem::create_directories(folder_, error);
  if (error) throw WorkFailed(folder_ + ": cannot be made: " + error.message());
  std::string file = file_of(key);
  WholeFile written(file);
  written.write(toml);
  written.finish();
  return file;
}

std::optional<RememberedDialect> DialectMemory::find(const TableStructure& structure) const {
  if (folder_.empty()) return std::nullopt;
  const std::string key = key_of(structure);
  if (key.empty()) return std::nullopt;
  const std::string file = file_of(key);
  std::error_code unreadable;
  if (!std::filesystem::is_regular_file(file, unreadable)) return std::nullopt;
  return RememberedDialect{parse_dialect(read_text_file(file), file), file};
}

std::optional<RememberedDialect> DialectMemory::find(ByteSource& table) const {
  std::error_code unreadable;
  if (folder_.empty() || !std::filesystem::is_directory(folder_, unreadable)) return std::nullopt;
  std::optional<TableStructure> structure;
  try {
    structure = find_structure(read_sample(table)).structure;
  } catch (const BadInput&) {
    // no text: reported where the table is read
  }
  table.rewind();
  return structure ? find(*structure) : std::nullopt;
}

}  // namespace triax::lab

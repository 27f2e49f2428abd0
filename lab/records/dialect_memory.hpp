// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Dialects that a user confirmed, for later tables with the same headings. Each is a TOML file in
// the folder DATABASE.dialects. Its name is a digest of the headings and units, so that a lookup
// opens one file, and no heading or file name becomes part of a path.
#include <optional>
#include <string>
#include <string_view>

#include "lab/intake/text/structure.hpp"
#include "lab/records/dialect.hpp"

namespace triax::lab {

struct RememberedDialect {
  Dialect dialect;
  std::string file;
};

class DialectMemory {
 public:
  /// The folder need not exist. An empty path is a memory without dialects.
  explicit DialectMemory(std::string folder) : folder_(std::move(folder)) {}
  /// The folder that belongs to a database.
  static std::string folder_of(const std::string& database) { return database + ".dialects"; }

  /// Key of the headings and units of a table, in their order: 32 hexadecimal digits. Spaces around
  /// a heading do not count. Empty for a table without headings, which cannot be remembered.
  static std::string key_of(const TableStructure& structure);

  /// Stores a dialect under a key, in place of an older one, and returns the path of its file.
  /// Throws BadInput for a key that key_of() cannot return and for a text that is no dialect,
  /// WorkFailed or NoRoom if the file cannot be written.
  std::string store(const std::string& key, std::string_view toml) const;

  /// Nothing if there is none for these headings. Throws BadInput "FILE:LINE: ..." for a file that
  /// is no dialect.
  std::optional<RememberedDialect> find(const TableStructure& structure) const;
  /// The same for the table of a text; nothing for a file without a table. Reads `table` only if
  /// the folder exists, and rewinds it.
  std::optional<RememberedDialect> find(ByteSource& table) const;

 private:
  std::string file_of(const std::string& key) const;
  std::string folder_;
};

}  // namespace triax::lab

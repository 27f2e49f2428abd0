// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/intake/names/lexicon_file.hpp"

#include <algorithm>

#include "lab/base/bad_input.hpp"
#include "lab/base/embedded.hpp"

namespace triax::lab {

TomlTable read_lexicon_file(std::string_view name) {
  const auto file = std::ranges::find(kLexiconFiles, name, &EmbeddedFile::name);
  if (file == kLexiconFiles.end()) throw BadInput(std::string(name), 0, "no file of the lexicon");
  return TomlTable::parse(file->text, std::string(name) + ".toml");
}

const std::vector<TomlTable>& lexicon_quantity_files() {
  static const std::vector<TomlTable> files = [] {
    std::vector<TomlTable> tables;
    for (const EmbeddedFile& file : kLexiconFiles) {
      TomlTable table = read_lexicon_file(file.name);
      if (table.has("quantity")) tables.push_back(std::move(table));
    }
    return tables;
  }();
  return files;
}

}  // namespace triax::lab

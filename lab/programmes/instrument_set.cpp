// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/programmes/instrument_set.hpp"

#include <fmt/format.h>

#include <vector>

#include "lab/base/bad_input.hpp"
#include "lab/base/embedded.hpp"
#include "lab/base/text.hpp"

namespace triax::lab {

TomlTable find_instruments(std::string_view name) {
  std::vector<std::string> known;
  for (const EmbeddedFile& file : kShippedInstruments) {
    if (file.name == name)
      return TomlTable::parse(file.text, fmt::format("instruments \"{}\"", name));
    known.emplace_back(file.name);
  }
  throw BadInput(
      fmt::format("unknown set of instruments {}; {}", excerpt(name), suggestion(name, known)));
}

}  // namespace triax::lab

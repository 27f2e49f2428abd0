// SPDX-License-Identifier: GPL-3.0-or-later
// Any bytes as a programme: they are read, or refused with BadInput; nothing else may happen.
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "lab/base/bad_input.hpp"
#include "lab/programmes/programme_reader.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  try {
    triax::lab::read_programme(text, "fuzz.toml");
  } catch (const triax::lab::BadInput&) {  // the one way to refuse
  }
  return 0;
}

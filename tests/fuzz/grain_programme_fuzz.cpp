// SPDX-License-Identifier: GPL-3.0-or-later
// Any bytes as a programme of grains and as a packing: read, or refused in words; nothing else.
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "lab/base/bad_input.hpp"
#include "lab/grains/grain_packing.hpp"
#include "lab/grains/grain_programme_reader.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace triax;
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  try {
    lab::read_grain_programme(text, "fuzz.toml");
  } catch (const lab::BadInput&) {  // the one way to refuse
  }
  try {
    lab::read_packing(text, "fuzz.txt", 1);
  } catch (const lab::BadInput&) {
  }
  return 0;
}

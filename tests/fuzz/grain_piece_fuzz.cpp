// SPDX-License-Identifier: GPL-3.0-or-later
// Any bytes as a piece of a rose of grains: read, or refused in words; nothing else.
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "lab/base/bad_input.hpp"
#include "src/study/grains/grain_piece.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace triax;
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  try {
    const study::GrainPiece piece = study::read_grain_piece(text, "fuzz.json");
    // What was read can be written, and is then the same.
    const std::string again = study::grain_piece_json(piece);
    if (study::grain_piece_json(study::read_grain_piece(again, "again.json")) != again)
      __builtin_trap();
    if (piece.count == 1 && study::merged({piece}).rose.probes.size() + 1 != piece.probes.size())
      __builtin_trap();
  } catch (const lab::BadInput&) {
  }
  return 0;
}

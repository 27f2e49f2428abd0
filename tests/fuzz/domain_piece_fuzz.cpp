// SPDX-License-Identifier: GPL-3.0-or-later
// Any bytes as a piece of a domain: read, or refused in words; nothing else.
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "lab/base/bad_input.hpp"
#include "src/domain/domain_text.hpp"
#include "src/study/domain/domain_piece.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace triax;
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  try {
    const study::DomainPiece piece = study::read_piece(text, "fuzz.json");
    // What was read can be written, and is then the same.
    const std::string again = study::piece_json(piece.domain, piece.index, piece.count);
    const study::DomainPiece second = study::read_piece(again, "again.json");
    if (second.domain.settings != piece.domain.settings) __builtin_trap();
    if (study::piece_json(second.domain, second.index, second.count) != again) __builtin_trap();
    if (piece.count == 1) src::domain_text(study::merged({piece}));
  } catch (const lab::BadInput&) {
  }
  return 0;
}

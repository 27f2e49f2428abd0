// SPDX-License-Identifier: GPL-3.0-or-later
// Any bytes as a path, and any text as a condition: read, or refused in words; nothing else.
#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <string_view>

#include "lab/base/bad_input.hpp"
#include "lab/paths/condition_text.hpp"
#include "lab/paths/path_reader.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace triax;
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  try {
    lab::read_condition<sim::Axisymmetric>(text);
  } catch (const std::invalid_argument&) {  // the one way to refuse
  }
  try {
    lab::read_condition<sim::Tensor>(text);
  } catch (const std::invalid_argument&) {
  }
  try {
    lab::check_start(lab::read_path(text, "fuzz.toml"));
  } catch (const lab::BadInput&) {
  }
  return 0;
}

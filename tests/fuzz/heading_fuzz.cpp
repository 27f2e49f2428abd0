// SPDX-License-Identifier: GPL-3.0-or-later
// Any bytes as headings, units, labels, stages and types of tests: nothing is refused.
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "lab/intake/names/labels.hpp"
#include "lab/intake/names/lexicon.hpp"
#include "lab/intake/names/software.hpp"
#include "lab/intake/names/stage_words.hpp"
#include "lab/results/test_type.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace triax::lab;
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  std::vector<std::vector<std::string>> lines(1);
  for (std::size_t start = 0; start <= size;) {
    const std::size_t end = std::min(text.find_first_of(",\n", start), size);
    lines.back().emplace_back(text.substr(start, end - start));
    if (end < size && text[end] == '\n') lines.emplace_back();
    start = end + 1;
  }
  find_labels(lines);
  find_software(lines.front(), text);
  for (const std::string& cell : lines.front()) {
    find_names(cell, lines.back().front());
    read_stage_words(cell);
    find_test_type(cell);
  }
  return 0;
}

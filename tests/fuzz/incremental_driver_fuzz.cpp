// SPDX-License-Identifier: GPL-3.0-or-later
// Any bytes as the three files of an incrementalDriver, parted by lines of "====": they are read,
// or refused with BadInput; what is read is made of finite numbers.
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>
#include <string_view>

#include "lab/base/bad_input.hpp"
#include "lab/paths/incremental_driver_reader.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace triax::lab;
  std::string_view rest(reinterpret_cast<const char*>(data), size);
  const auto part = [&rest] {
    constexpr std::string_view kBetween = "====\n";
    const std::size_t end = rest.find(kBetween);
    const std::string text(rest.substr(0, end));
    rest.remove_prefix(end == std::string_view::npos ? rest.size() : end + kBetween.size());
    return text;
  };
  const std::string test = part(), parameters = part(), start = part(), table = part();
  try {
    const auto read = read_incremental_driver(
        [&](const std::string& name) {
          return name == "test.inp"                ? test
                 : name == "parameters.inp"        ? parameters
                 : name == "initialconditions.inp" ? start
                                                   : table;
        },
        "fuzz", {.umat = {}, .void_ratio = 0.8});
    for (const auto& segment : read.path.segments)
      if (!segment.conditions.stress.allFinite() || !segment.conditions.strain.allFinite() ||
          !segment.conditions.increment.allFinite())
        std::abort();
    if (!read.path.stress.allFinite()) std::abort();
  } catch (const BadInput&) {  // the one way to refuse
  }
  return 0;
}

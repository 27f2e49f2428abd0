// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/records/stated/set_value.hpp"

#include <algorithm>
#include <charconv>

#include <fmt/format.h>

#include "lab/base/bad_input.hpp"
#include "lab/records/metadata.hpp"

namespace triax::lab {
namespace {

/// With the last alternative, with the drainage, or with the role of the only stage, the assumption
/// itself is removed.
void settle_guess(RecordHeader& header, const std::string& key) {
  const auto number = stage_of_key(key);
  if (!number) return;
  const bool drainage = key.ends_with(".drainage");
  if (drainage)
    std::ranges::find(header.stages, *number, &StageInfo::number)->drainage_was_said = true;
  std::erase_if(header.guesses, [&](Guess& guess) {
    if (guess.what == "role") return key.ends_with(".role");
    if (guess.what != "drainage" && guess.what != fmt::format("stage {}", *number)) return false;
    std::erase_if(guess.otherwise, [&](const Guess::Said& said) { return said.key == key; });
    return drainage && guess.otherwise.empty();
  });
}

}  // namespace

std::optional<int> stage_of_key(std::string_view key) {
  constexpr std::string_view kGroup = "stages.";
  if (!key.starts_with(kGroup)) return std::nullopt;
  key.remove_prefix(kGroup.size());
  int number = 0;
  const auto [stop, error] = std::from_chars(key.data(), key.data() + key.size(), number);
  if (error != std::errc{} || number < 0) return std::nullopt;
  return number;
}

void set_value(RecordHeader& header, const SetValue& set) {
  if (set.key == "test.origin" || set.key == "test.seed")
    throw BadInput(fmt::format("{}: {} describes the origin of the record; it cannot be set",
                               set.where, set.key));
  set_metadata(header, set.where, set.key, set.value);
  settle_guess(header, set.key);
}

}  // namespace triax::lab

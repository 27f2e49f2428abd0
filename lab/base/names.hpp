// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Enumerations and their texts in files, databases and reports: one table of pairs, looked up both
// ways. Decisions are taken by the enumerator, never by the text.
#include <optional>
#include <span>
#include <string_view>
#include <utility>

namespace triax::lab {

template <class Enum>
using Names = std::span<const std::pair<Enum, std::string_view>>;

/// Empty if the table does not have it.
template <class Enum>
constexpr std::string_view name_of(Enum value, Names<Enum> names) {
  for (const auto& [key, name] : names)
    if (key == value) return name;
  return {};
}

template <class Enum>
constexpr std::optional<Enum> value_of(std::string_view text, Names<Enum> names) {
  for (const auto& [key, name] : names)
    if (name == text) return key;
  return std::nullopt;
}

}  // namespace triax::lab

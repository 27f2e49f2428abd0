// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The target of a request: "/api/tests/3/window?from=0" as names and values.
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace triax::src {

struct Target {
  std::vector<std::string> path;                           ///< {"api", "tests", "3", "window"}
  std::vector<std::pair<std::string, std::string>> query;  ///< in order, a name may come again

  /// The first value of that name.
  std::optional<std::string> value(std::string_view name) const;
  /// Whether the path begins so.
  bool begins(std::string_view first, std::string_view second = {}) const;
};

/// Nothing for what is no target of ours: it does not begin with a slash, an escape that is none, a
/// byte of control, text that is not UTF-8, a part that is "." or "..", or has a slash or a zero
/// within.
std::optional<Target> parse_target(std::string_view text);

}  // namespace triax::src

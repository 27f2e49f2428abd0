// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/page/request/target.hpp"

#include <algorithm>

#include "lab/base/text.hpp"

namespace triax::src {
namespace {

int digit(char c) {
  if (c >= '0' && c <= '9') return c - '0';
  if (c >= 'a' && c <= 'f') return c - 'a' + 10;
  if (c >= 'A' && c <= 'F') return c - 'A' + 10;
  return -1;
}

/// Escapes resolved, once; UTF-8 without bytes of control.
std::optional<std::string> decoded(std::string_view text, bool plus_is_blank) {
  std::string plain;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] == '+' && plus_is_blank) {
      plain += ' ';
    } else if (text[i] != '%') {
      plain += text[i];
    } else {
      if (i + 2 >= text.size() || digit(text[i + 1]) < 0 || digit(text[i + 2]) < 0)
        return std::nullopt;
      plain += static_cast<char>(digit(text[i + 1]) * 16 + digit(text[i + 2]));
      i += 2;
    }
  }
  const auto is_control = [](unsigned char c) { return c < ' ' || c == 0x7f; };
  if (std::ranges::any_of(plain, is_control) || !lab::is_utf8(plain)) return std::nullopt;
  return plain;
}

bool is_no_name(const std::string& part) {
  return part == "." || part == ".." || part.find_first_of("/\\") != std::string::npos;
}

/// Calls `use` with each part of text between separators; false as soon as it gives false.
template <class Use>
bool each_part(std::string_view text, char separator, const Use& use) {
  while (!text.empty()) {
    const auto end = std::min(text.find(separator), text.size());
    if (!use(text.substr(0, end))) return false;
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return true;
}

}  // namespace

std::optional<std::string> Target::value(std::string_view name) const {
  for (const auto& [key, value] : query)
    if (key == name) return value;
  return std::nullopt;
}

bool Target::begins(std::string_view first, std::string_view second) const {
  return !path.empty() && path[0] == first &&
         (second.empty() || (path.size() > 1 && path[1] == second));
}

std::optional<Target> parse_target(std::string_view text) {
  if (!text.starts_with('/')) return std::nullopt;
  const auto mark = std::min(text.find('?'), text.size());
  Target target;
  const bool path_is_good = each_part(text.substr(1, mark - 1), '/', [&](std::string_view part) {
    auto name = decoded(part, false);
    if (!name || is_no_name(*name)) return false;
    target.path.push_back(std::move(*name));
    return true;
  });
  const auto query = text.substr(std::min(mark + 1, text.size()));
  const bool query_is_good = each_part(query, '&', [&](std::string_view part) {
    const auto equals = std::min(part.find('='), part.size());
    auto name = decoded(part.substr(0, equals), true);
    auto value = decoded(part.substr(std::min(equals + 1, part.size())), true);
    if (!name || !value) return false;
    target.query.emplace_back(std::move(*name), std::move(*value));
    return true;
  });
  if (!path_is_good || !query_is_good) return std::nullopt;
  return target;
}

}  // namespace triax::src

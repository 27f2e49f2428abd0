// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/page/api/json_body.hpp"

#include <algorithm>

#include "src/page/request/request.hpp"

namespace triax::src {
namespace {

using study::Json;

constexpr int kDeepest = 16;

/// A document nested a million deep must not be built.
bool goes_too_deep(const std::string& text) {
  int depth = 0;
  bool within = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (within && c == '\\')
      ++i;
    else if (c == '"')
      within = !within;
    else if (!within && (c == '{' || c == '['))
      if (++depth > kDeepest) return true;
    if (!within && (c == '}' || c == ']')) --depth;
  }
  return false;
}

[[noreturn]] void refuse(const char* key, const char* wanted) {
  throw Refused(400, std::string(key) + ": expected " + wanted);
}

}  // namespace

Json json_body(const std::string& body) {
  Json json = goes_too_deep(body) ? Json() : Json::parse(body, nullptr, false);
  if (!json.is_object()) throw Refused(400, "the body of the request must be a JSON object");
  return json;
}

std::string text_in(const Json& body, const char* key) {
  const auto found = body.find(key);
  if (found == body.end() || !found->is_string()) refuse(key, "a text");
  return found->get<std::string>();
}

std::optional<double> number_in(const Json& body, const char* key) {
  const auto found = body.find(key);
  if (found == body.end() || found->is_null()) return std::nullopt;
  if (!found->is_number()) refuse(key, "a number");
  return found->get<double>();
}

bool flag_in(const Json& body, const char* key) {
  const auto found = body.find(key);
  if (found == body.end() || found->is_null()) return false;
  if (!found->is_boolean()) refuse(key, "true or false");
  return found->get<bool>();
}

std::vector<double> numbers_in(const Json& body, const char* key) {
  const auto found = body.find(key);
  if (found == body.end() || found->is_null()) return {};
  if (found->is_number()) return {found->get<double>()};
  constexpr std::size_t kMost = 100;
  if (!found->is_array() || found->size() > kMost ||
      !std::ranges::all_of(*found, [](const Json& one) { return one.is_number(); }))
    refuse(key, "a number, or a list of at most 100");
  return found->get<std::vector<double>>();
}

}  // namespace triax::src

// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/study/document_part.hpp"

#include <fmt/format.h>

#include <cmath>
#include <utility>

#include "lab/base/bad_input.hpp"
#include "lab/base/text.hpp"

namespace triax::study {

using Json = nlohmann::ordered_json;

DocumentPart::DocumentPart(const Json& json, const std::string& file, std::string where)
    : json_(json), file_(file), where_(std::move(where)) {
  if (!json_.is_object()) fail("must be an object");
}

void DocumentPart::fail(const std::string& what) const {
  throw lab::BadInput(file_, 0, where_.empty() ? what : where_ + ": " + what);
}

const Json& DocumentPart::operator[](const char* key) const {
  const auto found = json_.find(key);
  if (found == json_.end()) fail(fmt::format("{} is missing", key));
  return *found;
}

double DocumentPart::number(const char* key, double lowest, double highest) const {
  const Json& value = (*this)[key];
  const double found = value.is_number() ? value.get<double>() : std::nan("");
  if (!(found >= lowest && found <= highest))
    fail(fmt::format("{} must be a number, {:g} to {:g}", key, lowest, highest));
  return found;
}

std::int64_t DocumentPart::whole(const char* key, std::int64_t lowest, std::int64_t highest) const {
  const Json& value = (*this)[key];
  const double found = value.is_number_integer() ? value.get<double>() : std::nan("");
  if (!(found >= static_cast<double>(lowest) && found <= static_cast<double>(highest)))
    fail(fmt::format("{} must be an integer, {} to {}", key, lowest, highest));
  return value.get<std::int64_t>();
}

std::optional<double> DocumentPart::known(const char* key) const {
  return (*this)[key].is_null() ? std::nullopt : std::optional(number(key));
}

bool DocumentPart::flag(const char* key) const {
  const Json& value = (*this)[key];
  if (!value.is_boolean()) fail(fmt::format("{} must be true or false", key));
  return value.get<bool>();
}

std::string DocumentPart::text(const char* key) const {
  const Json& value = (*this)[key];
  if (value.is_null()) return {};
  if (!value.is_string()) fail(fmt::format("{} must be a text", key));
  return value.get<std::string>();
}

const Json& DocumentPart::array(const char* key) const {
  const Json& value = (*this)[key];
  if (!value.is_array()) fail(fmt::format("{} must be an array", key));
  return value;
}

DocumentPart DocumentPart::in(const Json& json, const std::string& name) const {
  return {json, file_, where_.empty() ? name : where_ + ' ' + name};
}

Json parsed_document(std::string_view text, const std::string& file, const char* format,
                     const std::string& otherwise) {
  Json document = Json::parse(text, nullptr, false);
  if (document.is_discarded())
    throw lab::BadInput(
        file, 0, "is not a complete JSON document; if the piece was interrupted, run it again");
  if (!document.is_object() || !document.contains("format") || document["format"] != format)
    throw lab::BadInput(file, 0, otherwise);
  return document;
}

void require_version(const DocumentPart& root, int version) {
  if (root["version"] == version) return;
  const std::string found = root["version"].dump(-1, ' ', false, Json::error_handler_t::replace);
  root.fail(fmt::format("is a piece of format version {}; this program reads version {}",
                        lab::excerpt(found), version));
}

}  // namespace triax::study

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Reading JSON documents that may be anyone's: every value is looked at before it is used.
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>

namespace triax::study {

/// An object of a document. What is wrong is told as lab::BadInput, one line that says the file and
/// where in the document; the document has to live as long.
class DocumentPart {
 public:
  using Json = nlohmann::ordered_json;

  /// `where` is empty for the document itself. Throws if `json` is no object.
  DocumentPart(const Json& json, const std::string& file, std::string where = {});

  [[noreturn]] void fail(const std::string& what) const;

  const Json& operator[](const char* key) const;
  double number(const char* key, double lowest = -1e12, double highest = 1e12) const;
  std::int64_t whole(const char* key, std::int64_t lowest, std::int64_t highest) const;
  /// Empty for null.
  std::optional<double> known(const char* key) const;
  bool flag(const char* key) const;
  /// Empty for null.
  std::string text(const char* key) const;
  const Json& array(const char* key) const;
  DocumentPart part(const char* key) const { return in((*this)[key], key); }
  /// An element of this part that its messages call `name`.
  DocumentPart in(const Json& json, const std::string& name) const;

 private:
  const Json& json_;
  const std::string& file_;
  std::string where_;
};

/// The document that a text is. Throws lab::BadInput: no whole JSON (cut off), or its "format" is
/// another than `format`, where `otherwise` says what would be right.
nlohmann::ordered_json parsed_document(std::string_view text, const std::string& file,
                                       const char* format, const std::string& otherwise);

/// Throws lab::BadInput unless "version" is `version`.
void require_version(const DocumentPart& root, int version);

}  // namespace triax::study

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// TOML with strict keys: a key that nobody asked for is an error that names the nearest right one.
#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace triax::lab {

/// Bounds of a number; `above` excludes its value, `at_least` and `at_most` include theirs.
struct Bounds {
  double above = -std::numeric_limits<double>::infinity();
  double at_least = -std::numeric_limits<double>::infinity();
  double at_most = std::numeric_limits<double>::infinity();
  /// True for a finite value within the bounds.
  bool hold(double value) const;
};

/// A value to put in place of what the document holds: "specimen.void_ratio", "1.1". Parts of the
/// key are names of tables or, in a list, numbers from 1 on. The value takes the type of what it
/// replaces where that is a text, else that of what it looks like: number, true, false or text.
struct TomlEdit {
  std::string key;
  std::string value;
};

/// One table of a TOML document. Every error is a BadInput "FILE:LINE: ...". Copies share what has
/// been asked for.
class TomlTable {
 public:
  /// `first_line` is the line of `file` in which `text` begins. What is edited stands in no line.
  static TomlTable parse(std::string_view text, const std::string& file,
                         std::int64_t first_line = 1, const std::vector<TomlEdit>& edits = {});
  /// Throws BadInput for a file that cannot be read or is larger than 1 MB.
  static TomlTable read(const std::string& path);

  // Asking for a key makes it a known one. Empty where the key is absent; BadInput where its value
  // is of another type or out of bounds. A whole number is a number too; inf and nan are none.
  std::optional<double> number(std::string_view key, const Bounds& bounds = {}) const;
  std::optional<std::int64_t> integer(
      std::string_view key, std::int64_t lowest = std::numeric_limits<std::int64_t>::min(),
      std::int64_t highest = std::numeric_limits<std::int64_t>::max()) const;
  std::optional<std::string> text(std::string_view key) const;
  std::optional<bool> flag(std::string_view key) const;
  /// A string, number or boolean as text; numbers with the shortest digits that mean the same
  /// value.
  std::optional<std::string> scalar(std::string_view key) const;
  /// A string or an array of strings.
  std::vector<std::string> texts(std::string_view key) const;
  /// An array of finite numbers.
  std::vector<double> numbers(std::string_view key) const;
  std::optional<TomlTable> table(std::string_view key) const;
  /// [[key]]
  std::vector<TomlTable> tables(std::string_view key) const;

  // The same for keys that must be there; a text that must not be blank.
  double required_number(std::string_view key, const Bounds& bounds = {}) const;
  std::string required_text(std::string_view key) const;
  TomlTable required_table(std::string_view key) const;

  bool has(std::string_view key) const;
  bool is_table(std::string_view key) const;
  bool is_number(std::string_view key) const;
  /// Keys in the order of the file.
  std::vector<std::string> keys() const;
  std::int64_t line(std::string_view key) const;
  /// Line of the table itself.
  std::int64_t line() const;
  const std::string& file() const;
  /// "specimen" for [specimen], "stages 2" for the second of [[stages]]; empty for the document.
  const std::string& name() const;

  /// Throws for the first key that was never asked for: what was found and the nearest right key.
  void finish() const;
  /// BadInput "FILE:LINE: [NAME] KEY: MESSAGE" at the key's line; at the table's for an empty key.
  [[noreturn]] void fail(std::string_view key, const std::string& message) const;

 private:
  struct Impl;
  [[noreturn]] void missing(std::string_view key) const;
  explicit TomlTable(std::shared_ptr<Impl> impl) : impl_(std::move(impl)) {}
  std::shared_ptr<Impl> impl_;
};

/// The whole of a small file. Throws BadInput where it cannot be read or is larger than 1 MB.
std::string read_text_file(const std::string& path);

/// A basic TOML string with its quotes; bytes that are no UTF-8 are taken as Windows-1252. What a
/// spreadsheet that opens the text as a table could take for a formula (= + - @ behind a separator)
/// is escaped: the same text, another spelling.
std::string toml_quoted(std::string_view text);

}  // namespace triax::lab

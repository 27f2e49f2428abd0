#pragma once
// A TOML table of which every key must be known. Included by readers only: it brings in toml++.
#include <toml++/toml.h>
#include <limits>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <string_view>

namespace triax::lab {

/// The nearest of `known` if it is near enough to be meant by `word`; else empty.
std::string nearest_word(std::string_view word, std::span<const std::string> known);

/// Bounds of a number; `above` excludes its value, `at_least` and `at_most` include theirs.
struct Bounds {
  double above = -std::numeric_limits<double>::infinity();
  double at_least = -std::numeric_limits<double>::infinity();
  double at_most = std::numeric_limits<double>::infinity();
};

class StrictTable {
 public:
  /// `where` names the table in messages: "[specimen]".
  StrictTable(const toml::table& table, std::string file, std::string where)
      : table_(&table), file_(std::move(file)), where_(std::move(where)) {}

  /// Required values; throw BadInput where missing, of another type or out of bounds.
  double number(std::string_view key, const Bounds& bounds);
  std::string text(std::string_view key);
  StrictTable table(std::string_view key);

  /// Optional values; empty where the key is missing.
  std::optional<double> maybe_number(std::string_view key, const Bounds& bounds);
  std::optional<std::string> maybe_text(std::string_view key);
  std::optional<std::int64_t> maybe_integer(std::string_view key, std::int64_t lowest,
                                            std::int64_t highest);
  std::optional<StrictTable> maybe_table(std::string_view key);
  const toml::array* maybe_array(std::string_view key);

  /// Keys of the table, in the file's order of names; for tables whose keys are names of things.
  std::vector<std::string> keys() const;
  /// Refuses keys that nobody asked for, with the nearest known one. Call when all were asked for.
  void done() const;

  /// Throws BadInput at the key's line, or at the table's if the key is missing or empty.
  [[noreturn]] void fail(std::string_view key, const std::string& message) const;
  std::int64_t line() const;
  bool has(std::string_view key) const { return table_->contains(key); }

 private:
  const toml::node* ask(std::string_view key);
  [[noreturn]] void missing(std::string_view key) const;

  const toml::table* table_;
  std::string file_;
  std::string where_;
  std::set<std::string, std::less<>> asked_;
};

/// Parses TOML text; a syntax error becomes BadInput (file:line).
toml::table parse_toml(std::string_view text, const std::string& file);

}  // namespace triax::lab

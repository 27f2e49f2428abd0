// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/base/toml_reader.hpp"

#include <toml++/toml.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <utility>

#include <fmt/format.h>

#include "lab/base/bad_input.hpp"
#include "lab/base/byte_source.hpp"
#include "lab/base/text.hpp"
#include "lab/base/toml_edit.hpp"

namespace triax::lab {

bool Bounds::hold(double value) const {
  return std::isfinite(value) && value > above && value >= at_least && value <= at_most;
}

struct TomlTable::Impl {
  std::shared_ptr<const toml::table> document;
  const toml::table* table = nullptr;
  std::string file;
  std::string name;
  std::int64_t line_offset = 0;
  std::vector<std::string> asked;

  const toml::node* ask(std::string_view key) {
    if (std::ranges::find(asked, key) == asked.end()) asked.emplace_back(key);
    return table->get(key);
  }
  std::int64_t line_of(const toml::node& node) const {
    return static_cast<std::int64_t>(node.source().begin.line) + line_offset;
  }
  std::shared_ptr<Impl> child(const toml::table& inner, std::string_view key) const {
    auto made = std::make_shared<Impl>();
    *made = {document,    &inner,
             file,        name.empty() ? std::string(key) : name + "." + std::string(key),
             line_offset, {}};
    return made;
  }
};

namespace {

std::string wanted(const Bounds& bounds) {
  const auto part = [](const char* word, double value) {
    return std::isfinite(value) ? word + fmt::to_string(value) : std::string();
  };
  const auto text = joined({part("above ", bounds.above), part("at least ", bounds.at_least),
                            part("at most ", bounds.at_most)},
                           " and ");
  return text.empty() ? "finite" : text;
}

// One past the end of the string that starts at `i`; where it is not closed, at the end of its line
// or of the text: the parser goes no further than that.
std::size_t string_end(std::string_view text, std::size_t i) {
  const char quote = text[i];
  const bool many_lines = text.substr(i).starts_with(std::string(3, quote));
  for (i += many_lines ? 3 : 1; i < text.size(); ++i) {
    if (text[i] == '\\' && quote == '"') {
      ++i;
    } else if (text[i] == '\n' && !many_lines) {
      return i;
    } else if (text[i] == quote) {
      if (!many_lines) return i + 1;
      // Up to two quotes may stand in front of the three that close.
      const auto run = std::min(text.find_first_not_of(quote, i), text.size()) - i;
      if (run >= 3) return i + std::min<std::size_t>(run, 5);
      i += run - 1;
    }
  }
  return text.size();
}

constexpr int kDeepest = 200;

// Each dot of a dotted key is a table inside a table, each bracket a list or a table in another,
// and they are taken apart by recursion. What is inside brackets counts on from what they stand in.
bool too_deep(std::string_view text) {
  std::vector<int> outside;
  int depth = 0;
  const auto base = [&] { return outside.empty() ? 0 : outside.back() + 1; };
  for (std::size_t i = 0; i < text.size();) {
    const char c = text[i];
    if (c == '"' || c == '\'') {
      i = string_end(text, i);
    } else if (c == '#') {
      i = std::min(text.find('\n', i), text.size());
    } else {
      if (c == '\n' || c == ',') depth = base();
      if (c == '[' || c == '{') {
        outside.push_back(depth++);
      } else if ((c == ']' || c == '}') && !outside.empty()) {
        depth = outside.back();
        outside.pop_back();
      } else if (c == '.') {
        ++depth;
      }
      if (depth > kDeepest) return true;
      ++i;
    }
  }
  return false;
}

}  // namespace

TomlTable TomlTable::parse(std::string_view text, const std::string& file, std::int64_t first_line,
                           const std::vector<TomlEdit>& edits) {
  if (too_deep(text))
    throw BadInput(
        file, first_line,
        "tables and lists are nested more than 200 deep (dots of keys and brackets outside texts)");
  auto impl = std::make_shared<Impl>();
  impl->file = file;
  impl->line_offset = first_line - 1;
  try {
    auto document = std::make_shared<toml::table>(toml::parse(text));
    for (const TomlEdit& edit : edits) apply_edit(*document, edit, file);
    impl->document = std::move(document);
  } catch (const toml::parse_error& error) {
    const auto line = static_cast<std::int64_t>(error.source().begin.line) + impl->line_offset;
    throw BadInput(file, line, "invalid TOML: " + std::string(error.description()));
  }
  impl->table = impl->document.get();
  return TomlTable(std::move(impl));
}

std::string read_text_file(const std::string& path) {
  constexpr std::size_t kLargest = std::size_t{1} << 20;
  const auto source = open_file(path);
  if (source->size() > kLargest)
    throw BadInput(path, 0, "larger than 1 MB; a TOML description has a few hundred lines at most");
  std::string text(static_cast<std::size_t>(source->size()), '\0');
  std::size_t size = 0;
  while (size < text.size()) {
    const auto count = source->read({text.data() + size, text.size() - size});
    if (count == 0) break;
    size += count;
  }
  text.resize(size);
  return text;
}

TomlTable TomlTable::read(const std::string& path) { return parse(read_text_file(path), path); }

std::optional<double> TomlTable::number(std::string_view key, const Bounds& bounds) const {
  const auto* node = impl_->ask(key);
  if (!node) return std::nullopt;
  if (!node->is_number()) fail(key, "expected a number, without quotes");
  const double value = node->value<double>().value_or(NAN);
  if (!bounds.hold(value)) fail(key, "is " + fmt::to_string(value) + ", must be " + wanted(bounds));
  return value;
}

std::optional<std::int64_t> TomlTable::integer(std::string_view key, std::int64_t lowest,
                                               std::int64_t highest) const {
  const auto* node = impl_->ask(key);
  if (!node) return std::nullopt;
  const auto* whole = node->as_integer();
  if (!whole) fail(key, "expected an integer");
  if (whole->get() < lowest || whole->get() > highest)
    fail(key, "is " + std::to_string(whole->get()) + ", must be " + std::to_string(lowest) +
                  " to " + std::to_string(highest));
  return whole->get();
}

std::optional<std::string> TomlTable::text(std::string_view key) const {
  const auto* node = impl_->ask(key);
  if (!node) return std::nullopt;
  if (!node->is_string()) fail(key, "expected a text in quotes");
  return node->value<std::string>();
}

std::optional<bool> TomlTable::flag(std::string_view key) const {
  const auto* node = impl_->ask(key);
  if (!node) return std::nullopt;
  if (!node->is_boolean()) fail(key, "expected true or false");
  return node->value<bool>();
}

std::optional<std::string> TomlTable::scalar(std::string_view key) const {
  const auto* node = impl_->ask(key);
  if (!node) return std::nullopt;
  if (const auto* text = node->as_string()) return text->get();
  if (const auto* whole = node->as_integer()) return std::to_string(whole->get());
  if (const auto* number = node->as_floating_point()) return fmt::to_string(number->get());
  if (const auto* truth = node->as_boolean()) return truth->get() ? "true" : "false";
  fail(key, "expected one value");
}

std::vector<std::string> TomlTable::texts(std::string_view key) const {
  const auto* node = impl_->ask(key);
  if (!node) return {};
  if (const auto* text = node->as_string()) return {text->get()};
  const auto* array = node->as_array();
  if (!array) fail(key, "expected a text or a list of texts");
  std::vector<std::string> out;
  for (const auto& item : *array) {
    const auto* text = item.as_string();
    if (!text) fail(key, "expected a list of texts");
    out.push_back(text->get());
  }
  return out;
}

std::vector<double> TomlTable::numbers(std::string_view key) const {
  const auto* node = impl_->ask(key);
  if (!node) return {};
  const auto* array = node->as_array();
  if (!array) fail(key, "expected a list of numbers");
  std::vector<double> out;
  for (const auto& item : *array) {
    const auto number = item.value<double>();
    if (!item.is_number() || !number || !std::isfinite(*number))
      fail(key, "expected a list of finite numbers");
    out.push_back(*number);
  }
  return out;
}

std::optional<TomlTable> TomlTable::table(std::string_view key) const {
  const auto* node = impl_->ask(key);
  if (!node) return std::nullopt;
  const auto* inner = node->as_table();
  if (!inner) fail(key, "expected a table: [" + std::string(key) + "]");
  return TomlTable(impl_->child(*inner, key));
}

std::vector<TomlTable> TomlTable::tables(std::string_view key) const {
  const auto* node = impl_->ask(key);
  if (!node) return {};
  const auto* array = node->as_array();
  if (!array) fail(key, "expected a list of tables: [[" + std::string(key) + "]]");
  std::vector<TomlTable> out;
  for (const auto& item : *array) {
    const auto* inner = item.as_table();
    if (!inner) fail(key, "expected a list of tables: [[" + std::string(key) + "]]");
    const auto number = std::to_string(out.size() + 1);
    out.push_back(TomlTable(impl_->child(*inner, std::string(key) + " " + number)));
  }
  return out;
}

double TomlTable::required_number(std::string_view key, const Bounds& bounds) const {
  const auto value = number(key, bounds);
  if (!value) missing(key);
  return *value;
}

std::string TomlTable::required_text(std::string_view key) const {
  auto value = text(key);
  if (!value) missing(key);
  if (trimmed(*value).empty()) fail(key, "must not be empty");
  return *std::move(value);
}

TomlTable TomlTable::required_table(std::string_view key) const {
  auto value = table(key);
  if (!value) missing("[" + std::string(key) + "]");
  return *std::move(value);
}

bool TomlTable::has(std::string_view key) const { return impl_->table->contains(key); }

bool TomlTable::is_table(std::string_view key) const {
  const auto* node = impl_->table->get(key);
  return node && node->is_table();
}

bool TomlTable::is_number(std::string_view key) const {
  const auto* node = impl_->table->get(key);
  return node && node->is_number();
}

std::vector<std::string> TomlTable::keys() const {
  std::vector<std::pair<toml::source_position, std::string>> found;
  for (const auto& [key, node] : *impl_->table)
    found.emplace_back(key.source().begin, std::string(key.str()));
  std::ranges::stable_sort(found, [](const auto& a, const auto& b) { return a.first < b.first; });
  std::vector<std::string> out;
  out.reserve(found.size());
  for (auto& [position, key] : found) out.push_back(std::move(key));
  return out;
}

std::int64_t TomlTable::line(std::string_view key) const {
  const auto* node = impl_->table->get(key);
  return node ? impl_->line_of(*node) : line();
}

std::int64_t TomlTable::line() const { return impl_->line_of(*impl_->table); }
const std::string& TomlTable::file() const { return impl_->file; }
const std::string& TomlTable::name() const { return impl_->name; }

void TomlTable::finish() const {
  for (const auto& key : keys()) {
    if (std::ranges::find(impl_->asked, key) != impl_->asked.end()) continue;
    const auto where = name().empty() ? std::string() : " in [" + name() + "]";
    throw BadInput(file(), line(key),
                   "unknown key " + excerpt(key) + where + "; " + suggestion(key, impl_->asked));
  }
}

void TomlTable::fail(std::string_view key, const std::string& message) const {
  const std::string where = name().empty() ? "" : "[" + name() + "]";
  const auto subject = joined({where, std::string(key)}, " ");
  throw BadInput(file(), key.empty() ? line() : line(key),
                 subject.empty() ? message : subject + ": " + message);
}

void TomlTable::missing(std::string_view key) const {
  std::vector<std::string> strangers = keys();
  std::erase_if(strangers, [&](const auto& one) {
    return std::ranges::find(impl_->asked, one) != impl_->asked.end();
  });
  const auto near = nearest(key, strangers);
  fail("", std::string(key) + " is missing" +
               (near.empty() ? "" : "; is '" + near + "' a misspelling of it?"));
}

namespace {

/// A sign with which spreadsheets begin a formula, at the front of `text`: its code point and the
/// bytes that it takes.
struct FormulaSign {
  unsigned code = 0;
  std::size_t bytes = 0;
};
FormulaSign formula_sign(std::string_view text) {
  constexpr std::string_view kSigns = "=+-@";
  if (text.empty()) return {};
  if (kSigns.find(text.front()) != std::string_view::npos)
    return {static_cast<unsigned char>(text.front()), 1};
  for (const char sign : kSigns) {  // the wide forms, U+FF01 and on, which some locales take too
    const unsigned wide = 0xFF00U + static_cast<unsigned char>(sign) - 0x20U;
    const std::string utf8{static_cast<char>(0xEF), static_cast<char>(0x80 | (wide >> 6 & 0x3F)),
                           static_cast<char>(0x80 | (wide & 0x3F))};
    if (text.starts_with(utf8)) return {wide, utf8.size()};
  }
  return {};
}

}  // namespace

std::string toml_quoted(std::string_view text) {
  const std::string utf8 = is_utf8(text) ? std::string(text) : utf8_from_cp1252(text);
  std::string out = "\"";
  const auto escape = [&out](unsigned code) {
    std::array<char, 8> escaped{};
    std::snprintf(escaped.data(), escaped.size(), "\\u%04X", code);
    out += escaped.data();
  };
  bool opens_cell = false;  // where a spreadsheet that opens the file begins a new one
  for (std::size_t i = 0; i < utf8.size(); ++i) {
    const char c = utf8[i];
    const auto formula =
        opens_cell ? formula_sign(std::string_view(utf8).substr(i)) : FormulaSign{};
    if (c != ' ') opens_cell = std::string_view(",;|\t\r\n").find(c) != std::string_view::npos;
    if (formula.bytes > 0) {
      escape(formula.code);
      i += formula.bytes - 1;
    } else if (c == '"' || c == '\\') {
      out += '\\';
      out += c;
    } else if (static_cast<unsigned char>(c) < 0x20 || c == 0x7F) {
      escape(static_cast<unsigned char>(c));
    } else {
      out += c;
    }
  }
  return out + "\"";
}

}  // namespace triax::lab

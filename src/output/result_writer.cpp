// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/output/result_writer.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <nlohmann/json.hpp>

#include "lab/base/bad_input.hpp"
#include "lab/base/text.hpp"
#include "src/output/output.hpp"
#include "src/output/table.hpp"
#include "src/output/terminal.hpp"

namespace triax::src {
namespace {

bool is_number(const db::Value& value) {
  return std::holds_alternative<double>(value) || std::holds_alternative<std::int64_t>(value);
}

/// NULL is empty; numbers have the digits that mean the same value.
std::string exact_text(const db::Value& value) {
  if (const auto* text = std::get_if<std::string>(&value)) return *text;
  if (const auto* integer = std::get_if<std::int64_t>(&value)) return fmt::format("{}", *integer);
  const auto* number = std::get_if<double>(&value);
  return number && std::isfinite(*number) ? fmt::format("{}", *number) : std::string();
}

/// For people: six digits are more than any transducer resolves.
std::string short_text(const db::Value& value) {
  const auto* number = std::get_if<double>(&value);
  return number && std::isfinite(*number) ? fmt::format("{:.6g}", *number) : exact_text(value);
}

class TableWriter : public ResultWriter {
 public:
  void columns(const std::vector<std::string>& names) override {
    for (const auto& name : names) table_.columns.push_back({name, Align::left});
  }
  void row(const std::vector<db::Value>& values) override {
    auto& cells = table_.rows.emplace_back();
    for (std::size_t i = 0; i < values.size(); ++i) {
      cells.push_back(short_text(values[i]));
      if (widths_.empty() && is_number(values[i])) table_.columns[i].align = Align::right;
    }
    if (!widths_.empty() || table_.rows.size() == kHeldBack) release();
  }
  void finish() override {
    if (widths_.empty()) release();
    print({});
  }

 private:
  static constexpr std::size_t kHeldBack = 1000;

  void release() {
    if (widths_.empty()) {
      widths_ = column_widths(table_, text_width());
      put(to_text(table_, text_width()));
    } else {
      for (const auto& cells : table_.rows) put(table_line(cells, table_.columns, widths_) + '\n');
    }
    table_.rows.clear();
  }

  Table table_;
  std::vector<std::size_t> widths_;  ///< empty until the first rows are out
};

class CsvWriter : public ResultWriter {
 public:
  void columns(const std::vector<std::string>& names) override {
    std::vector<std::string> cells;
    cells.reserve(names.size());
    for (const auto& name : names) cells.push_back(inert(name));
    line(cells);
  }
  void row(const std::vector<db::Value>& values) override {
    std::vector<std::string> cells;
    cells.reserve(values.size());
    for (const auto& value : values)
      cells.push_back(std::holds_alternative<std::string>(value) ? inert(exact_text(value))
                                                                 : exact_text(value));
    line(cells);
  }
  void finish() override { print({}); }

 private:
  /// Text that neither commands a terminal nor is a formula to a spreadsheet, which an apostrophe
  /// in front tells. A finite number written as text stays one.
  static std::string inert(const std::string& cell) {
    const std::string text = without_controls(cell);
    // Spreadsheets skip blanks and ends of lines, too.
    const std::size_t blanks = std::min(text.find_first_not_of(" \t\r\n"), text.size());
    const std::string_view begins = std::string_view(text).substr(blanks);
    const bool formula =
        std::ranges::any_of(std::array{"=", "+", "-", "@", "＝", "＋", "－", "＠"},
                            [begins](const char* sign) { return begins.starts_with(sign); });
    const auto number = lab::whole_text_as<double>(text);
    return formula && !(number && std::isfinite(*number)) ? "'" + text : text;
  }
  static std::string quoted(const std::string& cell) {
    if (cell.find_first_of(",\"\r\n") == std::string::npos) return cell;
    std::string text = "\"";
    for (const char c : cell) text.append(c == '"' ? 2 : 1, c);
    return text + '"';
  }
  static void line(const std::vector<std::string>& cells) {
    std::string text;
    for (std::size_t i = 0; i < cells.size(); ++i) text += (i > 0 ? "," : "") + quoted(cells[i]);
    put(text + "\r\n");
  }
};

/// Nothing is printed before the last row is there: a document that ends in the middle is none. It
/// waits in a file without a name, however long it is.
class JsonWriter : public ResultWriter {
 public:
  JsonWriter() : waiting_(std::tmpfile()) {
    if (!waiting_) fail();
  }
  void columns(const std::vector<std::string>& names) override {
    names_.reserve(names.size());
    for (const auto& name : names) names_.push_back(unused(name));
    wait("[");
  }
  void row(const std::vector<db::Value>& values) override {
    nlohmann::ordered_json object = nlohmann::ordered_json::object();
    for (std::size_t i = 0; i < values.size(); ++i) object[names_[i]] = json(values[i]);
    constexpr auto replace = nlohmann::ordered_json::error_handler_t::replace;
    wait((rows_++ > 0 ? ",\n " : "\n ") + object.dump(-1, ' ', false, replace));
  }
  void finish() override {
    wait(rows_ > 0 ? "\n]\n" : "]\n");
    if (std::fflush(waiting_.get()) != 0) fail();
    std::rewind(waiting_.get());
    std::array<char, 65536> part{};
    while (const std::size_t bytes = std::fread(part.data(), 1, part.size(), waiting_.get()))
      put({part.data(), bytes});
    if (std::ferror(waiting_.get()) != 0) fail();
    print({});
  }

 private:
  struct Close {
    void operator()(std::FILE* file) const { std::fclose(file); }
  };
  [[noreturn]] static void fail() {
    throw lab::WorkFailed(
        fmt::format("temporary file cannot be written: {}", std::strerror(errno)));
  }
  void wait(std::string_view text) {
    if (std::fwrite(text.data(), 1, text.size(), waiting_.get()) != text.size()) fail();
  }
  std::string unused(const std::string& name) const {
    const auto taken = [&](const std::string& candidate) {
      return std::find(names_.begin(), names_.end(), candidate) != names_.end();
    };
    std::string candidate = name;
    for (int i = 2; taken(candidate); ++i) candidate = fmt::format("{}_{}", name, i);
    return candidate;
  }
  static nlohmann::ordered_json json(const db::Value& value) {
    if (const auto* text = std::get_if<std::string>(&value)) return *text;
    if (const auto* integer = std::get_if<std::int64_t>(&value)) return *integer;
    const auto* number = std::get_if<double>(&value);
    if (number && std::isfinite(*number)) return *number;
    return nullptr;
  }
  std::unique_ptr<std::FILE, Close> waiting_;
  std::vector<std::string> names_;
  std::size_t rows_ = 0;
};

}  // namespace

std::unique_ptr<ResultWriter> make_result_writer(const std::string& format) {
  if (format == "csv") return std::make_unique<CsvWriter>();
  if (format == "json") return std::make_unique<JsonWriter>();
  return std::make_unique<TableWriter>();
}

}  // namespace triax::src

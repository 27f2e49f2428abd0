#include "src/output/result_writer.hpp"

#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "src/output/output.hpp"
#include "src/output/table.hpp"

namespace triax::src {
namespace {

bool is_number(const db::Value& value) {
  return std::holds_alternative<double>(value) || std::holds_alternative<std::int64_t>(value);
}

/// NULL is empty; numbers have the digits that mean the same value.
std::string exact_text(const db::Value& value) {
  if (const auto* text = std::get_if<std::string>(&value)) return *text;
  if (const auto* number = std::get_if<double>(&value)) return fmt::format("{}", *number);
  if (const auto* integer = std::get_if<std::int64_t>(&value)) return fmt::format("{}", *integer);
  return {};
}

/// For people: six digits are more than any transducer resolves.
std::string short_text(const db::Value& value) {
  if (const auto* number = std::get_if<double>(&value)) return fmt::format("{:.6g}", *number);
  return exact_text(value);
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
      if (is_number(values[i])) table_.columns[i].align = Align::right;
    }
  }
  void finish() override { print(to_text(table_)); }

 private:
  Table table_;
};

class CsvWriter : public ResultWriter {
 public:
  void columns(const std::vector<std::string>& names) override { line(names); }
  void row(const std::vector<db::Value>& values) override {
    std::vector<std::string> cells;
    for (const auto& value : values) cells.push_back(exact_text(value));
    line(cells);
  }
  void finish() override { print({}); }

 private:
  static std::string quoted(const std::string& cell) {
    if (cell.find_first_of(",\"\r\n") == std::string::npos) return cell;
    std::string text = "\"";
    for (const char c : cell) text.append(c == '"' ? 2 : 1, c);
    return text + '"';
  }
  static void line(const std::vector<std::string>& cells) {
    std::string text;
    for (std::size_t i = 0; i < cells.size(); ++i) text += (i > 0 ? "," : "") + quoted(cells[i]);
    print(text + "\r\n");
  }
};

class JsonWriter : public ResultWriter {
 public:
  void columns(const std::vector<std::string>& names) override {
    names_ = names;
    print("[");
  }
  void row(const std::vector<db::Value>& values) override {
    nlohmann::ordered_json object = nlohmann::ordered_json::object();
    for (std::size_t i = 0; i < values.size(); ++i) object[names_[i]] = json(values[i]);
    constexpr auto replace = nlohmann::ordered_json::error_handler_t::replace;
    print((rows_++ > 0 ? ",\n " : "\n ") + object.dump(-1, ' ', false, replace));
  }
  void finish() override { print(rows_ > 0 ? "\n]\n" : "]\n"); }

 private:
  static nlohmann::ordered_json json(const db::Value& value) {
    if (const auto* text = std::get_if<std::string>(&value)) return *text;
    if (const auto* integer = std::get_if<std::int64_t>(&value)) return *integer;
    const auto* number = std::get_if<double>(&value);
    if (number && std::isfinite(*number)) return *number;
    return nullptr;
  }
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

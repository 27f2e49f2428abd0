// The forms of a path's report: JSON, text and CSV.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "lab/base/toml_reader.hpp"
#include "src/element/path_report.hpp"
#include "src/output/table.hpp"
#include "src/output/words.hpp"
#include "src/study/json_parts.hpp"

namespace triax::src {
namespace {

constexpr std::size_t kRowsOfText = 20;

study::Json point_json(const ReportedPath& path, const ReportedPoint& at) {
  study::Json object;
  object["segment"] = study::json_text(at.segment);
  for (std::size_t i = 0; i < path.columns.size(); ++i)
    object[path.columns[i]] =
        i < at.values.size() ? study::json_number(at.values[i]) : study::Json(nullptr);
  return object;
}

std::string in_percent(const ReportedPath& path, const ReportedPoint& at, const char* column) {
  const auto value = path.value(at, column);
  return number(value ? std::optional(100 * *value) : std::nullopt, 3);
}

std::string state_line(const ReportedPath& path, const ReportedPoint& at) {
  const auto eta = path.told_eta(at);
  return fmt::format("ε₁ {} %, q {} kPa, p′ {} kPa, u {} kPa", in_percent(path, at, "axial_strain"),
                     number(path.value(at, "q_kPa"), 2), number(path.value(at, "p_eff_kPa"), 2),
                     number(path.value(at, "pore_pressure_kPa"), 2)) +
         (eta ? ", η " + number(eta, 4) : "");
}

Table rows_table(const ReportedPath& path) {
  Table table;
  table.columns = {
      {"segment", Align::left},  {"ε₁ (%)", Align::right},   {"ε_v (%)", Align::right},
      {"q (kPa)", Align::right}, {"p′ (kPa)", Align::right}, {"u (kPa)", Align::right},
      {"η", Align::right},       {"e", Align::right},        {"W₂ norm.", Align::right}};
  const std::size_t count = path.rows.size(), shown = std::min(count, kRowsOfText);
  for (std::size_t i = 0; i < shown; ++i) {
    // Evenly spread, first and last among them.
    const auto& row = path.rows[shown == 1 ? 0 : i * (count - 1) / (shown - 1)];
    table.rows.push_back(
        {row.segment, in_percent(path, row, "axial_strain"),
         in_percent(path, row, "volumetric_strain"), number(path.value(row, "q_kPa"), 2),
         number(path.value(row, "p_eff_kPa"), 2), number(path.value(row, "pore_pressure_kPa"), 2),
         number(path.told_eta(row), 4), number(path.value(row, "void_ratio"), 5),
         number(path.value(row, "second_order_work_normalised"), 4)});
  }
  return table;
}

std::string event_words(const ReportedEvent& event) {
  if (event.kind == "end_condition") return event.what + ": the segment ends";
  if (event.kind == "second_order_work") return "second-order work turns negative";
  if (event.kind == "peak") return "peak of " + event.what;
  return "control of " + event.what + " is lost";
}

}  // namespace

std::string path_json(const ReportedPath& path) {
  study::Json document = {{"path",
                           {{"name", path.name},
                            {"origin", "simulated"},
                            {"source", path.source},
                            {"tolerance", path.tolerance}}},
                          {"material", study::json_material(path.material)},
                          {"start", point_json(path, path.start)},
                          {"outcome", path.outcome},
                          {"culprit", study::json_text(path.culprit)},
                          {"message", study::json_text(path.message)},
                          {"error", study::json_number(path.error)},
                          {"peak", path.peak ? point_json(path, *path.peak) : study::Json(nullptr)},
                          {"last", point_json(path, path.last)}};
  study::Json events = study::Json::array();
  for (const auto& event : path.events)
    events.push_back(
        {{"kind", event.kind}, {"what", event.what}, {"at", point_json(path, event.at)}});
  document["events"] = std::move(events);
  document["warnings"] = path.warnings;
  study::Json rows = study::Json::array();
  for (const auto& row : path.rows) rows.push_back(point_json(path, row));
  document["rows"] = std::move(rows);
  return study::json_document(document);
}

std::string path_text(const ReportedPath& path) {
  const std::string title = on_one_line(path.name + " (simulated, one material point)");
  std::string out = title + '\n' + std::string(display_width(title), '=') + '\n';
  const auto fact = [&out](const char* label, const std::string& value) {
    if (!value.empty()) out += fmt::format("  {:<12}{}\n", label, on_one_line(value));
  };
  fact("material", path.material.name);
  fact("based on", path.material.material.based_on);
  fact("source", path.material.source);
  fact("range", path.material.range);
  fact("start",
       fmt::format("p′ {} kPa, q {} kPa, e {}", number(path.value(path.start, "p_eff_kPa"), 2),
                   number(path.value(path.start, "q_kPa"), 2),
                   number(path.value(path.start, "void_ratio"), 4)));
  out += '\n' + indented(to_text(rows_table(path))) + '\n';
  for (const auto& event : path.events)
    out += fmt::format("  {}\n      {}\n", on_one_line(event_words(event)),
                       state_line(path, event.at));
  if (path.peak) out += fmt::format("  largest |q|\n      {}\n", state_line(path, *path.peak));
  if (path.peak || !path.events.empty()) out += '\n';
  for (const auto& warning : path.warnings) fact("warning", warning);
  fact("outcome", path.message.empty() ? "completed" : path.outcome + ": " + path.message);
  return without_controls(out);
}

std::string path_csv(const ReportedPath& path) {
  std::string out = fmt::format(
      "# [test]\n# name = {}\n# origin = \"simulated\"\n## one material point, {}\nsegment",
      lab::toml_quoted(path.name), on_one_line(path.material.name));
  for (const auto& column : path.columns) out += ',' + column;
  out += '\n';
  for (const auto& row : path.rows) {
    std::string name = row.segment;
    for (std::size_t at = 0; (at = name.find('"', at)) != std::string::npos; at += 2)
      name.insert(at, 1, '"');
    out += '"' + on_one_line(name) + '"';
    for (const auto& value : row.values) out += value ? fmt::format(",{}", *value) : ",";
    out += '\n';
  }
  return out;
}

}  // namespace triax::src

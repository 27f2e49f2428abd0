// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/plot/figure_files.hpp"

#include <fmt/format.h>
#include <qcustomplot.h>

#include <QBuffer>
#include <QPageSize>
#include <QPdfWriter>
#include <array>
#include <cmath>
#include <nlohmann/json.hpp>
#include <string_view>
#include <utility>

#include "lab/base/bad_input.hpp"
#include "src/output/markup.hpp"
#include "src/output/output.hpp"
#include "src/output/table.hpp"

namespace triax::src {
namespace {

std::string standalone_svg(const Drawing& drawing) {
  auto svg = to_svg(*drawing.plot);
  const auto inside = svg.find('>') + 1;
  svg.insert(inside, fmt::format("\n<desc>{}</desc>", escaped(drawing.caption)));
  return "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n" + svg;
}

std::optional<double> known(const std::optional<double>& value) {
  return value && std::isfinite(*value) ? value : std::nullopt;
}

std::string quoted(const std::string& cell) {
  if (cell.find_first_of(",\"") == std::string::npos) return cell;
  std::string out = "\"";
  for (const char c : cell) out += c == '"' ? std::string("\"\"") : std::string(1, c);
  return out + '"';
}

}  // namespace

std::string make_reproducible(std::string pdf) {
  // Qt 6.4 writes the first only, Qt 6.8 all of them: two in its XMP metadata.
  constexpr std::array<std::pair<std::string_view, char>, 7> kVariableParts{
      {{"/CreationDate (", ')'},
       {"/ModDate (", ')'},
       {"xmp:CreateDate=\"", '"'},
       {"xmp:ModifyDate=\"", '"'},
       {"xmp:MetadataDate=\"", '"'},
       {"xmpMM:DocumentID=\"", '"'},
       {"/ID [ <", ']'}}};
  // The length stays the same: a PDF has a table of the positions of its objects.
  for (const auto& [opening, closing] : kVariableParts) {
    const auto begin = pdf.find(opening);
    if (begin == std::string::npos) continue;
    const auto end = pdf.find(closing, begin + opening.size());
    if (end != std::string::npos) pdf.replace(begin, end + 1 - begin, end + 1 - begin, ' ');
  }
  return pdf;
}

std::string to_pdf(const Drawing& drawing) {
  QBuffer buffer;
  buffer.open(QIODevice::WriteOnly);
  QPdfWriter writer(&buffer);
  const auto size = QSizeF(drawing.plot->size()) * kPointsPerPixel;
  writer.setPageSize(QPageSize(size, QPageSize::Point, {}, QPageSize::ExactMatch));
  writer.setPageMargins(QMarginsF(0, 0, 0, 0));
  writer.setResolution(288);
  writer.setTitle(QString::fromStdString(drawing.caption));
  writer.setCreator("triax");
  QPainter page;
  if (!page.begin(&writer)) throw lab::WorkFailed("a figure cannot be drawn as PDF");
  page.setRenderHint(QPainter::LosslessImageRendering);
  draw_on_page(*drawing.plot, page, QRectF(0, 0, writer.width(), writer.height()));
  if (!page.end()) throw lab::WorkFailed("a figure cannot be drawn as PDF");
  return make_reproducible(buffer.data().toStdString());
}

std::vector<std::string> write_figure(const Drawing& drawing, const std::string& prefix) {
  const std::vector<std::pair<std::string, std::string>> files = {
      {prefix + ".svg", standalone_svg(drawing)},
      {prefix + ".png", to_png(*drawing.plot, 2, drawing.caption)},
      {prefix + ".pdf", to_pdf(drawing)}};
  std::vector<std::string> paths;
  for (const auto& [path, bytes] : files) {
    write_file(path, bytes);
    paths.push_back(path);
  }
  return paths;
}

std::string to_csv(const FigureData& data) {
  std::string out =
      fmt::format("# {}\n# origin = \"{}\"\n", on_one_line(data.title), on_one_line(data.origin));
  for (const auto& remark : data.remarks) out += fmt::format("# {}\n", on_one_line(remark));
  for (const auto& column : data.columns)
    if (!column.unit.empty())
      out += fmt::format("# {} in {}\n", on_one_line(column.name), on_one_line(column.unit));
  for (std::size_t i = 0; i < data.columns.size(); ++i)
    out += (i > 0 ? "," : "") + quoted(on_one_line(data.columns[i].name));
  out += '\n';
  for (const auto& row : data.rows) {
    for (std::size_t i = 0; i < row.size(); ++i) {
      if (i > 0) out += ',';
      if (const auto value = known(row[i])) out += fmt::format("{}", *value);
    }
    out += '\n';
  }
  return out;
}

std::string to_json(const FigureData& data) {
  nlohmann::ordered_json document = {
      {"title", data.title}, {"origin", data.origin}, {"remarks", data.remarks}};
  auto& columns = document["columns"] = nlohmann::ordered_json::array();
  for (const auto& column : data.columns)
    columns.push_back({{"name", column.name}, {"unit", column.unit}});
  // A row a line: readable, and not a line a number.
  std::string rows;
  for (const auto& row : data.rows) {
    auto line = nlohmann::ordered_json::array();
    for (const auto& cell : row) {
      const auto value = known(cell);
      line.push_back(value ? nlohmann::ordered_json(*value) : nlohmann::ordered_json());
    }
    rows += (rows.empty() ? "\n    " : ",\n    ") + line.dump();
  }
  auto text = document.dump(2);
  text.resize(text.size() - 2);  // the closing brace and its line break
  return text + fmt::format(",\n  \"rows\": [{}\n  ]\n}}\n", rows);
}

std::vector<std::string> write_figure_data(const FigureData& data, const std::string& prefix) {
  const auto csv = to_csv(data), json = to_json(data);
  write_file(prefix + ".csv", csv);
  write_file(prefix + ".json", json);
  return {prefix + ".csv", prefix + ".json"};
}

void write_named_figure(const NamedFigure& figure, const std::string& prefix) {
  write_figure(figure.drawing, prefix + '_' + figure.name);
  write_figure_data(figure.data, prefix + '_' + figure.name);
}

}  // namespace triax::src

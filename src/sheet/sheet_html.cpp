// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/sheet/sheet_html.hpp"

#include <fmt/format.h>
#include <qcustomplot.h>

#include "src/output/markup.hpp"

namespace triax::src {
namespace {

constexpr double kRowWidth = 3 * kSheetFigureWidth;  // px
constexpr int kFigureHeight = 235;

std::string part_html(const SheetPart& part, double shares, double height) {
  std::string inside = box_markup(part.box);
  if (part.plot) {
    resize_plot(*part.plot, static_cast<int>(kRowWidth * part.share / shares),
                static_cast<int>(kFigureHeight * height));
    if (part.settle) part.settle(*part.plot);
    inside = to_svg(*part.plot);
  }
  return fmt::format("<div class=\"part{}{}\" style=\"flex: {:.3g}\">\n{}</div>\n",
                     part.plot ? " figure" : "", part.box.marked ? " marked" : "", part.share,
                     inside);
}

}  // namespace

const char* sheet_style() {
  return R"(.sheet { width: 198mm; margin: 1rem auto; font-size: 7.6pt; line-height: 1.25; }
.sheet .head { border: 1px solid #222; padding: 0.25rem 0.6rem; display: flex; gap: 1rem;
  font-size: 12pt; font-weight: 700; align-items: baseline; }
.sheet .head .mark { color: #d55e00; } .sheet .head .subject { margin-left: auto; }
.sheet .row { display: flex; gap: 1.4mm; margin-top: 1.4mm; }
.sheet .part { border: 1px solid #888; padding: 0.8mm 1mm; min-width: 0; overflow-wrap: break-word; }
.sheet .part.figure { padding: 0; } .sheet .part svg { display: block; width: 100%; height: auto; }
.sheet .marked { background: #fbe3d3; border-color: #d55e00; print-color-adjust: exact; }
.sheet .title { font-weight: 700; }
.sheet table { font-size: inherit; width: 100%; border-collapse: collapse; }
.sheet td, .sheet th { padding: 0 0.6mm; border: 0; vertical-align: top; font-weight: 400; }
.sheet .rows [align=right] { white-space: nowrap; }
.sheet th { color: #555; border-bottom: 1px solid #999; }
.sheet .label { color: #555; white-space: nowrap; width: 1%; }
.sheet .blank { border-bottom: 1px solid #999; min-width: 18mm; }
.sheet .foot { color: #777; font-size: 6pt; margin-top: 1mm; }
@media print { @page { size: A4; margin: 6mm; } .sheet { margin: 0; }
  .sheet + .sheet { break-before: page; }
  .sheet .row { break-inside: avoid; } })";
}

std::string sheet_html(const Sheet& sheet, const std::string& id) {
  std::string html = fmt::format(
      "<section class=\"sheet\" id=\"{}\">\n<div class=\"head\"><span>{}</span><span "
      "class=\"mark\">{}</span><span class=\"subject\">{}</span></div>\n",
      escaped(id), escaped(sheet.title), escaped(sheet.mark), escaped(sheet.subject));
  for (const auto& row : sheet.rows) {
    double shares = 0;
    for (const auto& part : row.parts) shares += part.share;
    html += "<div class=\"row\">\n";
    // A figure beside boxes is as high as they usually are.
    const double height = row.parts.front().plot ? row.weight : 0.8;
    for (const auto& part : row.parts) html += part_html(part, shares, height);
    html += "</div>\n";
  }
  return html + fmt::format("<div class=\"foot\">{}</div>\n</section>\n", escaped(sheet.footer));
}

}  // namespace triax::src

// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/triaxial/html_report.hpp"

#include <fmt/format.h>

#include "src/output/markup.hpp"
#include "src/sheet/sheet_html.hpp"
#include "src/triaxial/content.hpp"
#include "src/triaxial/sheet/set_sheet.hpp"
#include "src/triaxial/sheet/test_sheet.hpp"
#include "src/triaxial/test_figures.hpp"

namespace triax::src {
namespace {

constexpr const char* kHead = R"(<!DOCTYPE html>
<html lang="en">
<head>
<meta charset="utf-8"/>
<meta name="viewport" content="width=device-width, initial-scale=1"/>
<title>Triaxial tests</title>
<style>
body { font: 15px/1.45 "DejaVu Sans", Verdana, sans-serif; color: #222; background: #fff;
       max-width: 80rem; margin: 0 auto; padding: 1rem; }
h1 { font-size: 1.5rem; }
h2 { font-size: 1.2rem; margin: 2.5rem 0 0.5rem; border-top: 2px solid #222; padding-top: 0.7rem; }
h3 { font-size: 1rem; margin: 1.2rem 0 0.3rem; }
a { color: #005a8c; }
.scroll { overflow-x: auto; }
table { border-collapse: collapse; font-size: 0.87rem; font-variant-numeric: tabular-nums; }
th, td { padding: 0.25rem 0.6rem; vertical-align: top; border-bottom: 1px solid #ddd; }
.data thead th { border-bottom: 2px solid #222; white-space: nowrap; }
.data td[align=right] { white-space: nowrap; }
.facts th { white-space: nowrap; font-weight: 600; }
.banner { background: #fbe3d3; border-left: 6px solid #d55e00; color: #222; font-weight: 700;
          padding: 0.5rem 0.8rem; margin: 0.6rem 0; }
.notes { font-size: 0.82rem; color: #444; padding-left: 1.2rem; }
.figures { display: grid; gap: 1rem 2rem; align-items: start;
           grid-template-columns: repeat(auto-fit, minmax(min(100%, 36rem), 1fr)); }
figure { margin: 1rem 0; overflow-x: auto; }
figure svg { display: block; width: 100%; max-width: 620px; min-width: 27rem; height: auto; }
figcaption { font-size: 0.87rem; color: #444; }
@media (max-width: 40rem) { .facts th, .facts td { display: block; border: 0; padding: 0.1rem 0; }
  .facts tr { display: block; border-bottom: 1px solid #ddd; padding: 0.3rem 0; } }
@media print { body { font-size: 10pt; padding: 0; margin: 0; }
  h2 { break-before: page; border-top: 0; } h2, h3 { break-after: avoid; }
  figure, tr, .banner { break-inside: avoid; } .scroll { overflow: visible; }
  .figures { display: block; } figure { overflow: visible; }
  figure svg { max-height: 235mm; min-width: 0; } .banner { print-color-adjust: exact; } }
)";

std::string anchor(const study::TestResult& test) { return fmt::format("test-{}", test.stored.id); }

std::string figure_markup(const Drawing& drawing) {
  return fmt::format("<figure>\n{}<figcaption>{}</figcaption>\n</figure>\n", to_svg(*drawing.plot),
                     escaped(drawing.caption));
}

std::string scrolling(const std::string& table) {
  return "<div class=\"scroll\">\n" + table + "</div>\n";
}

std::string section(const char* title, const Table& table) {
  if (table.rows.empty()) return {};
  return fmt::format("<h3>{}</h3>\n{}", title, scrolling(table_markup(table)));
}

std::string evidence_markup(const study::TestResult& test) {
  const auto content = test_content(test);
  std::string html = fmt::format("<section id=\"{}-evidence\">\n<h2>{}</h2>\n", anchor(test),
                                 escaped(content.title));
  if (!content.banner.empty())
    html += fmt::format("<p class=\"banner\">{}</p>\n", escaped(content.banner));
  html += facts_markup(content.facts);
  html += "<div class=\"figures\">\n";
  for (const auto& figure : test_figures(test)) html += figure_markup(figure.drawing);
  html += "</div>\n" + section("Criteria of collapse", content.criteria);
  html += section("Events", content.events);
  html += section("Checks", content.checks);
  return html + "</section>\n";
}

}  // namespace

std::string html_report(const ReportSheets& sheets, const std::string& more) {
  std::string html = kHead;
  html += sheet_style();
  html += "</style>\n</head>\n<body>\n";
  if (sheets.tests.empty() && more.empty()) html += "<p>The database holds no test.</p>\n";
  std::size_t number = 0;
  for (const auto& set : test_sets(sheets.tests))
    html += sheet_html(set_sheet(set), fmt::format("set-{}", ++number));
  sheets.for_each_page([&](const SheetTest& test) {
    html += sheet_html(test_sheet(test), anchor(test.result));
    if (sheets.evidence) html += evidence_markup(test.result);
  });
  return html + more + "</body>\n</html>\n";
}

}  // namespace triax::src

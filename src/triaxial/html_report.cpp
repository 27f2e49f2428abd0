// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/triaxial/html_report.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "src/output/markup.hpp"
#include "src/triaxial/content.hpp"
#include "src/triaxial/figures/collapse_points_figure.hpp"
#include "src/triaxial/test_figures.hpp"

namespace triax::src {
namespace {

constexpr const char* kHead = R"(<!DOCTYPE html>
<html lang="en">
<head>
<meta charset="utf-8"/>
<meta name="viewport" content="width=device-width, initial-scale=1"/>
<title>Triaxial tests: collapse report</title>
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
@media print { @page { size: A4; margin: 15mm; } body { font-size: 10pt; padding: 0; }
  h2 { break-before: page; border-top: 0; } h2, h3 { break-after: avoid; }
  figure, tr, .banner { break-inside: avoid; } .scroll { overflow: visible; }
  .figures { display: block; } figure { overflow: visible; }
  figure svg { max-height: 235mm; min-width: 0; } .banner { print-color-adjust: exact; } }
</style>
</head>
<body>
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

std::string test_markup(const study::TestResult& test) {
  const auto content = test_content(test);
  std::string html =
      fmt::format("<section id=\"{}\">\n<h2>{}</h2>\n", anchor(test), escaped(content.title));
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

std::string summary_markup(const std::vector<study::TestResult>& tests) {
  const auto table = summary_table(tests);
  std::vector<std::string> anchors;
  for (const auto& test : tests) anchors.push_back(anchor(test));
  std::string html = scrolling(table_markup(table, anchors, kSummaryNameColumn));
  html += "<ul class=\"notes\">\n";
  for (const auto& note : summary_notes()) html += fmt::format("<li>{}</li>\n", escaped(note));
  html += "</ul>\n";
  if (const auto points = collapse_points_figure(study::collapse_points(tests)); points.plot)
    html += figure_markup(points);
  return html;
}

}  // namespace

std::string html_report(const std::vector<study::TestResult>& tests, const std::string& more) {
  std::string html = kHead;
  html += "<h1>Triaxial tests: when and why they became unstable</h1>\n";
  if (tests.empty() && more.empty()) html += "<p>The database holds no test.</p>\n";
  if (const auto banner = summary_banner(tests); !banner.empty())
    html += fmt::format("<p class=\"banner\">{}</p>\n", escaped(banner));
  if (!tests.empty()) html += summary_markup(tests);
  for (const auto& test : tests) html += test_markup(test);
  return html + more + "</body>\n</html>\n";
}

}  // namespace triax::src

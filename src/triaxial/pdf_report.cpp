// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/triaxial/pdf_report.hpp"

#include <fmt/format.h>

#include <QBuffer>

#include "src/output/markup.hpp"
#include "src/output/output.hpp"
#include "src/plot/figure_files.hpp"
#include "src/plot/pages.hpp"
#include "src/sheet/sheet_pages.hpp"
#include "src/triaxial/content.hpp"
#include "src/triaxial/sheet/set_sheet.hpp"
#include "src/triaxial/sheet/test_sheet.hpp"
#include "src/triaxial/test_figures.hpp"

namespace triax::src {
namespace {

constexpr const char* kTitle = "Triaxial tests";

std::string banner_markup(const std::string& banner) {
  if (banner.empty()) return {};
  return fmt::format(
      "<table width=\"100%\" cellpadding=\"5\"><tr><td class=\"banner\">{}</td></tr>"
      "</table>\n",
      escaped(banner));
}

void add_figure(PageSection& section, Drawing drawing) {
  section.markup += fmt::format("<p><img src=\"{}\"/></p>\n", section.figures.size());
  section.figures.push_back(std::move(drawing));
}

void add_table(PageSection& section, const char* title, const Table& table) {
  if (table.rows.empty()) return;
  section.markup += fmt::format("<h3>{}</h3>\n{}", title, table_markup(table));
}

PageSection evidence_section(const study::TestResult& test) {
  const auto content = test_content(test);
  PageSection section{content.title, fmt::format("<h2>{}</h2>\n", escaped(content.title)), {}};
  if (!content.banner.empty()) section.running_head += " – " + content.banner;
  section.markup += banner_markup(content.banner) + facts_markup(content.facts);
  add_table(section, "Criteria of collapse", content.criteria);
  add_table(section, "Events", content.events);
  add_table(section, "Checks", content.checks);
  for (auto& figure : test_figures(test)) add_figure(section, std::move(figure.drawing));
  return section;
}

}  // namespace

std::string pdf_bytes(const ReportSheets& sheets, const std::vector<PageSection>& more) {
  need_drawing();
  QBuffer buffer;
  buffer.open(QIODevice::WriteOnly);
  Pages pages(buffer, kTitle);
  const auto add_sheet = [&](const Sheet& sheet) {
    pages.add_page([&](QPainter& page, QPaintDevice& device) { draw_sheet(sheet, page, device); });
  };
  if (sheets.tests.empty() && more.empty())
    pages.add({kTitle, "<p>The database holds no test.</p>", {}});
  for (const auto& set : test_sets(sheets.tests)) add_sheet(set_sheet(set));
  sheets.for_each_page([&](const SheetTest& test) {
    add_sheet(test_sheet(test));
    if (sheets.evidence) pages.add(evidence_section(test.result));
  });
  for (const auto& section : more) pages.add(section);
  pages.finish();
  return make_reproducible(buffer.data().toStdString());
}

void pdf_report(const ReportSheets& sheets, const std::string& path,
                const std::vector<PageSection>& more) {
  write_file(path, pdf_bytes(sheets, more));
}

}  // namespace triax::src

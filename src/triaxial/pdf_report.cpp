// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/triaxial/pdf_report.hpp"

#include <fmt/format.h>

#include <QBuffer>

#include "src/output/markup.hpp"
#include "src/output/output.hpp"
#include "src/plot/figure_files.hpp"
#include "src/plot/pages.hpp"
#include "src/triaxial/content.hpp"
#include "src/triaxial/figures/collapse_points_figure.hpp"
#include "src/triaxial/test_figures.hpp"

namespace triax::src {
namespace {

constexpr const char* kTitle = "Triaxial tests: when and why they became unstable";

std::string banner_markup(const std::string& banner) {
  if (banner.empty()) return {};
  return fmt::format(
      "<table width=\"100%\" cellpadding=\"5\"><tr><td class=\"banner\">{}</td></tr>"
      "</table>\n",
      escaped(banner));
}

void add_figure(PageSection& section, Drawing drawing) {
  section.markup += fmt::format("<p><img src=\"{}\"/></p>\n<p class=\"caption\">{}</p>\n",
                                section.figures.size(), escaped(drawing.caption));
  section.figures.push_back(std::move(drawing));
}

void add_table(PageSection& section, const char* title, const Table& table) {
  if (table.rows.empty()) return;
  section.markup += fmt::format("<h3>{}</h3>\n{}", title, table_markup(table));
}

PageSection summary_section(const std::vector<study::TestResult>& tests) {
  PageSection section{kTitle, fmt::format("<h1>{}</h1>\n", kTitle), {}};
  if (tests.empty()) {
    section.markup += "<p>The database holds no test.</p>\n";
    return section;
  }
  section.markup += banner_markup(summary_banner(tests)) + table_markup(summary_table(tests));
  for (const auto& note : summary_notes())
    section.markup += fmt::format("<div class=\"notes\">{}</div>\n", escaped(note));
  if (auto points = collapse_points_figure(study::collapse_points(tests)); points.plot)
    add_figure(section, std::move(points));
  return section;
}

PageSection test_section(const study::TestResult& test) {
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

std::string pdf_bytes(const std::vector<study::TestResult>& tests,
                      const std::vector<PageSection>& more) {
  need_drawing();
  QBuffer buffer;
  buffer.open(QIODevice::WriteOnly);
  Pages pages(buffer, kTitle);
  if (!tests.empty() || more.empty()) pages.add(summary_section(tests));
  for (const auto& test : tests) pages.add(test_section(test));
  for (const auto& section : more) pages.add(section);
  pages.finish();
  return without_date(buffer.data().toStdString());
}

void pdf_report(const std::vector<study::TestResult>& tests, const std::string& path,
                const std::vector<PageSection>& more) {
  write_file(path, pdf_bytes(tests, more));
}

}  // namespace triax::src

// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/grains/grain_markup.hpp"

#include <fmt/format.h>

#include "src/grains/grain_content.hpp"
#include "src/grains/grain_figures.hpp"
#include "src/output/markup.hpp"

namespace triax::src {
namespace {

constexpr const char* kTitle = "Runs of grains";
constexpr std::size_t kNameColumn = 1;  // of grain_summary_table

std::string anchor(const db::StoredGrainRun& run) { return fmt::format("grains-{}", run.id); }

std::string scrolling(const std::string& table) {
  return "<div class=\"scroll\">\n" + table + "</div>\n";
}

std::string section_html(const GrainSection& section) {
  std::string html = fmt::format("<h3>{}</h3>\n{}", escaped(section.title),
                                 scrolling(table_markup(section.table)));
  if (!section.notes.empty()) {
    html += "<ul class=\"notes\">\n";
    for (const auto& note : section.notes) html += fmt::format("<li>{}</li>\n", escaped(note));
    html += "</ul>\n";
  }
  return section.facts.empty() ? html : html + facts_markup(section.facts);
}

std::string run_html(const db::StoredGrainRun& run) {
  const GrainContent content = grain_content(run);
  std::string html = fmt::format("<section id=\"{}\">\n<h2>{}</h2>\n<p class=\"banner\">{}</p>\n",
                                 anchor(run), escaped(content.title), escaped(content.banner));
  html += facts_markup(content.facts) + "<div class=\"figures\">\n";
  for (const auto& [name, drawing, data] : grain_figures(run.report))
    html += fmt::format("<figure>\n{}<figcaption>{}</figcaption>\n</figure>\n",
                        to_svg(*drawing.plot), escaped(drawing.caption));
  html += "</div>\n";
  for (const auto& section : content.sections) html += section_html(section);
  return html + "</section>\n";
}

/// Text of a page: its banner is a table, which Qt draws with a background.
std::string banner_page(const std::string& banner) {
  return fmt::format(
      "<table width=\"100%\" cellpadding=\"5\"><tr><td class=\"banner\">{}</td></tr></table>\n",
      escaped(banner));
}

PageSection run_page(const db::StoredGrainRun& run) {
  const GrainContent content = grain_content(run);
  PageSection page{content.title + " – " + content.banner,
                   fmt::format("<h2>{}</h2>\n", escaped(content.title)) +
                       banner_page(content.banner) + facts_markup(content.facts),
                   {}};
  for (const auto& section : content.sections) {
    page.markup +=
        fmt::format("<h3>{}</h3>\n{}", escaped(section.title), table_markup(section.table));
    for (const auto& note : section.notes)
      page.markup += fmt::format("<div class=\"notes\">{}</div>\n", escaped(note));
    if (!section.facts.empty()) page.markup += facts_markup(section.facts);
  }
  for (auto& [name, drawing, data] : grain_figures(run.report)) {
    page.markup += fmt::format("<p><img src=\"{}\"/></p>\n", page.figures.size());
    page.figures.push_back(std::move(drawing));
  }
  return page;
}

}  // namespace

std::string grain_html(const std::vector<db::StoredGrainRun>& runs) {
  if (runs.empty()) return {};
  std::vector<std::string> anchors;
  anchors.reserve(runs.size());
  for (const auto& run : runs) anchors.push_back(anchor(run));
  std::string html = fmt::format("<h2>{}</h2>\n", kTitle) +
                     scrolling(table_markup(grain_summary_table(runs), anchors, kNameColumn));
  for (const auto& run : runs) html += run_html(run);
  return html;
}

std::vector<PageSection> grain_pages(const std::vector<db::StoredGrainRun>& runs) {
  std::vector<PageSection> pages;
  if (runs.empty()) return pages;
  pages.push_back(
      {kTitle, fmt::format("<h1>{}</h1>\n", kTitle) + table_markup(grain_summary_table(runs)), {}});
  for (const auto& run : runs) pages.push_back(run_page(run));
  return pages;
}

}  // namespace triax::src

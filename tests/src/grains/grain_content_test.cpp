// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/grains/grain_content.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "src/grains/grain_json.hpp"
#include "src/grains/grain_markup.hpp"
#include "src/grains/grain_text.hpp"
#include "tests/src/contains.hpp"
#include "tests/src/sample_grains.hpp"

using namespace triax;
using namespace triax::src;
using test::contains;

namespace {

std::string fact_of(const GrainContent& content, const std::string& label) {
  for (const auto& fact : content.facts)
    if (fact.label == label) return fact.lines.front();
  return {};
}

}  // namespace

TEST_CASE("a run in full has its specimen as facts and its stages as tables") {
  const GrainContent content = grain_content(test::stored(test::sample_run()));
  CHECK(content.title == "Run of grains 3: sample");
  CHECK(contains(content.banner, "SIMULATED"));
  CHECK(fact_of(content, "source") == "sample.toml");
  CHECK(contains(fact_of(content, "made"), "seed 7"));
  CHECK(fact_of(content, "status").empty());
  std::vector<std::string> titles;
  for (const auto& section : content.sections) titles.push_back(section.title);
  CHECK(titles == std::vector<std::string>{"Stages", "Paths", "Strain paths", "Marks", "Rests",
                                           "Stage probes: responses and contacts",
                                           "Stage probes: density of second-order work (J/m³)",
                                           "Stage probes: difference of microscopic and "
                                           "macroscopic work (J/m³)",
                                           "Stage probes: energy", "Perturbations", "Energy"});
  CHECK_FALSE(content.sections[6].facts.empty());
}

TEST_CASE("a run that was cut off, or stored by an older version, says so") {
  auto run = test::stored(test::sample_run());
  run.status = db::TestStatus::interrupted;
  run.whole = false;
  run.report.specimen->measures.grain_contacts = lab::kNotStored;
  run.report.specimen->median_m = std::nan("");
  const GrainContent content = grain_content(run);
  CHECK(contains(content.banner, "INTERRUPTED"));
  CHECK(contains(grain_text(run), "status      INTERRUPTED"));
  CHECK(contains(fact_of(content, "stored"), "older version"));
  CHECK(contains(fact_of(content, "contacts"), "– of grains, "));
  CHECK(contains(fact_of(content, "grains"), "median – mm"));
  CHECK(contains(grain_run_json(run), "\"status\": \"interrupted\""));
  CHECK(contains(grain_run_json(run), "\"grain_contacts\": null"));
  CHECK(contains(grain_run_json(run), "\"median_mm\": null"));
}

TEST_CASE("runs beside each other have a row each with what their last stage came to") {
  const Table table =
      grain_summary_table({test::stored(test::sample_run()), test::stored({"b", "", {}, {}})});
  REQUIRE(table.rows.size() == 2);
  CHECK(table.rows[0] == std::vector<std::string>{"3", "sample", "SIMULATED", "complete", "4",
                                                  "0.9948", "0.00", "9", "energy b: COLLAPSED"});
  CHECK(table.rows[1][4] == "–");
  CHECK(table.rows[1].back() == "–");
  const std::string text = grain_runs_text({test::stored(test::sample_run())});
  CHECK(text.starts_with("Runs of grains\n"));
  CHECK(contains(text, "\nGrains, sample (simulated)\n"));
}

TEST_CASE("markup of a run has its facts, tables and figures, and escapes names") {
  auto report = test::sample_run();
  report.programme = "<s>";
  const auto run = test::stored(std::move(report));
  const std::string html = grain_html({run});
  CHECK(contains(html, "<section id=\"grains-3\">"));
  CHECK(contains(html, "Run of grains 3: &lt;s&gt;"));
  CHECK_FALSE(contains(html, "<s>"));
  CHECK(contains(html, "<svg"));
  CHECK(contains(html, "Perturbations"));
  const auto pages = grain_pages({run});
  REQUIRE(pages.size() == 2);
  CHECK(contains(pages[1].running_head, "SIMULATED"));
  CHECK(pages[1].figures.size() == 8);
  CHECK(contains(pages[1].markup, "<img src=\"7\"/>"));
  CHECK(grain_html({}).empty());
  CHECK(grain_pages({}).empty());
}

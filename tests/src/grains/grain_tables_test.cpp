// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/grains/grain_tables.hpp"

#include <catch2/catch.hpp>

#include "tests/src/contains.hpp"
#include "tests/src/sample_grains.hpp"

using namespace triax;
using namespace triax::src;

namespace {

void check_widths(const Table& table) {
  for (const auto& row : table.rows) CHECK(row.size() == table.columns.size());
}

}  // namespace

TEST_CASE("every table has a row each of its kind, as wide as its headings") {
  const lab::GrainReport report = test::sample_run();
  CHECK(stages_table(report).rows.size() == 9);
  CHECK(paths_table(report).rows.size() == 4);
  CHECK(strain_paths_table(report).rows.size() == 2);
  CHECK(marks_table(report).rows.size() == 2);
  CHECK(rests_table(report).rows.size() == 1);
  CHECK(perturbations_table(report).rows.size() == 3);
  for (const auto& table : {stages_table(report), paths_table(report), strain_paths_table(report),
                            marks_table(report), rests_table(report), perturbations_table(report)})
    check_widths(table);
}

TEST_CASE("a strain path tells its peak and where W2 turns negative") {
  const Table table = strain_paths_table(test::sample_run());
  CHECK(table.rows[0] == std::vector<std::string>{"R-0.8", "0.8", "20.00", "0.200", "71.7", "0.488",
                                                  "yes", "0.220", "19.00"});
}

TEST_CASE("a perturbation tells how it ended") {
  const Table table = perturbations_table(test::sample_run());
  CHECK(table.rows[1] == std::vector<std::string>{"load b", "ES_b", "500", "none", "40",
                                                  "COLLAPSED", "0.1000", "0.0500", "0.1000",
                                                  "1.00e-04"});
}

TEST_CASE("probes have the null probe behind them, and stopped ones say nothing") {
  lab::ReportedGrainRose rose{{}, 1000, 0, {{260e3, 200e3}, sim::rose_angles(), test::rose()}};
  rose.made.rose.probes[1].stopped = true;
  const auto [responses, work, gap, energy] = rose_tables(rose);
  for (const Table* table : {&responses, &work, &gap, &energy}) check_widths(*table);
  REQUIRE(responses.rows.size() == 37);
  CHECK(responses.rows[9] == std::vector<std::string>{"90", "10.000", "0.000", "1.000", "5.00",
                                                      "0.10", "1.00e-06", "4000", "yes"});
  CHECK(responses.rows[1].back() == "stopped");
  CHECK(responses.rows[1][1] == "–");
  CHECK(responses.rows[14].back() == "NO");
  CHECK(responses.rows[36].front() == "null");
  CHECK(work.rows[9] == std::vector<std::string>{"90", "0.01000", "0.01000", "0.00900", "0.00010",
                                                 "0.00090", "0.01200", "1.200", "1.0000"});
  CHECK(gap.rows[9] == std::vector<std::string>{"90", "0.0020000", "0.0018000", "0.0001200",
                                                "0.0000600", "0.0000200", "-0.0300"});
  CHECK(gap.rows[1][1] == "–");
  CHECK(energy.rows[9] == std::vector<std::string>{"90", "2.00e-06", "1.00e-06", "0.00e+00",
                                                   "9.00e-07", "9.00e-08", "0.00e+00", "5.00e-03",
                                                   "0.00e+00"});
}

TEST_CASE("probes by strain tell the stresses that answer; those of old databases have no gap") {
  lab::ReportedGrainRose rose{
      sim::ProbeKind::strain, 0, 2e-5, {{260e3, 200e3}, sim::rose_angles(), test::rose()}};
  const RoseTables tables = rose_tables(rose);
  CHECK(tables.responses.columns[1].heading == "dσ₁ (Pa)");
  CHECK(tables.responses.rows[9][1] == "1000.00");
  CHECK(test::contains(rose_facts(rose).front().second, "probes of 2e-05 of strain"));
  rose.made.rose.null_probe.ledger = lab::ledger_not_stored();
  CHECK(rose_tables(rose).gap.rows.empty());
  CHECK(rose_tables(rose).energy.rows.empty());
}

TEST_CASE("every stage but a rose has a row of where its energy went") {
  lab::GrainReport report = test::sample_run();
  CHECK(energies_table(report).rows.size() == 8);
  CHECK(energies_table(report).rows[1][0] == "shear");
  CHECK(energies_table(report).rows[1][7] == "5.00e-03");
  report.stages[1].ledger.reset();
  CHECK(energies_table(report).rows.size() == 7);
}

TEST_CASE("a null probe that strains too much puts signs in doubt") {
  lab::ReportedGrainRose rose{{}, 1000, 0, {{260e3, 200e3}, sim::rose_angles(), test::rose()}};
  const auto words = [&] {
    for (const auto& [label, text] : rose_facts(rose))
      if (label == "null probe") return text;
    return std::string();
  };
  CHECK_FALSE(test::contains(words(), "doubt"));
  rose.made.rose.null_probe.strain = {2e-6, 0};
  CHECK(test::contains(words(), "20.00 % of the smallest probe's: signs of W₂ are in doubt"));
  rose.made.rose.null_probe.stopped = true;
  CHECK(words() == "not made");
}

// SPDX-License-Identifier: GPL-3.0-or-later
#include "db/scans/read_columns.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <fstream>
#include <numeric>
#include <set>

#include "db/recording/recorder.hpp"
#include "lab/rig/recorded.hpp"
#include "lab/rig/session.hpp"
#include "tests/db/temporary_folder.hpp"

using namespace triax;

namespace {

/// Rows of a stored record against what its scans decode to and what fill_row() made of them.
void check_rows(const std::string& record) {
  const triax::testing::TemporaryFolder folder;
  const std::string path = folder.file("rows.db");
  std::vector<std::vector<double>> told;
  db::Recorder recorder(path);
  const auto rig = lab::open_record(record, {});
  const auto summary = lab::run_session(
      *rig, {.reduction = {}},
      {recorder.listener(), {.scanned = [&](const lab::Reading& reading, const lab::State& state) {
         db::fill_row(reading, state, told.emplace_back());
       }}});
  const std::int64_t id = recorder.finish(summary);
  const db::Store store(path);
  std::vector<std::size_t> all(db::read_columns().size());
  std::iota(all.begin(), all.end(), 0);
  std::size_t at = 0;
  store.for_each_row(id, 0, all, [&](std::int64_t reading, std::span<const double> row) {
    REQUIRE(reading == static_cast<std::int64_t>(at));
    REQUIRE(row.size() == told[at].size());
    for (std::size_t i = 0; i < row.size(); ++i) {
      INFO(record << ", " << db::read_columns()[i].name << " at " << at << ": " << row[i] << " and "
                  << told[at][i]);
      if (std::isnan(told[at][i]))
        REQUIRE(std::isnan(row[i]));
      else
        REQUIRE(row[i] + 0.0 == told[at][i] + 0.0);
    }
    ++at;
  });
  CHECK(at == told.size());
  std::size_t from_half = 0;
  store.for_each_row(id, static_cast<std::int64_t>(at / 2), all,
                     [&](std::int64_t, std::span<const double>) { ++from_half; });
  CHECK(from_half == at - at / 2);
}

}  // namespace

TEST_CASE("columns have names of their own") {
  std::set<std::string> names;
  for (const auto& column : db::read_columns()) names.insert(column.name);
  CHECK(names.size() == db::read_columns().size());
  CHECK(db::find_read_column("q_kPa"));
  CHECK_FALSE(db::find_read_column("q_kPa; DROP TABLE scans"));
}

TEST_CASE("a row of the database is the row that was told while the test ran, to the bit") {
  check_rows("samples/records/icu_6.csv");
}

TEST_CASE("also where stresses were reduced before, and where there is no pore pressure") {
  const triax::testing::TemporaryFolder folder;
  const std::string path = folder.file("reduced.csv");
  {
    std::ofstream file(path);
    file << "axial_strain_pct,deviator_stress_kPa,mean_effective_stress_kPa,excess_pore_pressure_"
            "kPa\n";
    for (int i = 0; i < 60; ++i)
      file << i * 0.013 << ',' << i * 0.71 << ',' << 100 - i * 0.37 << ','
           << (i % 7 == 3 ? std::string() : std::to_string(i * 0.61)) << '\n';
  }
  check_rows(path);
  const std::string drained = folder.file("back.csv");
  {
    std::ofstream file(drained);
    file << "# [specimen]\n# height_mm = 140.0\n# diameter_mm = 70.0\n"
            "time_s,axial_displacement_mm,axial_force_kN,cell_pressure_kPa,back_pressure_kPa\n";
    for (int i = 0; i < 60; ++i)
      file << i << ',' << i * 0.011 << ',' << i * 0.0017 << ",600,"
           << (i % 9 == 4 ? std::string() : std::to_string(500 + i * 0.13)) << '\n';
  }
  check_rows(drained);
}

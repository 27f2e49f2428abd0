// SPDX-License-Identifier: GPL-3.0-or-later
#include "db/scan_source.hpp"

#include <SQLiteCpp/Database.h>

#include <catch2/catch.hpp>
#include <stdexcept>
#include <vector>

using namespace triax;

TEST_CASE("SQL sees a batch as a table; a failure while a row is made ends the statement") {
  std::vector<db::Scan> scans(3);
  for (int i = 0; i < 3; ++i) scans[static_cast<std::size_t>(i)].reading.number = i;
  db::ScanSource source{scans,
                        [](const db::Scan& scan, db::ScanRow& row) {
                          row = {};
                          row.raw.fill(lab::kMissing);
                          row.q_pa = 10.0 * static_cast<double>(scan.reading.number);
                          if (scan.reading.number == 2) throw std::runtime_error("two");
                          return 100 + scan.reading.number;
                        },
                        {}};
  SQLite::Database database(":memory:", SQLite::OPEN_READWRITE | SQLite::OPEN_CREATE);
  db::register_scan_source(database.getHandle(), source);
  source.scans = std::span(scans).first(2);
  CHECK(database.execAndGet("SELECT sum(id) FROM incoming_scans").getInt() == 201);
  CHECK(database.execAndGet("SELECT q_Pa FROM incoming_scans WHERE id = 101").getDouble() == 10);
  CHECK(database.execAndGet("SELECT count(cell_pressure_kPa) FROM incoming_scans").getInt() == 0);
  CHECK_FALSE(source.failure);
  source.scans = scans;
  CHECK_THROWS_AS(database.execAndGet("SELECT sum(id) FROM incoming_scans"), SQLite::Exception);
  CHECK(source.failure);
}

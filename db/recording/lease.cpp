// SPDX-License-Identifier: GPL-3.0-or-later
#include "db/recording/lease.hpp"

#include <SQLiteCpp/Statement.h>

#include <QUuid>

#include "lab/base/bad_input.hpp"

namespace triax::db {
namespace {

constexpr const char* kNow = "strftime('%Y-%m-%dT%H:%M:%SZ', 'now')";

struct LeasedTable {
  const char* table;
  const char* column;  ///< of leases
  const char* again;   ///< what else a row gets back that is no longer interrupted
};

LeasedTable table_of(Leased what) {
  if (what == Leased::test) return {"tests", "test_id", ", readings = NULL"};
  return {"grain_runs", "run_id", ""};
}

}  // namespace

Lease::Lease(Leased what)
    : what_(what), writer_(QUuid::createUuid().toString(QUuid::Id128).toStdString()) {}

void Lease::take(SQLite::Database& database, std::int64_t id) const {
  const std::string column = table_of(what_).column;
  SQLite::Statement insert(database, "INSERT OR REPLACE INTO leases (writer, " + column +
                                         ", last_sign_of_life) VALUES (?, ?, " + kNow + ")");
  insert.bind(1, writer_);
  insert.bind(2, id);
  insert.exec();
}

std::int64_t Lease::row(SQLite::Database& database) const {
  SQLite::Statement select(
      database, std::string("SELECT ") + table_of(what_).column + " FROM leases WHERE writer = ?");
  select.bind(1, writer_);
  return select.executeStep() ? select.getColumn(0).getInt64() : 0;
}

void Lease::renew(SQLite::Database& database) {
  SQLite::Statement sign(
      database, std::string("UPDATE leases SET heartbeats = heartbeats + 1, last_sign_of_life = ") +
                    kNow + " WHERE writer = ?");
  sign.bind(1, writer_);
  if (sign.exec() == 0)
    throw lab::WorkFailed(
        "the test was removed from the database while it was recorded; start it again");
  const LeasedTable of = table_of(what_);
  SQLite::Statement again(database, std::string("UPDATE ") + of.table + " SET status = 'running'" +
                                        of.again +
                                        " WHERE status = 'interrupted' AND id = (SELECT " +
                                        of.column + " FROM leases WHERE writer = ?)");
  again.bind(1, writer_);
  again.exec();
  due_ = std::chrono::steady_clock::now() + kBeat;
}

void Lease::end(SQLite::Database& database) const {
  SQLite::Statement remove(database, "DELETE FROM leases WHERE writer = ?");
  remove.bind(1, writer_);
  remove.exec();
}

}  // namespace triax::db

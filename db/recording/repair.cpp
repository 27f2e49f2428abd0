// SPDX-License-Identifier: GPL-3.0-or-later
#include "db/recording/repair.hpp"

#include <SQLiteCpp/Statement.h>
#include <SQLiteCpp/Transaction.h>
#include <fmt/format.h>

#include <algorithm>

#include "db/connection.hpp"
#include "db/recording/spool.hpp"
#include "db/test_writer.hpp"
#include "lab/base/text.hpp"

namespace triax::db {
namespace {

std::vector<std::int64_t> silent_tests(SQLite::Database& database) {
  SQLite::Statement select(database,
                           "SELECT t.id FROM tests t JOIN seen_tests s ON s.test_id = t.id "
                           "WHERE t.status = 'running' AND s.status = 'interrupted' ORDER BY t.id");
  std::vector<std::int64_t> ids;
  while (select.executeStep()) ids.push_back(select.getColumn(0).getInt64());
  return ids;
}

std::vector<std::string> mark_silent_runs(SQLite::Database& database) {
  SQLite::Statement mark(database,
                         "UPDATE grain_runs SET status = 'interrupted' WHERE status = 'running' "
                         "AND id IN (SELECT run_id FROM seen_grain_runs "
                         "WHERE status = 'interrupted') RETURNING id, name");
  std::vector<std::string> runs;
  while (mark.executeStep())
    runs.push_back(fmt::format("run {} {}", mark.getColumn(0).getInt64(),
                               lab::excerpt(mark.getColumn(1).getString())));
  return runs;
}

}  // namespace

Repaired repair(const std::string& path) {
  check_there(path);
  Repaired done;
  std::vector<std::int64_t> ids;
  for (const std::string& spool : spools_beside(path))
    if (const auto id = take_in(spool, path)) ids.push_back(*id);
  try {
    SQLite::Database database = open_for_writing(path);
    SQLite::Transaction transaction(database, SQLite::TransactionBehavior::IMMEDIATE);
    const auto silent = silent_tests(database);
    for (const std::int64_t id : silent) mark_interrupted(database, id);
    ids.insert(ids.end(), silent.begin(), silent.end());
    done.runs = mark_silent_runs(database);
    transaction.commit();
  } catch (const SQLite::Exception& error) {
    throw_for(error, path);
  }
  done.tests = list_tests(path);
  std::erase_if(done.tests, [&](const ListedTest& test) {
    return std::ranges::find(ids, test.id) == ids.end();
  });
  return done;
}

}  // namespace triax::db

// SPDX-License-Identifier: GPL-3.0-or-later
#include "db/recording/repair.hpp"

#include <SQLiteCpp/Statement.h>
#include <SQLiteCpp/Transaction.h>
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <iterator>
#include <set>
#include <string>

#include "db/connection.hpp"
#include "db/recording/spool.hpp"
#include "db/test_writer.hpp"
#include "lab/base/text.hpp"

namespace triax::db {
namespace {

struct Row {
  std::int64_t id = 0;
  std::string name;
};

/// The running rows of `table` whose writer is silent, or which have none; `column` of leases names
/// them.
std::vector<Row> abandoned(SQLite::Database& database, const std::string& table,
                           const std::string& column, const std::set<std::string>& silent) {
  SQLite::Statement select(database, "SELECT r.id, r.name, coalesce(l.writer, '') FROM " + table +
                                         " r LEFT JOIN leases l ON l." + column +
                                         " = r.id WHERE r.status = 'running' ORDER BY r.id");
  std::vector<Row> rows;
  while (select.executeStep()) {
    const std::string writer = select.getColumn(2).getString();
    if (writer.empty() || silent.contains(writer))
      rows.push_back({select.getColumn(0).getInt64(), select.getColumn(1).getString()});
  }
  return rows;
}

std::vector<std::string> mark_runs(SQLite::Database& database,
                                   const std::set<std::string>& silent) {
  std::vector<std::string> runs;
  for (const Row& run : abandoned(database, "grain_runs", "run_id", silent)) {
    SQLite::Statement mark(database, "UPDATE grain_runs SET status = 'interrupted' WHERE id = ?");
    mark.bind(1, run.id);
    mark.exec();
    runs.push_back(fmt::format("run {} {}", run.id, lab::excerpt(run.name)));
  }
  return runs;
}

}  // namespace

Repaired repair(const std::string& path, const Looks& looks) {
  const std::vector<std::string> spools = spools_beside(path);
  if (spools.empty() || std::filesystem::exists(path)) check_there(path);
  open_for_writing(path);
  std::vector<std::string> databases = {path};
  std::ranges::copy_if(spools, std::back_inserter(databases), waiting_test);
  const std::set<std::string> silent = silent_writers(databases, looks);
  Repaired done;
  std::vector<std::int64_t> ids;
  for (const std::string& spool : spools)
    if (const auto id = take_in(spool, path, silent)) ids.push_back(*id);
  try {
    SQLite::Database database = open_for_writing(path);
    check_pages(database, path);
    SQLite::Transaction transaction(database, SQLite::TransactionBehavior::IMMEDIATE);
    for (const Row& test : abandoned(database, "tests", "test_id", silent)) {
      mark_interrupted(database, test.id);
      ids.push_back(test.id);
    }
    done.runs = mark_runs(database, silent);
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

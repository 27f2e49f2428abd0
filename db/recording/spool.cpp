// SPDX-License-Identifier: GPL-3.0-or-later
#include "db/recording/spool.hpp"

#include <SQLiteCpp/Statement.h>
#include <SQLiteCpp/Transaction.h>

#include <algorithm>
#include <filesystem>

#include "db/connection.hpp"
#include "db/files/created_file.hpp"
#include "db/test_writer.hpp"
#include "lab/base/whole_file.hpp"

namespace triax::db {
namespace {

namespace fs = std::filesystem;
constexpr const char* kWaiting = ".waiting-";
/// Beside a computer that is in trouble: little in memory, short waits.
constexpr std::chrono::milliseconds kOwnFile{100};

void remove_database(const std::string& path) {
  for (const char* ending : {"", "-wal", "-shm", "-journal"}) {
    std::error_code ignored;
    fs::remove(path + ending, ignored);
  }
}

}  // namespace

Spool::Spool(const TestEntry& of, std::int64_t most_bytes)
    : entry_(lab::behind_links(of.path()) + kWaiting + of.lease().writer(), kOwnFile, most_bytes) {}

void Spool::empty_into(TestEntry& test, const TestStart& start) { entry_.copy_into(test, start); }

void Spool::remove() {
  entry_.close();
  remove_database(path());
}

std::vector<std::string> spools_beside(const std::string& path) {
  const std::string database = lab::behind_links(path);
  const fs::path folder = fs::absolute(database).parent_path();
  const std::string begins = fs::path(database).filename().string() + kWaiting;
  std::vector<std::string> spools;
  for (const auto& entry : fs::directory_iterator(folder)) {
    const std::string name = entry.path().filename().string();
    if (name.starts_with(begins) && name.find('-', begins.size()) == std::string::npos)
      spools.push_back((fs::path(database).parent_path() / name).string());
  }
  std::ranges::sort(spools);
  return spools;
}

std::int64_t waiting_test(const std::string& spool) {
  try {
    SQLite::Database there(spool, SQLite::OPEN_READONLY | SQLite::OPEN_NOMUTEX);
    distrust_schema(there);
    check_schema(there, spool);
    if (!there.tableExists("tests")) return 0;
    return there.execAndGet("SELECT coalesce(min(id), 0) FROM tests").getInt64();
  } catch (const SQLite::Exception& error) {
    throw_for(error, spool);
  }
}

namespace {

void remove_if_unused(const std::string& spool) {
  std::optional<SQLite::Database> there(open_for_writing(spool, kOwnFile));
  CreatedFile(spool, *there).remove_if_unused(there);
}

std::string writer_of(const std::string& spool) { return spool.substr(spool.rfind('-') + 1); }

/// It signs in its test while it empties the spool, in the spool while that is locked.
bool writer_lives(const std::string& database, const std::string& writer) {
  SQLite::Database there = open_for_reading(database);
  SQLite::Statement alive(there, "SELECT 1 FROM seen_leases WHERE writer = ? AND alive");
  alive.bind(1, writer);
  return alive.executeStep();
}

/// Whether a running test of the database has a writer that is not silent: `writer`, or any.
bool has_living_writer(const std::string& database, const std::set<std::string>& silent,
                       const std::string& writer) {
  SQLite::Database there = open_for_reading(database);
  SQLite::Statement leases(there,
                           "SELECT l.writer FROM leases l JOIN tests t ON t.id = l.test_id "
                           "WHERE t.status = 'running' AND ?1 IN ('', l.writer)");
  leases.bind(1, writer);
  bool lives = false;
  while (!lives && leases.executeStep()) lives = !silent.contains(leases.getColumn(0).getString());
  return lives;
}

}  // namespace

std::vector<LeftWaiting> left_waiting(const std::string& database) {
  std::vector<LeftWaiting> left;
  for (const std::string& spool : spools_beside(database)) try {
      const std::int64_t id = waiting_test(spool);
      if (id == 0) continue;
      const Store waiting(spool);
      const StoredTest test = waiting.load(id);
      if (test.status == TestStatus::running || writer_lives(database, writer_of(spool))) continue;
      left.push_back({spool, test.header.name, waiting.scan_count(id)});
    } catch (const std::exception&) {
      left.push_back({spool, {}, 0});
    }
  return left;
}

void discard_left_test(const std::string& database, const std::string& writer, bool was_there) {
  remove_database(lab::behind_links(database) + kWaiting + writer);
  if (!fs::exists(database)) return;
  std::optional<SQLite::Database> there(open_for_writing(database));
  try {
    SQLite::Transaction transaction(*there, SQLite::TransactionBehavior::IMMEDIATE);
    if (const auto id = Lease(Leased::test, writer).row(*there)) remove_test(*there, id);
    transaction.commit();
    if (!was_there) CreatedFile(database, *there).remove_if_unused(there);
  } catch (const SQLite::Exception& error) {
    throw_for(error, database);
  }
}

std::optional<std::int64_t> take_in(const std::string& spool, const std::string& database,
                                    const std::set<std::string>& silent) {
  const std::int64_t id = waiting_test(spool);
  if (id == 0) {
    remove_if_unused(spool);
    return std::nullopt;
  }
  const Store waiting(spool);
  const StoredTest test = waiting.load(id);
  const std::string writer = writer_of(spool);
  if (has_living_writer(spool, silent, {}) || has_living_writer(database, silent, writer))
    return std::nullopt;
  TestEntry entry(database, kPatience, writer);
  const TestStart start{test.header, test.stored_at, test.sweep};
  entry.take_in(start, waiting, id);
  entry.interrupt(start, {});
  remove_database(spool);
  return entry.id();
}

}  // namespace triax::db

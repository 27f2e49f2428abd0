// SPDX-License-Identifier: GPL-3.0-or-later
#include "db/test_entry.hpp"

#include <SQLiteCpp/Transaction.h>

#include <filesystem>
#include <utility>

#include "db/connection.hpp"
#include "db/test_writer.hpp"

namespace triax::db {

void Batch::clear() {
  scans.clear();
  work.clear();
  events.clear();
}

TestEntry::TestEntry(std::string path, std::chrono::milliseconds patience)
    : path_(std::move(path)), patience_(patience) {}

void TestEntry::open() {
  if (database_) return;
  const bool existed = std::filesystem::exists(path_);
  database_.emplace(open_for_writing(path_, patience_));
  created_ = created_ || !existed;
}

/// Gives `work` the id of the test, 0 where it is not there yet; it comes back with that it has.
template <class Work>
void TestEntry::in_transaction(const Work& work) {
  try {
    open();
    // IMMEDIATE: a second writer waits here instead of failing in the middle.
    SQLite::Transaction transaction(*database_, SQLite::TransactionBehavior::IMMEDIATE);
    std::int64_t id = id_;
    if (id != 0) lease_.renew(*database_);
    work(id);
    transaction.commit();
    id_ = id;
  } catch (const SQLite::Exception& error) {
    scans_.reset();  // what it remembers was rolled back
    throw_for(error, path_);
  }
}

void TestEntry::write(const TestStart& test, const Batch& batch, std::int64_t& id) {
  if (id == 0) {
    id = insert_test(*database_, test.header, test.stored_at);
    lease_.take(*database_, id);
    if (test.sweep) insert_sweep(*database_, id, *test.sweep);
  }
  if (!scans_) scans_.emplace(*database_, id);
  scans_->write(batch.scans);
  for (const lab::SecondOrderWorkPoint& point : batch.work) scans_->write(point);
  for (const lab::Event& event : batch.events) insert_event(*database_, id, event);
}

void TestEntry::store(const TestStart& test, const Batch& batch) {
  in_transaction([&](std::int64_t& id) { write(test, batch, id); });
}

void TestEntry::complete(const TestStart& test, const Batch& batch,
                         const lab::TestSummary& summary) {
  in_transaction([&](std::int64_t& id) {
    write(test, batch, id);
    insert_summary(*database_, id, summary);
    lease_.end(*database_);
  });
}

void TestEntry::interrupt(const TestStart& test, const Batch& batch) {
  in_transaction([&](std::int64_t& id) {
    write(test, batch, id);
    mark_interrupted(*database_, id);
  });
}

void TestEntry::sign() {
  if (id_ != 0 && lease_.is_due()) in_transaction([](std::int64_t&) {});
}

void TestEntry::close() {
  scans_.reset();
  database_.reset();
}

void TestEntry::discard() {
  scans_.reset();
  if (!database_) return;
  try {
    SQLite::Transaction transaction(*database_, SQLite::TransactionBehavior::IMMEDIATE);
    if (id_ != 0) remove_test(*database_, id_);
    transaction.commit();
    bool remove_file = false;
    if (created_ && database_->execAndGet("SELECT count(*) FROM tests").getInt() == 0) {
      // Leaving WAL succeeds only for the last connection: nobody else uses the file.
      remove_file =
          database_->tryExec("PRAGMA busy_timeout = 0; PRAGMA journal_mode = DELETE") == 0;
    }
    database_.reset();
    if (remove_file) std::filesystem::remove(path_);
  } catch (const SQLite::Exception& error) {
    database_.reset();
    throw_for(error, path_);
  }
}

}  // namespace triax::db

// SPDX-License-Identifier: GPL-3.0-or-later
#include "db/recording/test_entry.hpp"

#include <SQLiteCpp/Statement.h>
#include <SQLiteCpp/Transaction.h>

#include <algorithm>
#include <filesystem>
#include <utility>

#include "db/columns.hpp"
#include "db/connection.hpp"
#include "db/corrections/first_header.hpp"
#include "db/summary_writer.hpp"
#include "db/test_writer.hpp"

namespace triax::db {

void Batch::clear() {
  scans.clear();
  work.clear();
  forecasts.clear();
  events.clear();
}

TestEntry::TestEntry(std::string path, std::chrono::milliseconds patience, std::int64_t most_bytes)
    : path_(std::move(path)), patience_(patience), most_bytes_(most_bytes) {}

TestEntry::TestEntry(std::string path, std::chrono::milliseconds patience, std::string writer)
    : path_(std::move(path)),
      patience_(patience),
      continues_(true),
      lease_(Leased::test, std::move(writer)) {}

void TestEntry::set_patience(std::chrono::milliseconds patience) {
  patience_ = patience;
  if (database_) database_->setBusyTimeout(static_cast<int>(patience.count()));
}

void TestEntry::bound() {
  if (most_bytes_ == 0) return;
  const auto page = database_->execAndGet("PRAGMA page_size").getInt64();
  database_->exec("PRAGMA max_page_count = " + std::to_string(most_bytes_ / page));
}

void TestEntry::connect() {
  const bool existed = std::filesystem::exists(path_);
  if (away_ && !existed && !may_make_) throw MayPass(path_ + ": file does not exist");
  database_.emplace(open_for_writing(path_, patience_));
  if (!existed) created_.emplace(path_, *database_);
  bound();
  if (continues_) id_ = lease_.row(*database_);
  files_.emplace(*database_, path_);
}

void TestEntry::open() {
  if (database_) return;
  if (!away_) return connect();
  try {
    connect();
    away_ = false;
  } catch (const MayPass&) {
    close();
    throw;
  } catch (const std::exception& error) {  // what is in its place now may be anything
    close();
    throw NotInPlace(error.what());
  }
}

void TestEntry::check_files() const {
  if (!files_) return;
  if (const std::string missing = files_->missing(); !missing.empty())
    throw FilesMoved(
        missing + ": was renamed, removed or replaced while a test was recorded into the database");
}

void TestEntry::abandon() {
  scans_.reset();
  files_->make_whole();
  close();
  created_.reset();
  id_ = 0;
  continues_ = away_ = true;
}

void TestEntry::copy_into(TestEntry& other, const TestStart& test) {
  if (database_ && id_ != 0) other.take_in(test, Store(path_, *database_), id_);
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
    insert_first_header(*database_, id, test.header, test.earlier);
    if (test.sweep) insert_sweep(*database_, id, *test.sweep);
  }
  if (!scans_) scans_.emplace(*database_, id);
  scans_->write(batch.scans);
  for (const lab::SecondOrderWorkPoint& point : batch.work) scans_->write(point);
  insert_forecasts(*database_, id, batch.forecasts);
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
    set_first_ending(*database_, id, summary.ending);
    lease_.end(*database_);
  });
}

void TestEntry::interrupt(const TestStart& test, const Batch& batch) {
  in_transaction([&](std::int64_t& id) {
    write(test, batch, id);
    mark_interrupted(*database_, id);
  });
}

std::vector<std::int64_t> TestEntry::readings_in(const std::string& table) {
  SQLite::Statement select(*database_,
                           "SELECT id & 4294967295 FROM " + table +
                               " WHERE id BETWEEN ?1 << 32 AND ?1 << 32 | 4294967295 ORDER BY id");
  select.bind(1, id_);
  std::vector<std::int64_t> readings;
  while (select.executeStep()) readings.push_back(select.getColumn(0).getInt64());
  return readings;
}

std::vector<lab::Event> TestEntry::without_known(std::vector<lab::Event> events) {
  SQLite::Statement known(
      *database_,
      "SELECT 1 FROM events WHERE test_id = ? AND reading = ? AND kind = ? AND detail = ?");
  std::erase_if(events, [&](const lab::Event& event) {
    Binder(known)
        .integer(id_)
        .integer(event.reading)
        .text(to_string(event.kind))
        .text(event.detail);
    return known.executeStep();
  });
  return events;
}

void TestEntry::take_in(const TestStart& test, const Store& from, std::int64_t id) {
  store(test, {});
  constexpr std::size_t kAtATime = 20000;
  const auto scanned = readings_in("scans"), worked = readings_in("work_points"),
             forecast = readings_in("forecast_points");
  const auto is_in = [](const auto& readings, std::int64_t reading) {
    return std::ranges::binary_search(readings, reading);
  };
  Batch batch;
  from.for_each_scan(id, 1, [&](const lab::Reading& reading, const lab::State& state) {
    if (is_in(scanned, reading.number)) return;
    batch.scans.push_back({reading, state});
    if (batch.rows() < kAtATime) return;
    store(test, batch);
    batch.clear();
  });
  batch.work = from.second_order_work(id);
  std::erase_if(batch.work, [&](const auto& point) { return is_in(worked, point.reading); });
  batch.forecasts = from.forecasts(id);
  std::erase_if(batch.forecasts, [&](const auto& one) { return is_in(forecast, one.reading); });
  batch.events = without_known(from.load(id).events);
  store(test, batch);
}

void TestEntry::sign() {
  if (id_ != 0 && lease_.is_due()) in_transaction([](std::int64_t&) {});
}

void TestEntry::close() {
  scans_.reset();
  files_.reset();
  database_.reset();
}

void TestEntry::discard() {
  scans_.reset();
  if (!database_) return;
  try {
    SQLite::Transaction transaction(*database_, SQLite::TransactionBehavior::IMMEDIATE);
    if (id_ != 0) remove_test(*database_, id_);
    transaction.commit();
    if (created_ && files_ && files_->missing().empty()) created_->remove_if_unused(database_);
    close();
  } catch (const SQLite::Exception& error) {
    close();
    throw_for(error, path_);
  }
}

}  // namespace triax::db

// SPDX-License-Identifier: GPL-3.0-or-later
#include "db/recorder.hpp"

#include <SQLiteCpp/Transaction.h>

#include <QDateTime>
#include <chrono>
#include <condition_variable>
#include <exception>
#include <filesystem>
#include <mutex>
#include <optional>
#include <thread>
#include <utility>
#include <vector>

#include "db/connection.hpp"
#include "db/files/created_file.hpp"
#include "db/scan_writer.hpp"
#include "db/test_writer.hpp"
#include "lab/base/bad_input.hpp"

namespace triax::db {
namespace {

/// A batch is due at this many rows or after this time, whichever comes first.
constexpr std::size_t kRowsDue = 10000;
constexpr std::chrono::milliseconds kTimeDue{500};
/// The session waits for the disk beyond this: memory stays bounded.
constexpr std::size_t kRowsAtMost = 20000;

}  // namespace

/// The session's thread fills one batch while the writer's thread stores the other.
struct Recorder::Impl {
  struct Batch {
    std::vector<Scan> scans;
    std::vector<lab::SecondOrderWorkPoint> work;
    std::vector<lab::Event> events;

    std::size_t rows() const { return scans.size() + work.size() + events.size(); }
    void clear() {
      scans.clear();
      work.clear();
      events.clear();
    }
  };

  enum class Ending { none, complete, interrupted, discarded };

  explicit Impl(std::string path) : path_(std::move(path)) {}

  void start(const lab::RecordHeader& header);
  template <class Row>
  void add(std::vector<Row> Batch::*rows, Row row);
  void end(Ending ending, const lab::TestSummary* summary);
  void discard();
  bool started() const { return writer_.joinable() || ending_ != Ending::none; }
  bool open() const { return writer_.joinable(); }
  void belongs_to(SweepMembership sweep, Turns& turns) {
    sweep_ = std::move(sweep);
    turns_ = &turns;
  }
  std::int64_t test_id() const { return test_id_; }

 private:
  void write_batches();
  bool take_batch();
  void store_batch(Ending ending);
  void store_rows();
  void open_database();
  void rethrow_failure();
  bool enters_at_once() const { return turns_ && !entered_; }

  const std::string path_;
  lab::RecordHeader header_;
  std::string stored_at_;
  std::optional<SweepMembership> sweep_;
  Turns* turns_ = nullptr;

  std::mutex mutex_;
  std::condition_variable due_, room_;
  Batch filling_;
  Ending ending_ = Ending::none;
  bool entered_ = false;
  std::exception_ptr failure_;
  const lab::TestSummary* summary_ = nullptr;

  // Of the writer's thread while that runs.
  std::thread writer_;
  Batch storing_;
  std::optional<SQLite::Database> database_;
  std::optional<ScanWriter> scans_;
  std::int64_t test_id_ = 0;
  std::optional<CreatedFile> created_;  ///< the database is new, and this recorder made it
};

void Recorder::Impl::start(const lab::RecordHeader& header) {
  if (started()) throw lab::WorkFailed(path_ + ": a recorder records one test");
  header_ = header;
  stored_at_ = QDateTime::currentDateTimeUtc().toString(Qt::ISODate).toStdString();
  filling_.scans.reserve(kRowsAtMost);
  storing_.scans.reserve(kRowsAtMost);
  writer_ = std::thread([this] { write_batches(); });
}

void Recorder::Impl::rethrow_failure() {
  if (failure_) std::rethrow_exception(failure_);
}

template <class Row>
void Recorder::Impl::add(std::vector<Row> Batch::*rows, Row row) {
  std::unique_lock lock(mutex_);
  if (filling_.rows() >= kRowsAtMost)
    room_.wait(lock, [this] { return filling_.rows() < kRowsAtMost || failure_; });
  rethrow_failure();
  (filling_.*rows).push_back(std::move(row));
  if (filling_.rows() == kRowsDue || (filling_.rows() == 1 && enters_at_once())) due_.notify_one();
}

/// Waits until a batch is due and takes it; false at the end of the test.
bool Recorder::Impl::take_batch() {
  std::unique_lock lock(mutex_);
  const std::size_t due = enters_at_once() ? 1 : kRowsDue;
  due_.wait_for(lock, kTimeDue, [&] { return filling_.rows() >= due || ending_ != Ending::none; });
  entered_ = entered_ || filling_.rows() > 0;
  std::swap(filling_, storing_);
  room_.notify_one();
  return ending_ == Ending::none;
}

void Recorder::Impl::write_batches() {
  try {
    bool more = true;
    while (more) {
      more = take_batch();
      if (!more && ending_ == Ending::discarded) break;
      store_batch(more ? Ending::none : ending_);
      storing_.clear();
    }
  } catch (...) {
    const std::lock_guard lock(mutex_);
    failure_ = std::current_exception();
    room_.notify_one();
  }
}

void Recorder::Impl::open_database() {
  if (database_) return;
  const bool existed = std::filesystem::exists(path_);
  database_.emplace(open_for_writing(path_));
  if (!existed) created_.emplace(path_, *database_);
}

void Recorder::Impl::store_batch(Ending ending) {
  const bool ends = ending == Ending::complete || (ending == Ending::interrupted && test_id_ != 0);
  if (storing_.rows() == 0 && !ends) return;
  if (test_id_ == 0 && turns_) turns_->wait_for(sweep_->place);
  try {
    open_database();
    // IMMEDIATE: a second writer waits here instead of failing in the middle.
    SQLite::Transaction transaction(*database_, SQLite::TransactionBehavior::IMMEDIATE);
    const std::int64_t id = test_id_ != 0 ? test_id_ : insert_test(*database_, header_, stored_at_);
    if (test_id_ == 0 && sweep_) insert_sweep(*database_, id, *sweep_);
    if (!scans_) scans_.emplace(*database_, id);
    store_rows();
    for (const lab::Event& event : storing_.events) insert_event(*database_, id, event);
    if (ending == Ending::complete) insert_summary(*database_, id, *summary_);
    if (ending == Ending::interrupted) mark_interrupted(*database_, id);
    transaction.commit();
    test_id_ = id;
    if (turns_) turns_->over(sweep_->place);
  } catch (const SQLite::Exception& error) {
    throw_for(error, path_);
  }
}

void Recorder::Impl::store_rows() {
  scans_->write(storing_.scans);
  for (const lab::SecondOrderWorkPoint& point : storing_.work) scans_->write(point);
}

void Recorder::Impl::end(Ending ending, const lab::TestSummary* summary) {
  {
    const std::lock_guard lock(mutex_);
    ending_ = ending;
    summary_ = summary;
    due_.notify_one();
  }
  writer_.join();
  scans_.reset();
  // After a failure the database stays open for discard().
  if (ending == Ending::discarded) return;
  rethrow_failure();
  database_.reset();
}

void Recorder::Impl::discard() {
  if (open()) end(Ending::discarded, nullptr);
  if (!database_) return;
  try {
    SQLite::Transaction transaction(*database_, SQLite::TransactionBehavior::IMMEDIATE);
    if (test_id_ != 0) remove_test(*database_, test_id_);
    transaction.commit();
    if (created_) created_->remove_if_unused(database_);
    database_.reset();
  } catch (const SQLite::Exception& error) {
    database_.reset();
    throw_for(error, path_);
  }
}

Recorder::Recorder(std::string path) : impl_(std::make_unique<Impl>(std::move(path))) {}

Recorder::~Recorder() {
  if (!impl_->open()) return;
  try {
    impl_->end(Impl::Ending::interrupted, nullptr);
  } catch (...) {  // NOLINT(bugprone-empty-catch)
    // What was committed stands; the next to open the database marks the test as interrupted.
  }
}

void Recorder::belongs_to(SweepMembership sweep, Turns& turns) {
  impl_->belongs_to(std::move(sweep), turns);
}

lab::SessionListener Recorder::listener() {
  Impl* const impl = impl_.get();
  return {
      .started = [impl](const lab::RecordHeader& header) { impl->start(header); },
      .scanned =
          [impl](const lab::Reading& reading, const lab::State& state) {
            impl->add(&Impl::Batch::scans, Scan{reading, state});
          },
      .second_order_work =
          [impl](const lab::SecondOrderWorkPoint& point) { impl->add(&Impl::Batch::work, point); },
      .happened = [impl](const lab::Event& event) { impl->add(&Impl::Batch::events, event); },
      .progressed = {}};
}

std::int64_t Recorder::finish(const lab::TestSummary& summary) {
  if (!impl_->open()) throw lab::WorkFailed("there is no running test to finish");
  impl_->end(Impl::Ending::complete, &summary);
  return impl_->test_id();
}

void Recorder::discard() { impl_->discard(); }

}  // namespace triax::db

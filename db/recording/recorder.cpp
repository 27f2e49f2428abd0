// SPDX-License-Identifier: GPL-3.0-or-later
#include "db/recording/recorder.hpp"

#include <QDateTime>
#include <algorithm>
#include <chrono>
#include <condition_variable>
#include <exception>
#include <mutex>
#include <optional>
#include <thread>
#include <utility>
#include <vector>

#include "db/connection.hpp"
#include "db/recording/spool.hpp"
#include "db/recording/test_entry.hpp"
#include "lab/base/bad_input.hpp"

namespace triax::db {
namespace {

/// A batch is due at this many rows or after this time, whichever comes first.
constexpr std::size_t kRowsDue = 10000;
constexpr std::chrono::milliseconds kTimeDue{500};
/// The session waits for the disk beyond this: memory stays bounded.
constexpr std::size_t kRowsAtMost = 40000;

}  // namespace

/// The session's thread fills one batch while the writer's thread stores the other.
struct Recorder::Impl {
  enum class Ending { none, complete, interrupted, discarded };

  Impl(std::string path, Patience patience, const std::string& writer)
      : patience_(std::move(patience)),
        entry_(writer.empty() ? TestEntry(std::move(path), patience_.quiet)
                              : TestEntry(std::move(path), patience_.quiet, writer)) {
    check_place(entry_.path());
  }

  void start(const lab::RecordHeader& header);
  template <class Row, class... Parts>
  void add(std::vector<Row> Batch::*rows, const Parts&... parts);
  void end(Ending ending, const lab::TestSummary* summary);
  void discard();
  bool started() const { return writer_.joinable() || ending_ != Ending::none; }
  bool open() const { return writer_.joinable(); }
  void belongs_to(SweepMembership sweep, Turns& turns) {
    test_.sweep = std::move(sweep);
    turns_ = &turns;
  }
  void knows(const lab::EarlierTests& earlier) { test_.earlier = earlier; }
  void when_entered(std::function<void(std::int64_t)> use) {
    tell_entered_ = std::move(use);
    is_awaited_ = true;
  }
  std::int64_t test_id() const { return entry_.id(); }
  const std::string& path() const { return entry_.path(); }

 private:
  void write_batches();
  bool take_batch();
  void keep(Ending ending);
  bool is_discarded();
  void store_batch(Ending ending);
  bool set_aside(const MayPass& why);
  void empty_spool();
  void drop_spool();
  void wait_for_turn();
  std::string advice(const MayPass& why) const;
  void rethrow_failure();
  bool enters_at_once() const { return (turns_ || is_awaited_) && !entered_; }

  const Patience patience_;
  TestStart test_;
  Turns* turns_ = nullptr;
  bool is_awaited_ = false;                         ///< its entry is
  std::function<void(std::int64_t)> tell_entered_;  ///< of the writer's thread

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
  TestEntry entry_;
  std::optional<Spool> spool_;
  Waiting waiting_{patience_};
};

void Recorder::Impl::start(const lab::RecordHeader& header) {
  if (started()) throw lab::WorkFailed(entry_.path() + ": a recorder records one test");
  test_.header = header;
  test_.stored_at = QDateTime::currentDateTimeUtc().toString(Qt::ISODate).toStdString();
  filling_.scans.reserve(kRowsAtMost);
  storing_.scans.reserve(kRowsAtMost);
  writer_ = std::thread([this] { write_batches(); });
}

void Recorder::Impl::rethrow_failure() {
  if (failure_) std::rethrow_exception(failure_);
}

template <class Row, class... Parts>
void Recorder::Impl::add(std::vector<Row> Batch::*rows, const Parts&... parts) {
  std::unique_lock lock(mutex_);
  if (filling_.rows() >= kRowsAtMost)
    room_.wait(lock, [this] { return filling_.rows() < kRowsAtMost || failure_; });
  rethrow_failure();
  (filling_.*rows).emplace_back(parts...);
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
      keep(more ? Ending::none : ending_);
      if (tell_entered_ && entry_.id() != 0) std::exchange(tell_entered_, {})(entry_.id());
      storing_.clear();
    }
  } catch (...) {
    const std::lock_guard lock(mutex_);
    failure_ = std::current_exception();
    room_.notify_one();
  }
}

/// Until the batch is in the database, or at least beside it. The end of a test has to be in it, in
/// a new one where it was taken away.
void Recorder::Impl::keep(Ending ending) {
  if (ending != Ending::none) entry_.make_anew();
  for (waiting_.count_from_now(); !is_discarded(); waiting_.pause()) try {
      entry_.check_files();
      empty_spool();
      store_batch(ending);
      drop_spool();
      waiting_.succeeded(entry_.path());
      return entry_.set_patience(patience_.quiet);
    } catch (const MayPass& why) {
      const bool too_long = waiting_.failed(why);
      entry_.set_patience(std::min(patience_.quiet, patience_.again));
      const bool aside = set_aside(why);
      if (aside && ending == Ending::interrupted && patience_.say) patience_.say(advice(why));
      if (aside && ending != Ending::complete) return;
      // Nobody is going to put the database back after the end of a test.
      const bool is_hopeless = dynamic_cast<const NotInPlace*>(&why) != nullptr;
      if (too_long || (is_hopeless && ending == Ending::complete))
        throw lab::WorkFailed(advice(why));
    }
}

bool Recorder::Impl::is_discarded() {
  const std::lock_guard lock(mutex_);
  return ending_ == Ending::discarded;
}

/// False where the disk takes nothing at all.
bool Recorder::Impl::set_aside(const MayPass& why) {
  const bool has_moved = dynamic_cast<const FilesMoved*>(&why) != nullptr;
  if (has_moved) entry_.find_folder();
  if (!spool_) spool_.emplace(entry_, patience_.most_bytes);
  try {
    if (has_moved) {
      spool_->rescue(entry_, test_);
      entry_.abandon();
      if (patience_.say)
        patience_.say(spool_->path() + ": contains all readings of the test so far (" + why.what() +
                      ")");
    }
    if (storing_.rows() > 0) spool_->store(test_, storing_);
    storing_.clear();
    spool_->sign();
    return true;
  } catch (const MayPass&) {
    return false;
  }
}

void Recorder::Impl::empty_spool() {
  if (!spool_ || spool_->is_empty()) return;
  wait_for_turn();
  spool_->empty_into(entry_, test_);
  drop_spool();
}

void Recorder::Impl::drop_spool() {
  if (spool_) spool_->remove();
  spool_.reset();
}

std::string Recorder::Impl::advice(const MayPass& why) const {
  if (!spool_ || spool_->is_empty()) return why.what();
  return std::string(why.what()) + "; the readings are buffered in " + spool_->path() +
         ", and `triax tests repair` stores them";
}

void Recorder::Impl::wait_for_turn() {
  if (turns_ && entry_.id() == 0) turns_->wait_for(test_.sweep->place);
}

void Recorder::Impl::store_batch(Ending ending) {
  const bool is_new = entry_.id() == 0;
  if (storing_.rows() == 0 && ending != Ending::complete && (is_new || ending == Ending::none))
    return entry_.sign();
  wait_for_turn();
  if (ending == Ending::complete)
    entry_.complete(test_, storing_, *summary_);
  else if (ending == Ending::interrupted)
    entry_.interrupt(test_, storing_);
  else
    entry_.store(test_, storing_);
  if (turns_) turns_->over(test_.sweep->place);
}

void Recorder::Impl::end(Ending ending, const lab::TestSummary* summary) {
  {
    const std::lock_guard lock(mutex_);
    ending_ = ending;
    summary_ = summary;
    due_.notify_one();
  }
  writer_.join();
  // After a failure the database stays open for discard().
  if (ending == Ending::discarded) return;
  rethrow_failure();
  entry_.close();
}

void Recorder::Impl::discard() {
  if (open()) end(Ending::discarded, nullptr);
  drop_spool();
  entry_.set_patience(kPatience);
  entry_.discard();
}

void Recorder::when_entered(std::function<void(std::int64_t)> use) {
  impl_->when_entered(std::move(use));
}

Recorder::Recorder(std::string path, Patience patience, const std::string& writer)
    : impl_(std::make_unique<Impl>(std::move(path), std::move(patience), writer)) {}

Recorder::~Recorder() {
  if (!impl_->open()) return;
  try {
    impl_->end(Impl::Ending::interrupted, nullptr);
  } catch (...) {  // NOLINT(bugprone-empty-catch)
    // What was committed stands; readers see that no sign of life comes.
  }
}

void Recorder::belongs_to(SweepMembership sweep, Turns& turns) {
  impl_->belongs_to(std::move(sweep), turns);
}

void Recorder::knows(const lab::EarlierTests& earlier) { impl_->knows(earlier); }

lab::SessionListener Recorder::listener() {
  Impl* const impl = impl_.get();
  return {
      .started = [impl](const lab::RecordHeader& header) { impl->start(header); },
      .scanned = [impl](const lab::Reading& reading,
                        const lab::State& state) { impl->add(&Batch::scans, reading, state); },
      .second_order_work =
          [impl](const lab::SecondOrderWorkPoint& point) { impl->add(&Batch::work, point); },
      .happened = [impl](const lab::Event& event) { impl->add(&Batch::events, event); },
      .foreseen = [impl](const lab::Forecast& forecast) { impl->add(&Batch::forecasts, forecast); },
      .progressed = {}};
}

std::int64_t Recorder::finish(const lab::TestSummary& summary) {
  if (!impl_->open()) throw lab::WorkFailed("no running test to finish");
  impl_->end(Impl::Ending::complete, &summary);
  return impl_->test_id();
}

void Recorder::discard() { impl_->discard(); }

const std::string& Recorder::path() const { return impl_->path(); }

}  // namespace triax::db

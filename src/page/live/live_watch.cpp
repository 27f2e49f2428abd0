// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/page/live/live_watch.hpp"

#include <algorithm>
#include <utility>

#include "db/connection.hpp"
#include "db/store.hpp"

namespace triax::src {

/// How far the test has been told.
struct LiveWatch::Seen {
  explicit Seen(const std::string& db) : store(db) {}

  db::Store store;
  bool begun = false;
  std::int64_t next = 0;  ///< reading
  std::size_t events = 0, forecasts = 0;
  int stage = 0;
};

LiveWatch::LiveWatch(std::string db, std::int64_t test)
    : db_(std::move(db)), test_(test), thread_([this] { watch(); }) {}

LiveWatch::~LiveWatch() {
  ending_ = true;
  thread_.join();
}

/// Tells what is new; false once the test is over.
bool LiveWatch::look(Seen& seen) {
  // Whether it runs is asked before its readings: the last of them come with its end.
  const db::StoredTest test = seen.store.load(test_);
  if (!std::exchange(seen.begun, true)) {
    constexpr std::int64_t kTail = 4000;
    seen.next = std::max<std::int64_t>(seen.store.scan_count(test_) - kTail, 0);
    if (seen.next > 0) feed_->begin_behind(seen.next - 1);
    const auto first = std::ranges::find_if(test.events, [&](const lab::Event& event) {
      return event.noticed && event.noticed->reading >= seen.next;
    });
    seen.events = static_cast<std::size_t>(first - test.events.begin());
    seen.forecasts = seen.store.forecasts(test_).size();
  }
  const std::int64_t before = seen.next;
  seen.store.for_each_scan_from(test_, seen.next,
                                [&](const lab::Reading& reading, const lab::State& state) {
                                  if (std::exchange(seen.stage, reading.stage) != reading.stage)
                                    if (const auto* stage = test.header.stage(reading.stage))
                                      feed_->stage_began(*stage);
                                  feed_->scanned(reading, state);
                                  seen.next = reading.number + 1;
                                });
  const bool runs = test.status == db::TestStatus::running;
  if (runs && seen.next == before) return true;  // what else there is comes with readings
  for (; seen.events < test.events.size(); ++seen.events) feed_->happened(test.events[seen.events]);
  const auto forecasts = seen.store.forecasts(test_);
  for (; seen.forecasts < forecasts.size(); ++seen.forecasts)
    feed_->foreseen(forecasts[seen.forecasts]);
  if (runs) return true;
  feed_->ended(std::string(to_string(test.status)));
  return false;
}

void LiveWatch::watch() {
  try {
    Seen seen(db_);
    for (bool more = true; more && !ending_;) {
      try {
        more = look(seen);
      } catch (const db::MayPass&) {  // NOLINT(bugprone-empty-catch)
        // The lock of another program: at the next look.
      }
      if (more) std::this_thread::sleep_for(kLook);
    }
  } catch (const std::exception& failure) {
    feed_->ended("interrupted", failure.what());
  }
  over_ = true;
}

}  // namespace triax::src

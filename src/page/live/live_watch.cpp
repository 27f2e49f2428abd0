// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/page/live/live_watch.hpp"

#include <algorithm>
#include <utility>

#include "db/connection.hpp"
#include "db/store.hpp"

namespace triax::src {

/// How far the test has been told.
struct LiveWatch::Seen {
  Seen(const std::string& db, std::int64_t test, LiveFeed& feed);

  db::Store store;
  std::int64_t next = 0;  ///< reading
  std::size_t events = 0, forecasts = 0;
  int stage = 0;
};

/// Of what is there only the tail is told.
LiveWatch::Seen::Seen(const std::string& db, std::int64_t test, LiveFeed& feed) : store(db) {
  const db::StoredTest stored = store.load(test);
  constexpr std::int64_t kTail = 4000;
  next = std::max<std::int64_t>(store.scan_count(test) - kTail, 0);
  if (next > 0) feed.begin_behind(next - 1);
  const auto first = std::ranges::find_if(stored.events, [this](const lab::Event& event) {
    return event.detected_at && event.detected_at->reading >= next;
  });
  events = static_cast<std::size_t>(first - stored.events.begin());
  forecasts = store.forecasts(test).size();
}

// Where the feed begins is known before anybody has it: a browser that is told nothing of what it
// missed would never ask for it.
LiveWatch::LiveWatch(const std::string& db, std::int64_t test)
    : test_(test), seen_(std::make_unique<Seen>(db, test, *feed_)), thread_([this] { watch(); }) {}

LiveWatch::~LiveWatch() {
  ending_ = true;
  thread_.join();
}

/// Tells what is new; false once the test is over.
bool LiveWatch::look() {
  Seen& seen = *seen_;
  // Whether it runs is asked before its readings: the last of them come with its end.
  const db::StoredTest test = seen.store.load(test_);
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
    for (bool more = true; more && !ending_;) {
      try {
        more = look();
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

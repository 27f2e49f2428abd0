// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// What happens in a test that runs, kept for browsers as far as memory allows. Who records the test
// never waits for one of them: it adds to a ring of bounded length, and a browser that comes too
// late is told what it missed.
#include <chrono>
#include <compare>
#include <cstdint>
#include <deque>
#include <functional>
#include <map>
#include <mutex>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "lab/health/sensor_finding.hpp"
#include "lab/measured/unread_steps.hpp"
#include "lab/results/forecast.hpp"
#include "lab/results/reading.hpp"
#include "lab/results/record_header.hpp"
#include "lab/results/state.hpp"
#include "lab/results/summary.hpp"

namespace triax::src {

/// Where an item stands in the stream: a reading is (its number, 0), what is told before the next
/// one (its number, 1), (its number, 2)... Before the first reading the number is -1.
struct LivePosition {
  std::int64_t reading = -1;
  int part = 0;
  // NOLINTNEXTLINE(modernize-use-nullptr): a false alarm of version 14
  auto operator<=>(const LivePosition&) const = default;
};
/// "17" or "17.2"; nothing for anything else.
std::optional<LivePosition> live_position(const std::string& text);
std::string to_string(const LivePosition& position);

struct LiveReading {
  lab::Reading reading;
  lab::State state;
  std::chrono::system_clock::time_point told;  ///< when it came here
  bool unread = false;  ///< ends a step in which the specimen ran away (lab::UnreadSteps)
};
/// The test is over: "complete", "interrupted", or why it failed.
struct LiveEnd {
  std::string status;
  std::string error;
};
struct LiveItem {
  LivePosition at;
  std::variant<LiveReading, lab::Event, lab::Forecast, lab::SensorFinding, lab::StageInfo, LiveEnd>
      what;
};

/// What one browser is given at a time.
struct LiveTaken {
  std::vector<LiveItem> items;
  /// Readings that are not among the items and never will be, first and last; they are in the
  /// database, or will be within a second.
  std::optional<std::pair<std::int64_t, std::int64_t>> missed;
  std::optional<double> share;  ///< done of the programme, where it changed
  bool over = false;            ///< nothing follows
};

class LiveFeed {
 public:
  /// Of so many items the ring holds the latest.
  explicit LiveFeed(std::size_t most = 8192) : most_(most) {}

  // By who records, one thread at a time.
  void scanned(const lab::Reading& reading, const lab::State& state);
  void happened(const lab::Event& event);
  void foreseen(const lab::Forecast& forecast);
  void doubted(const lab::SensorFinding& finding);
  void stage_began(const lab::StageInfo& stage);
  void progressed(double share);
  /// Only once; what is told later is not heard.
  void ended(const std::string& status, const std::string& error = {});
  /// Where a stream begins that continues one in the database: behind that reading.
  void begin_behind(std::int64_t reading);

  // By browsers, any thread.
  /// A place in the stream of one browser.
  struct Cursor {
    std::optional<LivePosition> after;  ///< what the browser has; empty: nothing
    std::optional<std::uint64_t> next;  ///< number of the item, counted from the first
    double share = -1;                  ///< told last
  };
  /// At most so many items from the cursor on, which moves behind them.
  LiveTaken take(Cursor& cursor, std::size_t most);
  /// `changed` is called, by whoever records, after there may be more to take; once until somebody
  /// takes. It must not wait. Gives a number for forget().
  std::uint64_t listen(std::function<void()> changed);
  void forget(std::uint64_t listener);

 private:
  template <class What>
  void add(What what);
  void wake();
  void place(Cursor& cursor, LiveTaken& taken) const;

  mutable std::mutex mutex_;
  std::size_t most_;
  std::deque<LiveItem> ring_;
  std::uint64_t first_ = 0;  ///< number of the first item in the ring
  LivePosition last_;
  lab::UnreadSteps steps_{true};         ///< by who records
  std::optional<LivePosition> dropped_;  ///< the last that is in the ring no more
  double share_ = -1;
  bool over_ = false;
  bool told_ = false;  ///< listeners were woken since the last take
  std::map<std::uint64_t, std::function<void()>> listeners_;
  std::uint64_t next_listener_ = 0;
};

}  // namespace triax::src

// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/page/live/live_feed.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "lab/base/text.hpp"

namespace triax::src {

std::optional<LivePosition> live_position(const std::string& text) {
  const auto dot = text.find('.');
  const auto reading = lab::whole_text_as<std::int64_t>(text.substr(0, dot));
  const auto part =
      dot == std::string::npos ? std::optional(0) : lab::whole_text_as<int>(text.substr(dot + 1));
  if (!reading || !part || *reading < -1 || *part < 0) return std::nullopt;
  return LivePosition{*reading, *part};
}

std::string to_string(const LivePosition& position) {
  return position.part == 0 ? fmt::format("{}", position.reading)
                            : fmt::format("{}.{}", position.reading, position.part);
}

/// Inside the lock.
void LiveFeed::wake() {
  if (std::exchange(told_, true)) return;
  for (const auto& [number, changed] : listeners_) changed();
}

template <class What>
void LiveFeed::add(What what) {
  const std::lock_guard lock(mutex_);
  if (over_) return;
  if constexpr (std::is_same_v<What, LiveReading>)
    last_ = {what.reading.number, 0};
  else
    ++last_.part;
  ring_.push_back({last_, std::move(what)});
  if (ring_.size() > most_) {
    dropped_ = ring_.front().at;
    ring_.pop_front();
    ++first_;
  }
  wake();
}

void LiveFeed::scanned(const lab::Reading& reading, const lab::State& state) {
  add(LiveReading{reading, state, std::chrono::system_clock::now(), steps_.add(state)});
}

void LiveFeed::happened(const lab::Event& event) { add(event); }
void LiveFeed::foreseen(const lab::Forecast& forecast) { add(forecast); }
void LiveFeed::doubted(const lab::SensorFinding& finding) { add(finding); }
void LiveFeed::stage_began(const lab::StageInfo& stage) { add(stage); }

/// Goes along with the next item: it is told too often to wake anybody.
void LiveFeed::progressed(double share) {
  const std::lock_guard lock(mutex_);
  constexpr double kLittle = 5e-4;
  if (share >= 1 || std::fabs(share - share_) > kLittle) share_ = share;
}

void LiveFeed::ended(const std::string& status, const std::string& error) {
  add(LiveEnd{status, error});
  const std::lock_guard lock(mutex_);
  over_ = true;
}

void LiveFeed::begin_behind(std::int64_t reading) {
  const std::lock_guard lock(mutex_);
  last_ = {reading, 0};
  dropped_ = last_;
}

/// Behind what the browser has. Where something between is gone, the stream goes on with what is
/// new, and with its end if that was told.
void LiveFeed::place(Cursor& cursor, LiveTaken& taken) const {
  const LivePosition had = cursor.after.value_or(LivePosition{});
  if (!dropped_ || had >= *dropped_) {
    const auto behind = std::ranges::upper_bound(ring_, had, {}, &LiveItem::at);
    cursor.next = first_ + static_cast<std::uint64_t>(behind - ring_.begin());
    return;
  }
  taken.missed = {had.reading + 1, last_.reading};
  const int end = over_ ? 1 : 0;
  cursor.after = {last_.reading, last_.part - end};
  cursor.next = first_ + ring_.size() - static_cast<std::uint64_t>(end);
}

LiveTaken LiveFeed::take(Cursor& cursor, std::size_t most) {
  const std::lock_guard lock(mutex_);
  LiveTaken taken;
  told_ = false;
  if (!cursor.next || *cursor.next < first_) place(cursor, taken);
  const std::uint64_t end = first_ + ring_.size();
  for (std::uint64_t& next = *cursor.next; next < end && taken.items.size() < most; ++next) {
    const LiveItem& item = ring_[next - first_];
    // A browser may have more from the database than the stream has told yet.
    if (cursor.after && item.at <= *cursor.after) continue;
    taken.items.push_back(item);
    cursor.after = item.at;
  }
  if (share_ != cursor.share) taken.share = cursor.share = share_;
  taken.over = over_ && *cursor.next == end;
  return taken;
}

std::uint64_t LiveFeed::listen(std::function<void()> changed) {
  const std::lock_guard lock(mutex_);
  listeners_.emplace(next_listener_, std::move(changed));
  return next_listener_++;
}

void LiveFeed::forget(std::uint64_t listener) {
  const std::lock_guard lock(mutex_);
  listeners_.erase(listener);
}

}  // namespace triax::src

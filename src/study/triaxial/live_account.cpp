// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/study/triaxial/live_account.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "src/study/triaxial/test_result.hpp"

namespace triax::study {
namespace {

struct StageSpan {
  std::int64_t begin = 0, end = 0;  ///< readings; the end is the first behind it
};

std::vector<StageSpan> stage_spans(const db::StoredTest& test) {
  std::vector<StageSpan> spans;
  for (const lab::Event& event : test.events) {
    if (event.kind != lab::EventKind::stage_started) continue;
    if (!spans.empty()) spans.back().end = event.reading;
    spans.push_back({event.reading, std::numeric_limits<std::int64_t>::max()});
  }
  return spans;
}

/// Chooses among the forecasts of one stage.
class RowsOfStage {
 public:
  RowsOfStage(std::int64_t begin, std::int64_t end) : begin_(begin), end_(end) {}

  bool shows(const lab::Forecast& o, bool is_last) {
    const auto tenth = 10 * (o.reading - begin_) / std::max<std::int64_t>(end_ - begin_, 1);
    const bool moved = o.eta < low_ || o.eta > high_;
    if (tenth <= tenth_ && !is_last && !(moved && moves_ < kMoves)) return false;
    if (tenth <= tenth_ && moved) ++moves_;
    tenth_ = std::max(tenth, tenth_);
    low_ = o.eta_low, high_ = o.eta_high;
    return true;
  }

 private:
  std::int64_t begin_, end_, tenth_ = -1;
  int moves_ = 0;
  double low_ = -std::numeric_limits<double>::infinity();  ///< of the forecast shown last
  double high_ = std::numeric_limits<double>::infinity();
};

LiveRow forecast_row(const lab::Forecast& o) {
  return {
      .said = lab::Moment{o.reading, o.time_s}, .stage = {}, .eta = {}, .event = {}, .forecast = o};
}

void add_forecasts(const std::vector<lab::Forecast>& all, StageSpan span,
                   const std::optional<lab::Instant>& onset, LiveAccount& account) {
  const auto from = [&](std::int64_t reading) {
    return std::ranges::lower_bound(all, reading, {}, &lab::Forecast::reading);
  };
  const auto first = from(span.begin), behind = from(span.end);
  if (first == behind) return;
  std::int64_t end = std::min(span.end, std::prev(behind)->reading + 1);
  if (onset && span.begin <= onset->reading) end = std::min(end, onset->reading + 1);
  RowsOfStage rows(span.begin, end);
  for (auto o = first; o != behind && o->reading < end; ++o) {
    if (!rows.shows(*o, std::next(o) == behind || std::next(o)->reading >= end)) continue;
    account.rows.push_back(forecast_row(*o));
    ++account.shown;
  }
}

/// Every event; what was forecast at that very reading stands in its row and in no other.
void add_events(const std::vector<lab::Event>& events, const std::vector<lab::Forecast>& all,
                LiveAccount& account) {
  for (const lab::Event& event : events) {
    LiveRow row{.said = event.detected_at, .stage = {}, .eta = {}, .event = event, .forecast = {}};
    const bool of_alarm = event.kind == lab::EventKind::approaching ||
                          event.kind == lab::EventKind::imminent ||
                          event.kind == lab::EventKind::warning_withdrawn;
    if (row.said && of_alarm) {
      const auto o = std::ranges::lower_bound(all, row.said->reading, {}, &lab::Forecast::reading);
      if (o != all.end() && o->reading == row.said->reading) row.forecast = *o;
      const auto removed = std::erase_if(account.rows, [&](const LiveRow& other) {
        return !other.event && other.said->reading == row.said->reading;
      });
      account.shown -= static_cast<std::int64_t>(removed);
    }
    account.rows.push_back(std::move(row));
  }
}

void put_in_order(std::vector<LiveRow>& rows) {
  const auto when = [](const LiveRow& row) {
    return row.said ? row.said->reading : std::numeric_limits<std::int64_t>::max();
  };
  std::ranges::stable_sort(rows, {}, when);
}

std::optional<LiveLead> lead_of(const std::optional<lab::Forecast>& said,
                                const std::optional<lab::Instant>& onset) {
  if (!said || !onset) return std::nullopt;
  LiveLead lead{*said, onset->reading - said->reading, {}};
  if (onset->time_s && said->time_s) lead.time_s = *onset->time_s - *said->time_s;
  return lead;
}

}  // namespace

LiveAccount live_account(const db::Store& store, const db::StoredTest& test) {
  LiveAccount account;
  account.onset = has_verdict(test) ? test.summary.collapse.onset : std::nullopt;
  const auto forecasts = store.forecasts(test.id);
  account.forecasts = static_cast<std::int64_t>(forecasts.size());
  for (const StageSpan& span : stage_spans(test))
    add_forecasts(forecasts, span, account.onset, account);
  add_events(test.events, forecasts, account);
  put_in_order(account.rows);
  for (LiveRow& row : account.rows) {
    const auto state = row.said ? store.state_at(test.id, row.said->reading) : std::nullopt;
    if (!state) continue;
    row.stage = state->stage;
    if (std::isfinite(state->eta())) row.eta = state->eta();
  }
  account.approaching = lead_of(test.summary.collapse.approaching, account.onset);
  account.imminent = lead_of(test.summary.collapse.imminent, account.onset);
  return account;
}

}  // namespace triax::study

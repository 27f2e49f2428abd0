// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/study/triaxial/line_breaks.hpp"

#include <algorithm>
#include <utility>

#include "lab/health/sensor_limits.hpp"

namespace triax::study {

bool LineBreaks::is_faulty(std::int64_t reading) const {
  return std::ranges::any_of(faults, [reading](const lab::FaultySpan& span) {
    return span.from <= reading && reading <= span.until;
  });
}

bool LineBreaks::has_fault_between(std::int64_t from, std::int64_t to) const {
  return std::ranges::any_of(faults, [&](const lab::FaultySpan& span) {
    return lab::info(span.channel).raw.in_state &&
           span.until - span.from >= lab::sensor_limits::kMissing.count() && from < span.from &&
           span.until < to;
  });
}

bool LineBreaks::is_unread(std::int64_t from, std::int64_t to) const {
  const auto next = std::ranges::upper_bound(unread_steps, from);
  return next != unread_steps.end() && *next <= to;
}

Join Joiner::join(const lab::State& state) {
  const std::int64_t before = std::exchange(last_, state.reading);
  if (std::exchange(gap_, false)) return Join::none;
  return before >= 0 && breaks_.is_unread(before, state.reading) ? Join::dotted : Join::solid;
}

bool has_sensor_faults(const db::StoredTest& test) {
  return std::ranges::any_of(test.events, [](const lab::Event& event) {
    return event.kind == lab::EventKind::sensor_fault;
  });
}

lab::RecordHeader header_with_vouched(const db::StoredTest& test) {
  lab::RecordHeader header = test.header;
  for (const lab::Warning& warning : test.summary.warnings) {
    if (!warning.text.ends_with(lab::kBelievedThough)) continue;
    for (const lab::Quantity channel : header.columns)
      if (warning.text.starts_with(lab::sensor_name(channel))) header.vouched.push_back(channel);
  }
  return header;
}

std::vector<lab::FaultySpan> faulty_spans(const db::Store& store, const db::StoredTest& test) {
  if (!has_sensor_faults(test)) return {};
  lab::FaultySpans found(header_with_vouched(test));
  store.for_each_scan(test.id, 1,
                      [&](const lab::Reading& reading, const lab::State&) { found.add(reading); });
  return found.spans();
}

void remove_faulty(const std::vector<lab::FaultySpan>& faults, const lab::RecordHeader& header,
                   lab::Reading& reading, lab::State& state) {
  for (const lab::FaultySpan& span : faults)
    if (span.from <= reading.number && reading.number <= span.until)
      lab::remove_channel(span.channel, header, reading, state);
}

}  // namespace triax::study

// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/study/correction/stored_rig.hpp"

#include <algorithm>
#include <utility>

namespace triax::study {
namespace {

constexpr std::int64_t kReadingsAtATime = 4096;

/// Events that a rig reports to a session; it finds all other kinds itself.
bool is_of_the_rig(const lab::Event& event) {
  using enum lab::EventKind;
  switch (event.kind) {
    case device_fault:
    case held:
    case resumed:
    case aborted:
    case safe_state:
    case run_away:
      return true;
    default:
      return false;
  }
}

}  // namespace

StoredRig::StoredRig(const db::Store& store, const db::StoredTest& test, lab::RecordHeader header,
                     lab::RecordEnding ending)
    : store_(store), test_(test), header_(std::move(header)), ending_(std::move(ending)) {
  std::ranges::copy_if(test.events, std::back_inserter(events_), is_of_the_rig);
}

bool StoredRig::next(lab::Reading& reading) {
  if (next_in_chunk_ == chunk_.size()) {
    chunk_ = store_.readings(test_.id, drawn_, kReadingsAtATime);
    next_in_chunk_ = 0;
  }
  if (chunk_.empty()) {
    over_ = true;
    return false;
  }
  reading = chunk_[next_in_chunk_++];
  const auto& lines = ending_.stage_lines;
  if (next_stage_ < lines.size() && lines[next_stage_].first == reading.number)
    reading.line = lines[next_stage_++].second;
  drawn_ = reading.number + 1;
  is_processing_ = false;
  return true;
}

double StoredRig::progress() const {
  const auto all = static_cast<double>(test_.summary.readings);
  return all > 0 ? std::min(1.0, static_cast<double>(drawn_) / all) : 1.0;
}

std::vector<lab::Event> StoredRig::events() {
  is_processing_ = true;
  std::vector<lab::Event> due;
  for (; next_event_ < events_.size(); ++next_event_) {
    const lab::Event& event = events_[next_event_];
    const auto known_at = event.detected_at ? event.detected_at->reading : event.reading;
    if (!over_ && known_at >= drawn_) break;
    due.push_back(event);
  }
  return due;
}

std::vector<lab::Check> StoredRig::checks() const {
  std::vector<lab::Check> own;
  std::ranges::copy_if(test_.summary.checks, std::back_inserter(own), [](const lab::Check& check) {
    return check.kind == lab::CheckKind::stage_target;
  });
  return own;
}

std::optional<std::string> StoredRig::guarded() {
  const auto& guard = test_.summary.guard;
  if (!guard || guarded_) return std::nullopt;
  // A session asks before it processes a reading, of the one before, and again after it.
  const std::int64_t asked_of = is_processing_ ? drawn_ - 1 : drawn_ - 2;
  if (asked_of < guard->at.reading) return std::nullopt;
  guarded_ = true;
  return guard->done;
}

lab::RecordHeader header_to_replay(const db::StoredTest& test, const db::FirstHeader& first) {
  lab::RecordHeader header = test.header;
  header.programme = first.header.programme;
  header.specimen = first.header.specimen;
  header.stages = first.header.stages;
  header.notes = first.header.notes;
  header.guesses = first.header.guesses;
  header.vouched = first.header.vouched;
  header.cut_short = first.header.cut_short;
  if (first.ending) {
    if (!first.ending->cut_short.empty()) header.cut_short = first.ending->cut_short;
    header.back_volume_joined = first.ending->back_volume_joined;
    const auto own = std::min<std::size_t>(static_cast<std::size_t>(first.ending->warnings),
                                           test.summary.warnings.size());
    header.warnings.assign(test.summary.warnings.begin(),
                           test.summary.warnings.begin() + static_cast<std::ptrdiff_t>(own));
  }
  return header;
}

}  // namespace triax::study

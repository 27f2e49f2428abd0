// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <cstddef>
#include <cstdint>
#include <vector>

#include "db/corrections/first_header.hpp"
#include "db/store.hpp"
#include "lab/rig/back_end.hpp"

namespace triax::study {

/// The back end that replays a stored test: its readings, and what its rig reported beside them
/// (events, checks, the guard and the truth of a simulation). With the header as first stored, a
/// session gives the stored result again, to the bit. The store must outlive it.
class StoredRig : public lab::BackEnd {
 public:
  /// `header` is that of the next revision; `test` is the stored one, with its readings in `store`.
  StoredRig(const db::Store& store, const db::StoredTest& test, lab::RecordHeader header,
            lab::RecordEnding ending);

  const lab::RecordHeader& header() const override { return header_; }
  bool next(lab::Reading& reading) override;
  double progress() const override;
  std::optional<lab::Truth> truth() const override { return test_.summary.truth; }
  std::vector<lab::Event> events() override;
  std::vector<lab::Check> checks() const override;
  std::optional<std::string> guarded() override;

 private:
  const db::Store& store_;
  const db::StoredTest& test_;
  lab::RecordHeader header_;
  lab::RecordEnding ending_;
  std::vector<lab::Event> events_;  ///< of the rig
  std::size_t next_event_ = 0;
  std::vector<lab::Reading> chunk_;
  std::size_t next_in_chunk_ = 0, next_stage_ = 0;
  std::int64_t drawn_ = 0;
  bool over_ = false, guarded_ = false;
  bool is_processing_ = false;  ///< events of the reading last drawn were asked for
};

/// The header from which a replay of `test` starts: the first one, completed by what no correction
/// changes.
lab::RecordHeader header_to_replay(const db::StoredTest& test, const db::FirstHeader& first);

}  // namespace triax::study

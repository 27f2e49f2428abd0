// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Where the curves of a test are no solid lines: a sensor could not be believed, or the specimen
// ran away between two readings.
#include <cstdint>
#include <vector>

#include "db/store.hpp"
#include "lab/health/faulty_spans.hpp"
#include "lab/results/state.hpp"

namespace triax::study {

struct LineBreaks {
  std::vector<lab::FaultySpan> faults;     ///< values of these are removed from drawn states
  std::vector<std::int64_t> unread_steps;  ///< readings that end such a step, rising

  bool is_faulty(std::int64_t reading) const;
  /// Whether a fault of more than a few readings lies between two readings.
  bool has_fault_between(std::int64_t from, std::int64_t to) const;
  /// Whether a step between two readings ends after `from` and not after `to`.
  bool is_unread(std::int64_t from, std::int64_t to) const;
};

/// How a point is joined to the point before it.
enum class Join : std::uint8_t { solid, dotted, none };

/// Joins the points of a curve, state by state, those without a point too.
class Joiner {
 public:
  explicit Joiner(const LineBreaks& breaks) : breaks_(breaks) {}
  /// A state without a point: a gap if its sensors are faulty.
  void skip(const lab::State& state) { gap_ = gap_ || breaks_.is_faulty(state.reading); }
  Join join(const lab::State& state);

 private:
  const LineBreaks& breaks_;
  bool gap_ = false;
  std::int64_t last_ = -1;
};

/// Whether the test has findings about its sensors.
bool has_sensor_faults(const db::StoredTest& test);
/// The header with the channels that were said to be sound, which the store has in warnings.
lab::RecordHeader header_with_vouched(const db::StoredTest& test);
/// The faulty spans of a stored test. Reads its scans only if it has findings about sensors.
std::vector<lab::FaultySpan> faulty_spans(const db::Store& store, const db::StoredTest& test);
/// Removes from the scan what the faults leave unknown.
void remove_faulty(const std::vector<lab::FaultySpan>& faults, const lab::RecordHeader& header,
                   lab::Reading& reading, lab::State& state);

}  // namespace triax::study

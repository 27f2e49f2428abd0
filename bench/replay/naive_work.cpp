// SPDX-License-Identifier: GPL-3.0-or-later
// bench_naive_work ROWS: when do naive methods see the collapse of the synthetic record, and when
// do we? Judged by the true peak of q, where second-order work vanishes undrained.
#include <cstdio>
#include <cstdlib>
#include <deque>
#include <optional>

#include "bench/replay/synthetic_states.hpp"
#include "lab/collapse/monitor.hpp"

namespace {

using triax::bench::SyntheticRecord;
using triax::lab::State;

/// First reading at which the product of increments over `lag` readings of the moving averages over
/// `window` has stayed negative for `window` readings: what a spreadsheet does.
class MovingAverage {
 public:
  explicit MovingAverage(std::size_t window) : window_(window) {}
  void add(const State& s) {
    states_.push_back(s);
    sum_q_ += s.q;
    sum_e_ += s.strain.axial;
    if (states_.size() > window_) {
      sum_q_ -= states_.front().q;
      sum_e_ -= states_.front().strain.axial;
      states_.pop_front();
    }
    if (states_.size() < window_) return;
    if (last_q_) {
      const bool negative = (sum_q_ - *last_q_) * (sum_e_ - *last_e_) < 0;
      ++seen_;
      negatives_ += negative;
      run_ = negative ? run_ + 1 : 0;
      if (!found_ && run_ >= window_) found_ = s.reading;
    }
    last_q_ = sum_q_;
    last_e_ = sum_e_;
  }
  std::optional<long> found() const { return found_; }
  double negative_share() const { return double(negatives_) / double(seen_); }

 private:
  std::size_t window_, run_ = 0;
  long seen_ = 0, negatives_ = 0;
  std::deque<State> states_;
  double sum_q_ = 0, sum_e_ = 0;
  std::optional<double> last_q_, last_e_;
  std::optional<long> found_;
};

void print(const char* method, std::optional<long> found, long truth, const char* remark) {
  if (found)
    std::printf("%-46s %10ld %+10ld  %s\n", method, *found, *found - truth, remark);
  else
    std::printf("%-46s %10s %10s  %s\n", method, "none", "", remark);
}

}  // namespace

int main(int argc, char** argv) {
  const long rows = argc > 1 ? std::atol(argv[1]) : 1000000;
  if (rows < 2) return 2;
  SyntheticRecord record(rows);
  const long truth = record.peak_row();
  triax::lab::RecordHeader header;
  triax::lab::CollapseMonitor monitor(header);
  MovingAverage neighbours(1), spreadsheet(51);
  long top = 0;
  double q_top = 0;
  for (long i = 0; i < rows; ++i) {
    const State s = triax::bench::reduced(record.row(i), i);
    if (s.q > q_top) {
      q_top = s.q;
      top = i;
    }
    neighbours.add(s);
    spreadsheet.add(s);
    monitor.watch(s);
  }
  const auto ours = monitor.finish();
  char shares[2][80];
  std::snprintf(shares[0], sizeof shares[0], "sign negative in %.0f %% of all readings: noise",
                100 * neighbours.negative_share());
  std::snprintf(shares[1], sizeof shares[1],
                "negative in %.0f %% of all readings, 51 in a row asked",
                100 * spreadsheet.negative_share());
  std::printf("%ld readings, q truly peaks at reading %ld\n\n", rows, truth);
  std::printf("%-46s %10s %10s\n", "method", "reading", "error");
  print("sign of the product of neighbouring increments", neighbours.found(), truth, shares[0]);
  print("sign of W2 after a moving average of 51", spreadsheet.found(), truth, shares[1]);
  print("maximum of q (after the test)", top, truth, "says nothing of W2 or of loss");
  std::optional<long> found;
  if (ours.onset) found = ours.onset->reading;
  print("triax", found, truth, ours.onset ? ours.criteria[0].evidence.c_str() : "");
  return found ? 0 : 1;
}

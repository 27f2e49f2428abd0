#include "lab/rig/session.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <thread>

namespace triax::lab {
namespace {

using Clock = std::chrono::steady_clock;

/// Holds the stream back to `speed` times the clock; results do not depend on it.
class Pace {
 public:
  explicit Pace(const SessionOptions& options) : options_(options) {}
  /// Waits until a reading is due; less if the test is to stop.
  void wait_for(double time_s) {
    if (options_.speed <= 0 || std::isnan(time_s)) return;
    if (std::isnan(first_)) first_ = time_s;
    const std::chrono::duration<double> after((time_s - first_) / options_.speed);
    const auto due = start_ + std::chrono::duration_cast<Clock::duration>(after);
    constexpr std::chrono::milliseconds kLook{100};
    while (options_.stop && due - Clock::now() > kLook) {
      if (options_.stop()) return;
      std::this_thread::sleep_for(kLook);
    }
    std::this_thread::sleep_until(due);
  }

 private:
  const SessionOptions& options_;
  double first_ = kMissing;
  Clock::time_point start_ = Clock::now();
};

/// Breaks the test off after this reading and sees to it that the record says so.
void abort(BackEnd& back_end, const Reading& reading, std::vector<Warning>& warnings) {
  const std::string when = back_end.header().has_time
                               ? fmt::format("at {:.6g} s", reading.time_s)
                               : fmt::format("after reading {}", reading.number);
  const std::string reason = "aborted by the operator " + when;
  back_end.abort(reason);
  const auto says_so = [&](const Warning& w) { return w.text.find(reason) != std::string::npos; };
  if (!std::ranges::any_of(back_end.header().warnings, says_so)) warnings.push_back({0, reason});
}

Event stage_event(const RecordHeader& header, const Reading& reading) {
  const StageInfo* stage = header.stage(reading.stage);
  std::string detail = "stage " + std::to_string(reading.stage);
  if (stage && !stage->name.empty()) detail += ": " + stage->name;
  Event event{.reading = reading.number, .time_s = {}, .kind = "stage_started", .detail = detail};
  if (header.has_time) event.time_s = reading.time_s;
  return event;
}

}  // namespace

TestSummary Session::run(BackEnd& back_end, const SessionOptions& options) {
  Reduction reduction(back_end.header(), options.reduction);
  CollapseMonitor monitor(back_end.header());
  monitor.on_point = [this](const SecondOrderWorkPoint& p) { emit second_order_work(p); };
  monitor.on_event = [this](const Event& e) { emit happened(e); };
  emit started(back_end.header());

  TestSummary summary;
  Pace pace(options);
  Reading reading;
  std::optional<int> stage;
  std::vector<Warning> aborted;
  auto next_progress = Clock::now();
  while (back_end.next(reading)) {
    pace.wait_for(reading.time_s);
    if (stage != reading.stage) emit happened(stage_event(back_end.header(), reading));
    stage = reading.stage;
    const State state = reduction.reduce(reading);
    emit scanned(reading, state);
    monitor.watch(state);
    if (++summary.readings % 1024 == 0 || options.speed > 0) {
      const auto now = Clock::now();
      if (now >= next_progress) emit progressed(back_end.progress());
      if (now >= next_progress) next_progress = now + std::chrono::milliseconds(50);
    }
    if (options.stop && options.stop()) {
      abort(back_end, reading, aborted);
      break;
    }
  }
  summary.collapse = monitor.finish();
  summary.peak = monitor.peak();
  summary.consolidation = reduction.consolidation();
  summary.truth = back_end.truth();
  summary.checks = reduction.checks(back_end.header().warnings);
  summary.warnings = back_end.header().warnings;
  for (auto& warning : aborted) summary.warnings.push_back(std::move(warning));
  for (auto& warning : reduction.warnings()) summary.warnings.push_back(std::move(warning));
  emit progressed(1.0);
  return summary;
}

}  // namespace triax::lab

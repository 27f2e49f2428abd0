#include "lab/rig/session.hpp"

#include <chrono>
#include <thread>

namespace triax::lab {
namespace {

using Clock = std::chrono::steady_clock;

/// Holds the stream back to `speed` times the clock; results do not depend on it.
class Pace {
 public:
  explicit Pace(double speed) : speed_(speed) {}
  void wait_for(double time_s) {
    if (speed_ <= 0 || std::isnan(time_s)) return;
    if (std::isnan(first_)) first_ = time_s;
    const std::chrono::duration<double> due((time_s - first_) / speed_);
    std::this_thread::sleep_until(start_ + std::chrono::duration_cast<Clock::duration>(due));
  }

 private:
  double speed_;
  double first_ = kMissing;
  Clock::time_point start_ = Clock::now();
};

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
  Pace pace(options.speed);
  Reading reading;
  std::optional<int> stage;
  auto next_progress = Clock::now();
  while (back_end.next(reading)) {
    pace.wait_for(reading.time_s);
    if (stage != reading.stage) emit happened(stage_event(back_end.header(), reading));
    stage = reading.stage;
    for (const Event& event : back_end.events()) emit happened(event);
    const State state = reduction.reduce(reading);
    emit scanned(reading, state);
    monitor.watch(state);
    if (++summary.readings % 1024 == 0 || options.speed > 0) {
      const auto now = Clock::now();
      if (now >= next_progress) emit progressed(back_end.progress());
      if (now >= next_progress) next_progress = now + std::chrono::milliseconds(50);
    }
  }
  for (const Event& event : back_end.events()) emit happened(event);
  summary.collapse = monitor.finish();
  summary.peak = monitor.peak();
  summary.consolidation = reduction.consolidation();
  summary.truth = back_end.truth();
  summary.checks = reduction.checks(back_end.header().warnings);
  summary.warnings = back_end.header().warnings;
  for (auto& warning : reduction.warnings()) summary.warnings.push_back(std::move(warning));
  emit progressed(1.0);
  return summary;
}

}  // namespace triax::lab

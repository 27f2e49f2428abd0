#include "lab/rig/session.hpp"

#include <chrono>
#include <thread>

#include "lab/health/judged_states.hpp"
#include "lab/reduction/cross_checks.hpp"

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

Event sensor_event(const SensorFinding& finding) {
  return {.reading = finding.from,
          .time_s = finding.from_time_s,
          .kind = "sensor_fault",
          .detail = describe(finding)};
}

/// The reading without the channels that cannot be believed.
Reading believed(const JudgedStates::Judged& judged) {
  Reading reading = judged.reading;
  for (std::size_t i = 0; i < kQuantityCount; ++i)
    if (judged.wrong & channel_bit(static_cast<Quantity>(i))) reading.si[i] = kMissing;
  return reading;
}

/// Takes back what was measured with a sensor that could not be believed.
void take_back(const JudgedStates& states, TestSummary& summary) {
  constexpr ChannelSet kPressures =
      channel_bit(Quantity::cell_pressure) | channel_bit(Quantity::pore_pressure);
  constexpr ChannelSet kDimensions =
      channel_bit(Quantity::axial_displacement) | channel_bit(Quantity::back_volume);
  Consolidation& c = summary.consolidation;
  if (states.wrong_at_shear() & (kPressures | channel_bit(Quantity::axial_force)))
    c.p_eff_pa.reset();
  if (states.wrong_at_shear() & kDimensions) {
    c.void_ratio.reset();
    c.height_m.reset();
    c.diameter_m.reset();
  }
  if (!(states.wrong_in_b_check() & kPressures)) return;
  c.b_value.reset();
  std::erase_if(summary.checks, [](const Check& check) { return check.name == "b_value"; });
}

}  // namespace

TestSummary Session::run(BackEnd& back_end, const SessionOptions& options) {
  Reduction reduction(back_end.header(), options.reduction);
  CollapseMonitor monitor(back_end.header());
  monitor.on_point = [this](const SecondOrderWorkPoint& p) { emit second_order_work(p); };
  monitor.on_event = [this](const Event& e) { emit happened(e); };
  JudgedStates states(back_end.header());
  CrossChecks cross_checks(back_end.header());
  const auto pass_on = [&] {
    while (const auto* judged = states.next()) {
      cross_checks.add(believed(*judged), judged->state);
      if (!judged->live) continue;
      if (judged->after_gap) monitor.interrupt();
      monitor.watch(judged->state);
    }
  };
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
    const State state = reduction.reduce(reading);
    emit scanned(reading, state);
    states.add(reading, state);
    for (const SensorFinding& finding : states.health().news())
      emit happened(sensor_event(finding));
    pass_on();
    if (++summary.readings % 1024 == 0 || options.speed > 0) {
      const auto now = Clock::now();
      if (now >= next_progress) emit progressed(back_end.progress());
      if (now >= next_progress) next_progress = now + std::chrono::milliseconds(50);
    }
  }
  states.finish();
  pass_on();
  summary.collapse = monitor.finish();
  states.bound(summary.collapse);
  summary.peak = monitor.peak();
  summary.consolidation = reduction.consolidation();
  summary.truth = back_end.truth();
  summary.checks = reduction.checks(back_end.header().warnings);
  const auto& onset = summary.collapse.onset;
  const auto crossed = cross_checks.checks(onset ? std::optional(onset->reading) : std::nullopt);
  summary.checks.insert(summary.checks.end(), crossed.begin(), crossed.end());
  take_back(states, summary);
  summary.warnings = back_end.header().warnings;
  for (auto& warning : reduction.warnings()) summary.warnings.push_back(std::move(warning));
  for (auto& warning : warnings_of(crossed)) summary.warnings.push_back(std::move(warning));
  for (auto& warning : states.warnings()) summary.warnings.push_back(std::move(warning));
  emit progressed(1.0);
  return summary;
}

}  // namespace triax::lab

#include "lab/rig/session.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <thread>

#include "lab/health/gaps.hpp"
#include "lab/health/judged_states.hpp"
#include "lab/reduction/cross_checks.hpp"

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

Event sensor_event(const SensorFinding& finding) {
  return {.reading = finding.from,
          .time_s = finding.from_time_s,
          .kind = "sensor_fault",
          .detail = describe(finding)};
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
  Gaps gaps;
  monitor.on_point = [&](const SecondOrderWorkPoint& p) {
    gaps.add(p);
    emit second_order_work(p);
  };
  monitor.on_event = [this](const Event& e) { emit happened(e); };
  JudgedStates states(back_end.header());
  CrossChecks cross_checks(back_end.header());
  Collapse until_mark;
  const auto pass_on = [&] {
    while (const auto* judged = states.next()) {
      cross_checks.add(believed(*judged), judged->state);
      if (judged->mark) until_mark = monitor.so_far();
      if (!judged->live) continue;
      if (judged->after_gap) {
        monitor.interrupt();
        gaps.end(judged->reading.number);
      }
      monitor.watch(judged->state);
    }
  };
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
    for (const Event& event : back_end.events()) emit happened(event);
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
    if (options.stop && options.stop()) {
      abort(back_end, reading, aborted);
      break;
    }
  }
  for (const Event& event : back_end.events()) emit happened(event);
  states.finish();
  pass_on();
  summary.collapse = states.ends_at_mark() ? until_mark : monitor.finish();
  states.bound(summary.collapse);
  const auto caveat = gaps.caveat(summary.collapse);
  if (caveat && summary.collapse.judged_until_reason.empty())
    summary.collapse.judged_until_reason = *caveat;
  summary.peak = monitor.peak();
  summary.consolidation = reduction.consolidation();
  summary.truth = back_end.truth();
  summary.checks = reduction.checks(back_end.header().warnings);
  const auto& onset = summary.collapse.onset;
  const auto crossed = cross_checks.checks(onset ? std::optional(onset->reading) : std::nullopt);
  summary.checks.insert(summary.checks.end(), crossed.begin(), crossed.end());
  take_back(states, summary);
  summary.warnings = back_end.header().warnings;
  for (auto& warning : aborted) summary.warnings.push_back(std::move(warning));
  for (auto& warning : reduction.warnings()) summary.warnings.push_back(std::move(warning));
  for (auto& warning : warnings_of(crossed)) summary.warnings.push_back(std::move(warning));
  for (auto& warning : states.warnings()) summary.warnings.push_back(std::move(warning));
  if (caveat) summary.warnings.push_back({0, "the onset of collapse is " + *caveat});
  emit progressed(1.0);
  return summary;
}

}  // namespace triax::lab

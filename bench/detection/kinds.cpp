// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/detection/kinds.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "lab/programmes/programme_reader.hpp"
#include "lab/rig/simulated/virtual_rig.hpp"
#include "sim/mechanics/axisymmetric.hpp"

namespace triax::bench {
namespace {

using lab::Programme;
using lab::Quantity;

constexpr std::uint64_t kFirstChoice = 100;  ///< numbers below are those of varied()
constexpr std::string_view kScaleErrors = "standard instruments, errors of scale";

/// Between two values, as far in ratio as the seed says.
double between(double low, double high, std::uint64_t seed, std::uint64_t number) {
  return low * std::pow(high / low, choice(seed, kFirstChoice + number));
}

void as_it_is(Programme&, std::uint64_t) {}

/// 12 bits over the range, and half a kPa of noise.
void cheap(Programme& programme, std::uint64_t) {
  const auto transducer = [&](Quantity channel) -> lab::Transducer& {
    return programme.transducers[static_cast<std::size_t>(channel)];
  };
  const auto give = [&](Quantity channel, double range_si, double noise_si) {
    lab::Transducer& t = transducer(channel);
    t.range = range_si / t.unit.scale;
    t.step = lab::converter_step(t.range, 12);
    t.noise_rms = noise_si / t.unit.scale;
  };
  give(Quantity::axial_displacement, 0.05, 1e-5);
  give(Quantity::axial_force, 5000, 3);
  for (const Quantity pressure :
       {Quantity::cell_pressure, Quantity::pore_pressure, Quantity::back_pressure})
    give(pressure, 2e6, 500);
  for (const Quantity volume : {Quantity::back_volume, Quantity::cell_volume}) {
    lab::Transducer& t = transducer(volume);
    t.step = 1e-8 / t.unit.scale;
    t.noise_rms = volume == Quantity::back_volume ? 5e-9 / t.unit.scale : 0;
  }
}

void read_every(Programme& programme, double interval_s) {
  programme.logging = {interval_s, 0};
  for (lab::Stage& stage : programme.stages)
    if (stage.role == lab::StageRole::shear) stage.logging = {interval_s, 0};
}

void sparse(Programme& programme, std::uint64_t seed) {
  read_every(programme, std::round(between(10, 60, seed, 0)));
}

void cheap_and_sparse(Programme& programme, std::uint64_t seed) {
  cheap(programme, seed);
  sparse(programme, seed);
}

/// 1 to 4 mm/min, read every 2 to 10 s.
void fast(Programme& programme, std::uint64_t seed) {
  read_every(programme, std::round(between(2, 10, seed, 0)));
  const double rate = between(1e-3, 4e-3, seed, 1) / 60;
  for (lab::Stage& stage : programme.stages)
    if (stage.axial == lab::AxialAction::displacement) stage.axial_rate_m_per_s = rate;
}

/// B of about 0.75 to 0.93.
void with_air(Programme& programme, std::uint64_t seed) {
  programme.specimen.saturation = 1 - between(0.01, 0.035, seed, 0);
}

lab::Stage load_step(const lab::Stage& like, double step_n, double minutes) {
  lab::Stage stage = like;
  stage.axial = lab::AxialAction::dead_load;
  stage.axial_rate_m_per_s = 0;
  stage.load_step_n = step_n;
  stage.end = {{lab::EndQuantity::time, 60 * minutes, {}},
               {lab::EndQuantity::axial_strain, 0.12, {}}};
  stage.time_limit_s = 60 * minutes + 60;
  return stage;
}

/// Steps of dead load from the start of shear, until the specimen falls.
void load_steps(Programme& programme, std::uint64_t seed) {
  constexpr double kMost = 400;  // N, beyond any peak
  const double step = between(5, 50, seed, 0);
  lab::Stage shear = programme.stages.back();
  programme.stages.pop_back();
  for (double load = 0; load < kMost; load += step) {
    programme.stages.push_back(load_step(shear, step, 5));
    programme.stages.back().name = fmt::format("step to {:.0f} N", load + step);
  }
}

/// One step of dead load, near the peak or past it.
void one_step(Programme& programme, std::uint64_t seed) {
  for (lab::Stage& stage : programme.stages)
    if (stage.load_step_n > 0) stage.load_step_n = between(5, 50, seed, 0);
}

/// Shear that is called consolidation, as by who brings a specimen to an anisotropic state.
void consolidation(Programme& programme, std::uint64_t) {
  for (lab::Stage& stage : programme.stages)
    if (stage.role == lab::StageRole::shear) stage.role = lab::StageRole::consolidation;
}

constexpr std::string_view kStandard = "standard instruments", kCheap = "12 bits, 0.5 kPa",
                           kSparse = "readings of 10 to 60 s",
                           kBoth = "12 bits, readings of 10 to 60 s",
                           kFast = "1 to 4 mm/min, readings of 2 to 10 s",
                           kCut = "ends in the fall", kAir = "B of 0.75 to 0.93",
                           kSteps = "load steps of 5 to 50 N",
                           kCyclic = "cycles, intergranular strain",
                           kCalled = "called consolidation";

constexpr auto kKinds = std::to_array<Kind>({
    {kStandard, "samples/programmes/icu_6.toml", "", as_it_is},
    {kStandard, "samples/programmes/icu_load.toml", "", as_it_is},
    {kStandard, "samples/programmes/icu_spring.toml", "", as_it_is},
    {kStandard, "samples/programmes/csd_51.toml", "", as_it_is},
    {kStandard, "samples/programmes/csu_26.toml", "", as_it_is},
    {kStandard, "samples/programmes/strain_path_070.toml", "", as_it_is},
    {kScaleErrors, "samples/programmes/icu_6.toml", "", as_it_is},
    {kScaleErrors, "samples/programmes/csd_51.toml", "", as_it_is},
    {kScaleErrors, "samples/programmes/csu_26.toml", "", as_it_is},
    {kCheap, "samples/programmes/icu_6.toml", "", cheap},
    {kCheap, "samples/programmes/icu_42.toml", "", cheap},
    {kCheap, "samples/programmes/icu_load.toml", "", cheap},
    {kCheap, "samples/programmes/icu_spring.toml", "", cheap},
    {kCheap, "samples/programmes/csd_51.toml", "", cheap},
    {kCheap, "samples/programmes/csd_58.toml", "", cheap},
    {kCheap, "samples/programmes/csu_26.toml", "", cheap},
    {kCheap, "samples/programmes/csu_31.toml", "", cheap},
    {kCheap, "samples/programmes/strain_path_070.toml", "", cheap},
    {kCheap, "bench/detection/programmes/csd_cheap.toml", "", as_it_is},
    {kCheap, "bench/detection/programmes/csu_cheap.toml", "", as_it_is},
    {kSparse, "samples/programmes/icu_6.toml", "", sparse},
    {kSparse, "samples/programmes/icu_42.toml", "", sparse},
    {kSparse, "samples/programmes/icu_load.toml", "", sparse},
    {kSparse, "samples/programmes/icu_spring.toml", "", sparse},
    {kSparse, "samples/programmes/csu_26.toml", "", sparse},
    {kSparse, "samples/programmes/csd_51.toml", "", sparse},
    {kBoth, "samples/programmes/icu_6.toml", "", cheap_and_sparse},
    {kBoth, "samples/programmes/icu_load.toml", "", cheap_and_sparse},
    {kBoth, "samples/programmes/csu_26.toml", "", cheap_and_sparse},
    {kFast, "samples/programmes/icu_6.toml", "", fast},
    {kFast, "samples/programmes/icu_42.toml", "", fast},
    {kFast, "samples/programmes/icu_6.toml", "sanisand/S28-general", fast},
    {kCut, "samples/programmes/icu_6.toml", "", as_it_is, true},
    {kCut, "samples/programmes/icu_load.toml", "", as_it_is, true},
    {kCut, "samples/programmes/csu_26.toml", "", as_it_is, true},
    {kCut, "samples/programmes/csd_51.toml", "", as_it_is, true},
    {kAir, "samples/programmes/csu_26.toml", "", with_air},
    {kAir, "samples/programmes/csu_27.toml", "", with_air},
    {kAir, "samples/programmes/csu_31.toml", "", with_air},
    {kAir, "bench/detection/programmes/csu_air.toml", "", with_air},
    {kSteps, "samples/programmes/icu_6.toml", "", load_steps},
    {kSteps, "samples/programmes/icu_6.toml", "sanisand/S28-general", load_steps},
    {kSteps, "bench/detection/programmes/one_step.toml", "", one_step},
    {kCyclic, "bench/verdicts/programmes/cyclic_loose.toml", "hypoplastic/S28-MT-IGS", as_it_is},
    {kCyclic, "bench/verdicts/programmes/cyclic_two_way.toml", "hypoplastic/S28-MT-IGS", as_it_is},
    {kCalled, "samples/programmes/csd_51.toml", "", consolidation},
    {kCalled, "samples/programmes/icu_load.toml", "", consolidation},
});

void leave_out_scale(Programme& programme) {
  for (lab::Transducer& t : programme.transducers)
    t.offset = t.drift_per_hour = t.hysteresis = t.nonlinearity = 0;
}

/// Ends the record of another once so much of its q is gone.
class EndsInTheFall : public lab::BackEnd {
 public:
  EndsInTheFall(lab::VirtualRig& rig, double share) : rig_(rig), share_(share) {}
  const lab::RecordHeader& header() const override { return rig_.header(); }
  bool next(lab::Reading& reading) override {
    if (over_ || !rig_.next(reading)) return false;
    const double q = std::fabs(
        sim::deviator_stress(sim::axisymmetric_stress(rig_.specimen_state().material.stress)));
    if (!rig_.truth()->lost_sustainability) return true;
    largest_ = std::max(largest_, q);
    over_ = q < (1 - share_) * largest_;
    return true;
  }
  double progress() const override { return rig_.progress(); }
  std::optional<lab::Truth> truth() const override { return rig_.truth(); }
  std::vector<lab::Event> events() override { return rig_.events(); }

 private:
  lab::VirtualRig& rig_;
  double share_, largest_ = 0;
  bool over_ = false;
};

std::string cell(const std::optional<double>& value, int digits) {
  return value ? fmt::format("{:.{}f}", *value, digits) : "-";
}

std::string share(int part, std::size_t whole) {
  return whole > 0 ? fmt::format("{:.1f}", 100.0 * part / static_cast<double>(whole)) : "-";
}

std::string line_of(std::string_view name, const std::vector<const TrialResult*>& group) {
  std::vector<double> errors, delays, widths;
  int detected = 0, with_interval = 0, never = 0;
  std::array<int, 3> covered{};
  for (const TrialResult* r : group) {
    const Outcome& o = r->outcomes.front();
    if (!o.detected) continue;
    ++detected;
    errors.push_back(*o.eta_error);
    delays.push_back(static_cast<double>(std::abs(*o.delay)));
    if (!o.notice_delay) ++never;
    if (!r->interval) continue;
    ++with_interval;
    widths.push_back((r->interval->eta.high - r->interval->eta.low) / 2);
    covered[0] += r->interval->eta.holds(r->truth_eta);
    covered[1] += r->interval->q_pa.holds(r->truth_q_pa);
    covered[2] += r->interval->p_eff_pa.holds(r->truth_p_pa);
  }
  const auto known = static_cast<std::size_t>(with_interval);
  return fmt::format(
      "{:<38} {:>6} {:>8} {:>7} {:>7} {:>7} {:>6} {:>6} {:>6} {:>6} {:>8} {:>8} {:>6} {:>6} {:>6} "
      "{:>6}\n",
      name, group.size(), share(detected, group.size()), cell(quantile(errors, 0.5), 4),
      cell(quantile(errors, 0.95), 4), cell(quantile(errors, 1), 4), cell(quantile(delays, 0.5), 0),
      cell(quantile(delays, 0.95), 0), cell(quantile(delays, 1), 0), never,
      cell(quantile(widths, 0.5), 4), cell(quantile(widths, 0.95), 4), share(covered[0], known),
      share(covered[1], known), share(covered[2], known), detected - with_interval);
}

}  // namespace

std::span<const Kind> kinds() { return kKinds; }

TrialResult run_kind(const Kind& kind, std::uint64_t seed) {
  Subject subject{lab::load_programme(std::string(kind.programme)), true};
  if (!kind.material.empty()) subject.programme.material = lab::find_material(kind.material);
  Programme programme = varied(subject, seed);
  kind.alter(programme, seed);
  if (kind.name != kScaleErrors) leave_out_scale(programme);
  lab::VirtualRig rig(programme, seed);
  std::optional<EndsInTheFall> cut;
  if (kind.ends_in_the_fall) cut.emplace(rig, between(0.03, 0.6, seed, 9));
  TrialResult result =
      judge_trial(programme, true, seed,
                  cut ? static_cast<lab::BackEnd&>(*cut) : static_cast<lab::BackEnd&>(rig));
  result.trait = kind.name;
  return result;
}

std::string table_of_kinds(const std::vector<TrialResult>& results) {
  std::string text = fmt::format("{:<38} {:>6} {:>8} {:^23} {:^20} {:>6} {:^17} {:^20} {:>6}\n", "",
                                 "", "", "|error of eta|", "|delay|, readings", "",
                                 "half width, eta", "interval holds, %", "no");
  text += fmt::format(
      "{:<38} {:>6} {:>8} {:>7} {:>7} {:>7} {:>6} {:>6} {:>6} {:>6} {:>8} {:>8} {:>6} {:>6} {:>6} "
      "{:>6}\n",
      "kind", "tests", "found %", "50 %", "95 %", "max", "50 %", "95 %", "max", "never", "50 %",
      "95 %", "eta", "q", "p'", "int.");
  std::vector<std::string_view> names;
  for (const Kind& kind : kKinds)
    if (std::ranges::find(names, kind.name) == names.end()) names.push_back(kind.name);
  for (const std::string_view name : names) {
    std::vector<const TrialResult*> group;
    for (const TrialResult& r : results)
      if (r.trait == name && r.truth_lost) group.push_back(&r);
    if (!group.empty()) text += line_of(name, group);
  }
  const auto without = std::ranges::count(results, false, &TrialResult::truth_lost);
  if (without > 0) text += fmt::format("{} specimens did not collapse; left out\n", without);
  return text;
}

}  // namespace triax::bench

#include "lab/rig/virtual_rig.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "lab/devices/noise.hpp"
#include "lab/records/bad_input.hpp"
#include "lab/rig/truth_watch.hpp"

namespace triax::lab {
namespace {

/// Longest tick.
constexpr double kTick_s = 0.25;

AxialControl control_of(AxialAction action) {
  switch (action) {
    case AxialAction::displacement:
      return AxialControl::displacement;
    case AxialAction::constant_q:
      return AxialControl::constant_q;
    case AxialAction::free:
    case AxialAction::load:
      return AxialControl::load;
  }
  return AxialControl::unknown;
}

RecordHeader make_header(const Programme& programme, std::uint64_t seed) {
  RecordHeader h;
  h.name = programme.name;
  h.origin = Origin::simulated;
  h.programme = programme.type;
  h.source = programme.source;
  h.seed = seed;
  h.specimen.height_m = programme.specimen.height_m;
  h.specimen.diameter_m = programme.specimen.diameter_m;
  h.specimen.void_ratio = programme.void_ratio;
  h.specimen.specific_gravity = programme.specific_gravity;
  h.specimen.material = programme.material.name;
  if (const auto limit = programme.material.material.axisymmetric->limit_stress_ratio())
    h.specimen.limit_friction_angle_rad = sim::mobilised_friction_angle(*limit);
  int number = 1;
  for (const Stage& stage : programme.stages)
    h.stages.push_back({number++, stage.name, stage.role,
                        stage.valve_open ? Drainage::open : Drainage::closed,
                        control_of(stage.axial)});
  for (const auto& row : quantities().first(kRawQuantityCount)) h.columns.push_back(row.quantity);
  return h;
}

sim::Specimen make_specimen(const Programme& programme) {
  try {
    return {programme.material.material.axisymmetric, programme.specimen, programme.void_ratio,
            programme.initial_effective_stress_pa, programme.initial_back_pressure_pa};
  } catch (const std::invalid_argument& error) {
    throw BadInput(programme.source, 0, error.what());
  }
}

}  // namespace

struct VirtualRig::Impl {
  Impl(const Programme& p, std::uint64_t used_seed)
      : programme(p),
        seed(used_seed),
        header(make_header(p, used_seed)),
        specimen(make_specimen(p)),
        state(specimen.start()),
        back_pressure(p.initial_back_pressure_pa) {}

  const Stage& stage() const { return programme.stages[stage_index]; }
  double time_in_stage() const {
    return static_cast<double>(number - stage_start) * programme.scan_interval_s;
  }
  void warn(const std::string& text) { header.warnings.push_back({0, text}); }
  void warn_once(bool& done, const std::string& text) {
    if (!std::exchange(done, true)) warn(text);
  }

  void begin_stage();
  double value_of(EndQuantity quantity) const;
  bool end_met() const;
  bool next_stage();
  double wanted_force(double ahead_s) const;
  bool tick(double time_s, double dt_s);
  bool advance_to_next_scan();
  void scan(Reading& reading);
  double true_channel(Quantity quantity) const;

  Programme programme;
  std::uint64_t seed;
  RecordHeader header;
  sim::Specimen specimen;
  sim::SpecimenState state;
  double back_pressure;
  TruthWatch watch;

  std::int64_t number = -1;  ///< of the last reading
  std::size_t stage_index = 0;
  std::int64_t stage_start = 0;  ///< reading at which the stage began
  double force_at_stage_start = 0;
  double held_q = 0;
  std::optional<double> shear_height, shear_volume;  ///< at the start of the first shear stage
  std::array<double, kEndQuantityCount> at_stage_start{};
  bool finished = false;
  std::array<bool, kRawQuantityCount> saturation_warned{};
  bool cavitation_warned = false, accuracy_warned = false;
};

void VirtualRig::Impl::begin_stage() {
  stage_start = std::max<std::int64_t>(number, 0);
  force_at_stage_start = specimen.axial_force(state);
  held_q = stage().held_q_pa.value_or(state.material.q());
  if (stage().role == StageRole::shear && !shear_height) {
    shear_height = state.height_m;
    shear_volume = specimen.volume_m3(state);
    for (const auto& outside : {void_ratio_outside(programme.material, state.material.void_ratio),
                                p_eff_outside(programme.material, state.material.p())})
      if (outside) warn("at the start of shear " + *outside);
  }
  for (int i = 0; i < kEndQuantityCount; ++i)
    at_stage_start[static_cast<std::size_t>(i)] = value_of(static_cast<EndQuantity>(i));
}

double VirtualRig::Impl::value_of(EndQuantity quantity) const {
  const double height_0 = shear_height.value_or(programme.specimen.height_m);
  switch (quantity) {
    case EndQuantity::time:
      return time_in_stage();
    case EndQuantity::cell_pressure:
      return state.cell_pressure;
    case EndQuantity::back_pressure:
      return back_pressure;
    case EndQuantity::pore_pressure:
      return state.pore_pressure;
    case EndQuantity::pore_pressure_lag:
      return std::abs(state.pore_pressure - back_pressure);
    case EndQuantity::deviator_stress:
      return state.material.q();
    case EndQuantity::mean_effective_stress:
      return state.material.p();
    case EndQuantity::stress_ratio:
      return state.material.q() / state.material.p();
    case EndQuantity::axial_strain:
      return 1 - state.height_m / height_0;
    case EndQuantity::volumetric_strain:
      return 1 - specimen.volume_m3(state) /
                     shear_volume.value_or(specimen.volume_m3(specimen.start()));
    case EndQuantity::axial_displacement:
      return programme.specimen.height_m - state.height_m;
    case EndQuantity::axial_force:
      return specimen.axial_force(state);
  }
  return 0;
}

bool VirtualRig::Impl::end_met() const {
  return std::ranges::any_of(stage().end,
                             [&](const EndCondition& e) { return e.met(value_of(e.quantity)); });
}

bool VirtualRig::Impl::next_stage() {
  if (stage_index + 1 >= programme.stages.size()) return false;
  ++stage_index;
  begin_stage();
  return true;
}

double VirtualRig::Impl::wanted_force(double ahead_s) const {
  if (stage().axial == AxialAction::load)
    return force_at_stage_start + stage().load_rate_n_per_s * (time_in_stage() + ahead_s);
  return held_q * specimen.area_m2(state);
}

/// One tick of the rig; false when the test cannot go on.
bool VirtualRig::Impl::tick(double time_s, double dt_s) {
  sim::SpecimenBoundary boundary;
  boundary.valve_open = stage().valve_open;
  const double cell_next =
      process(programme.cell_controller, state.cell_pressure, stage().cell, dt_s);
  const double back_next = process(programme.back_controller, back_pressure, stage().back, dt_s);
  boundary.cell_pressure_rate = (cell_next - state.cell_pressure) / dt_s;
  boundary.back_pressure = back_pressure;
  boundary.back_pressure_rate = (back_next - back_pressure) / dt_s;
  if (stage().axial == AxialAction::free) {
    boundary.axial = sim::SpecimenBoundary::Axial::deviator_stress;
    // What an earlier stage left on the piston comes off within this tick.
    boundary.axial_rate = -state.material.q() / dt_s;
  } else if (stage().axial == AxialAction::displacement) {
    boundary.axial_rate = stage().axial_rate_m_per_s;
  } else {
    const double ahead_s = time_s - static_cast<double>(number) * programme.scan_interval_s;
    boundary.axial = sim::SpecimenBoundary::Axial::servo;
    boundary.servo = {wanted_force(ahead_s + dt_s), programme.frame.servo_gain_m_per_s_per_n,
                      programme.frame.fastest_m_per_s};
  }
  const sim::SpecimenStep step = specimen.advance(state, boundary, dt_s);
  if (step.outcome == sim::StepOutcome::failed) {
    // A test that has readings is kept: the law may end where the specimen is liquefied.
    if (!step.law_ended || number <= 0)
      throw WorkFailed(fmt::format("{}: stage \"{}\" at {:.6g} s: {}", programme.source,
                                   stage().name, time_s, step.message));
    warn(fmt::format("stage \"{}\" ended at {:.6g} s: the law goes no further: {}", stage().name,
                     time_s, step.message));
    return false;
  }
  if (step.outcome == sim::StepOutcome::inaccurate)
    warn_once(accuracy_warned, fmt::format("from {:.6g} s on the integration of the law is less "
                                           "accurate than asked for",
                                           time_s));
  watch.watch(time_s, dt_s, state, step, stage().role == StageRole::shear,
              shear_height.value_or(programme.specimen.height_m));
  if (step.outcome == sim::StepOutcome::lost_control) {
    warn(
        fmt::format("stage \"{}\" ended at {:.6g} s: the specimen does not allow what was asked "
                    "(q = {:.4g} kPa, p' = {:.4g} kPa)",
                    stage().name, time_s + step.done_s, step.state.material.q() / 1e3,
                    step.state.material.p() / 1e3));
    return false;
  }
  state = step.state;
  state.cell_pressure = cell_next;
  back_pressure = back_next;
  if (state.pore_pressure < 0)
    warn_once(cavitation_warned,
              fmt::format("pore pressure below 0 from {:.6g} s on: cavitation is "
                          "not modelled",
                          time_s));
  if (programme.specimen.height_m - state.height_m > programme.frame.travel_m) {
    warn(fmt::format("stage \"{}\" ended at {:.6g} s: the frame's travel of {:g} mm is used up",
                     stage().name, time_s, programme.frame.travel_m * 1e3));
    return false;
  }
  return true;
}

bool VirtualRig::Impl::advance_to_next_scan() {
  const double interval = programme.scan_interval_s;
  const auto ticks = static_cast<int>(std::ceil(interval / kTick_s - 1e-9));
  const double start = static_cast<double>(number) * interval;
  const double dt = interval / ticks;
  for (int i = 0; i < ticks; ++i)
    if (!tick(start + i * dt, dt)) return false;
  return true;
}

double VirtualRig::Impl::true_channel(Quantity quantity) const {
  switch (quantity) {
    case Quantity::axial_displacement:
      return programme.specimen.height_m - state.height_m;
    case Quantity::axial_force:
      return specimen.axial_force(state);
    case Quantity::cell_pressure:
      return state.cell_pressure;
    case Quantity::back_pressure:
      return back_pressure;
    case Quantity::pore_pressure:
      return state.pore_pressure;
    case Quantity::back_volume:
      return -state.drained_volume_m3;
    case Quantity::cell_volume:
      return specimen.volume_m3(specimen.start()) - specimen.volume_m3(state);
    default:
      return kMissing;
  }
}

void VirtualRig::Impl::scan(Reading& reading) {
  reading = Reading();
  reading.number = number;
  reading.time_s = static_cast<double>(number) * programme.scan_interval_s;
  reading.stage = static_cast<int>(stage_index) + 1;
  for (std::size_t i = 0; i < kRawQuantityCount; ++i) {
    const auto& row = quantities()[i];
    const Transducer& transducer = programme.transducers[i];
    const double normal =
        transducer.noise_rms > 0 ? standard_normal(seed, i, static_cast<std::uint64_t>(number)) : 0;
    const TransducerReading r = read(transducer, true_channel(row.quantity), normal);
    if (r.saturated)
      warn_once(saturation_warned[i],
                fmt::format("{} went out of its range of {:g} {} at {:.6g} s", row.name,
                            transducer.range, row.unit, reading.time_s));
    reading[row.quantity] = r.si;
  }
}

VirtualRig::VirtualRig(const Programme& programme, std::optional<std::uint64_t> seed)
    : impl_(std::make_unique<Impl>(programme, seed.value_or(programme.seed))) {
  if (programme.stages.empty()) throw BadInput(programme.source, 0, "the programme has no stage");
  impl_->begin_stage();
}
VirtualRig::~VirtualRig() = default;

const RecordHeader& VirtualRig::header() const { return impl_->header; }
std::optional<Truth> VirtualRig::truth() const { return impl_->watch.truth(); }
const sim::SpecimenState& VirtualRig::specimen_state() const { return impl_->state; }

bool VirtualRig::next(Reading& reading) {
  Impl& rig = *impl_;
  if (rig.finished) return false;
  if (rig.number >= 0) {
    const bool late = rig.time_in_stage() >= rig.stage().time_limit_s;
    const bool met = rig.end_met();
    if (!met && late)
      rig.warn(
          fmt::format("stage \"{}\" did not reach its end within {:g} min; the test ended there",
                      rig.stage().name, rig.stage().time_limit_s / 60));
    rig.finished = (met && !rig.next_stage()) || (!met && late) || !rig.advance_to_next_scan();
    if (rig.finished) return false;
  }
  ++rig.number;
  rig.scan(reading);
  return true;
}

double VirtualRig::progress() const {
  const Impl& rig = *impl_;
  if (rig.finished) return 1;
  double done = 0;
  for (const EndCondition& end : rig.stage().end) {
    const double start = rig.at_stage_start[static_cast<std::size_t>(end.quantity)];
    const double way = (end.above ? *end.above : *end.below) - start;
    if (way != 0) done = std::max(done, (rig.value_of(end.quantity) - start) / way);
  }
  return (static_cast<double>(rig.stage_index) + std::clamp(done, 0.0, 1.0)) /
         static_cast<double>(rig.programme.stages.size());
}

}  // namespace triax::lab

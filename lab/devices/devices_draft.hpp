#pragma once
// DRAFT of the interface of lab/devices (each group becomes its own file pair; what exists is
// replaced). All devices are plain constants; what changes is in plain state values; randomness only
// through standard_normal(seed, stream, number). An imperfection of 0 is absent, and with all absent
// the true value passes bit for bit.
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "sim/mechanics/units.hpp"

namespace triax::lab {

// transducer.hpp --------------------------------------------------------------------------------
// true value -> first-order lag (time_constant_s) -> hysteresis (play of ± hysteresis_fraction of the
// range) -> non-linearity (fraction of range, parabola, 0 at both ends) -> offset + drift·t + noise ->
// electrical signal (sensitivity) -> converter (bits over ± range, or a step) held between samples
// (sampling_interval_s) -> calibration polynomial (of the electrical signal) -> reading in the unit
// of the field.
struct Transducer {
  sim::Unit unit;
  double range = 0, step = 0, noise_rms = 0, offset = 0;
  double drift_per_hour = 0, time_constant_s = 0;
  double hysteresis = 0, nonlinearity = 0;  ///< in the unit of the field, at most, within the range
  double sensitivity_mV = 0;                ///< electrical output at full scale; 0: none modelled
  std::vector<double> calibration;          ///< c0 + c1 s + c2 s²..., s in mV; empty: linear
  double sampling_interval_s = 0;           ///< 0: at every look
};
struct TransducerState {
  std::optional<double> lagged, played;  ///< unit of the field
  std::int64_t samples = 0;
  double next_sample_s = 0, held_si = 0;
  bool saturated = false;
};
struct TransducerReading { double si = 0; bool saturated = false; };
/// Looks at the true value at `time_s` (never decreasing); `stream` tells channels apart.
TransducerReading look(const Transducer&, TransducerState&, double true_si, double time_s,
                       std::uint64_t seed, std::uint64_t stream);

// fault.hpp -------------------------------------------------------------------------------------
enum class FaultKind { stuck, open_circuit, spike, drop_out, drift, latency,  // of transducers
                       full, empty, leak, /* stuck too */                     // of controllers
                       does_not_close, does_not_open };                       // of the valve
struct Fault {
  std::string device;  ///< "pore_pressure" (a channel), "cell_controller", "back_controller",
                       ///< "frame", "valve"
  FaultKind kind = FaultKind::stuck;
  double from_s = 0;             ///< test time
  std::optional<double> until_s; ///< for good without it
  double size = 0;               ///< spike: height; drift: per s; latency: s; leak: m³/s/Pa... SI
  bool active(double time_s) const;
};
/// In words for record and report: "simulated fault: pore_pressure stuck from 3600 s".
std::string describe(const Fault&);
/// What comes out of a channel under its faults; keeps what stuck and latency need (a ring of fixed
/// size). A drop-out is NaN.
class FaultyChannel {
 public:
  FaultyChannel(std::vector<Fault> faults, const Transducer&, std::uint64_t seed, std::uint64_t stream);
  double pass(double si, double time_s);
};

// pressure_controller.hpp: a DPVC ------------------------------------------------------------------
struct PressureController {
  double range_pa = 0, rate_limit_pa_per_s = 0;
  double pressure_resolution_pa = 0;    ///< it can only be asked for whole steps
  double time_constant_s = 0;           ///< of its loop
  double fluid_compliance_m3_per_pa = 0;///< of its own water and tubing; 0: it holds against any flow
  double capacity_m3 = 0, start_volume_m3 = 0;  ///< 0: unlimited; start: half full
  double volume_rate_limit_m3_per_s = 0;        ///< 0: unlimited
  double leak_m3_per_s_per_pa = 0;
};
struct PressureDemand { double rate_pa_per_s = 0; std::optional<double> target_pa; };
struct ControllerState {
  double pressure_pa = 0;  ///< at its port, true
  double asked_pa = 0;     ///< where the ramp is; rounded to the resolution it is the set point
  double held_volume_m3 = 0;   ///< water in the cylinder
  double given_volume_m3 = 0;  ///< that its piston pushed out since the start: what it reports
  bool full = false, empty = false;
};
/// Ramps for dt under pressure control; `inflow_m3` ran into it during the last tick.
void advance(const PressureController&, ControllerState&, const PressureDemand&, double inflow_m3,
             double dt_s, const std::vector<Fault>& active);
/// The same under volume control (proportional strain paths): the piston pushes `flow` and the
/// pressure is what the specimen's side answers.
void push(const PressureController&, ControllerState&, double& flow_m3_per_s,
          double answered_pressure_pa, double dt_s, const std::vector<Fault>& active);

// loading_frame.hpp -------------------------------------------------------------------------------
struct LoadingFrame {
  double slowest_m_per_s = 0, fastest_m_per_s = 0;
  double velocity_step_m_per_s = 0;      ///< resolution; 0: any velocity
  double stiffness_n_per_m = 0;          ///< frame and load cell in series; 0: rigid
  double travel_m = 0;
  double load_limit_n = 0;               ///< emergency stop above it; 0: none
  // piston-type cylinder for load and dead load
  double bandwidth_hz = 0;               ///< of the force servo; 0: follows at once
  double moving_mass_kg = 0;             ///< piston, rod and cap (a dead load's own mass comes on top)
  double damping_n_s_per_m = 0;
};

}  // namespace triax::lab

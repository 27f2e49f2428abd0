// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/materials/norsand.hpp"

#include <algorithm>
#include <cmath>

namespace triax::sim {
namespace {

/// Stress ratio by which a state must be inside the yield surface to count as elastic.
constexpr double kInsideSurface = 1e-6;

/// Share of a rate's size that counts as none of it: round-off of the control's solution.
constexpr double kNoRate = 1e-9;
/// The same of dp′ in an elastic step, where water and apparatus give way a little.
constexpr double kGivesWay = 0.02;
/// Volume change over |dε| beyond which a step with pore fluid counts as drained: above what water
/// and apparatus let through, far below that of a drained compression.
constexpr double kDrained = 0.05;

constexpr const char* kNoInstabilityLine =
    "p' falls at constant q or inside the yield surface (CSD and the like), which NorSand cannot "
    "follow: below M_i such a fall is elastic unloading until the inner cap, and the stress ratio "
    "there depends on the path taken, so that the law has no instability line for it; use "
    "sanisand, hypoplastic or inl2";
constexpr const char* kIsotropicLoading =
    "p' rises while q does not (isotropic loading), which NorSand cannot follow: its start is "
    "already the consolidated state; start at the consolidated stress";
constexpr const char* kExtension =
    "triaxial extension: the law and its parameters are for compression only";
constexpr const char* kSetForDrained =
    "the volume is held, but this set is for drained loading (pore_fluid_bulk_modulus_kPa is 0); "
    "take one for undrained loading, such as norsand/S28-MT";
constexpr const char* kSetForUndrained =
    "the volume changes, but this set is for undrained loading (pore_fluid_bulk_modulus_kPa is "
    "above 0); take one for drained loading, such as norsand/S28-MT-drained";

/// Relative change of p_i that is round-off: such a state stands on its yield surface.
constexpr double kRoundOff = 1e-15;

constexpr double kVanished = 1;  // Pa; the law comes to p′ = 0 where e stays above Γ

/// (1, D) in terms of (ε_q, ε_v), or of (q, p): both the flow and the normal.
Vector<Axisymmetric> shear_and_volume(double d) {
  return components(AxisymmetricStrain{1 + d / 3, d / 3 - 0.5});
}

}  // namespace

const ParameterTable<NorSandParameters>& norsand_table() {
  using P = NorSandParameters;
  using enum ParameterKind;
  static const ParameterTable<P> table = {
      {{"critical_stress_ratio",
        "M",
        "",
        "q/p' at critical state, compression",
        {.above = 0, .below = 3}},
       &P::critical_stress_ratio},
      {{"volumetric_coupling",
        "N",
        "",
        "fall of the image stress ratio with the state",
        {.at_least = 0, .below = 1}},
       &P::volumetric_coupling},
      {{"state_dilatancy", "χ", "", "dilatancy with the state parameter", {.above = 0}},
       &P::state_dilatancy},
      {{"hardening_modulus", "H0", "", "plastic hardening", {.at_least = 10}},
       &P::hardening_modulus},
      {{"hardening_state_slope",
        "H_ψ",
        "",
        "decrease of the hardening with the state parameter",
        {},
        number,
        0},
       &P::hardening_state_slope},
      {{"shear_modulus_kPa", "G_r", "kPa", "shear modulus at its pressure", {.above = 0}},
       &P::shear_modulus_pa},
      {{"shear_modulus_pressure_kPa",
        "p_r",
        "kPa",
        "p' at which the shear modulus is G_r",
        {.above = 0}},
       &P::shear_modulus_pressure_pa},
      {{"shear_modulus_exponent",
        "n",
        "",
        "growth of the shear modulus with p'",
        {.at_least = 0, .at_most = 1}},
       &P::shear_modulus_exponent},
      {{"poisson_ratio", "ν", "", "Poisson's ratio", {.above = -1, .below = 0.5}},
       &P::poisson_ratio},
      {{"critical_void_ratio", "Γ", "", "critical state line, its height", {.above = 0}},
       &P::critical_void_ratio},
      {{"critical_slope", "λ", "", "slope of the critical state line", {.above = 0}},
       &P::critical_slope},
      {{"critical_exponent",
        "c",
        "",
        "exponent of the critical state line; 0: straight over ln p'",
        {.at_least = 0},
        number,
        0},
       &P::critical_exponent},
      {{"critical_pressure_kPa", "p_c", "kPa", "its pressure", {.above = 0}, number, 1},
       &P::critical_pressure_pa},
      {{"pore_fluid_bulk_modulus_kPa",
        "K_w",
        "kPa",
        "bulk modulus of the pore fluid in undrained loading; 0: for drained loading",
        {.at_least = 0},
        number,
        0},
       &P::pore_fluid_bulk_modulus_pa},
      {{"overconsolidation_ratio",
        "OCR",
        "",
        "image pressure at the start over that on yield",
        {.at_least = 1},
        number,
        1},
       &P::overconsolidation_ratio},
      {{"largest_state_parameter",
        "ψ_max",
        "",
        "state parameter above which a state is out of range",
        {.above = 0, .at_most = 0.5},
        number,
        0.25},
       &P::largest_state_parameter}};
  return table;
}

LawDescription norsand_law() {
  LawDescription law;
  law.name = "norsand";
  law.title = "NorSand, critical state plasticity with an image stress, triaxial compression";
  law.source =
      "Jefferies (1993), Géotechnique 43:91; Jefferies and Shuttle (2005), Géotechnique 55:93; "
      "Jefferies and Been (2015), Soil Liquefaction";
  law.refuses =
      "constant q with falling p' (CSD): below M_i a fall of p' is elastic unloading until the "
      "inner cap, and the stress ratio there depends on the path taken, so that there is no "
      "instability line; isotropic loading; triaxial extension; undrained loading with a set for "
      "drained loading and the reverse";
  law.parameters = descriptions(norsand_table());
  law.make = [](const ParameterSet& set, const MaterialFinder&) {
    return Material{std::make_shared<NorSand>(parameters_from(set, norsand_table())),
                    nullptr,
                    "the law and its parameters are for triaxial compression only",
                    {}};
  };
  return law;
}

NorSand::NorSand(const NorSandParameters& p) : parameters_(p) {
  check_parameters(p, norsand_table());
}

NorSand::CriticalState NorSand::critical_state(double p) const {
  const auto& par = parameters_;
  const double ratio = p / par.critical_pressure_pa;
  if (par.critical_exponent == 0)
    return {par.critical_void_ratio - par.critical_slope * std::log(ratio), par.critical_slope};
  const double fall = par.critical_slope * std::pow(ratio, par.critical_exponent);
  return {par.critical_void_ratio - fall, par.critical_exponent * fall};
}

/// λ₀, of a p₀ that stays as it is for a whole path.
double NorSand::consolidation_slope(double p0) const {
  const auto& par = parameters_;
  if (par.critical_exponent == 0) return par.critical_slope;
  struct Kept {
    Mark law;
    double p0, slope;
  };
  thread_local std::optional<Kept> kept;
  if (!kept || kept->law != mark_ || kept->p0 != p0) kept = {mark_, p0, critical_state(p0).slope};
  return kept->slope;
}

double NorSand::shear_modulus(double p) const {
  return parameters_.shear_modulus_pa *
         std::pow(p / parameters_.shear_modulus_pressure_pa, parameters_.shear_modulus_exponent);
}

double NorSand::bulk_ratio() const {
  const double nu = parameters_.poisson_ratio;
  return 2 * (1 + nu) / (3 * (1 - 2 * nu));
}

double NorSand::hardening(const State& state) const {
  const double slope = parameters_.hardening_state_slope;
  const double fall = slope == 0 ? 0 : slope * state_parameter(state);
  return std::max(parameters_.hardening_modulus - fall, 10.0);
}

/// Without largest_ratio.
NorSand::Image NorSand::image_at(double p, double void_ratio, double image_pressure,
                                 double p0) const {
  const auto& par = parameters_;
  const double m = par.critical_stress_ratio;
  Image i;
  i.ratio = image_pressure / p;
  const auto critical = critical_state(image_pressure);
  i.critical_slope = critical.slope;
  i.state_parameter = void_ratio - critical.void_ratio;
  i.dilatancy = par.state_dilatancy / (1 - consolidation_slope(p0) * par.state_dilatancy / m);
  i.stress_ratio = m - i.dilatancy * par.volumetric_coupling * std::abs(i.state_parameter);
  i.limit = i.stress_ratio - i.dilatancy * i.state_parameter;
  return i;
}

/// A step asks for that of where it ends twice, the next one for that of where it begins.
const NorSand::Image& NorSand::image(const State& state) const {
  struct Kept {
    Mark law;
    double p, void_ratio, image_pressure, p0;
    Image image;
  };
  thread_local std::optional<Kept> kept;
  const double p = state.p(), pressure = image_pressure(state), p0 = state.memory(1);
  if (!kept || kept->law != mark_ || kept->p != p || kept->void_ratio != state.void_ratio ||
      kept->image_pressure != pressure || kept->p0 != p0) {
    Image i = image_at(p, state.void_ratio, pressure, p0);
    i.largest_ratio = std::exp(-i.dilatancy * i.state_parameter / i.stress_ratio);
    kept = {mark_, p, state.void_ratio, pressure, p0, i};
  }
  return kept->image;
}

double NorSand::restraint(double skeleton_pa) const {
  const double fluid = parameters_.pore_fluid_bulk_modulus_pa;
  return fluid * skeleton_pa / (fluid + skeleton_pa);
}

double NorSand::cap_softening(const State& state, const Image& i, double restraint_pa) const {
  const double eta = state.q() / state.p();
  const double share = 1 / (1 + i.dilatancy * consolidation_slope(state.memory(1)) /
                                    parameters_.critical_stress_ratio);
  return -eta / i.limit * (i.stress_ratio - eta) * share * restraint_pa / state.p();
}

/// Makes p_i that with which q = p M_i (1 + ln(p_i/p)), by Newton's method.
void NorSand::put_on_yield(State& state) const {
  const double eta = state.q() / state.p();
  for (int k = 0; k < 20; ++k) {
    const Image& i = image(state);
    const double x = 1 + std::log(i.ratio);
    const double slope =
        i.stress_ratio -
        x * std::copysign(i.dilatancy * parameters_.volumetric_coupling, i.state_parameter) *
            i.critical_slope;
    const double step = (i.stress_ratio * x - eta) / slope;
    if (std::abs(step) < kRoundOff) return;
    state.memory(0) *= std::exp(-step);
    if (!(std::abs(step) > 1e-9)) return;  // the next would be of the order of its square
  }
}

PointState<Axisymmetric> NorSand::start(const Vector<Axisymmetric>& stress,
                                        double void_ratio) const {
  State state{stress, void_ratio, Memory::Zero(2)};
  const double p = state.p();
  if (!(p > 0)) return state;  // objection() says so
  state.memory << std::exp(-1.0), p;
  put_on_yield(state);
  state.memory(0) *= parameters_.overconsolidation_ratio;
  return state;
}

std::vector<std::string> NorSand::memory_names() const {
  return {"image_pressure_ratio", "consolidation_p_eff_Pa"};
}

double NorSand::memory_scale(int entry) const {
  return entry == 0 ? 1 : parameters_.shear_modulus_pressure_pa;
}

std::optional<std::string> NorSand::objection(const State& state) const {
  if (auto general = Law::objection(state)) return general;
  const double p = state.p();
  if (p < kVanished)
    return "p' is below " + short_number(kVanished / 1e3) +
           " kPa: liquefied, and the law's stiffness vanishes with p'";
  if (state.q() < -kOnYield * p)
    return "q is below 0, triaxial extension, and the law is one for compression";
  if (const double smallest = axisymmetric_stress(state.stress).radial; smallest < 0)
    return "the radial stress is " + short_number(smallest / 1e3) + " kPa, tension";
  if (const double psi = state_parameter(state); psi > parameters_.largest_state_parameter)
    return "the state parameter is " + short_number(psi) + ", must be at most " +
           short_number(parameters_.largest_state_parameter) +
           ", beyond which the image stress ratio M_i is not defined";
  const Image& i = image(state);
  if (!(i.dilatancy > 0))
    return "1 - λ χ/M is not above 0 at the pressure of consolidation; "
           "expected a smaller state_dilatancy";
  if (!(i.stress_ratio > 0))
    return "the image state parameter is " + short_number(i.state_parameter) +
           ", with which M_i = M - χ_i N |ψ_i| is not above 0";
  if (i.ratio > i.largest_ratio * (1 + kInsideSurface) &&
      yield_distance(state, 0) < -kInsideSurface)
    return "inside the yield surface p' is below " +
           short_number(image_pressure(state) / i.largest_ratio / 1e3) +
           " kPa, the inner cap: a fall of p' below M_i is elastic and the stress ratio at the cap "
           "depends on the path to it, so that the law has no instability line for it (constant q "
           "with falling p' and the like)";
  return std::nullopt;
}

std::optional<std::string> NorSand::refusal(const State& state, const Rate& rate) const {
  const double size = rate.stress.norm();
  if (!(size > 0)) return std::nullopt;
  const double p = state.p(), eta = state.q() / p;
  const double dp = mean_stress<Axisymmetric>(rate.stress) / size;
  const double dq = deviator_stress<Axisymmetric>(rate.stress) / size;
  const bool elastic = rate.active == 0, constant_q = std::abs(dq) <= kNoRate;
  // In an undrained test q stands still at its peak while p′ falls; that is plastic.
  const bool drained_set = parameters_.pore_fluid_bulk_modulus_pa == 0;
  if (constant_q && dp < -kNoRate && (elastic || drained_set)) return kNoInstabilityLine;
  if (elastic && dp < -kGivesWay && dq - eta * dp > kNoRate) return kNoInstabilityLine;
  // Beyond M_i the law dilates, and p′ may rise past a peak of q.
  if (constant_q && dp > kNoRate && (elastic || eta < image(state).stress_ratio))
    return kIsotropicLoading;
  const bool backwards = shear_strain(axisymmetric_strain(rate.strain)) < 0;
  if ((eta <= kOnYield && dq < -kNoRate) || (!elastic && backwards)) return kExtension;
  return wrong_drainage(state, rate);
}

/// Undrained is no change of volume at all or that of the set's own fluid, and all between.
std::optional<std::string> NorSand::wrong_drainage(const State& state, const Rate& rate) const {
  const double fluid = parameters_.pore_fluid_bulk_modulus_pa;
  const double size = rate.strain.norm(), volume = trace<Axisymmetric>(rate.strain);
  if (fluid == 0) {
    // At critical state nothing tells drained from undrained: stress and volume both stand still.
    const bool stress_moves = rate.stress.norm() > 1e-6 * shear_modulus(state.p()) * size;
    if (stress_moves && std::abs(volume) < kNoRate * size) return kSetForDrained;
    return std::nullopt;
  }
  const double of_fluid = -mean_stress<Axisymmetric>(rate.stress) / fluid;
  const double excess =
      volume - std::clamp(volume, std::min(of_fluid, 0.0), std::max(of_fluid, 0.0));
  if (std::abs(excess) > kDrained * size) return kSetForUndrained;
  return std::nullopt;
}

std::optional<std::string> NorSand::warning(const State& state) const {
  if (yield_distance(state, 0) >= -kInsideSurface) return std::nullopt;
  return "inside the yield surface, where the law is elastic and has no instability";
}

double NorSand::yield_distance(const State& state, int) const {
  const Image& i = image(state);
  return state.q() / state.p() - i.stress_ratio * (1 + std::log(i.ratio));
}

void NorSand::settle(State& state, unsigned on_yield) const {
  if (on_yield != 0) put_on_yield(state);
}

void NorSand::response(const State& state, Response<Axisymmetric>& out) const {
  StiffnessForm<Axisymmetric>& form = stiffness_form(out);
  const double p = state.p(), q = state.q();
  const double shear = shear_modulus(p), bulk = bulk_ratio() * shear;
  form.stiffness = isotropic_stiffness<Axisymmetric>(bulk, shear);
  const Image& i = image(state);
  const double growth = hardening(state) * (i.largest_ratio - i.ratio) / (i.ratio * i.ratio) +
                        cap_softening(state, i, restraint(bulk));  // dp_i/p_i per dε_q^p
  // M_i changes with p_i and, through the void ratio, with any strain: the second part belongs to
  // the trigger. On yield p (1 + ln r) = q/M_i.
  const double fall =
      q / i.stress_ratio *
      std::copysign(i.dilatancy * parameters_.volumetric_coupling, i.state_parameter);
  const Vector<Axisymmetric> flow = shear_and_volume(i.stress_ratio - q / p);
  form.add_plastic(flow, flow, growth * (p * i.stress_ratio - fall * i.critical_slope));
  form.trigger[0] -= fall * (1 + state.void_ratio) * identity<Axisymmetric>();
  form.memory_slope[0].setZero(2);
  form.memory_slope[0](0) = growth * state.memory(0);
}

}  // namespace triax::sim

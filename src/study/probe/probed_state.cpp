#include "src/study/probe/probed_state.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>

#include "lab/base/bad_input.hpp"
#include "sim/point/point_driver.hpp"
#include "sim/stability/plane_rate.hpp"

namespace triax::study {
namespace {

/// To which the first unstable state is isolated, of the part between two rows of a path.
constexpr double kPartOfRow = 1e-9;

/// Of cone edges by increments that are integrated: their round-off is that of the driver.
constexpr double kFinitePrecision = 1e-6;

Eigen::Vector3d principal(const sim::Vector<sim::Axisymmetric>& v) {
  const auto s = sim::axisymmetric_stress(v);
  return {s.axial, s.radial, s.radial};
}
Eigen::Vector3d principal(const sim::Vector<sim::Tensor>& v) { return v.head<3>(); }

template <class Space>
double deviator_stress(const sim::PointState<Space>& state) {
  const Eigen::Vector3d s = principal(state.stress);
  return s(1) == s(2) ? s(0) - s(2) : state.q();
}

template <class Space>
std::string words(const sim::PointState<Space>& state) {
  const double p = state.p(), q = deviator_stress(state);
  return fmt::format("p' {:.6g} kPa, q {:.6g} kPa, void ratio {:.6g}", p / 1e3, q / 1e3,
                     state.void_ratio);
}

void scale(sim::Probe& probe, double norm) {
  probe.stress *= norm;
  probe.strain *= norm;
  probe.second_order_work *= norm * norm;
}

void scale(sim::Circle& circle, double norm) {
  for (sim::Probe& probe : circle.probes) scale(probe, norm);
  for (sim::Cone& cone : circle.cones) scale(cone.strongest, norm);
  scale(circle.least, norm);
}

/// Probers of one state; increments of unit norm, those of finite ones of the norm.
template <class Space>
class StateProbers {
 public:
  StateProbers(const sim::Law<Space>& law, const sim::PointState<Space>& state,
               const Probing& probing)
      : law_(law),
        state_(state),
        probing_(probing),
        response_(std::make_shared<const sim::IncrementalResponse<Space>>(law, state)) {}

  sim::Circle circle() const {
    sim::CircleOptions options{.directions = probing_.directions};
    if (probing_.finite) options.precision = kFinitePrecision;
    sim::Circle circle = sim::probe_circle(prober(probing_.kind), options);
    if (!probing_.finite) scale(circle, probing_.norm);
    return circle;
  }

  /// A stress increment: of the norm where that is one of stress, else of 1 kPa along the rate.
  sim::Probe stress_probe(double angle) const {
    const bool of_norm = probing_.kind == sim::ProbeKind::stress;
    sim::Probe probe = of_norm ? prober(sim::ProbeKind::stress)(angle)
                               : sim::make_prober(response_, sim::ProbeKind::stress)(angle);
    if (!(of_norm && probing_.finite)) scale(probe, of_norm ? probing_.norm : 1e3);
    return probe;
  }

  ControlReport control(const sim::Probe& least) const {
    return control_of(*response_, least, probing_.ratios, probing_.conditions);
  }

  /// Empty unless the law is octolinear and the probes are of stress.
  std::optional<std::vector<sim::UnstableSector>> closed_form() const {
    const auto* form = std::get_if<sim::InterpolatedForm<Space>>(&response_->response());
    if (form == nullptr || form->quadratic || probing_.kind != sim::ProbeKind::stress)
      return std::nullopt;
    if constexpr (Space::kSize == 6)
      if (!sim::answers_in_plane_strain(*form)) return std::nullopt;
    return sim::unstable_sectors(sim::octolinear_zones(*form));
  }

  /// The words on the first direction that is refused.
  std::string refusal(const sim::Circle& circle) const {
    for (const sim::Probe& probe : circle.probes)
      if (probe.refused)
        if (auto words = why_refused(probe.angle)) return *words;
    return {};
  }

 private:
  std::optional<std::string> why_refused(double angle) const {
    const sim::PlaneVector direction = sim::unit_direction(angle);
    const auto unit = sim::plane_control<Space>(probing_.kind, direction);
    if (!law_.finite() && !probing_.finite)
      return law_.refusal(state_, sim::point_rate(law_, state_, unit));
    const double small = probing_.kind == sim::ProbeKind::stress ? 1 : 1e-7;
    const auto step = sim::advance_point(
        law_, state_,
        sim::plane_control<Space>(probing_.kind,
                                  (probing_.finite ? probing_.norm : small) * direction));
    if (step.message.empty()) return std::nullopt;
    return step.message;
  }

  sim::Prober prober(sim::ProbeKind kind) const {
    return probing_.finite ? sim::make_finite_prober(law_, state_, kind, probing_.norm)
                           : sim::make_prober(response_, kind);
  }

  const sim::Law<Space>& law_;
  const sim::PointState<Space>& state_;
  const Probing& probing_;
  std::shared_ptr<const sim::IncrementalResponse<Space>> response_;
};

double turned(double angle) {
  const double rest = std::fmod(angle, 2 * std::numbers::pi);
  return rest < 0 ? rest + 2 * std::numbers::pi : rest;
}

}  // namespace

std::vector<std::string> StateHead::all_warnings() const {
  std::vector<std::string> all = warnings;
  for (const auto& words : {void_ratio_outside, p_eff_outside})
    if (words) all.push_back(*words);
  return all;
}

std::vector<std::string> warnings_of(const std::vector<const StateHead*>& states) {
  std::vector<std::string> all;
  for (const StateHead* state : states)
    for (const auto& warning : state->warnings)
      if (std::ranges::find(all, warning) == all.end()) all.push_back(warning);
  for (const auto outside : {&StateHead::void_ratio_outside, &StateHead::p_eff_outside}) {
    const auto is_outside = [&](const StateHead* s) { return (s->*outside).has_value(); };
    const auto first = std::ranges::find_if(states, is_outside);
    if (first == states.end()) continue;
    const auto more = std::ranges::count_if(states, is_outside) - 1;
    all.push_back(*((*first)->*outside) +
                  (more > 0 ? fmt::format(", and so at {} more of the states", more) : ""));
  }
  return all;
}

template <class Space>
StateHead head_of(const lab::MaterialSet& material, const StateToProbe<Space>& what) {
  const sim::Law<Space>& law = *material.material.law<Space>();
  const sim::PointState<Space>& state = what.state;
  if (const auto objection = law.objection(state))
    throw lab::BadInput(fmt::format("{}{}: out of range for {}: {}",
                                    what.name.empty() ? "" : what.name + ", ", words(state),
                                    material.name, *objection));
  StateHead head{.name = what.name,
                 .from_path = what.from_path,
                 .axial_strain = what.axial_strain,
                 .stress = principal(state.stress),
                 .p = state.p(),
                 .q = deviator_stress(state),
                 .void_ratio = state.void_ratio,
                 .memory = {},
                 .test = what.test,
                 .warnings = {},
                 .void_ratio_outside = lab::void_ratio_outside(material, state.void_ratio),
                 .p_eff_outside = lab::p_eff_outside(material, state.p())};
  if (auto warning = law.warning(state)) head.warnings.push_back(std::move(*warning));
  if (what.test)
    head.warnings.insert(head.warnings.end(), what.test->warnings.begin(),
                         what.test->warnings.end());
  const auto names = law.memory_names();
  for (std::size_t i = 0; i < names.size() && static_cast<Eigen::Index>(i) < state.memory.size();
       ++i)
    head.memory.emplace_back(names[i], state.memory(static_cast<Eigen::Index>(i)));
  return head;
}

FirstUnstable ProbedState::as_first() const {
  return {p, q, void_ratio, axial_strain, circle.least.angle};
}

template <class Space>
ProbedState probe_state(const lab::MaterialSet& material, const StateToProbe<Space>& what,
                        const Probing& probing) {
  ProbedState probed;
  static_cast<StateHead&>(probed) = head_of(material, what);
  const StateProbers<Space> probers(*material.material.law<Space>(), what.state, probing);
  probed.circle = probers.circle();
  probed.circle_of = [set = material.material, state = what.state, probing](int directions) {
    Probing finer = probing;
    finer.directions = directions;
    return StateProbers<Space>(*set.template law<Space>(), state, finer).circle();
  };
  probed.control = probers.control(probed.circle.least);
  probed.isotropic_unloading = probers.stress_probe(isotropic_unloading(probing.plane));
  if (what.test && what.test->increment && probing.plane == sim::ProbePlane::axisymmetric)
    probed.own = probers.stress_probe(what.test->increment->angle);
  probed.closed_form = probers.closed_form();
  if (probed.circle.refused == 0) return probed;
  probed.refusal = probers.refusal(probed.circle);
  if (material.material.law<Space>()->finite())
    probed.warnings.push_back(fmt::format("the law gives no result in {} of {} directions{}{}",
                                          probed.circle.refused, probing.directions,
                                          probed.refusal.empty() ? "" : ": ", probed.refusal));
  return probed;
}

namespace {

/// Circles of one probing, without their probes.
template <class Space>
std::optional<sim::Probe> unstable_least(const sim::Law<Space>& law,
                                         const sim::PointState<Space>& state,
                                         const Probing& probing) {
  if (law.objection(state)) return std::nullopt;
  const auto prober =
      probing.finite
          ? sim::make_finite_prober(law, state, probing.kind, probing.norm)
          : sim::make_prober(std::make_shared<const sim::IncrementalResponse<Space>>(law, state),
                             probing.kind);
  sim::CircleOptions options{.directions = probing.directions, .keep_probes = false};
  if (probing.finite) options.precision = kFinitePrecision;
  const sim::Circle circle = sim::probe_circle(prober, options);
  return circle.unstable() ? std::optional(circle.least) : std::nullopt;
}

template <class Space>
FirstUnstable found_at(const PassedRow<Space>& row, const sim::Probe& least) {
  return {row.state.p(), deviator_stress(row.state), row.state.void_ratio, row.strain(0),
          least.angle};
}

/// What `part` of the strain increment from one row to the next makes of the earlier; empty where
/// it does not arrive there.
template <class Space>
std::optional<PassedRow<Space>> between(const sim::Law<Space>& law, const PassedRow<Space>& from,
                                        const PassedRow<Space>& to, double part) {
  const sim::Vector<Space> strain = part * (to.strain - from.strain);
  auto step = sim::advance_point(law, from.state, sim::MixedControl<Space>::strains(strain));
  if (step.outcome != sim::StepOutcome::accepted) return std::nullopt;
  return PassedRow<Space>{std::move(step.state), from.strain + strain};
}

}  // namespace

template <class Space>
std::optional<FirstUnstable> first_unstable(const lab::MaterialSet& material,
                                            const std::vector<PassedRow<Space>>& rows,
                                            const Probing& probing) {
  const sim::Law<Space>& law = *material.material.law<Space>();
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const auto least = unstable_least(law, rows[i].state, probing);
    if (!least) continue;
    auto found = found_at(rows[i], *least);
    double stable = 0, unstable = 1;
    while (i > 0 && unstable - stable > kPartOfRow) {
      const double middle = (stable + unstable) / 2;
      const auto state = between(law, rows[i - 1], rows[i], middle);
      if (!state) break;
      const auto there = unstable_least(law, state->state, probing);
      if (there) found = found_at(*state, *there);
      (there ? unstable : stable) = middle;
    }
    return found;
  }
  return std::nullopt;
}

std::optional<ConePlace> place_among(const std::vector<sim::Cone>& cones, double angle) {
  std::optional<ConePlace> nearest;
  for (std::size_t i = 0; i < cones.size(); ++i) {
    const auto& [from, to, strongest] = cones[i];
    if (cones[i].contains(angle))
      return ConePlace{true, i, std::min(turned(angle - from), turned(to - angle))};
    const double to_edge = std::min(turned(from - angle), turned(angle - to));
    if (!nearest || to_edge < nearest->to_edge) nearest = ConePlace{false, i, to_edge};
  }
  return nearest;
}

template StateHead head_of(const lab::MaterialSet&, const StateToProbe<sim::Axisymmetric>&);
template StateHead head_of(const lab::MaterialSet&, const StateToProbe<sim::Tensor>&);
template ProbedState probe_state(const lab::MaterialSet&, const StateToProbe<sim::Axisymmetric>&,
                                 const Probing&);
template ProbedState probe_state(const lab::MaterialSet&, const StateToProbe<sim::Tensor>&,
                                 const Probing&);
template std::optional<FirstUnstable> first_unstable(
    const lab::MaterialSet&, const std::vector<PassedRow<sim::Axisymmetric>>&, const Probing&);
template std::optional<FirstUnstable> first_unstable(const lab::MaterialSet&,
                                                     const std::vector<PassedRow<sim::Tensor>>&,
                                                     const Probing&);

}  // namespace triax::study

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <Eigen/Core>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "sim/law/response.hpp"

namespace triax::sim {

/// What a law keeps that is too large for a Memory and never changes once made: copies of a state
/// share it.
struct Interior {
  virtual ~Interior() = default;
};

/// A material point at an instant. A plain value: copy, compare, save, restore.
template <class Space>
struct PointState {
  Vector<Space> stress = Vector<Space>::Zero();  ///< σ′, Pa
  double void_ratio = 0;                         ///< e, de = −(1 + e) dε_v
  Memory memory;
  std::shared_ptr<const Interior> interior = nullptr;  ///< null but of a self-driven law

  double p() const { return mean_stress<Space>(stress); }
  double q() const { return deviator_stress<Space>(stress); }
};

/// What happens per unit of progress.
template <class Space>
struct PointRate {
  bool controllable = false;  ///< false: the conditions cannot be met, nothing else has meaning
  int limiting_variable =
      -1;  ///< row of the control that cannot be held; −1: the rows are not independent
  unsigned active = 0;                               ///< bit k: mechanism k loads
  std::array<double, kMostMechanisms> multiplier{};  ///< λ_k
  Vector<Space> stress = Vector<Space>::Zero();      ///< dσ′, Pa
  Vector<Space> strain = Vector<Space>::Zero();      ///< dε
  /// det(S T + E) with the tangent T of this direction, over that of the law's elastic or linear
  /// part: 1 far from the limit, 0 where control is lost.
  double determinant = 1;

  /// dσ′:dε
  double second_order_work() const { return stress.dot(strain); }
  /// dσ′:dε/(|dσ′| |dε|) in [−1, 1]; 0 where a norm vanishes.
  double normalised_work() const {
    const double norms = stress.norm() * strain.norm();
    return norms > 0 ? second_order_work() / norms : 0;
  }
};

template <class Space>
class SelfDriven;

/// What a law that integrates finite increments itself gives back.
template <class Space>
struct FiniteStep {
  PointState<Space> state;
  Matrix<Space> tangent = Matrix<Space>::Zero();  ///< ∂Δσ/∂Δε, Pa
  std::string failure;                            ///< empty where it worked
  bool smaller = false;  ///< with a failure: a smaller increment may succeed
};

/// A constitutive law in one space, with its parameters: constant once built, everything that
/// changes is in PointState. A law of rate form gives response() and, if it remembers something,
/// memory_rate(); the point driver does the rest.
template <class Space>
class Law {
 public:
  using State = PointState<Space>;
  using Rate = PointRate<Space>;

  virtual ~Law() = default;

  /// The state at this effective stress (Pa), without memory of shear. No objection is raised here.
  virtual State start(const Vector<Space>& stress, double void_ratio) const {
    return {stress, void_ratio, {}};
  }
  State isotropic(double p_pa, double void_ratio) const {
    return start(sim::isotropic<Space>(p_pa), void_ratio);
  }

  /// Names of the memory's entries, with units: columns of a table of results.
  virtual std::vector<std::string> memory_names() const { return {}; }
  /// Natural size of memory entry i, by which its integration error is divided.
  virtual double memory_scale(int) const { return 1; }

  /// Why the law has no meaning at this state: it is refused. Empty where it has one.
  virtual std::optional<std::string> objection(const State& state) const;
  /// Whether the objection is that of a limit surface: a control that gives stresses is lost there.
  virtual bool at_limit(const State&) const { return false; }
  /// What a reader must know of this state although the law goes on: outside the calibrated range.
  virtual std::optional<std::string> warning(const State&) const { return std::nullopt; }
  /// Why the law cannot follow this direction although the state is fine: a programme that it was
  /// not made for. Asked at the beginning of every integration step; a step that is refused fails.
  /// Not asked of a law that integrates itself. Empty where it can follow.
  virtual std::optional<std::string> refusal(const State&, const Rate&) const {
    return std::nullopt;
  }
  /// Whether mean stresses of zero and tension have a meaning.
  virtual bool carries_tension() const { return false; }

  /// Incremental response. Pre-condition: no objection. Every mechanism the law has is given, as if
  /// the state were on its yield surface.
  virtual void response(const State& state, Response<Space>& out) const = 0;
  Response<Space> response(const State& state) const {
    Response<Space> r;
    response(state, r);
    return r;
  }

  /// Rate of the memory that goes with `rate`, a solution with `response`; `out` comes with the
  /// memory's size and is left empty where nothing changes. To be written anew only where the
  /// memory changes with something else than the multipliers.
  virtual void memory_rate(const State& state, const Response<Space>& response, const Rate& rate,
                           Memory& out) const;

  /// Distance of mechanism k from yield, as a ratio (of stresses): negative inside, 0 on the
  /// surface. A mechanism without an elastic range is always at 0.
  virtual double yield_distance(const State&, int) const { return 0; }
  /// Takes the drift of integration out: puts the state onto the yield surfaces of these
  /// mechanisms, which it stands on to within kOnYield or which have just loaded, and notes a
  /// reversal of loading; mechanisms may have other names afterwards. Called at the beginning and
  /// at the end of an integration step.
  virtual void settle(State&, unsigned /*mechanisms*/) const {}
  /// A witness that becomes negative where loading mechanisms have reversed their direction, so
  /// that settle() has something to note: its zero is isolated within the step.
  virtual double reversal(const State&) const { return 1; }
  /// Notes a change of direction, for laws whose memory depends on it; true if it changed the
  /// state.
  virtual bool turn(State&, const Rate&) const { return false; }

  /// True for a foreign law that is only known by its answer to finite increments: then integrate()
  /// is used, and response() is its tangent for a small one.
  virtual bool finite() const { return false; }
  virtual FiniteStep<Space> integrate(const State& state, const Vector<Space>& /*strain*/) const {
    return {state, Matrix<Space>::Zero(), "the law is given in rates"};
  }

  /// The law as one that meets mixed control by itself (sim/point/self_driven.hpp); null for all
  /// that the point driver integrates.
  virtual const SelfDriven<Space>* self_driven() const { return nullptr; }

  /// M in triaxial compression: the stress ratio q/p′ that the law does not exceed at large strain.
  virtual std::optional<double> limit_stress_ratio() const { return std::nullopt; }
};

template <class Space>
void Law<Space>::memory_rate(const State&, const Response<Space>& response, const Rate& rate,
                             Memory& out) const {
  const auto* form = std::get_if<StiffnessForm<Space>>(&response);
  bool first = true;
  for (unsigned k = 0; form != nullptr && k < static_cast<unsigned>(form->mechanisms); ++k) {
    if (rate.multiplier[k] == 0 || form->memory_slope[k].size() == 0) continue;
    if (std::exchange(first, false))
      out = rate.multiplier[k] * form->memory_slope[k];
    else
      out += rate.multiplier[k] * form->memory_slope[k];
  }
  if (first) out.resize(0);
}

/// Stress ratio by which a state may stand inside a yield surface and still count as on it.
inline constexpr double kOnYield = 1e-9;

template <class Space>
std::optional<std::string> Law<Space>::objection(const State& s) const {
  if (!std::isfinite(s.stress.sum() + s.void_ratio + s.memory.sum()))
    return "the state is not finite";
  if (!carries_tension() && !(s.p() > 0)) return "p' is not above 0, where the law ends";
  if (!(s.void_ratio > 0)) return "the void ratio is not above 0";
  return std::nullopt;
}

}  // namespace triax::sim

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// A foreign law at run time: an Abaqus UMAT in a shared library.
//
// Tension positive, the plug-in's unit of stress and shear strains γ = 2 ε end here: what comes in
// and goes out is σ′ in Pa, compression positive. The UMAT is always called with NTENS = 6; in
// axisymmetry axis 1 is the axis and the answer must keep that symmetry.
//
// The law has no clock. A UMAT that asks for time is given DTIME = |Δε|/rate (the largest component
// of Δε), so that a path takes the same time however it is cut.
//
// Memory: STATEV, then what a UMAT is told of the past: STRAN (6), TIME, number of increments.
#include <memory>

#include "sim/law/parameters.hpp"
#include "sim/materials/umat_worker.hpp"

namespace triax::sim {

LawDescription umat_law();

/// Throws as making the law does, but for what the library itself refuses: no process is started.
void check_umat(const ParameterSet& set);

/// Most state variables that a UMAT may have here.
inline constexpr int kMostUmatState = kMostMemory - 8;

struct UmatSettings {
  double stress_unit_pa = 1e3;        ///< Pa per unit of stress of the plug-in
  std::vector<double> initial_state;  ///< STATEV at the start; what is not given is 0
  int void_ratio_index = 0;           ///< 1-based STATEV that starts as void ratio; 0: none
  double strain_rate_per_s = 1e-5;    ///< for DTIME
};

template <class Space>
class Umat : public Law<Space> {
 public:
  using State = PointState<Space>;

  Umat(std::shared_ptr<UmatWorker> worker, UmatSettings settings);

  State start(const Vector<Space>& stress, double void_ratio) const override;
  std::vector<std::string> memory_names() const override;
  std::optional<std::string> objection(const State& state) const override;
  /// The plug-in itself says where it ends.
  bool carries_tension() const override { return true; }
  using Law<Space>::response;
  /// Tangent of a vanishing increment; throws std::runtime_error where the plug-in fails.
  void response(const State& state, Response<Space>& out) const override;
  bool finite() const override { return true; }
  FiniteStep<Space> integrate(const State& state, const Vector<Space>& strain) const override;

 private:
  std::string check(const UmatCall& call) const;

  std::shared_ptr<UmatWorker> worker_;
  UmatSettings settings_;
};

extern template class Umat<Axisymmetric>;
extern template class Umat<Tensor>;

}  // namespace triax::sim

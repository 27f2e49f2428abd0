// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <memory>

#include "sim/materials/generalised_triaxial.hpp"

namespace triax::sim {

/// Generalised triaxial moduli of a law by probing: from the state, dσ_j = ±1 with the other
/// stresses held, as the law itself answers at that instant. As with SANISAND in closed form there
/// is no memory of an earlier yield surface: it always passes through the stress where the law can
/// put it there (settle()), so that a path is elastoplastic where it raises the stress towards
/// yield. A state at which a probe has no answer (a limit surface) is refused.
template <class Space>
class ProbedModuli : public GeneralisedTriaxial<Space> {
 public:
  using State = PointState<Space>;

  explicit ProbedModuli(std::shared_ptr<const Law<Tensor>> base) : base_(std::move(base)) {}

  void moduli(const State& state, Matrix<Space>& plus, Matrix<Space>& minus) const override;
  State start(const Vector<Space>& stress, double void_ratio) const override;
  std::vector<std::string> memory_names() const override { return base_->memory_names(); }
  double memory_scale(int entry) const override { return base_->memory_scale(entry); }
  std::optional<std::string> objection(const State& state) const override;
  bool at_limit(const State& state) const override;
  std::optional<std::string> warning(const State& state) const override;
  std::optional<double> limit_stress_ratio() const override { return base_->limit_stress_ratio(); }

 private:
  /// False where a probe has no answer.
  bool probe(const State& state, Matrix<Tensor>& plus, Matrix<Tensor>& minus) const;

  std::shared_ptr<const Law<Tensor>> base_;
};

extern template class ProbedModuli<Axisymmetric>;
extern template class ProbedModuli<Tensor>;

}  // namespace triax::sim

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "sim/law/interpolated_compliance.hpp"
#include "sim/law/law.hpp"

namespace triax::sim {

/// Responses of a soil to generalised triaxial paths, on which only one principal stress changes:
/// what INL2 and the octolinear law interpolate.
template <class Space>
class GeneralisedTriaxial {
 public:
  using State = PointState<Space>;
  virtual ~GeneralisedTriaxial() = default;

  /// N⁺ and N⁻ (1/Pa) in the orthonormal components of the space. Pre-condition: no objection.
  virtual void moduli(const State& state, Matrix<Space>& plus, Matrix<Space>& minus) const = 0;

  // What a law of the same state answers (sim/law/law.hpp).
  virtual State start(const Vector<Space>& stress, double void_ratio) const {
    return {stress, void_ratio, {}};
  }
  virtual std::vector<std::string> memory_names() const { return {}; }
  virtual double memory_scale(int) const { return 1; }
  virtual std::optional<std::string> objection(const State&) const { return std::nullopt; }
  virtual bool at_limit(const State&) const { return false; }
  virtual std::optional<std::string> warning(const State&) const { return std::nullopt; }
  virtual double reversal(const State&) const { return 1; }
  virtual bool turn(State&, const PointRate<Space>&) const { return false; }
  virtual std::optional<double> limit_stress_ratio() const { return std::nullopt; }
};

}  // namespace triax::sim

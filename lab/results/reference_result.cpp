// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/results/reference_result.hpp"

namespace triax::lab {
namespace {

/// σ₃ − u + q·share
std::optional<double> effective(const ReferenceResult& at, double share) {
  const auto q = at.signed_q_pa();
  if (!at.cell_pressure_pa || !at.pore_pressure_pa || !q) return std::nullopt;
  return *at.cell_pressure_pa - *at.pore_pressure_pa + share * *q;
}

}  // namespace

std::optional<double> ReferenceResult::signed_q_pa() const {
  const bool extension = test_type.ends_with('E');
  return extension && q_pa && *q_pa > 0 ? std::nullopt : q_pa;
}

std::optional<double> ReferenceResult::p_eff_pa() const { return effective(*this, 1.0 / 3); }

std::optional<double> ReferenceResult::s_eff_pa() const { return effective(*this, 0.5); }

std::optional<double> ReferenceResult::t_pa() const {
  const auto q = signed_q_pa();
  return q ? std::optional(*q / 2) : std::nullopt;
}

}  // namespace triax::lab

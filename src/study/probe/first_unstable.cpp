// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/study/probe/first_unstable.hpp"

#include <memory>

#include "sim/point/point_driver.hpp"
#include "src/study/probe/state_head.hpp"

namespace triax::study {
namespace {

/// To which the first unstable state is isolated, of the part between two rows of a path.
constexpr double kPartOfRow = 1e-9;

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
  auto options = probing.circle_options();
  options.keep_probes = false;
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

template std::optional<FirstUnstable> first_unstable(
    const lab::MaterialSet&, const std::vector<PassedRow<sim::Axisymmetric>>&, const Probing&);
template std::optional<FirstUnstable> first_unstable(const lab::MaterialSet&,
                                                     const std::vector<PassedRow<sim::Tensor>>&,
                                                     const Probing&);

}  // namespace triax::study

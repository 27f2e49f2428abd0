// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/stability/controllability.hpp"

#include <algorithm>
#include <array>

#include "sim/stability/plane_rate.hpp"

namespace triax::sim {
namespace {

template <class Space>
std::array<Probe, 2> free_modes(const IncrementalResponse<Space>& response, double R) {
  const double angle = failure_angle(kPlane<Space>, R);
  return {stress_probe(stress_rate(response, angle)),
          stress_probe(stress_rate(response, angle + std::numbers::pi))};
}

Probe weaker(const std::array<Probe, 2>& modes) {
  const auto& [loading, unloading] = modes;
  if (!loading.answered) return unloading;
  if (!unloading.answered) return loading;
  return loading.normalised < unloading.normalised ? loading : unloading;
}

template <class Space>
std::optional<ControlMatrix> matrix_of(const IncrementalResponse<Space>& response,
                                       const Probe& mode, double R) {
  if (!mode.answered) return std::nullopt;
  const auto compliance = plane_compliance(response, stress_rate(response, mode.angle));
  if (!compliance || !compliance->matrix.allFinite() || compliance->matrix(0, 0) == 0)
    return std::nullopt;
  return ControlMatrix{control_matrix(*compliance, R), control_determinant(*compliance, R),
                       failure_rule(*compliance, R)};
}

template <class Space>
ControlAnswer answer_to(const IncrementalResponse<Space>& response,
                        const MixedControl<Space>& control) {
  const auto rate = response.to(control);
  if (rate.controllable)
    return {ControlState::held, rate.determinant, stress_probe(rate), rate.limiting_variable};
  // A law that integrates itself and meets no control, though no row is at its limit, tells
  // nothing.
  const bool unknown =
      rate.limiting_variable == kRefused || (response.law().finite() && rate.limiting_variable < 0);
  return {unknown ? ControlState::unanswered : ControlState::lost, {}, {}, rate.limiting_variable};
}

template <class Space>
ControlState state_of(const IncrementalResponse<Space>& response, double R, ControlSense sense) {
  return answer_to(response, proportional_control<Space>(R, sense)).state;
}

/// Between an R that can be controlled and one that cannot; empty where the law does not answer
/// between them. Near the limit the solution of the control grows without bound and loses digits,
/// so that the sign of the mode's W₂ is looked at instead, where it changes with control. Of the
/// modes only that counts which goes the way of the sense, d(σ₁′ − σ₃′/R) dε₁ > 0.
template <class Space>
std::optional<double> limit(const IncrementalResponse<Space>& response, double held, double lost,
                            double precision, ControlSense sense) {
  const double way = sense == ControlSense::loading ? 1 : -1;
  const auto works = [&](double R) {
    return std::ranges::none_of(free_modes(response, R), [&](const Probe& mode) {
      return mode.answered && way * mode.strain.y() > 0 && mode.normalised <= 0;
    });
  };
  const bool by_work = works(held) && !works(lost);
  while (std::abs(lost - held) > precision) {
    const double middle = (held + lost) / 2;
    if (by_work) {
      (works(middle) ? held : lost) = middle;
      continue;
    }
    const auto state = state_of(response, middle, sense);
    if (state == ControlState::unanswered) return std::nullopt;
    (state == ControlState::held ? held : lost) = middle;
  }
  return held;
}

/// The search of one sense, step by step.
template <class Space>
class LossSearch {
 public:
  LossSearch(const IncrementalResponse<Space>& response, ControlSense sense, double precision,
             ControlSearch& found)
      : response_(response), sense_(sense), precision_(precision), found_(found) {}

  void look_at(double R) {
    const auto state = state_of(response_, R, sense_);
    ++found_.asked;
    if (state == ControlState::unanswered) ++found_.unanswered;
    const bool is_lost = state == ControlState::lost;
    if (is_lost && !lost_) begin(R);
    if (is_lost) found_.lost.back().to = R;
    if (lost_ && state == ControlState::held) end(R);
    lost_ = is_lost;
    held_ = state == ControlState::held;
    before_ = R;
  }

 private:
  void begin(double R) {
    found_.lost.push_back({R, R, false, false, sense_});
    if (!held_) return;
    if (const auto at = limit(response_, before_, R, precision_, sense_)) {
      found_.lost.back().from = *at;
      found_.lost.back().begins = true;
    }
  }
  void end(double R) {
    if (const auto at = limit(response_, R, before_, precision_, sense_)) {
      found_.lost.back().to = *at;
      found_.lost.back().ends = true;
    }
  }

  const IncrementalResponse<Space>& response_;
  ControlSense sense_;
  double precision_, before_ = 0;
  ControlSearch& found_;
  bool lost_ = false, held_ = false;
};

MixedControl<Axisymmetric> rows(const Eigen::RowVector2d& stress, const Eigen::RowVector2d& strain,
                                double stress_increment, double strain_increment) {
  MixedControl<Axisymmetric> c;
  c.stress.row(0) = stress;
  c.strain.row(1) = strain;
  c.increment << stress_increment, strain_increment;
  return c;
}

}  // namespace

template <>
MixedControl<Axisymmetric> proportional_control(double R, ControlSense sense) {
  constexpr double kRadial = 1 / std::numbers::sqrt2;
  return rows({1, -kRadial / R}, {1, 2 * R * kRadial}, sense == ControlSense::loading ? 1 : -1, 0);
}

template <>
MixedControl<Tensor> proportional_control(double R, ControlSense sense) {
  MixedControl<Tensor> control;
  control.stress.row(0) << 1, 0, -1 / R, 0, 0, 0;
  control.strain.row(2) << 1, 0, R, 0, 0, 0;
  hold_plane_strain(control);
  control.increment(0) = sense == ControlSense::loading ? 1 : -1;
  return control;
}

template <class Space>
std::vector<ControlPoint> scan_control(const IncrementalResponse<Space>& response,
                                       const std::vector<double>& ratios) {
  std::vector<ControlPoint> points;
  for (const double R : ratios) {
    ControlPoint point{.R = R};
    point.loading = answer_to(response, proportional_control<Space>(R));
    point.unloading = answer_to(response, proportional_control<Space>(R, ControlSense::unloading));
    point.controllable = point.loading.held() && point.unloading.held();
    if (point.controllable) point.index = std::min(*point.loading.index, *point.unloading.index);
    point.mode = weaker(free_modes(response, R));
    point.matrix = matrix_of(response, point.mode, R);
    points.push_back(std::move(point));
  }
  return points;
}

template <class Space>
ControlSearch lost_control(const IncrementalResponse<Space>& response, double R_from, double R_to,
                           int steps) {
  ControlSearch found;
  for (const auto sense : {ControlSense::loading, ControlSense::unloading}) {
    LossSearch<Space> search(response, sense, 1e-12 * (R_to - R_from), found);
    for (int i = 0; i <= steps; ++i) search.look_at(R_from + (R_to - R_from) * i / steps);
  }
  return found;
}

std::vector<NamedControl> triaxial_controls() {
  constexpr double kRadial = 1 / std::numbers::sqrt2;
  const Eigen::RowVector2d axial(1, 0), radial(0, kRadial), q(1, -kRadial), volume(1, 2 * kRadial);
  return {{"undrained, dq > 0", rows(q, volume, 1, 0)},
          {"undrained, dε1 > 0", MixedControl<Axisymmetric>::strain_path(1)},
          {"dq = 0, dp′ < 0", MixedControl<Axisymmetric>::stress_path(-1, 0)},
          {"dq = 0, dεv < 0", rows(q, volume, 0, -1)},
          {"drained, dσ1 > 0, dσ3 = 0", MixedControl<Axisymmetric>::stresses({1, 0})},
          {"drained, dε1 > 0, dσ3 = 0", rows(radial, axial, 0, 1)},
          {"all strains, dε1 > 0, dε3 = 0", MixedControl<Axisymmetric>::strains({1, 0})}};
}

std::vector<ControlIndex> control_indices(const IncrementalResponse<Axisymmetric>& response,
                                          const std::vector<NamedControl>& controls) {
  std::vector<ControlIndex> indices;
  for (const auto& [name, control, conditions] : controls) {
    ControlIndex index{name, answer_to(response, control)};
    const auto row = static_cast<std::size_t>(std::max(index.answer.limiting_variable, 0));
    if (index.answer.state == ControlState::lost && index.answer.limiting_variable >= 0 &&
        row < conditions.size())
      index.limiting_variable = conditions[row];
    indices.push_back(std::move(index));
  }
  return indices;
}

template std::vector<ControlPoint> scan_control(const IncrementalResponse<Axisymmetric>&,
                                                const std::vector<double>&);
template std::vector<ControlPoint> scan_control(const IncrementalResponse<Tensor>&,
                                                const std::vector<double>&);
template ControlSearch lost_control(const IncrementalResponse<Axisymmetric>&, double, double, int);
template ControlSearch lost_control(const IncrementalResponse<Tensor>&, double, double, int);

}  // namespace triax::sim

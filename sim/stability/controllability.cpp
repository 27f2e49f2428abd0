#include "sim/stability/controllability.hpp"

#include "sim/stability/proportional_control.hpp"

namespace triax::sim {
namespace {

PlaneVector in_plane(const Vector<Axisymmetric>& v) { return rendulic(v); }
PlaneVector in_plane(const Vector<Tensor>& v) { return {v(2), v(0)}; }

template <class Space>
constexpr ProbePlane kPlane =
    Space::kSize == 2 ? ProbePlane::axisymmetric : ProbePlane::plane_strain;

/// The increment of a rate with the angle of its stress, of unit stress norm.
template <class Space>
Probe probe_of(const PointRate<Space>& rate) {
  Probe probe;
  const double norm = in_plane(rate.stress).norm();
  if (!rate.controllable || !(norm > 0)) return probe;
  probe.answered = true;
  probe.stress = in_plane(rate.stress) / norm;
  probe.strain = in_plane(rate.strain) / norm;
  probe.angle = angle_of(probe.stress);
  probe.second_order_work = probe.stress.dot(probe.strain);
  const double strain = probe.strain.norm();
  probe.normalised = strain > 0 ? probe.second_order_work / strain : 0;
  return probe;
}

/// A stress direction of the plane.
Probe stress_probe(const IncrementalResponse<Axisymmetric>& response, double angle) {
  return probe_of(response.to_stress({std::sin(angle), std::cos(angle)}));
}
Probe stress_probe(const IncrementalResponse<Tensor>& response, double angle) {
  MixedControl<Tensor> control;
  control.increment << std::sin(angle), 0, std::cos(angle), 0, 0, 0;
  for (const int free : {0, 2}) control.stress(free, free) = 1;
  for (const int fixed : {1, 3, 4, 5}) control.strain(fixed, fixed) = 1;
  return probe_of(response.to(control));
}

template <class Space>
Probe free_mode(const IncrementalResponse<Space>& response, double R) {
  const double angle = failure_angle(kPlane<Space>, R);
  const Probe loading = stress_probe(response, angle);
  const Probe unloading = stress_probe(response, angle + std::numbers::pi);
  if (!loading.answered) return unloading;
  if (!unloading.answered) return loading;
  return loading.normalised < unloading.normalised ? loading : unloading;
}

template <class Space>
bool controllable(const IncrementalResponse<Space>& response, double R) {
  return response.to(proportional_control<Space>(R)).controllable;
}

/// Between an R that can be controlled and one that cannot. Near the limit the solution of the
/// control grows without bound and loses digits, so that the sign of the mode's W₂ is looked at
/// instead, where it changes with control.
template <class Space>
double limit(const IncrementalResponse<Space>& response, double held, double lost,
             double precision) {
  const auto works = [&](double R) { return free_mode(response, R).normalised > 0; };
  const bool by_work = works(held) && !works(lost);
  while (std::abs(lost - held) > precision) {
    const double middle = (held + lost) / 2;
    ((by_work ? works(middle) : controllable(response, middle)) ? held : lost) = middle;
  }
  return held;
}

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
MixedControl<Axisymmetric> proportional_control(double R) {
  constexpr double kRadial = 1 / std::numbers::sqrt2;
  return rows({1, -kRadial / R}, {1, 2 * R * kRadial}, 1, 0);
}

template <>
MixedControl<Tensor> proportional_control(double R) {
  MixedControl<Tensor> control;
  control.stress.row(0) << 1, 0, -1 / R, 0, 0, 0;
  control.strain.row(2) << 1, 0, R, 0, 0, 0;
  for (const int fixed : {1, 3, 4, 5}) control.strain(fixed, fixed) = 1;
  control.increment(0) = 1;
  return control;
}

template <class Space>
std::vector<ControlPoint> scan_control(const IncrementalResponse<Space>& response,
                                       const std::vector<double>& ratios) {
  std::vector<ControlPoint> points;
  for (const double R : ratios) {
    const auto rate = response.to(proportional_control<Space>(R));
    const double index = rate.controllable ? rate.determinant : std::min(rate.determinant, 0.0);
    points.push_back({R, rate.controllable, index, probe_of(rate), free_mode(response, R)});
  }
  return points;
}

template <class Space>
std::vector<LostControl> lost_control(const IncrementalResponse<Space>& response, double R_from,
                                      double R_to, int steps) {
  const double precision = 1e-12 * (R_to - R_from);
  std::vector<LostControl> ranges;
  double before = R_from;
  bool held = controllable(response, R_from);
  if (!held) ranges.push_back({R_from, R_to, false, false});
  for (int i = 1; i <= steps; ++i) {
    const double here = R_from + (R_to - R_from) * i / steps;
    const bool holds = controllable(response, here);
    if (held && !holds)
      ranges.push_back({limit(response, before, here, precision), R_to, true, false});
    if (!held && holds) {
      ranges.back().to = limit(response, here, before, precision);
      ranges.back().ends = true;
    }
    held = holds;
    before = here;
  }
  return ranges;
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
  for (const auto& [name, control] : controls) {
    const auto rate = response.to(control);
    const double index = rate.controllable ? rate.determinant : std::min(rate.determinant, 0.0);
    indices.push_back({name, rate.controllable, index, probe_of(rate)});
  }
  return indices;
}

template std::vector<ControlPoint> scan_control(const IncrementalResponse<Axisymmetric>&,
                                                const std::vector<double>&);
template std::vector<ControlPoint> scan_control(const IncrementalResponse<Tensor>&,
                                                const std::vector<double>&);
template std::vector<LostControl> lost_control(const IncrementalResponse<Axisymmetric>&, double,
                                               double, int);
template std::vector<LostControl> lost_control(const IncrementalResponse<Tensor>&, double, double,
                                               int);

}  // namespace triax::sim

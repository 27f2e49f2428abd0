// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/materials/mohr_coulomb.hpp"

#include <algorithm>
#include <cmath>

#include "sim/materials/component_names.hpp"
#include "sim/materials/strength.hpp"
#include "sim/mechanics/linear_algebra.hpp"

namespace triax::sim {
namespace {

/// On an edge, principal stresses closer than this (as a ratio to the strength) have no axes of
/// their own and take those of the remembered frame.
constexpr double kTie = 1e-7;
/// Share of shear in the plane of two equal principal stresses from which on an increment turns
/// their axes.
constexpr double kTurned = 1e-9;
/// Change of stress, as a ratio to the strength, that is round-off: such a state is settled.
constexpr double kRoundOffChange = 1e-14;

// Where a state stands, as its memory says it.
constexpr double kInside = 0, kOnPlane = 1, kCompressionEdge = 2, kExtensionEdge = 3;

/// Places of σ_i and σ_j of the mechanisms (1,3), (1,2), (2,3) in descending order.
constexpr std::array<std::array<int, 2>, 3> kPairs{{{0, 2}, {0, 1}, {1, 2}}};

double along(const Eigen::Matrix3d& a, const Eigen::Vector3d& v) { return v.dot(a * v); }

/// v vᵗ
Vector<Tensor> dyad(const Eigen::Vector3d& v) {
  constexpr double r = std::numbers::sqrt2;
  Vector<Tensor> d;
  d << v(0) * v(0), v(1) * v(1), v(2) * v(2), r * (v(0) * v(1)), r * (v(0) * v(2)),
      r * (v(1) * v(2));
  return d;
}

/// Axes of the symmetric `a` in the plane of columns i and j, the larger value in column i.
void turn_axes(const Eigen::Matrix3d& a, Eigen::Matrix3d& axes, int i, int j) {
  const Eigen::Vector3d u = axes.col(i), v = axes.col(j);
  const double angle = 0.5 * std::atan2(2 * u.dot(a * v), along(a, u) - along(a, v));
  axes.col(i) = std::cos(angle) * u + std::sin(angle) * v;
  axes.col(j) = std::cos(angle) * v - std::sin(angle) * u;
}

/// The columns in the order of descending rank.
Eigen::Matrix3d sorted(const Eigen::Matrix3d& axes, const Eigen::Vector3d& rank) {
  std::array<int, 3> order{0, 1, 2};
  std::ranges::sort(order, [&rank](int a, int b) {  // a stable sort would allocate
    return rank(a) != rank(b) ? rank(a) > rank(b) : a > b;
  });
  Eigen::Matrix3d result;
  for (int i = 0; i < 3; ++i) result.col(i) = axes.col(order[static_cast<std::size_t>(i)]);
  return result;
}

}  // namespace

const ParameterTable<MohrCoulombParameters>& mohr_coulomb_table() {
  static const auto table = elastic_and_strength_rows<MohrCoulombParameters>();
  return table;
}

LawDescription mohr_coulomb_law() {
  return describe<MohrCoulomb>("mohr_coulomb",
                               "perfect plasticity on the exact hexagon, flow not associated",
                               "Mohr's envelope of straight lines; corners after Koiter (1953), "
                               "Q. Appl. Math. 11:350",
                               mohr_coulomb_table());
}

template <class Space>
MohrCoulomb<Space>::MohrCoulomb(const MohrCoulombParameters& p)
    : parameters_(p),
      sine_(std::sin(p.friction_angle)),
      flow_sine_(std::sin(p.dilation_angle)),
      cohesion_(p.cohesion_pa * std::cos(p.friction_angle)) {
  check_parameters(p, mohr_coulomb_table());
  check_hyperelastic(p.hyperelastic);
  check_strength(p);
}

/// The planes of the three mechanisms of a tensor: f_k = excess(high_k·σ high_k, low_k·σ low_k).
template <class Space>
struct MohrCoulomb<Space>::Planes {
  Planes(const MohrCoulomb& of, const PointState<Tensor>& state);
  bool answer(const MohrCoulomb& asked, const PointState<Tensor>& state) const {
    return law == asked.mark_ && components == state.stress && memory == state.memory;
  }

  Mark law;
  Vector<Tensor> components;
  Eigen::Matrix<double, 7, 1> memory;
  Eigen::Matrix3d stress;
  Eigen::Matrix3d axes;   ///< v₁, v₂, v₃
  Eigen::Vector3d value;  ///< principal stresses
  Eigen::Matrix3d high, low;
  Eigen::Vector3d distance;  ///< from yield
};

template <class Space>
MohrCoulomb<Space>::Planes::Planes(const MohrCoulomb& of, const PointState<Tensor>& state)
    : law(of.mark_), components(state.stress), memory(state.memory), stress(matrix_of(components)) {
  const Eigen::Matrix3d v = principal_axes(stress).directions;
  const double place = memory(6), strength = of.strength(state.p());
  if (place == kInside) {
    axes = v.rowwise().reverse();
  } else {
    const Eigen::Matrix3d names = matrix_of(Vector<Tensor>(memory.head<6>()));
    axes = sorted(v, (v.transpose() * names * v).diagonal());
    const int i = place == kCompressionEdge ? 1 : 0, j = i + 1;
    if (place != kOnPlane &&
        std::abs(along(stress, axes.col(i)) - along(stress, axes.col(j))) < kTie * strength)
      turn_axes(names, axes, i, j);
  }
  for (int k = 0; k < 3; ++k) {
    const auto& [i, j] = kPairs[static_cast<std::size_t>(k)];
    value(k) = along(stress, axes.col(k));
    high.col(k) = axes.col(i);
    low.col(k) = axes.col(j);
  }
  // cos and sin of 60°
  const double c = 0.5, s = std::sqrt(0.75);
  if (place == kCompressionEdge) {
    high.col(2) = axes.col(0);
    low.col(1) = c * axes.col(2) + s * axes.col(1);
    low.col(2) = c * axes.col(2) - s * axes.col(1);
  } else if (place == kExtensionEdge) {
    low.col(1) = axes.col(2);
    high.col(1) = c * axes.col(0) + s * axes.col(1);
    high.col(2) = c * axes.col(0) - s * axes.col(1);
  }
  for (int k = 0; k < 3; ++k)
    distance(k) = of.excess(along(stress, high.col(k)), along(stress, low.col(k))) / strength;
}

/// Valid until the next call on this thread: the distance of each mechanism, the settling and the
/// response ask for the planes of one state a dozen times in a step.
template <class Space>
const typename MohrCoulomb<Space>::Planes& MohrCoulomb<Space>::planes(
    const PointState<Tensor>& state) const {
  thread_local std::optional<Planes> kept;
  if (!kept || !kept->answer(*this, state)) kept.emplace(*this, state);
  return *kept;
}

template <class Space>
void MohrCoulomb<Space>::remember(PointState<Tensor>& state, const Eigen::Matrix3d& axes,
                                  double place) const {
  state.memory.head<6>() = dyad(axes.col(0)) - dyad(axes.col(2));
  state.memory(6) = place;
}

template <class Space>
PointState<Space> MohrCoulomb<Space>::start(const Vector<Space>& stress, double void_ratio) const {
  return {stress, void_ratio, Memory::Zero(Space::kSize == 2 ? 0 : 7)};
}

template <class Space>
std::vector<std::string> MohrCoulomb<Space>::memory_names() const {
  if constexpr (Space::kSize == 2) return {};
  std::vector<std::string> names;
  name_components<Space>("frame", names);
  names.emplace_back("place");
  return names;
}

template <class Space>
std::optional<std::string> MohrCoulomb<Space>::objection(const State& state) const {
  if (auto general = Law<Space>::objection(state)) return general;
  if (!(strength(state.p()) > 0))
    return "the mean stress is at the apex of the surface or beyond, where the law ends";
  return std::nullopt;
}

template <class Space>
std::optional<std::string> MohrCoulomb<Space>::warning(const State& state) const {
  for (int k = 0; k < 2; ++k)
    if (yield_distance(state, k) > kFarOutside) return "the stress lies outside the yield surface";
  return std::nullopt;
}

template <class Space>
void MohrCoulomb<Space>::response(const State& state, Response<Space>& out) const {
  StiffnessForm<Space>& form = stiffness_form(out);
  form.stiffness = elastic_stiffness<Space>(parameters_, state.stress);
  if constexpr (Space::kSize == 2) {
    const auto compression = [](double sine) {
      return Vector<Space>(1 - sine, -(1 + sine) / std::numbers::sqrt2);
    };
    const auto extension = [](double sine) {
      return Vector<Space>(-(1 + sine), (1 - sine) / std::numbers::sqrt2);
    };
    form.add_plastic(compression(flow_sine_), compression(sine_), 0);
    form.add_plastic(extension(flow_sine_), extension(sine_), 0);
  } else {
    const Planes& on = planes(state);
    for (int k = 0; k < 3; ++k) {
      const Vector<Space> high = dyad(on.high.col(k)), low = dyad(on.low.col(k));
      const Vector<Space> c_high = form.stiffness * high, c_low = form.stiffness * low;
      form.add_plastic((1 - flow_sine_) * c_high - (1 + flow_sine_) * c_low,
                       (1 - sine_) * c_high - (1 + sine_) * c_low,
                       (1 - sine_) * high - (1 + sine_) * low, 0);
    }
  }
}

template <class Space>
double MohrCoulomb<Space>::yield_distance(const State& state, int k) const {
  if constexpr (Space::kSize == 2) {
    const double axial = state.stress(0), radial = state.stress(1) / std::numbers::sqrt2;
    return (k == 0 ? excess(axial, radial) : excess(radial, axial)) / strength(state.p());
  } else {
    return planes(state).distance(k);
  }
}

template <class Space>
void MohrCoulomb<Space>::settle(State& state, unsigned on_yield) const {
  for (int k = 0; k < 2; ++k)
    if ((on_yield >> k & 1U) && yield_distance(state, k) > kFarOutside) on_yield = 0;
  // σ_i = N σ_j + D on the plane (i, j).
  const double n = (1 + sine_) / (1 - sine_), d = 2 * cohesion_ / (1 - sine_);
  const double total = trace<Space>(state.stress);
  if constexpr (Space::kSize == 2) {
    const double radial = on_yield == 1 ? (total - d) / (n + 2) : (n * total + d) / (2 * n + 1);
    if (on_yield == 1 || on_yield == 2)
      state.stress << total - 2 * radial, std::numbers::sqrt2 * radial;
  } else if (on_yield == 0) {
    state.memory.setZero();
  } else {
    const Planes& on = planes(state);
    const double place = state.memory(6);
    const Eigen::Vector3d& value = on.value;
    const double size = kOnYield * strength(state.p());
    // At constant p′ onto the edge, or onto the plane of the largest and the smallest stress.
    const bool stays = place <= kOnPlane || on_yield == 7;
    Eigen::Matrix3d change = Eigen::Matrix3d::Zero();
    double now = kOnPlane;
    if (stays && excess(value(0), value(1)) >= -size) {
      const double low = (total - d) / (n + 2);
      change.diagonal() = Eigen::Vector3d(total - 2 * low, low, low) - value;
      change(1, 2) = change(2, 1) = -on.axes.col(1).dot(on.stress * on.axes.col(2));
      now = kCompressionEdge;
    } else if (stays && excess(value(1), value(2)) >= -size) {
      const double low = (total - 2 * d) / (2 * n + 1);
      change.diagonal() = Eigen::Vector3d(n * low + d, n * low + d, low) - value;
      change(0, 1) = change(1, 0) = -on.axes.col(0).dot(on.stress * on.axes.col(1));
      now = kExtensionEdge;
    } else {
      const double sum = value(0) + value(2), low = (sum - d) / (n + 1);
      change(0, 0) = sum - low - value(0);
      change(2, 2) = low - value(2);
    }
    if (now == place && change.norm() < kRoundOffChange * strength(state.p())) return;
    state.stress += components(Eigen::Matrix3d(on.axes * change * on.axes.transpose()));
    remember(state, on.axes, now);
  }
}

template <class Space>
bool MohrCoulomb<Space>::turn(State& state, const Rate& rate) const {
  if constexpr (Space::kSize == 6) {
    const double place = state.memory(6);
    if (place == kInside) return false;
    bool turned = false;
    const Planes* on = &planes(state);
    if (place != kOnPlane) {
      const Eigen::Matrix3d strain = matrix_of(rate.strain);
      const int i = place == kCompressionEdge ? 1 : 0, j = i + 1;
      const double small = kTurned * rate.strain.norm();
      turned = std::abs(on->axes.col(i).dot(strain * on->axes.col(j))) > small ||
               along(strain, on->axes.col(i)) < along(strain, on->axes.col(j)) - small;
      if (turned) {
        Eigen::Matrix3d axes = on->axes;
        turn_axes(strain, axes, i, j);
        remember(state, axes, place);
        on = &planes(state);
      }
    }
    if (rate.active != 0) return turned;
    // Elastic so far: if it stays so on these planes, they need no names any more.
    const Eigen::Matrix3d stress = matrix_of(rate.stress);
    for (int k = 0; k < 3; ++k)
      if (on->distance(k) >= -kOnYield && (1 - sine_) * along(stress, on->high.col(k)) -
                                                  (1 + sine_) * along(stress, on->low.col(k)) >
                                              1e-9 * rate.stress.norm())
        return turned;
    state.memory.setZero();
    return true;
  } else {
    return false;
  }
}

template <class Space>
std::optional<double> MohrCoulomb<Space>::limit_stress_ratio() const {
  if (cohesion_ > 0) return std::nullopt;
  return stress_ratio_at_friction_angle(parameters_.friction_angle);
}

template class MohrCoulomb<Axisymmetric>;
template class MohrCoulomb<Tensor>;

}  // namespace triax::sim

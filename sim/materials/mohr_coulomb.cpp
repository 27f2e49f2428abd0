#include "sim/materials/mohr_coulomb.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

namespace triax::sim {
namespace {

/// A state this far (as a ratio) outside the surface is no round-off.
constexpr double kFarOutside = 1e-6;
/// Principal stresses closer than this, as a ratio to the strength, take their axes from the
/// remembered frame.
constexpr double kTie = 1e-7;
/// Share of shear in the plane of two equal principal stresses from which on an increment turns
/// their axes.
constexpr double kTurned = 1e-9;

/// Places of σ_i and σ_j of the mechanisms (1,3), (1,2), (2,3) in descending order.
constexpr std::array<std::array<int, 2>, 3> kPairs{{{0, 2}, {0, 1}, {1, 2}}};

Eigen::Vector3d along(const Eigen::Matrix3d& a, const Eigen::Matrix3d& axes) {
  return (axes.transpose() * a * axes).diagonal();
}

}  // namespace

const ParameterTable<MohrCoulombParameters>& mohr_coulomb_table() {
  using P = MohrCoulombParameters;
  static const ParameterTable<P> table = [] {
    ParameterTable<P> rows = elastic_rows<P>();
    rows.push_back(
        {{"friction_angle_deg", "φ", "deg", "friction angle", {.at_least = 0, .below = 90}},
         &P::friction_angle});
    rows.push_back({{.key = "cohesion_kPa",
                     .symbol = "c",
                     .unit = "kPa",
                     .meaning = "cohesion",
                     .range = {.at_least = 0},
                     .usual = 0},
                    &P::cohesion_pa});
    rows.push_back({{.key = "dilation_angle_deg",
                     .symbol = "ψ",
                     .unit = "deg",
                     .meaning = "dilation angle",
                     .range = {.above = -90, .below = 90},
                     .usual = 0},
                    &P::dilation_angle});
    return rows;
  }();
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
  if (p.friction_angle == 0 && p.cohesion_pa == 0)
    throw std::invalid_argument(
        "friction_angle_deg and cohesion_kPa are both 0, one must be above 0");
}

/// Principal stresses in the order of the mechanisms' names, with their axes in columns. In
/// axisymmetry the axial stress and the radial one.
template <class Space>
struct MohrCoulomb<Space>::Frame {
  Eigen::Vector3d value;
  Eigen::Matrix3d axes;
};

template <class Space>
typename MohrCoulomb<Space>::Frame MohrCoulomb<Space>::frame(const State& state) const {
  if constexpr (Space::kSize == 2) {
    const double radial = state.stress(1) / std::numbers::sqrt2;
    return {{state.stress(0), radial, radial}, Eigen::Matrix3d::Identity()};
  } else {
    const Eigen::Matrix3d stress = matrix_of(state.stress);
    const bool named = !state.memory.isZero(0);
    Eigen::Matrix3d names = stress, tilted = stress;
    if (named) {
      names = matrix_of(Vector<Tensor>(state.memory));
      tilted += kTie * std::max(strength(state.p()), 0.0) * names;
    }
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> eigen(tilted);
    const Eigen::Matrix3d& v = eigen.eigenvectors();
    const Eigen::Vector3d rank = along(names, v);
    std::array<int, 3> order{2, 1, 0};
    std::ranges::stable_sort(order, [&rank](int a, int b) { return rank(a) > rank(b); });
    Frame f;
    for (int i = 0; i < 3; ++i) f.axes.col(i) = v.col(order[static_cast<std::size_t>(i)]);
    f.value = along(stress, f.axes);
    return f;
  }
}

template <class Space>
PointState<Space> MohrCoulomb<Space>::start(const Vector<Space>& stress, double void_ratio) const {
  return {stress, void_ratio, Memory::Zero(Space::kSize == 2 ? 0 : 6)};
}

template <class Space>
std::vector<std::string> MohrCoulomb<Space>::memory_names() const {
  if constexpr (Space::kSize == 2) return {};
  return {"frame_11", "frame_22", "frame_33", "frame_12", "frame_13", "frame_23"};
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
  form.stiffness = elastic_stiffness<Space>(parameters_, state.p());
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
    const Frame f = frame(state);
    std::array<Vector<Space>, 3> dyad;
    for (int i = 0; i < 3; ++i)
      dyad[static_cast<std::size_t>(i)] =
          components(Eigen::Matrix3d(f.axes.col(i) * f.axes.col(i).transpose()));
    for (const auto& [i, j] : kPairs) {
      const Vector<Space>& high = dyad[static_cast<std::size_t>(i)];
      const Vector<Space>& low = dyad[static_cast<std::size_t>(j)];
      form.add_plastic((1 - flow_sine_) * high - (1 + flow_sine_) * low,
                       (1 - sine_) * high - (1 + sine_) * low, 0);
    }
  }
}

template <class Space>
double MohrCoulomb<Space>::yield_distance(const State& state, int mechanism) const {
  const Frame f = frame(state);
  const double size = strength(state.p());
  if constexpr (Space::kSize == 2) {
    return (mechanism == 0 ? excess(f.value(0), f.value(1)) : excess(f.value(1), f.value(0))) /
           size;
  } else {
    const auto& [i, j] = kPairs[static_cast<std::size_t>(mechanism)];
    return excess(f.value(i), f.value(j)) / size;
  }
}

template <class Space>
void MohrCoulomb<Space>::settle(State& state, unsigned on_yield) const {
  const Frame f = frame(state);
  // σ_i = N σ_j + D on the plane (i, j).
  const double n = (1 + sine_) / (1 - sine_), d = 2 * cohesion_ / (1 - sine_);
  for (int k = 0; k < 2; ++k)
    if ((on_yield >> k & 1U) && yield_distance(state, k) > kFarOutside) on_yield = 0;
  Eigen::Vector3d change = Eigen::Vector3d::Zero();
  if constexpr (Space::kSize == 2) {
    // At constant p′, on the edge of compression or that of extension.
    const double total = f.value.sum();
    const double radial = on_yield == 1 ? (total - d) / (n + 2) : (n * total + d) / (2 * n + 1);
    if (on_yield == 1 || on_yield == 2)
      state.stress << total - 2 * radial, std::numbers::sqrt2 * radial;
  } else {
    if (on_yield == 0) {
      state.memory.setZero();
      return;
    }
    const auto onto_plane = [&](int i, int j) {
      const double sum = f.value(i) + f.value(j), low = (sum - d) / (n + 1);
      change(i) = sum - low - f.value(i);
      change(j) = low - f.value(j);
    };
    Eigen::Matrix3d edge = Eigen::Matrix3d::Zero();
    const auto equal = [&](int i, int j) {  // their shear, which would part them, goes
      edge(i, j) = edge(j, i) = -f.axes.col(i).dot(matrix_of(state.stress) * f.axes.col(j));
    };
    const double total = f.value.sum();
    if (on_yield == 0b011) {
      const double low = (total - d) / (n + 2);
      change = Eigen::Vector3d(total - 2 * low, low, low) - f.value;
      equal(1, 2);
    } else if (on_yield == 0b101) {
      const double low = (total - 2 * d) / (2 * n + 1);
      change = Eigen::Vector3d(n * low + d, n * low + d, low) - f.value;
      equal(0, 1);
    } else if ((on_yield & 0b001U) != 0) {
      onto_plane(0, 2);
    } else if (on_yield == 0b010) {
      onto_plane(0, 1);
    } else if (on_yield == 0b100) {
      onto_plane(1, 2);
    }
    edge.diagonal() = change;
    state.stress += components(Eigen::Matrix3d(f.axes * edge * f.axes.transpose()));
    // Names of the planes from here on: by size, in a tie as before.
    Eigen::Vector3d value = f.value + change;
    std::array<int, 3> order{0, 1, 2};
    std::ranges::stable_sort(order, [&value](int a, int b) { return value(a) > value(b); });
    const auto first = f.axes.col(order[0]), last = f.axes.col(order[2]);
    state.memory = components(Eigen::Matrix3d(first * first.transpose() - last * last.transpose()));
  }
}

template <class Space>
bool MohrCoulomb<Space>::turn(State& state, const Rate& rate) const {
  if constexpr (Space::kSize == 6) {
    if (state.memory.isZero(0)) return false;
    Frame f = frame(state);
    const Eigen::Matrix3d strain = f.axes.transpose() * matrix_of(rate.strain) * f.axes;
    bool turned = false;
    for (int i = 0; i < 2; ++i) {
      const int j = i + 1;
      if (f.value(i) - f.value(j) > 10 * kTie * strength(state.p())) continue;
      if (std::abs(strain(i, j)) <= kTurned * rate.strain.norm()) continue;
      // The axes of the increment in the plane of the two, the more compressed one first.
      const double angle = 0.5 * std::atan2(2 * strain(i, j), strain(i, i) - strain(j, j));
      const Eigen::Vector3d a = f.axes.col(i), b = f.axes.col(j);
      f.axes.col(i) = std::cos(angle) * a + std::sin(angle) * b;
      f.axes.col(j) = std::cos(angle) * b - std::sin(angle) * a;
      turned = true;
      break;
    }
    if (turned)
      state.memory = components(Eigen::Matrix3d(f.axes.col(0) * f.axes.col(0).transpose() -
                                                f.axes.col(2) * f.axes.col(2).transpose()));
    if (rate.active != 0) return turned;
    // Elastic so far: if it stays so along these axes, the planes need no names any more.
    const Eigen::Vector3d stress = along(matrix_of(rate.stress), f.axes);
    for (int k = 0; k < 3; ++k) {
      const auto& [i, j] = kPairs[static_cast<std::size_t>(k)];
      if (yield_distance(state, k) < -kOnYield) continue;
      if ((1 - sine_) * stress(i) - (1 + sine_) * stress(j) > 1e-9 * rate.stress.norm())
        return turned;
    }
    state.memory.setZero();
    return true;
  } else {
    return false;
  }
}

template <class Space>
std::optional<double> MohrCoulomb<Space>::limit_stress_ratio() const {
  if (cohesion_ > 0) return std::nullopt;
  return 6 * sine_ / (3 - sine_);
}

template class MohrCoulomb<Axisymmetric>;
template class MohrCoulomb<Tensor>;

}  // namespace triax::sim

#include "sim/materials/drucker_prager.hpp"

#include <Eigen/Eigenvalues>
#include <cmath>

namespace triax::sim {
namespace {

/// 6 sin a/(3 − sin a), q/p′ of a plane's slope in triaxial compression.
double compression_slope(double angle) { return 6 * std::sin(angle) / (3 - std::sin(angle)); }

/// A state this far (as a ratio) outside the cone is no round-off.
constexpr double kFarOutside = 1e-6;

template <class Space>
double smallest_principal(const Vector<Space>& stress) {
  if constexpr (Space::kSize == 2)
    return stress.minCoeff();  // its sign is what counts, √2 does not change it
  else
    return Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(matrix_of(stress)).eigenvalues()(0);
}

}  // namespace

const ParameterTable<DruckerPragerParameters>& drucker_prager_table() {
  using P = DruckerPragerParameters;
  static const ParameterTable<P> table = [] {
    ParameterTable<P> rows = elastic_rows<P>();
    rows.push_back({{"friction_angle_deg",
                     "φ",
                     "deg",
                     "friction angle in triaxial compression",
                     {.at_least = 0, .below = 90}},
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
                     .meaning = "dilation angle in triaxial compression",
                     .range = {.above = -90, .below = 90},
                     .usual = 0},
                    &P::dilation_angle});
    return rows;
  }();
  return table;
}

LawDescription drucker_prager_law() {
  return describe<DruckerPrager>(
      "drucker_prager", "perfect plasticity on a cone, flow not associated",
      "Drucker and Prager (1952), Q. Appl. Math. 10:157", drucker_prager_table());
}

template <class Space>
DruckerPrager<Space>::DruckerPrager(const DruckerPragerParameters& p)
    : parameters_(p),
      friction_slope_(compression_slope(p.friction_angle)),
      dilation_slope_(compression_slope(p.dilation_angle)),
      cohesion_(6 * p.cohesion_pa * std::cos(p.friction_angle) / (3 - std::sin(p.friction_angle))) {
  check_parameters(p, drucker_prager_table());
  if (p.friction_angle == 0 && p.cohesion_pa == 0)
    throw std::invalid_argument(
        "friction_angle_deg and cohesion_kPa are both 0, one must be above 0");
}

template <class Space>
std::optional<std::string> DruckerPrager<Space>::objection(const State& state) const {
  if (auto general = Law<Space>::objection(state)) return general;
  if (!(strength(state.p()) > 0))
    return "the mean stress is at the apex of the cone or beyond, where the law ends";
  return std::nullopt;
}

template <class Space>
std::optional<std::string> DruckerPrager<Space>::warning(const State& state) const {
  if (yield_distance(state, 0) > kFarOutside) return "the stress lies outside the yield surface";
  if (parameters_.cohesion_pa == 0 && smallest_principal<Space>(state.stress) < 0)
    return "a principal stress is tensile, which the cone allows and soil does not";
  return std::nullopt;
}

template <class Space>
void DruckerPrager<Space>::response(const State& state, Response<Space>& out) const {
  StiffnessForm<Space>& form = stiffness_form(out);
  form.stiffness = elastic_stiffness<Space>(parameters_, state.p());
  Vector<Space> direction = deviator<Space>(state.stress);
  if (!(direction.norm() > 0)) direction = deviator<Space>(Vector<Space>::Unit(0));
  direction *= std::sqrt(1.5) / direction.norm();
  form.add_plastic(direction - dilation_slope_ / 3 * identity<Space>(),
                   direction - friction_slope_ / 3 * identity<Space>(), 0);
}

template <class Space>
double DruckerPrager<Space>::yield_distance(const State& state, int) const {
  return std::abs(deviator_stress<Space>(state.stress)) / strength(state.p()) - 1;
}

template <class Space>
void DruckerPrager<Space>::settle(State& state, unsigned on_yield) const {
  const double distance = yield_distance(state, 0);
  if (on_yield == 0 || distance > kFarOutside) return;
  state.stress -= distance / (1 + distance) * deviator<Space>(state.stress);
}

template <class Space>
std::optional<double> DruckerPrager<Space>::limit_stress_ratio() const {
  if (cohesion_ > 0) return std::nullopt;
  return friction_slope_;
}

template class DruckerPrager<Axisymmetric>;
template class DruckerPrager<Tensor>;

}  // namespace triax::sim

// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/materials/umat.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "sim/mechanics/units.hpp"

namespace triax::sim {
namespace {

struct UmatNumbers {
  double state_variables = 0, void_ratio_index = 0, strain_rate_per_s = 0, time_limit_s = 0,
         memory_limit_megabytes = 0;
};

const ParameterTable<UmatNumbers>& umat_table() {
  using P = UmatNumbers;
  static const ParameterTable<P> table = {
      {{"state_variables",
        "NSTATV",
        "",
        "number of state variables",
        {.at_least = 0, .at_most = kMostUmatState},
        ParameterKind::number,
        0},
       &P::state_variables},
      {{"void_ratio_index",
        "",
        "",
        "number of the state variable that starts as the void ratio; 0: none",
        {.at_least = 0, .at_most = kMostUmatState},
        ParameterKind::number,
        0},
       &P::void_ratio_index},
      {{"strain_rate_per_s",
        "",
        "",
        "strain per second, which makes DTIME of a strain increment",
        {.above = 0},
        ParameterKind::number,
        1e-5},
       &P::strain_rate_per_s},
      {{"time_limit_s",
        "",
        "",
        "time limit of one call, in seconds",
        {.above = 0, .at_most = 3600},
        ParameterKind::number,
        10},
       &P::time_limit_s},
      {{"memory_limit_megabytes",
        "",
        "",
        "maximum memory of the UMAT, in megabytes",
        {.at_least = 1, .at_most = 1e6},
        ParameterKind::number,
        1024},
       &P::memory_limit_megabytes}};
  return table;
}

std::vector<ParameterDescription> umat_parameters() {
  std::vector<ParameterDescription> all = {
      {"umat",
       "",
       "",
       "shared library, relative to this file, or a name that the loader finds",
       {},
       ParameterKind::text},
      {"name", "CMNAME", "", "name of the material; default empty", {}, ParameterKind::text},
      {"stress_unit", "", "", "unit of stress of the UMAT; default kPa", {}, ParameterKind::text},
      {"properties", "PROPS", "", "material constants of the UMAT", {}, ParameterKind::numbers},
      {"initial_state",
       "STATEV",
       "",
       "state variables at the start; default 0",
       {},
       ParameterKind::numbers}};
  for (auto& one : descriptions(umat_table())) all.push_back(std::move(one));
  return all;
}

int whole(const char* key, double value) {
  if (value != std::floor(value))
    throw std::invalid_argument(std::string(key) + " must be an integer");
  return static_cast<int>(value);
}

std::string text_of(const ParameterSet& set, const char* key, const char* usual) {
  const auto found = set.texts.find(key);
  return found == set.texts.end() ? usual : found->second;
}

std::vector<double> list_of(const ParameterSet& set, const char* key) {
  const auto found = set.lists.find(key);
  if (found == set.lists.end()) return {};
  for (const double value : found->second)
    if (!std::isfinite(value)) throw std::invalid_argument(std::string(key) + " must be finite");
  return found->second;
}

/// Beside the parameter file if it is there, else as the loader finds it.
std::string library_of(const ParameterSet& set) {
  const std::string name = text_of(set, "umat", "");
  if (name.empty())
    throw std::invalid_argument("umat is missing: the shared library, \"libNAME.so\"");
  std::error_code none;
  const auto beside = std::filesystem::absolute(std::filesystem::path(set.folder) / name, none);
  return !none && std::filesystem::is_regular_file(beside, none) ? beside.string() : name;
}

double stress_unit_of(const ParameterSet& set) {
  const std::string name = text_of(set, "stress_unit", "kPa");
  const auto unit = find_unit(name);
  if (!unit || unit->dimension != Dimension::pressure)
    throw std::invalid_argument("stress_unit is " + name +
                                ", must be a unit of stress: Pa, kPa, MPa");
  return unit->scale;
}

std::pair<UmatPlugin, UmatSettings> read_umat(const ParameterSet& set) {
  const UmatNumbers numbers = parameters_from(set, umat_table());
  UmatPlugin plugin{library_of(set),
                    text_of(set, "name", ""),
                    list_of(set, "properties"),
                    whole("state_variables", numbers.state_variables),
                    numbers.time_limit_s,
                    static_cast<std::size_t>(numbers.memory_limit_megabytes) << 20U};
  if (plugin.name.size() > 80)
    throw std::invalid_argument("name is longer than the 80 characters of CMNAME");
  UmatSettings settings{stress_unit_of(set), list_of(set, "initial_state"),
                        whole("void_ratio_index", numbers.void_ratio_index),
                        numbers.strain_rate_per_s};
  const auto n = static_cast<std::size_t>(plugin.state_variables);
  if (settings.initial_state.size() > n)
    throw std::invalid_argument("initial_state has " +
                                std::to_string(settings.initial_state.size()) +
                                " values, state_variables is " + std::to_string(n));
  if (settings.void_ratio_index > plugin.state_variables)
    throw std::invalid_argument("void_ratio_index is " + std::to_string(settings.void_ratio_index) +
                                ", state_variables is " + std::to_string(n));
  settings.initial_state.resize(n);
  return {std::move(plugin), std::move(settings)};
}

Material make_umat(const ParameterSet& set, const MaterialFinder&) {
  auto [plugin, settings] = read_umat(set);
  const auto worker = std::make_shared<UmatWorker>(std::move(plugin));
  return {std::make_shared<Umat<Axisymmetric>>(worker, settings),
          std::make_shared<Umat<Tensor>>(worker, settings),
          {}};
}

constexpr double kRootTwo = std::numbers::sqrt2;
/// Where STRAN, TIME and the number of increments stand behind STATEV.
constexpr int kStrain = 0, kTime = 6, kCount = 7, kPast = 8;
/// Asymmetry, as a share of the stress, that still counts as round-off of the plug-in.
constexpr double kAsymmetry = 1e-6;
/// A strain that is no strain, for plug-ins that divide by its length.
constexpr double kProbe = 1e-10;

Vector<Tensor> full(const Vector<Tensor>& a) { return a; }
Vector<Tensor> full(const Vector<Axisymmetric>& a) { return as_tensor(a); }

/// P with a = P a_axisymmetric, PᵗP = 1.
Eigen::Matrix<double, 6, 2> embedding() {
  Eigen::Matrix<double, 6, 2> p = Eigen::Matrix<double, 6, 2>::Zero();
  p(0, 0) = 1;
  p(1, 1) = p(2, 1) = 1 / kRootTwo;
  return p;
}

/// `factor` is −1/unit for stress with 1/√2 for shear, −1 for strain with √2 for shear.
void to_plugin(const Vector<Tensor>& a, double factor, double shear, std::array<double, 6>& out) {
  for (int i = 0; i < 6; ++i)
    out[static_cast<std::size_t>(i)] = factor * (i < 3 ? a(i) : shear * a(i));
}

Vector<Tensor> stress_from(const std::array<double, 6>& s, double unit) {
  Vector<Tensor> a;
  for (int i = 0; i < 6; ++i)
    a(i) = -unit * (i < 3 ? 1 : kRootTwo) * s[static_cast<std::size_t>(i)];
  return a;
}

Matrix<Tensor> tangent_from(const std::array<double, 36>& d, double unit) {
  Matrix<Tensor> c = unit * Eigen::Map<const Matrix<Tensor>>(d.data());
  c.bottomRows<3>() *= kRootTwo;
  c.rightCols<3>() *= kRootTwo;
  return c;
}

bool all_finite(const double* values, int count) {
  return std::all_of(values, values + count, [](double v) { return std::isfinite(v); });
}

/// Into the space; what does not fit there is `failure`.
void reduce(const Vector<Tensor>& stress, const Matrix<Tensor>& tangent, FiniteStep<Tensor>& step) {
  step.state.stress = stress;
  step.tangent = tangent;
}
void reduce(const Vector<Tensor>& stress, const Matrix<Tensor>& tangent,
            FiniteStep<Axisymmetric>& step) {
  const auto p = embedding();
  step.state.stress = p.transpose() * stress;
  step.tangent = p.transpose() * tangent * p;
  if ((stress - p * step.state.stress).norm() > kAsymmetry * stress.norm())
    step.failure =
        "the stresses of the UMAT are not axisymmetric about axis 1; use a path with full tensors";
}

}  // namespace

LawDescription umat_law() {
  return {
      "umat",   "an Abaqus UMAT in a shared library", "the library's author", {}, umat_parameters(),
      make_umat};
}

void check_umat(const ParameterSet& set) { read_umat(set); }

template <class Space>
Umat<Space>::Umat(std::shared_ptr<UmatWorker> worker, UmatSettings settings)
    : worker_(std::move(worker)), settings_(std::move(settings)) {}

template <class Space>
PointState<Space> Umat<Space>::start(const Vector<Space>& stress, double void_ratio) const {
  const int n = worker_->plugin().state_variables;
  State state{stress, void_ratio, Memory::Zero(n + kPast)};
  std::copy(settings_.initial_state.begin(), settings_.initial_state.end(), state.memory.data());
  if (settings_.void_ratio_index > 0) state.memory(settings_.void_ratio_index - 1) = void_ratio;
  return state;
}

template <class Space>
std::vector<std::string> Umat<Space>::memory_names() const {
  std::vector<std::string> names;
  for (int i = 1; i <= worker_->plugin().state_variables; ++i)
    names.push_back("state_variable_" + std::to_string(i));
  for (const char* part : {"11", "22", "33", "12", "13", "23"})
    names.push_back(std::string("plugin_strain_") + part);
  names.insert(names.end(), {"plugin_time_s", "plugin_increments"});
  return names;
}

template <class Space>
std::optional<std::string> Umat<Space>::objection(const State& state) const {
  if (state.memory.size() != worker_->plugin().state_variables + kPast)
    return "the memory is not that of this UMAT";
  return Law<Space>::objection(state);
}

template <class Space>
std::string Umat<Space>::check(const UmatCall& call) const {
  const char* wrong = nullptr;
  if (!all_finite(call.stress.data(), 6))
    wrong = "STRESS";
  else if (!all_finite(call.tangent.data(), 36))
    wrong = "DDSDDE";
  else if (!all_finite(call.state.data(), worker_->plugin().state_variables))
    wrong = "STATEV";
  else if (!std::isfinite(call.smaller))
    wrong = "PNEWDT";
  if (wrong == nullptr) return {};
  return worker_->plugin().library + ": the UMAT returned a " + wrong + " that is not finite";
}

template <class Space>
FiniteStep<Space> Umat<Space>::integrate(const State& from, const Vector<Space>& strain) const {
  FiniteStep<Space> step;
  step.state = from;
  const int n = worker_->plugin().state_variables;
  if (from.memory.size() != n + kPast || !strain.allFinite()) {
    step.failure = "the UMAT is called with a state or a strain that is not finite";
    return step;
  }
  UmatCall call;
  to_plugin(full(from.stress), -1 / settings_.stress_unit_pa, 1 / kRootTwo, call.stress);
  to_plugin(full(strain), -1, kRootTwo, call.strain_increment);
  const double* past = from.memory.data() + n;
  std::copy(past + kStrain, past + kStrain + 6, call.strain.begin());
  std::copy(from.memory.data(), from.memory.data() + n, call.state.begin());
  call.time = past[kTime];
  call.time_step =
      std::max(full(strain).cwiseAbs().maxCoeff(), kProbe) / settings_.strain_rate_per_s;
  call.increment = static_cast<int>(std::min(past[kCount], 2e9)) + 1;

  step.failure = worker_->call(call);
  if (!step.failure.empty()) return step;
  step.failure = check(call);
  if (step.failure.empty() && call.smaller < 1)
    step.failure =
        worker_->plugin().library +
        ": the UMAT requests a smaller increment (PNEWDT = " + std::to_string(call.smaller) + ")";
  if (!step.failure.empty()) {
    step.smaller = true;
    return step;
  }
  reduce(stress_from(call.stress, settings_.stress_unit_pa),
         tangent_from(call.tangent, settings_.stress_unit_pa), step);
  std::copy(call.state.begin(), call.state.begin() + n, step.state.memory.data());
  double* told = step.state.memory.data() + n;
  for (std::size_t i = 0; i < 6; ++i) told[kStrain + i] += call.strain_increment[i];
  told[kTime] += call.time_step;
  told[kCount] += 1;
  step.state.void_ratio = (1 + from.void_ratio) * std::exp(-trace<Space>(strain)) - 1;
  return step;
}

template <class Space>
void Umat<Space>::response(const State& state, Response<Space>& out) const {
  FiniteStep<Space> step = integrate(state, Vector<Space>::Zero());
  if (!step.failure.empty() && step.smaller) step = integrate(state, kProbe * identity<Space>());
  if (!step.failure.empty()) throw std::runtime_error(step.failure);
  stiffness_form(out).stiffness = step.tangent;
}

template class Umat<Axisymmetric>;
template class Umat<Tensor>;

}  // namespace triax::sim

// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/materials/moduli_table.hpp"

#include <algorithm>
#include <cmath>

namespace triax::sim {
namespace {

constexpr const char* kNames[] = {"E1", "E3", "V13", "V31", "V33"};

const std::vector<double>& list(const ParameterSet& set, const std::string& key, std::size_t size) {
  const auto found = set.lists.find(key);
  if (found == set.lists.end()) throw std::invalid_argument(key + " is missing");
  if (size != 0 && found->second.size() != size)
    throw std::invalid_argument(key + " has " + std::to_string(found->second.size()) +
                                " numbers, stress_ratios " + std::to_string(size));
  return found->second;
}

std::vector<double> moduli_pa(const ParameterSet& set, const std::string& key, std::size_t size) {
  std::vector<double> values = list(set, key, size);
  for (double& value : values) {
    if (!(value > 0)) throw std::invalid_argument(key + " has a modulus that is not above 0");
    value *= 1e3;
  }
  return values;
}

double number(const ParameterSet& set, const std::string& key, double usual) {
  const auto found = set.numbers.find(key);
  return found == set.numbers.end() ? usual : found->second;
}

}  // namespace

std::vector<ParameterDescription> moduli_table_parameters() {
  std::vector<ParameterDescription> all = {
      {"reference_pressure_kPa",
       "p_ref",
       "kPa",
       "p' of the table",
       {.above = 0},
       ParameterKind::number,
       100},
      {"pressure_exponent",
       "n",
       "",
       "E grows as (p'/p_ref)^n",
       {.at_least = 0},
       ParameterKind::number,
       0},
      {"stress_ratios", "η", "", "of the table's rows, rising", {}, ParameterKind::numbers, {}}};
  for (const char* name : kNames)
    for (const char* side : {"plus", "minus"}) {
      const bool modulus = name[0] == 'E';
      all.push_back({std::string(name) + "_" + side + (modulus ? "_kPa" : ""),
                     std::string(name) + (side[0] == 'p' ? "+" : "-"),
                     modulus ? "kPa" : "",
                     "at each stress ratio",
                     {},
                     ParameterKind::numbers,
                     {}});
    }
  return all;
}

ModuliTable::ModuliTable(const ParameterSet& set)
    : reference_pa_(1e3 * number(set, "reference_pressure_kPa", 100)),
      exponent_(number(set, "pressure_exponent", 0)),
      eta_(list(set, "stress_ratios", 0)) {
  if (!(reference_pa_ > 0) || !(exponent_ >= 0))
    throw std::invalid_argument(
        "reference_pressure_kPa must be above 0, pressure_exponent 0 or more");
  if (eta_.size() < 2 || !std::ranges::is_sorted(eta_, std::ranges::less_equal()))
    throw std::invalid_argument("stress_ratios must be two or more rising numbers");
  const auto side = [&](const std::string& sign) {
    const std::size_t n = eta_.size();
    return Side{moduli_pa(set, "E1_" + sign + "_kPa", n), moduli_pa(set, "E3_" + sign + "_kPa", n),
                list(set, "V13_" + sign, n), list(set, "V31_" + sign, n),
                list(set, "V33_" + sign, n)};
  };
  plus_ = side("plus");
  minus_ = side("minus");
}

std::optional<std::string> ModuliTable::objection(const State& state) const {
  const double eta = state.q() / state.p();
  if (eta >= eta_.front() && eta <= eta_.back()) return std::nullopt;
  return "the stress ratio has left the table of moduli";
}

Matrix<Axisymmetric> ModuliTable::compliance(const Side& side, double eta, double factor) const {
  const auto above = std::ranges::upper_bound(eta_, eta);
  const auto i = static_cast<std::size_t>(
      std::clamp<std::ptrdiff_t>(above - eta_.begin(), 1, std::ssize(eta_) - 1));
  const double x = (eta - eta_[i - 1]) / (eta_[i] - eta_[i - 1]);
  const auto at = [&](const std::vector<double>& v) { return (1 - x) * v[i - 1] + x * v[i]; };
  const double e1 = factor * at(side.e1_pa), e3 = factor * at(side.e3_pa);
  // (dσ₁, √2 dσ₃) to (dε₁, √2 dε₃), Eq. (37)
  constexpr double root = std::numbers::sqrt2;
  Matrix<Axisymmetric> q;
  q << 1 / e1, -root * at(side.v31) / e3, -root * at(side.v13) / e1, (1 - at(side.v33)) / e3;
  return q;
}

void ModuliTable::moduli(const State& state, Matrix<Axisymmetric>& plus,
                         Matrix<Axisymmetric>& minus) const {
  const double eta = state.q() / state.p();
  const double factor = std::pow(state.p() / reference_pa_, exponent_);
  plus = compliance(plus_, eta, factor);
  minus = compliance(minus_, eta, factor);
}

}  // namespace triax::sim

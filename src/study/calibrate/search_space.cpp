// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/study/calibrate/search_space.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "lab/base/bad_input.hpp"
#include "lab/base/text.hpp"
#include "sim/materials/umat.hpp"

namespace triax::study {
namespace {

constexpr const char* kPoreFluid = "pore_fluid_bulk_modulus_kPa";
constexpr double kWater_kPa = 1e6;

/// "properties.3" is number 3 of the list "properties".
std::optional<std::pair<std::string, std::size_t>> list_entry(const std::string& key) {
  const auto dot = key.rfind('.');
  if (dot == std::string::npos) return std::nullopt;
  const auto index = lab::whole_text_as<std::size_t>(key.substr(dot + 1));
  if (!index || *index < 1) return std::nullopt;
  return std::pair(key.substr(0, dot), *index - 1);
}

void put(sim::ParameterSet& set, const std::string& key, double value) {
  if (const auto entry = list_entry(key))
    set.lists.at(entry->first).at(entry->second) = value;
  else
    set.numbers[key] = value;
}

bool has_pore_fluid(const sim::LawDescription& law) {
  return std::ranges::find(law.parameters, kPoreFluid, &sim::ParameterDescription::key) !=
         law.parameters.end();
}

sim::MaterialFinder shipped() {
  return [](const std::string& name) { return lab::find_material(name).material; };
}

}  // namespace

std::optional<double> value_of(const lab::MaterialSet& set, const std::string& key) {
  if (const auto entry = list_entry(key)) {
    const auto list = set.parameters.lists.find(entry->first);
    if (list == set.parameters.lists.end() || entry->second >= list->second.size())
      return std::nullopt;
    return list->second[entry->second];
  }
  if (const auto number = set.parameters.numbers.find(key); number != set.parameters.numbers.end())
    return number->second;
  for (const auto& parameter : set.law->parameters)
    if (parameter.key == key && parameter.kind == sim::ParameterKind::number)
      return parameter.usual;
  return std::nullopt;
}

sim::ParameterSet for_drainage(sim::ParameterSet parameters, const sim::LawDescription& law,
                               Imposed imposed) {
  if (!has_pore_fluid(law)) return parameters;
  double& modulus = parameters.numbers[kPoreFluid];
  if (imposed != Imposed::undrained)
    modulus = 0;
  else if (modulus == 0)
    modulus = kWater_kPa;
  return parameters;
}

SearchSpace::SearchSpace(lab::MaterialSet start, std::vector<lab::SearchRange> ranges)
    : start_(std::move(start)),
      ranges_(std::move(ranges)),
      drainage_matters_(has_pore_fluid(*start_.law)) {
  for (const auto& range : ranges_)
    if (!value_of(start_, range.key))
      throw lab::BadInput(fmt::format("{} has no number {}", start_.name, lab::excerpt(range.key)));
  anchor_.resize(size());
  for (Eigen::Index i = 0; i < size(); ++i) {
    const auto& range = ranges_[static_cast<std::size_t>(i)];
    anchor_(i) = std::clamp(unknown(i, *value_of(start_, range.key)), 0.0, 1.0);
  }
  if (!possible(anchor_)) {
    // The start may lie outside the ranges, and its nearest point within them beyond the law.
    anchor_.setConstant(0.5);
    if (!possible(anchor_))
      throw lab::BadInput(
          fmt::format("neither {} within the search ranges nor their middle is valid for the law; "
                      "give other ranges",
                      start_.name));
  }
}

double SearchSpace::value(Eigen::Index unknown, double x) const {
  const auto& r = ranges_[static_cast<std::size_t>(unknown)];
  return r.in_logarithm ? r.low * std::pow(r.high / r.low, x) : r.low + (r.high - r.low) * x;
}

double SearchSpace::unknown(Eigen::Index unknown, double value) const {
  const auto& r = ranges_[static_cast<std::size_t>(unknown)];
  if (r.in_logarithm && !(value > 0)) return 0;
  return r.in_logarithm ? std::log(value / r.low) / std::log(r.high / r.low)
                        : (value - r.low) / (r.high - r.low);
}

double SearchSpace::slope(Eigen::Index unknown, double x) const {
  const auto& r = ranges_[static_cast<std::size_t>(unknown)];
  return r.in_logarithm ? value(unknown, x) * std::log(r.high / r.low) : r.high - r.low;
}

Unknowns SearchSpace::start_point() const { return anchor_; }

sim::ParameterSet SearchSpace::parameters(const Unknowns& x) const {
  sim::ParameterSet set = start_.parameters;
  for (Eigen::Index i = 0; i < size(); ++i)
    put(set, ranges_[static_cast<std::size_t>(i)].key, value(i, x(i)));
  return set;
}

std::optional<sim::Material> SearchSpace::material(const Unknowns& x, Imposed imposed) const {
  try {
    return start_.law->make(for_drainage(parameters(x), *start_.law, imposed), shipped());
  } catch (const std::invalid_argument&) {
    return std::nullopt;
  }
}

bool SearchSpace::possible(const Unknowns& x) const {
  if (start_.law->name != "umat") return material(x, Imposed::drained).has_value();
  try {  // the library has been loaded with the start: no process of it for each question
    sim::check_umat(parameters(x));
    return true;
  } catch (const std::invalid_argument&) {
    return false;
  }
}

Unknowns SearchSpace::possible_near(const Unknowns& x) const {
  Unknowns inside = x.cwiseMax(0.0).cwiseMin(1.0);
  if (possible(inside)) return inside;
  double no = 0, yes = 1;  // share of the way to the anchor
  for (int i = 0; i < 30; ++i) {
    const double middle = (no + yes) / 2;
    (possible(inside + middle * (anchor_ - inside)) ? yes : no) = middle;
  }
  return inside + yes * (anchor_ - inside);
}

}  // namespace triax::study

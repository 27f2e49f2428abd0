// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// What a law says of its parameters: the one source of the reader of parameter files, of the checks
// and of `triax materials`.
#include <functional>
#include <limits>
#include <map>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "sim/law/law.hpp"

namespace triax::sim {

/// Range of a number. "above" and "below" exclude their value.
struct Range {
  double at_least = -std::numeric_limits<double>::infinity();
  double above = -std::numeric_limits<double>::infinity();
  double at_most = std::numeric_limits<double>::infinity();
  double below = std::numeric_limits<double>::infinity();
  bool holds(double value) const {
    return value >= at_least && value > above && value <= at_most && value < below;
  }
  std::string words() const;  ///< "above 0 and at most 1"
};

enum class ParameterKind { number, text, numbers };

struct ParameterDescription {
  std::string key;      ///< in files; ends in its unit if it has one: "young_modulus_kPa"
  std::string symbol;   ///< as in the literature: "E", "φ_c"
  std::string unit;     ///< "", "kPa", "deg"
  std::string meaning;  ///< half a sentence
  Range range;          ///< in that unit
  ParameterKind kind = ParameterKind::number;
  std::optional<double> usual;  ///< taken where a file says nothing; empty: must be given
  bool chooses = false;         ///< another value makes the other parameters of a set meaningless
};

/// The values of one set, in the units of the file.
struct ParameterSet {
  std::map<std::string, double, std::less<>> numbers;
  std::map<std::string, std::string, std::less<>> texts;
  std::map<std::string, std::vector<double>, std::less<>> lists;
  std::string folder;  ///< of the file they come from: what a file name among them is relative to
};

/// A law with its parameters in both spaces. A law that has no form in a space leaves that empty
/// and says why.
struct Material {
  std::shared_ptr<const Law<Axisymmetric>> axisymmetric;
  std::shared_ptr<const Law<Tensor>> tensor;
  std::string no_tensor;  ///< why there is no tensor form; empty where there is one
  std::string based_on;   ///< of a law built on others: on what
  template <class Space>
  const Law<Space>* law() const {
    if constexpr (Space::kSize == 2)
      return axisymmetric.get();
    else
      return tensor.get();
  }
};

/// Finds another material by name, for laws that are built on one.
using MaterialFinder = std::function<Material(const std::string& name)>;

/// A law as the program knows it.
struct LawDescription {
  std::string name;     ///< "sanisand"
  std::string title;    ///< one line
  std::string source;   ///< of the equations
  std::string refuses;  ///< programmes that it cannot follow and why; empty: none
  std::vector<ParameterDescription> parameters;
  /// Throws std::invalid_argument (parameter, value found, what would be right).
  std::function<Material(const ParameterSet&, const MaterialFinder&)> make;
};

/// One row of a law's table: what the parameter is called and where its value goes, in SI.
template <class Parameters>
struct ParameterRow {
  ParameterDescription description;
  double Parameters::*member = nullptr;
};
template <class Parameters>
using ParameterTable = std::vector<ParameterRow<Parameters>>;

/// A number as messages write it, six digits at most.
std::string short_number(double value);

/// SI per unit of a parameter; throws std::logic_error for a unit that nobody knows.
double unit_scale(std::string_view unit);

/// Throws std::invalid_argument: "poisson_ratio is 0.5, must be below 0.5".
void check_parameter(const ParameterDescription& description, double value_in_its_unit);

template <class Parameters>
void check_parameters(const Parameters& p, const ParameterTable<Parameters>& table) {
  for (const auto& row : table)
    check_parameter(row.description, p.*row.member / unit_scale(row.description.unit));
}

/// The set as the law's own struct.
template <class Parameters>
Parameters parameters_from(const ParameterSet& set, const ParameterTable<Parameters>& table) {
  Parameters p;
  for (const auto& row : table) {
    const ParameterDescription& d = row.description;
    const auto found = set.numbers.find(d.key);
    if (found == set.numbers.end() && !d.usual) throw std::invalid_argument(d.key + " is missing");
    const double value = found == set.numbers.end() ? *d.usual : found->second;
    check_parameter(d, value);
    p.*row.member = value * unit_scale(d.unit);
  }
  return p;
}

template <class Parameters>
std::vector<ParameterDescription> descriptions(const ParameterTable<Parameters>& table) {
  std::vector<ParameterDescription> all;
  for (const auto& row : table) all.push_back(row.description);
  return all;
}

/// Description of a law whose parameters are numbers only: `SomeLaw<Space>(Parameters)`.
template <template <class> class SomeLaw, class Parameters>
LawDescription describe(std::string name, std::string title, std::string source,
                        const ParameterTable<Parameters>& table) {
  return {std::move(name),
          std::move(title),
          std::move(source),
          {},
          descriptions(table),
          [table](const ParameterSet& set, const MaterialFinder&) {
            const Parameters p = parameters_from(set, table);
            return Material{std::make_shared<SomeLaw<Axisymmetric>>(p),
                            std::make_shared<SomeLaw<Tensor>>(p),
                            {},
                            {}};
          }};
}

}  // namespace triax::sim

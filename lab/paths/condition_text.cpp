// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/paths/condition_text.hpp"

#include <fmt/format.h>

#include <array>
#include <charconv>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "lab/base/text.hpp"

namespace triax::lab {
namespace {

using sim::Axisymmetric;
using sim::Tensor;
using std::numbers::sqrt2;

constexpr double kLargestStrain = 2;
constexpr double kLargestStress = 100e6;     // Pa
constexpr double kLargestCoefficient = 1e9;  // beyond it and below its inverse nothing is meant

/// An increment that is linear in the axial and the radial component, per unit of its name.
struct TriaxialName {
  std::string_view name;
  bool strain;
  double axial, radial;
};
constexpr auto kTriaxial = std::to_array<TriaxialName>({
    {"axial_strain", true, 1, 0},
    {"radial_strain", true, 0, 1},
    {"volumetric_strain", true, 1, 2},
    {"shear_strain", true, 2.0 / 3, -2.0 / 3},
    {"sqrt2_radial_strain", true, 0, sqrt2},
    {"p_kPa", false, 1.0 / 3, 2.0 / 3},
    {"q_kPa", false, 1, -1},
    {"axial_stress_kPa", false, 1, 0},
    {"radial_stress_kPa", false, 0, 1},
    {"sqrt2_radial_stress_kPa", false, 0, sqrt2},
});
constexpr auto kComponents = std::to_array<std::string_view>({"11", "22", "33", "12", "13", "23"});

[[noreturn]] void fail(std::size_t column, const std::string& message) {
  throw std::invalid_argument(fmt::format("column {}: {}", column + 1, message));
}

template <class Space>
Eigen::Matrix<double, 1, Space::kSize> spread(double axial, double radial) {
  Eigen::Matrix<double, 1, Space::kSize> row;
  if constexpr (Space::kSize == 2)
    row << axial, radial / sqrt2;
  else
    row << axial, radial / 2, radial / 2, 0, 0, 0;
  return row;
}

/// Adds `factor` times the named increment; false where the name is not known.
template <class Space>
bool add(std::string_view name, double factor, Combination<Space>& to) {
  const bool percent = name.ends_with("_pct");
  const std::string_view bare = percent ? name.substr(0, name.size() - 4) : name;
  const double strain_factor = percent ? 100 * factor : factor;
  for (const TriaxialName& row : kTriaxial) {
    if (row.name != bare || (percent && !row.strain)) continue;
    if (row.strain)
      to.strain += strain_factor * spread<Space>(row.axial, row.radial);
    else
      to.stress += 1e-3 * factor * spread<Space>(row.axial, row.radial);
    return true;
  }
  if constexpr (Space::kSize == 6)
    for (std::size_t i = 0; i < kComponents.size(); ++i) {
      const auto at = static_cast<Eigen::Index>(i);
      const double unit = i < 3 ? 1 : 1 / sqrt2;
      if (bare == fmt::format("strain_{}", kComponents[i])) {
        to.strain(at) += strain_factor * unit;
        return true;
      }
      if (name == fmt::format("stress_{}_kPa", kComponents[i])) {
        to.stress(at) += 1e-3 * factor * unit;
        return true;
      }
    }
  return false;
}

bool is_blank(char c) { return c == ' ' || c == '\t'; }
bool in_name(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_';
}

class Scanner {
 public:
  explicit Scanner(std::string_view text) : text_(text) {}
  std::size_t column() const { return at_; }
  bool at_end() {
    while (at_ < text_.size() && is_blank(text_[at_])) ++at_;
    return at_ == text_.size();
  }
  bool take(char c) {
    if (at_end() || text_[at_] != c) return false;
    ++at_;
    return true;
  }
  bool number(double& value) {
    if (at_end() || !(text_[at_] == '.' || (text_[at_] >= '0' && text_[at_] <= '9'))) return false;
    const char* const begin = text_.data() + at_;
    const auto [stopped, error] = std::from_chars(begin, text_.data() + text_.size(), value);
    if (error == std::errc::result_out_of_range) fail(at_, "a number out of range");
    if (error != std::errc()) return false;
    at_ += static_cast<std::size_t>(stopped - begin);
    return true;
  }
  std::string_view name() {
    at_end();
    const std::size_t begin = at_;
    while (at_ < text_.size() && in_name(text_[at_])) ++at_;
    return text_.substr(begin, at_ - begin);
  }
  /// What stands here, for a message.
  std::string found() { return at_end() ? "the end" : excerpt(text_.substr(at_)); }

 private:
  std::string_view text_;
  std::size_t at_ = 0;
};

template <class Space>
void read_term(Scanner& scanner, double sign, Combination<Space>& to) {
  double factor = 1;
  const std::size_t begin = scanner.column();
  if (scanner.number(factor)) {
    if (!(factor < kLargestCoefficient && factor > 1 / kLargestCoefficient))
      fail(begin, fmt::format("the coefficient {:g} must be {:g} to {:g}", factor,
                              1 / kLargestCoefficient, kLargestCoefficient));
    scanner.take('*');
  }
  scanner.at_end();
  const std::size_t column = scanner.column();
  const std::string_view name = scanner.name();
  if (name.empty())
    fail(column, fmt::format("expected the name of an increment, found {}; {}", scanner.found(),
                             must_be_one_of(increment_names<Space>())));
  if (!add(name, sign * factor, to))
    fail(column, fmt::format("unknown increment {}; {}", excerpt(name),
                             suggestion(name, increment_names<Space>())));
}

template <class Space>
Combination<Space> read_left(Scanner& scanner) {
  Combination<Space> left;
  double sign = scanner.take('-') ? -1 : 1;
  if (sign > 0) scanner.take('+');
  for (bool more = true; more;) {
    read_term(scanner, sign, left);
    more = scanner.take('+');
    sign = 1;
    if (!more && scanner.take('-')) {
      more = true;
      sign = -1;
    }
  }
  if (left.stress.cwiseAbs().maxCoeff() < 1e-15 && left.strain.cwiseAbs().maxCoeff() < 1e-12)
    fail(0, "the terms cancel: the condition is empty");
  return left;
}

std::string tidied(std::string_view text) {
  std::string tidy;
  for (const char c : trimmed(text)) {
    if (is_blank(c) && is_blank(tidy.back())) continue;
    tidy += is_blank(c) ? ' ' : c;
  }
  return tidy;
}

}  // namespace

template <class Space>
std::vector<std::string> increment_names() {
  std::vector<std::string> names;
  const auto add_strain = [&](const std::string& name) {
    names.push_back(name);
    names.push_back(name + "_pct");
  };
  for (const TriaxialName& row : kTriaxial)
    if (row.strain)
      add_strain(std::string(row.name));
    else
      names.emplace_back(row.name);
  if constexpr (Space::kSize == 6)
    for (const auto component : kComponents) {
      add_strain(fmt::format("strain_{}", component));
      names.push_back(fmt::format("stress_{}_kPa", component));
    }
  return names;
}

template <class Space>
Combination<Space> read_combination(std::string_view text) {
  Scanner scanner(text);
  auto left = read_left<Space>(scanner);
  if (!scanner.at_end()) fail(scanner.column(), fmt::format("unexpected {}", scanner.found()));
  return left;
}

template <class Space>
Condition<Space> read_condition(std::string_view text) {
  Scanner scanner(text);
  Condition<Space> condition{.left = read_left<Space>(scanner)};
  if (scanner.at_end() || !scanner.take('='))
    fail(scanner.column(),
         fmt::format("expected '= TOTAL' after the increments, found {}", scanner.found()));
  condition.label = tidied(text.substr(0, scanner.column() - 1));
  const double sign = scanner.take('-') ? -1 : 1;
  if (sign > 0) scanner.take('+');
  if (!scanner.number(condition.total))
    fail(scanner.column(),
         fmt::format("expected the total increment as a number, found {}", scanner.found()));
  condition.total *= sign;
  if (!scanner.at_end())
    fail(scanner.column(),
         fmt::format("unexpected {}; the unit is part of the name", scanner.found()));
  check_total(condition.left, condition.total);
  return condition;
}

template <class Space>
void check_total(const Combination<Space>& left, double total) {
  const double most =
      kLargestStress * left.stress.cwiseAbs().sum() + kLargestStrain * left.strain.cwiseAbs().sum();
  if (!(std::abs(total) <= most))
    throw std::invalid_argument(
        fmt::format("the total {:g} is out of range (a strain of {:g}, a stress of "
                    "{:g} kPa)",
                    total, kLargestStrain, kLargestStress / 1e3));
}

template std::vector<std::string> increment_names<Axisymmetric>();
template std::vector<std::string> increment_names<Tensor>();
template Combination<Axisymmetric> read_combination(std::string_view);
template Combination<Tensor> read_combination(std::string_view);
template Condition<Axisymmetric> read_condition(std::string_view);
template Condition<Tensor> read_condition(std::string_view);
template void check_total(const Combination<Axisymmetric>&, double);
template void check_total(const Combination<Tensor>&, double);

}  // namespace triax::lab

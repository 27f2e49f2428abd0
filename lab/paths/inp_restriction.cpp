// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/paths/inp_restriction.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>

#include "lab/base/text.hpp"
#include "lab/paths/inp_frame.hpp"

namespace triax::lab {
namespace {

/// sign [number *] name, cut off the front of `rest`.
struct Term {
  double factor = 1;
  std::string name;
};

std::string without_blanks(std::string_view text) {
  std::string out;
  for (const char c : text)
    if (std::isspace(static_cast<unsigned char>(c)) == 0) out += c;
  return out;
}

/// Where the next term begins: a sign that is not the first character nor that of an exponent.
std::size_t term_end(std::string_view text) {
  for (std::size_t i = 1; i < text.size(); ++i) {
    if (text[i] != '+' && text[i] != '-') continue;
    const bool exponent =
        i >= 2 && std::string_view("eEdD").find(text[i - 1]) < 4 &&
        (std::isdigit(static_cast<unsigned char>(text[i - 2])) != 0 || text[i - 2] == '.');
    if (!exponent) return i;
  }
  return text.size();
}

Term take_term(std::string_view& rest, const InpLines& lines) {
  const std::size_t end = term_end(rest);
  std::string_view text = rest.substr(0, end);
  rest.remove_prefix(end);
  Term term;
  if (!text.empty() && (text[0] == '+' || text[0] == '-')) {
    if (text[0] == '-') term.factor = -1;
    text.remove_prefix(1);
  }
  const std::size_t star = text.find('*');
  if (star != std::string_view::npos) {
    const auto factor = fortran_number(text.substr(0, star));
    if (!factor)
      lines.fail(fmt::format("{} is not a factor of a term", excerpt(text.substr(0, star))));
    term.factor *= *factor;
    text.remove_prefix(star + 1);
  }
  term.name = std::string(text);
  return term;
}

struct EndName {
  std::string_view name;
  sim::PathQuantity quantity;
  int component;
  double scale;  ///< of our quantity per one of theirs
};

}  // namespace

void read_inp_restriction(std::string_view line, int row, const InpLines& lines,
                          sim::MixedControl<sim::Tensor>& conditions) {
  const std::string text = without_blanks(line.substr(0, line.find_first_of("!#")));
  const std::size_t equals = text.find('=');
  if (equals == std::string::npos)
    lines.fail(
        fmt::format("{} is not a restriction; expected one like sd1 + 2*sd2 = -10", excerpt(line)));
  std::string_view rest(text.data(), equals);
  if (rest.empty()) lines.fail("the restriction is empty to the left of =");
  while (!rest.empty()) {
    const Term term = take_term(rest, lines);
    const std::string name = folded(term.name);
    const bool known = name.size() == 3 && (name[0] == 's' || name[0] == 'e') && name[1] == 'd' &&
                       name[2] >= '1' && name[2] <= '6';
    if (!known)
      lines.fail(fmt::format("unknown increment {}; must be one of: sd1 to sd6, ed1 to ed6",
                             excerpt(term.name)));
    const int component = name[2] - '1';
    if (name[0] == 's')
      conditions.stress.row(row) += term.factor * inp_stress_row(component);
    else
      conditions.strain.row(row) += term.factor * inp_strain_row(component);
  }
  const auto total = fortran_number(std::string_view(text).substr(equals + 1));
  if (!total)
    lines.fail(fmt::format("{} on the right of the = is not a number",
                           excerpt(std::string_view(text).substr(equals + 1))));
  conditions.increment(row) = *total;
}

sim::PathEnd read_inp_end(std::string_view condition, const InpLines& lines,
                          std::vector<std::string>& warnings) {
  using enum sim::PathQuantity;
  const double root_three = std::sqrt(3.0), root_1_5 = std::sqrt(1.5);
  static constexpr double kTension = -1e3;
  const EndName known[] = {{"s1", effective_stress_component, 0, kTension},
                           {"s2", effective_stress_component, 1, kTension},
                           {"s3", effective_stress_component, 2, kTension},
                           {"p", mean_effective_stress, 0, 1e3},
                           {"q", deviator_stress, 0, 1e3},
                           {"P", mean_effective_stress, 0, 1e3 / root_three},
                           {"Q", deviator_stress, 0, 1e3},
                           {"e1", strain_component, 0, -1},
                           {"e2", strain_component, 1, -1},
                           {"e3", strain_component, 2, -1},
                           {"ev", volumetric_strain, 0, 1},
                           {"eq", shear_strain, 0, 1},
                           {"eP", volumetric_strain, 0, root_three},
                           {"eQ", shear_strain, 0, 1 / root_1_5}};
  const std::string text = without_blanks(condition);
  const std::size_t sign = text.find_first_of("<>");
  if (sign == std::string::npos)
    lines.fail(
        fmt::format("{} is not a condition; expected one like ? s1 < -200", excerpt(condition)));
  std::string_view left(text.data(), sign);
  const auto bound = fortran_number(std::string_view(text).substr(sign + 1));
  if (!bound)
    lines.fail(fmt::format("{} is not a number to compare with",
                           excerpt(std::string_view(text).substr(sign + 1))));
  const Term term = take_term(left, lines);
  if (!left.empty()) lines.fail("an end condition on a sum is not supported; give one quantity");
  const auto* found = std::ranges::find(known, term.name, &EndName::name);
  if (found == std::end(known)) {
    std::vector<std::string> names;
    for (const auto& one : known) names.emplace_back(one.name);
    lines.fail(fmt::format("an end condition on {} is not supported; {}", excerpt(term.name),
                           must_be_one_of(names)));
  }
  if (term.factor == 0) lines.fail("the factor of an end condition must not be 0");
  const double limit = *bound / term.factor * found->scale;
  const bool above = (text[sign] == '>') == (found->scale / term.factor > 0);
  if (found->quantity == deviator_stress) {
    if (limit < 0)
      lines.fail("an end condition on a negative q is not supported: q is used without sign");
    warnings.push_back(
        fmt::format("{}:{}: in the end condition q is used without sign, √(3/2)|s|; "
                    "incrementalDriver uses σ3 − σ1",
                    lines.name(), lines.line_number()));
  }
  sim::PathEnd end;
  end.quantity = found->quantity;
  end.component = found->component;
  (above ? end.above : end.below) = limit;
  end.label = std::string(trimmed(condition));
  return end;
}

}  // namespace triax::lab

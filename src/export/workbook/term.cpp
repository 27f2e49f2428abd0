// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/export/workbook/term.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "lab/workbook/sheet_cells.hpp"

namespace triax::src {
namespace {

/// Behind * or /, where a product would be taken apart.
std::string closed(const Term& term) { return term.product ? '(' + term.text + ')' : term.text; }

bool is_told(const Term& a, const Term& b) { return !a.text.empty() && !b.text.empty(); }

}  // namespace

Term constant(double value) {
  std::string text = fmt::format("{}", value);
  std::ranges::transform(text, text.begin(), [](char c) { return c == 'e' ? 'E' : c; });
  return {value, std::move(text), false};
}

Term cell(const std::string& address, double value) { return {value, address, false}; }

Term sum(const Term& a, const Term& b) {
  return {a.value + b.value, is_told(a, b) ? "SUM(" + a.text + ',' + b.text + ')' : "", false};
}

Term difference(const Term& a, const Term& b) {
  return {a.value - b.value, is_told(a, b) ? "SUM(" + a.text + ",-" + b.text + ')' : "", false};
}

Term times(const Term& a, const Term& b) {
  return {a.value * b.value, is_told(a, b) ? a.text + '*' + closed(b) : "", true};
}

Term over(const Term& a, const Term& b) {
  return {a.value / b.value, is_told(a, b) ? a.text + '/' + closed(b) : "", true};
}

Term negative(const Term& a) { return {-a.value, a.text.empty() ? "" : '-' + a.text, true}; }

Term function(const char* name, const Term& a, double (*of)(double)) {
  return {of(a.value), a.text.empty() ? "" : std::string(name) + '(' + a.text + ')', false};
}

Term mean(const Term& a, const Term& b) {
  return {0.5 * (a.value + b.value), is_told(a, b) ? "AVERAGE(" + a.text + ',' + b.text + ')' : "",
          false};
}

Term first_known(std::initializer_list<Term> terms) {
  for (const Term& term : terms)
    if (term.known()) return term;
  return {};
}

std::string address(std::size_t column, std::size_t row) {
  return lab::column_name(column) + std::to_string(row);
}

}  // namespace triax::src

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// A number and the formula that gives it, operation by operation the same: what a spreadsheet makes
// of the text is `value` to the last bit, as far as its own operations are those of IEEE 754.
#include <cmath>
#include <initializer_list>
#include <string>

#include "lab/results/reading.hpp"

namespace triax::src {

struct Term {
  double value = lab::kMissing;
  std::string text;      ///< without "="; empty where nothing says how the value follows
  bool product = false;  ///< its last operation is * or /

  bool known() const { return !std::isnan(value); }
};

Term constant(double value);
/// What stands in a cell: "readings!C12".
Term cell(const std::string& address, double value);

/// a + b as SUM(a,b), and a − b as SUM(a,-b): some spreadsheets make small differences nought or
/// round them where they are written with a minus sign.
Term sum(const Term& a, const Term& b);
Term difference(const Term& a, const Term& b);
Term times(const Term& a, const Term& b);
Term over(const Term& a, const Term& b);
Term negative(const Term& a);
/// A function of one number: name("SQRT") and what it is in C++.
Term function(const char* name, const Term& a, double (*of)(double));
/// (a + b)/2
Term mean(const Term& a, const Term& b);
/// The first that is known, or what is not.
Term first_known(std::initializer_list<Term> terms);

/// "C12" of column 2 and row 12, which counts from 1.
std::string address(std::size_t column, std::size_t row);

}  // namespace triax::src

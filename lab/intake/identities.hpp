// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Facts that hold for the readings of a triaxial test, whatever its columns are called: relations
// between stresses, strains and dimensions, and the course of single quantities. They decide
// between the quantities that a heading can mean.
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace triax::lab {

/// A column read as one quantity, in its canonical unit (lexicon.hpp), compression positive.
struct Series {
  std::vector<double> values;  ///< NaN where the cell has no value
  double half_unit = 0;        ///< half a unit of the last printed digit
};

/// Values above the table that bound the relations.
struct SpecimenValues {
  std::optional<double> height_mm;
  std::optional<double> diameter_mm;
};

struct Identity;
/// How much the readings speak for an identity, as a difference of log-likelihoods: 3 ln(0.1 s / r)
/// with the deviation r (root mean square, at least the rounding of the printed digits) and the
/// variation s of the terms, between a lower and an upper bound of the identity. 0 if nothing
/// varies beyond rounding, or with fewer than three complete rows.
using EvidenceFunction = double(const Identity&, std::span<const Series* const> series,
                                const SpecimenValues& specimen);

/// A relation with the quantities that it needs.
struct Identity {
  std::string text;                     ///< "q = σ1 − σ3"
  std::vector<std::string> quantities;  ///< names of the lexicon
  std::vector<std::string> unless;  ///< not evaluated if one of these is known: a stronger one is
  EvidenceFunction* evidence = nullptr;

  // Parameters of the relation, for `evidence`.
  std::vector<double> coefficients{};  ///< of a sum of the quantities that is 0 or constant
  bool is_constant = false;            ///< the sum is any constant
  double lowest = -4, highest = 8;     ///< bounds of the evidence
  double from = 0, to = 0;             ///< range of the factor of a proportion, canonical units
  double factor = 1;                   ///< of the function; -1 if it has the opposite sign
};

/// All of them.
const std::vector<Identity>& identities();

}  // namespace triax::lab

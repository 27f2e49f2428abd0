// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The quantities that a heading can mean: names in 13 languages, symbols and codes. The names are
// in lab/intake/lexicon/QUANTITY.toml, the rules of the search in normalise.toml of that folder.
#include <string>
#include <string_view>
#include <vector>

#include "lab/intake/names/lexicon_quantity.hpp"

namespace triax::lab {

/// How a heading names a quantity, the strongest evidence first.
enum class NameMatch {
  exact,      ///< the whole heading
  kept_word,  ///< by a word such as "target" or "rate": no reading of the quantity beside it
  dropped,    ///< without a part that may be missing: a channel, "(corrected)", "_Avg"
  tail,       ///< the end, behind another name or a group of columns: "Stress path s'"
  symbol,     ///< a Greek or effective symbol at the end: "Tensione σ3'"
  head,       ///< the beginning, in front of a symbol: "Vertikalverschiebung s"
  words,      ///< a phrase inside the heading; a longer phrase comes first
  borrowed,   ///< a name of another quantity that laboratories use for this one
};

struct NameCandidate {
  const LexiconQuantity* quantity = nullptr;  ///< never null, valid to the end of the program
  NameMatch how = NameMatch::exact;
  NameMatch lender = NameMatch::exact;  ///< how a borrowed name is that of the other quantity
};

struct HeadingNames {
  std::string name;                       ///< the heading without its unit
  std::string unit;                       ///< as written in the heading, empty if none
  std::vector<NameCandidate> candidates;  ///< the best first, each quantity once
};

/// Quantities that a heading (UTF-8) can mean. `unit_of_row` is the cell below it in a row of
/// units; a text that is no unit counts as none. With a unit, of the row or of the heading, only
/// quantities that can have it are candidates. There are none for an unknown heading and for one of
/// more than 200 characters. Thread-safe; the first call reads the lexicon. Each thread remembers
/// what it found last.
HeadingNames find_names(std::string_view heading, std::string_view unit_of_row = {});

}  // namespace triax::lab

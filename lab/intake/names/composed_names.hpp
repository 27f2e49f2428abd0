// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <QHash>
#include <QString>
#include <bitset>
#include <cstdint>
#include <optional>
#include <vector>

namespace triax::lab {

/// Quantities by their position in lexicon_quantities().
using QuantitySet = std::bitset<64>;

/// Names that are made of words with known meanings, in any order: "Effektive Vertikalspannung" and
/// "Vertical eff. stress" are effective, axial, stress. The words are in
/// lab/intake/lexicon/words.toml, the meanings of a quantity in `composed` of its file.
class ComposedNames {
 public:
  /// Throws BadInput if a quantity has a meaning that is in no word.
  ComposedNames();

  /// Quantities that a heading of these tokens (heading_tokens()) names. None if a token is
  /// unknown.
  QuantitySet find(const std::vector<QString>& tokens) const;
  /// True if a heading of these tokens has a word that no reading of a quantity has: a set point, a
  /// rate, an error, a value at failure.
  bool is_no_reading(const std::vector<QString>& tokens) const;
  /// Quantities that a heading of these tokens cannot name, whatever phrases it contains: a known
  /// word qualifies it ("half", "ratio", "excess") that is in none of their composed names, or a
  /// strict one ("increment") that is in none of those whose words are all in the heading.
  QuantitySet find_contradicted(const std::vector<QString>& tokens) const;

 private:
  using Meanings = std::uint64_t;  ///< one bit each

  void add_word(const QString& word, Meanings meanings);
  void add_names(const QString& composed, std::size_t quantity, const QHash<QString, int>& bits);
  std::optional<Meanings> meanings_of(const QString& token) const;
  /// Of all listed words inside a token in Chinese, Japanese or Korean characters.
  Meanings meanings_inside(const QString& token) const;
  /// Meanings of a compound word: "porenwasserdruck".
  std::optional<Meanings> meanings_of_parts(QStringView text, std::vector<bool>& failed,
                                            std::size_t begin) const;

  QHash<QString, Meanings> words_;
  QHash<QString, std::optional<Meanings>> short_forms_;  ///< empty: of words that differ
  QHash<Meanings, QuantitySet> names_;
  std::vector<Meanings> of_quantity_;  ///< in any of its composed names
  Meanings qualifiers_ = 0, strict_ = 0, unread_ = 0;
  std::vector<QString> endings_;
  qsizetype max_word_ = 0, min_part_ = 0, min_short_ = 0;
};

}  // namespace triax::lab

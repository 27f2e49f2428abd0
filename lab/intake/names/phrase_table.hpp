// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <QHash>
#include <QString>
#include <vector>

namespace triax::lab {

/// Phrases, each with a number, that are found inside a longer text. A phrase is a sequence of
/// tokens; one in Chinese, Japanese or Korean characters may also begin and end inside a token.
class PhraseTable {
 public:
  /// Does nothing if the phrase is known. Pre-condition: `tokens` is not empty.
  void add(const std::vector<QString>& tokens, int number);

  struct Match {
    int number = 0;
    qsizetype length = 0;  ///< characters of the longest phrase
  };
  /// Numbers of the phrases that a text contains, the longest phrase first, each number once.
  std::vector<Match> find(const std::vector<QString>& tokens) const;

 private:
  QHash<QString, int> phrases_;  ///< by tokens with spaces between them
  std::size_t max_tokens_ = 0;
  struct EastAsianPhrase {
    QString text;
    int number = 0;
  };
  QHash<QChar, std::vector<EastAsianPhrase>> east_asian_;  ///< by their first character
};

}  // namespace triax::lab

// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/intake/names/phrase_table.hpp"

#include <algorithm>
#include <functional>

#include "lab/intake/names/heading_form.hpp"

namespace triax::lab {
namespace {

QString joined_tokens(const std::vector<QString>& tokens) {
  QString text;
  for (const QString& token : tokens) text += token;
  return text;
}

}  // namespace

void PhraseTable::add(const std::vector<QString>& tokens, int number) {
  if (std::ranges::any_of(tokens.front(), is_east_asian)) {
    east_asian_[tokens.front().front()].push_back({joined_tokens(tokens), number});
    return;
  }
  QString phrase = tokens.front();
  for (std::size_t i = 1; i < tokens.size(); ++i) phrase += u' ' + tokens[i];
  if (!phrases_.contains(phrase)) phrases_[phrase] = number;
  max_tokens_ = std::max(max_tokens_, tokens.size());
}

std::vector<PhraseTable::Match> PhraseTable::find(const std::vector<QString>& tokens) const {
  std::vector<Match> matches;
  const auto add_match = [&](int number, qsizetype length) {
    const auto same = std::ranges::find(matches, number, &Match::number);
    if (same == matches.end())
      matches.push_back({number, length});
    else
      same->length = std::max(same->length, length);
  };
  for (std::size_t first = 0; first < tokens.size(); ++first) {
    QString phrase;
    const std::size_t end = std::min(tokens.size(), first + max_tokens_);
    for (std::size_t last = first; last < end; ++last) {
      phrase += last == first ? tokens[last] : u' ' + tokens[last];
      if (const auto known = phrases_.find(phrase); known != phrases_.end())
        add_match(*known, phrase.size() - static_cast<qsizetype>(last - first));
    }
  }
  const QString text = joined_tokens(tokens);
  for (qsizetype i = 0; i < text.size(); ++i) {
    const auto phrases = east_asian_.find(text[i]);
    if (phrases == east_asian_.end()) continue;
    for (const auto& [phrase, number] : *phrases)
      if (QStringView(text).sliced(i).startsWith(phrase)) add_match(number, phrase.size());
  }
  std::ranges::sort(matches, {}, &Match::number);
  std::ranges::stable_sort(matches, std::ranges::greater{}, &Match::length);
  return matches;
}

}  // namespace triax::lab

// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/intake/names/composed_names.hpp"

#include <QStringList>
#include <algorithm>

#include "lab/base/bad_input.hpp"
#include "lab/intake/names/heading_form.hpp"
#include "lab/intake/names/lexicon_file.hpp"

namespace triax::lab {
ComposedNames::ComposedNames() {
  constexpr int kMaxLength = 100, kMaxMeanings = 64;
  const TomlTable file = read_lexicon_file("words");
  min_part_ = file.integer("min_part", 1, kMaxLength).value();
  min_short_ = file.integer("min_short", 1, kMaxLength).value();
  endings_.emplace_back();
  for (const std::string& ending : file.texts("endings"))
    endings_.push_back(QString::fromStdString(ending));
  QHash<QString, int> bits;
  for (const TomlTable& row : file.tables("word")) {
    Meanings meanings = 0;
    for (const QString& meaning :
         QString::fromStdString(row.text("means").value_or("")).split(u' ', Qt::SkipEmptyParts)) {
      if (!bits.contains(meaning)) bits[meaning] = static_cast<int>(bits.size());
      meanings |= Meanings{1} << bits[meaning];
    }
    for (const std::string& word : row.texts("written")) {
      for (const QString& key : name_keys(word)) add_word(key, meanings);
      add_word(fold_heading(repair_heading(word)), meanings);  // as a part of a longer word
    }
  }
  if (bits.size() > kMaxMeanings) throw BadInput("words.toml", 0, "too many meanings");
  const auto all_of = [&](const std::vector<std::string>& listed) {
    Meanings all = 0;
    for (const std::string& meaning : listed) {
      const auto bit = bits.find(QString::fromStdString(meaning));
      if (bit == bits.end()) throw BadInput("words.toml", 0, "no word means " + meaning);
      all |= Meanings{1} << *bit;
    }
    return all;
  };
  qualifiers_ = all_of(file.texts("qualifiers"));
  strict_ = all_of(file.texts("strict"));
  unread_ = all_of({"unread"});
  const auto& quantities = lexicon_quantity_files();
  of_quantity_.resize(quantities.size());
  for (std::size_t i = 0; i < quantities.size(); ++i)
    for (const std::string& composed : quantities[i].texts("composed"))
      add_names(QString::fromStdString(composed), i, bits);
}

void ComposedNames::add_word(const QString& word, Meanings meanings) {
  words_[word] = meanings;
  max_word_ = std::max(max_word_, word.size());
  for (qsizetype length = min_short_; length < word.size(); ++length) {
    const QString short_form = word.first(length);
    const auto known = short_forms_.find(short_form);
    if (known == short_forms_.end())
      short_forms_[short_form] = meanings;
    else if (*known != meanings)
      *known = std::nullopt;
  }
}

/// "axial/radial total? stress" is four names: one of the words with a slash, those with a question
/// mark may be missing.
void ComposedNames::add_names(const QString& composed, std::size_t quantity,
                              const QHash<QString, int>& bits) {
  std::vector<Meanings> names{0};
  for (QString part : composed.split(u' ')) {
    std::vector<Meanings> longer;
    if (part.endsWith(u'?')) {
      longer = names;
      part.chop(1);
    }
    for (const QString& meaning : part.split(u'/')) {
      if (!bits.contains(meaning))
        throw BadInput("words.toml", 0, "no word means " + meaning.toStdString());
      for (const Meanings name : names) longer.push_back(name | Meanings{1} << bits[meaning]);
    }
    names = std::move(longer);
  }
  for (const Meanings name : names) {
    names_[name].set(quantity);
    of_quantity_[quantity] |= name;
  }
}

std::optional<ComposedNames::Meanings> ComposedNames::meanings_of_parts(QStringView text,
                                                                        std::vector<bool>& failed,
                                                                        std::size_t begin) const {
  if (text.isEmpty()) return Meanings{0};
  if (failed[begin]) return std::nullopt;
  constexpr qsizetype kMinShortEnd = 5;  // "cellpress"
  if (begin > 0 && text.size() >= kMinShortEnd && !words_.contains(text.toString()))
    if (const auto short_end = short_forms_.value(text.toString())) return short_end;
  for (qsizetype length = std::min(max_word_, text.size()); length > 0; --length) {
    const bool is_part = length >= min_part_ || is_east_asian(text.front());
    if (!is_part) break;
    const auto word = words_.find(text.first(length).toString());
    if (word == words_.end()) continue;
    for (const QString& ending : endings_) {
      if (!text.sliced(length).startsWith(ending)) continue;
      const qsizetype end = length + ending.size();
      if (const auto rest =
              meanings_of_parts(text.sliced(end), failed, begin + static_cast<std::size_t>(end)))
        return *word | *rest;
    }
  }
  failed[begin] = true;
  return std::nullopt;
}

std::optional<ComposedNames::Meanings> ComposedNames::meanings_of(const QString& token) const {
  constexpr qsizetype kMaxToken = 100;
  if (token.size() > kMaxToken) return std::nullopt;
  if (const auto word = words_.find(token); word != words_.end()) return *word;
  std::vector<bool> failed(static_cast<std::size_t>(token.size()));
  if (const auto parts = meanings_of_parts(token, failed, 0)) return parts;
  return short_forms_.value(token);
}

ComposedNames::Meanings ComposedNames::meanings_inside(const QString& token) const {
  Meanings meanings = 0;
  for (qsizetype at = 0; at < token.size();) {
    qsizetype length = is_east_asian(token[at]) ? std::min(max_word_, token.size() - at) : 0;
    while (length > 0 && !words_.contains(token.sliced(at, length))) --length;
    if (length > 0) meanings |= words_[token.sliced(at, length)];
    at += std::max<qsizetype>(length, 1);
  }
  return meanings;
}

bool ComposedNames::is_no_reading(const std::vector<QString>& tokens) const {
  return std::ranges::any_of(tokens, [&](const QString& token) {
    return (meanings_of(token).value_or(meanings_inside(token)) & unread_) != 0;
  });
}

QuantitySet ComposedNames::find_contradicted(const std::vector<QString>& tokens) const {
  Meanings meanings = 0;
  for (const QString& token : tokens) {
    const bool is_ordinal = std::ranges::all_of(token, [](QChar c) { return c.isDigit(); });
    if (is_ordinal) continue;  // "LVDT 1" is not the largest one
    const auto of_token = meanings_of(token);
    meanings |= of_token ? *of_token : meanings_inside(token);
  }
  QuantitySet allowed;  // by a composed name inside the heading with all its strict meanings
  for (auto name = names_.begin(); name != names_.end(); ++name)
    if ((meanings & strict_ & ~name.key()) == 0 && (name.key() & ~meanings) == 0)
      allowed |= name.value();
  QuantitySet found;
  for (std::size_t i = 0; i < of_quantity_.size(); ++i) {
    const bool is_other = (meanings & strict_) != 0 && !allowed[i];
    found[i] =
        of_quantity_[i] != 0 && (is_other || (meanings & qualifiers_ & ~of_quantity_[i]) != 0);
  }
  return found;
}

QuantitySet ComposedNames::find(const std::vector<QString>& tokens) const {
  Meanings meanings = 0;
  for (const QString& token : tokens) {
    const bool is_inside = &token != &tokens.front() && &token != &tokens.back();
    if (is_inside && token == u"in") continue;  // at the end it is the unit
    if (const auto of_token = words_.constFind(token); of_token != words_.constEnd()) {  // "1/2"
      meanings |= *of_token;
      continue;
    }
    for (const QString& part : token.split(u'/')) {  // "deviator/mean stress" is one token
      const auto of_part = meanings_of(part);
      if (!of_part) return {};
      meanings |= *of_part;
    }
  }
  return names_.value(meanings);
}

}  // namespace triax::lab

// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/intake/names/heading_form.hpp"

#include <QHash>
#include <QSet>
#include <algorithm>
#include <bitset>
#include <utility>

#include "lab/intake/names/lexicon_file.hpp"

namespace triax::lab {
namespace {

QString utf16(const std::string& utf8) { return QString::fromStdString(utf8); }

struct HeadingRules {
  std::vector<std::pair<QString, QString>> repair;
  QHash<char32_t, QString> characters, accents;
  QHash<QString, QString> umlauts, short_forms;
  std::bitset<0x80> replaced_ascii;  ///< characters below 0x80 that are in `characters`
  QString repair_starts;             ///< first characters of what is repaired
  QString kept_signs;
  QSet<QString> kept_plurals;
};

void read_characters(const TomlTable& file, const char* key, QHash<char32_t, QString>& to) {
  for (const TomlTable& row : file.tables(key))
    for (const char32_t character : utf16(row.text("from").value()).toUcs4())
      to[character] = utf16(row.text("to").value());
}

QHash<QString, QString> read_pairs(const TomlTable& table) {
  QHash<QString, QString> pairs;
  for (const std::string& key : table.keys()) pairs[utf16(key)] = utf16(table.text(key).value());
  return pairs;
}

HeadingRules read_heading_rules() {
  const TomlTable file = read_lexicon_file("normalise");
  HeadingRules rules;
  const TomlTable repair = file.required_table("repair");
  for (const std::string& wrong : repair.keys())
    rules.repair.emplace_back(utf16(wrong), utf16(repair.text(wrong).value()));
  for (const auto& [wrong, right] : rules.repair) rules.repair_starts += wrong.front();
  read_characters(file, "characters", rules.characters);
  constexpr char32_t kFirstFullWidth = 0xFF01, kLastFullWidth = 0xFF5E, kFullWidthOffset = 65248;
  for (char32_t wide = kFirstFullWidth; wide <= kLastFullWidth; ++wide)
    if (!rules.characters.contains(wide))
      rules.characters[wide] = QChar(static_cast<char16_t>(wide - kFullWidthOffset));
  for (const char32_t c : rules.characters.keys())
    if (c < rules.replaced_ascii.size()) rules.replaced_ascii.set(c);
  read_characters(file, "accents", rules.accents);
  rules.umlauts = read_pairs(file.required_table("umlauts"));
  rules.short_forms = read_pairs(file.required_table("short_forms"));
  rules.kept_signs = utf16(file.required_table("tokens").required_text("kept_signs"));
  for (const std::string& word : file.required_table("plural").texts("kept"))
    rules.kept_plurals.insert(utf16(word));
  return rules;
}

const HeadingRules& heading_rules() {
  static const HeadingRules rules = read_heading_rules();
  return rules;
}

bool is_ascii(const QString& text) {
  return std::ranges::all_of(text, [](QChar c) { return c.unicode() < 0x80; });
}

bool is_combining(QChar c) {
  const bool is_accent = c.unicode() >= 0x300 && c.unicode() <= 0x36F;
  const bool is_part_of_hangul = c.unicode() >= 0x1100 && c.unicode() <= 0x11FF;
  return is_accent || is_part_of_hangul;
}

/// "CellPress" is "Cell Press".
QString with_split_words(const QString& text) {
  QString split;
  split.reserve(text.size() + text.size() / 4);
  for (const QChar c : text) {
    if (!split.isEmpty() && split.back().isLower() && c.isUpper()) split += u' ';
    split += c;
  }
  return split;
}

enum class CharacterKind { separator, word, east_asian, sign };

CharacterKind kind_of(QChar c) {
  if (is_east_asian(c)) return CharacterKind::east_asian;
  if (c.isLetterOrNumber()) return CharacterKind::word;
  return heading_rules().kept_signs.contains(c) ? CharacterKind::sign : CharacterKind::separator;
}

bool is_small_latin(QChar c) { return c >= u'a' && c <= u'z'; }

/// The usual form of a word, in the singular.
QString usual_form(QString word) {
  constexpr qsizetype kMinPluralLength = 4;
  const HeadingRules& rules = heading_rules();
  if (const auto known = rules.short_forms.find(word); known != rules.short_forms.end())
    word = *known;
  if (word.size() >= kMinPluralLength && word.back() == u's' && word[word.size() - 2] != u's' &&
      std::ranges::all_of(word, is_small_latin) && !rules.kept_plurals.contains(word))
    word.chop(1);
  return word;
}

/// A sign belongs to the token in front of it, and what follows a slash, plus or root to that.
bool joins(const QString& before, const QString& token) {
  const QChar first = token.front();
  const QChar last = before.back();
  return token == u"'" || token == u"%" || first == u'/' || first == u'+' || last == u'/' ||
         last == u'+' || last == u'√';
}

QString repaired_text(QString heading) {
  const HeadingRules& rules = heading_rules();
  const auto is_plain = [&](QChar c) {
    return c.unicode() < rules.replaced_ascii.size() && !rules.replaced_ascii[c.unicode()];
  };
  if (std::ranges::all_of(heading, is_plain)) return heading;
  const auto may_be_broken = [&](QChar c) { return rules.repair_starts.contains(c); };
  if (std::ranges::any_of(heading, may_be_broken))
    for (const auto& [wrong, right] : rules.repair) heading.replace(wrong, right);
  QString repaired;
  repaired.reserve(heading.size());
  for (const char32_t c : heading.toUcs4()) {
    const auto known = rules.characters.find(c);
    if (known != rules.characters.end())
      repaired += *known;
    else
      repaired += QStringView(QChar::fromUcs4(c));
  }
  return std::ranges::any_of(repaired, is_combining)
             ? repaired.normalized(QString::NormalizationForm_C)
             : repaired;
}

}  // namespace

QString repair_heading(std::string_view utf8) {
  return repaired_text(QString::fromUtf8(utf8.data(), static_cast<qsizetype>(utf8.size())));
}

QString fold_heading(const QString& repaired) {
  QString lower = repaired.toLower();
  if (is_ascii(lower)) return lower;
  const auto& accents = heading_rules().accents;
  QString folded;
  folded.reserve(lower.size());
  for (const QChar c : lower) {
    const auto plain = accents.find(c.unicode());
    if (plain != accents.end())
      folded += *plain;
    else
      folded += c;
  }
  return folded;
}

std::vector<QString> heading_tokens(const QString& repaired) {
  const QString text = fold_heading(with_split_words(repaired));
  std::vector<QString> tokens;
  for (qsizetype start = 0; start < text.size();) {
    const CharacterKind kind = kind_of(text[start]);
    qsizetype end = start + 1;
    while (kind != CharacterKind::sign && end < text.size() && kind_of(text[end]) == kind) ++end;
    if (kind != CharacterKind::separator) {
      QString token = usual_form(text.sliced(start, end - start));
      if (!tokens.empty() && joins(tokens.back(), token))
        tokens.back() += token;
      else
        tokens.push_back(std::move(token));
    }
    start = end;
  }
  return tokens;
}

QString heading_key(const QString& repaired) {
  QString key;
  for (const QString& token : heading_tokens(repaired)) key += token;
  return key;
}

std::vector<QString> name_keys(std::string_view name) {
  const QString written = QString::fromUtf8(name.data(), static_cast<qsizetype>(name.size()));
  std::vector<QString> keys{heading_key(repaired_text(written))};
  if (is_ascii(written)) return keys;
  const QString lower = written.toLower();
  QString spelled_out;
  for (const QChar c : lower)
    spelled_out += c.unicode() < 0x80 ? c : heading_rules().umlauts.value(QString(c), QString(c));
  if (spelled_out != lower) {
    QString other = heading_key(repaired_text(spelled_out));
    if (other != keys.front()) keys.push_back(std::move(other));
  }
  return keys;
}

bool is_east_asian(QChar character) {
  const char16_t code = character.unicode();
  return (code >= 0x3005 && code <= 0x30FF) || (code >= 0x3400 && code <= 0x9FFF) ||
         (code >= 0xAC00 && code <= 0xD7AF);
}

bool is_heading_blank(QChar character) { return character == u' ' || character == u'_'; }

QString without_outer(const QString& text, QStringView characters) {
  qsizetype start = 0;
  qsizetype end = text.size();
  while (start < end && characters.contains(text[start])) ++start;
  while (end > start && characters.contains(text[end - 1])) --end;
  return text.sliced(start, end - start);
}

}  // namespace triax::lab

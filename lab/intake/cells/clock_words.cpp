// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/intake/cells/clock_words.hpp"

#include <algorithm>
#include <cstdint>
#include <functional>
#include <map>
#include <string>
#include <unordered_map>
#include <vector>

#include <QString>

#include "lab/base/embedded.hpp"
#include "lab/base/text.hpp"
#include "lab/base/toml_reader.hpp"

namespace triax::lab {
namespace {

constexpr std::size_t kMaxWordSize = 40;  ///< bytes

struct ClockWordHash {
  using is_transparent = void;
  std::size_t operator()(std::string_view text) const {
    return std::hash<std::string_view>{}(text);
  }
};

/// The spellings of each word, so that a look-up needs no conversion.
class ClockWordTable {
 public:
  ClockWordTable() {
    const auto document =
        TomlTable::parse(kClockWords.front().text, std::string(kClockWords.front().name));
    add_months(document.required_table("months"));
    add_lists(document.required_table("half_days"),
              {{"first", ClockWordKind::first_half}, {"second", ClockWordKind::second_half}});
    add_lists(document.required_table("marks"), {{"year", ClockWordKind::year_mark},
                                                 {"month", ClockWordKind::month_mark},
                                                 {"day", ClockWordKind::day_mark},
                                                 {"hour", ClockWordKind::hour_mark},
                                                 {"minute", ClockWordKind::minute_mark},
                                                 {"second", ClockWordKind::second_mark}});
    add_lists(document.required_table("other"),
              {{"between", ClockWordKind::other}, {"weekdays", ClockWordKind::other}});
    add_values(document.required_table("zones"), ClockWordKind::zone);
    add_values(document.required_table("eras"), ClockWordKind::era);
  }

  std::optional<ClockWord> find(std::string_view word) const {
    const auto found = words_.find(word);
    if (found == words_.end()) return std::nullopt;
    ClockWord out = found->second;
    out.length = word.size();
    return out;
  }
  std::optional<int> era_letter(char letter) const {
    const auto found = era_letters_.find(letter);
    return found == era_letters_.end() ? std::nullopt : std::optional(found->second);
  }

 private:
  void add(const QString& word, ClockWord meaning) {
    QString plain = word.normalized(QString::NormalizationForm_D);
    plain.removeIf([](QChar c) { return c.category() == QChar::Mark_NonSpacing; });
    for (const QString& form : {word, plain.normalized(QString::NormalizationForm_C)})
      for (const QString& spelling :
           {form, form.toUpper(), QString(form.left(1).toUpper() + form.mid(1))})
        words_.try_emplace(spelling.toStdString(), meaning);
  }

  void add_months(const TomlTable& table) {
    constexpr int kShortest = 3;  // letters
    std::map<QString, int> months;
    for (const auto& language : table.keys()) {
      int month = 0;
      for (const auto& text : table.texts(language)) {
        const auto name = QString::fromStdString(text);
        ++month;
        for (auto size = std::min<qsizetype>(kShortest, name.size()); size <= name.size(); ++size) {
          int& known = months.try_emplace(name.left(size), month).first->second;
          if (known != month) known = 0;
        }
      }
    }
    for (const auto& [name, month] : months)
      if (month > 0) add(name, {ClockWordKind::month, month});
  }

  void add_lists(const TomlTable& table, const std::map<std::string, ClockWordKind>& kinds) {
    for (const auto& [key, kind] : kinds)
      for (const auto& word : table.texts(key)) add(QString::fromStdString(word), {kind});
  }

  void add_values(const TomlTable& table, ClockWordKind kind) {
    for (const auto& word : table.keys()) {
      const int value = static_cast<int>(table.integer(word).value_or(0));
      if (kind == ClockWordKind::era && word.size() == 1) {
        era_letters_[word.front()] = value;
        era_letters_[static_cast<char>(word.front() - 'a' + 'A')] = value;
      } else {
        add(QString::fromStdString(word), {kind, value});
      }
    }
  }

  std::unordered_map<std::string, ClockWord, ClockWordHash, std::equal_to<>> words_;
  std::map<char, int> era_letters_;
};

const ClockWordTable& clock_word_table() {
  static const ClockWordTable table;
  return table;
}

bool is_ascii(char c) { return static_cast<unsigned char>(c) < 0x80; }

}  // namespace

std::optional<ClockWord> find_clock_word(std::string_view run) {
  if (run.size() <= kMaxWordSize)
    if (const auto whole = clock_word_table().find(run)) return whole;
  if (is_ascii(run.front())) return std::nullopt;
  for (auto size = std::min(run.size(), kMaxWordSize); size > 0; --size) {
    const bool is_inside =
        size < run.size() && (static_cast<unsigned char>(run[size]) & 0xC0) == 0x80;
    if (is_inside) continue;
    if (const auto part = clock_word_table().find(run.substr(0, size))) return part;
  }
  return std::nullopt;
}

std::optional<int> find_era_letter(char letter) { return clock_word_table().era_letter(letter); }

}  // namespace triax::lab

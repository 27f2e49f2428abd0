// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// What the head of a sheet says: by the preamble of the record, and by who asks for the sheet.
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "db/store.hpp"
#include "lab/results/labels.hpp"
#include "src/study/sheet/root_time.hpp"

namespace triax::study {

using SheetWord = lab::LabelKey;
/// All of them: the labels of a test in the order of the head, then what only a test report needs.
std::span<const SheetWord> sheet_word_list();

/// --set KEY=VALUE, or TEST/KEY=VALUE of one test.
struct SaidWord {
  std::string test, key, value;
};
/// Throws lab::BadInput for a key that is none.
SaidWord said_word(const std::string& key, const std::string& value);

/// By key; what nobody says is not there.
using SheetWords = std::map<std::string, std::string, std::less<>>;
SheetWords sheet_words(const db::StoredTest& test, const std::vector<SaidWord>& said);

/// The text of a key; empty where nobody says it.
std::string word_of(const SheetWords& words, std::string_view key);
/// The same as a number, with a comma or a point.
std::optional<double> number_of(const SheetWords& words, std::string_view key);
/// Whether it begins with y or j, or is 1 or true.
bool says_yes(const SheetWords& words, std::string_view key);
/// What "drained_at" says, or the drains that a preamble names.
std::optional<DrainageBoundary> drained_at(const SheetWords& words);

}  // namespace triax::study

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The conversation about one table: its open questions, and corrections of its columns.
#include <cstddef>
#include <functional>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <utility>

#include "src/study/intake/import_choices.hpp"
#include "src/study/intake/import_question.hpp"

namespace triax::src {

/// The user at a terminal.
struct Conversation {
  std::function<std::optional<std::string>()> read_line;  ///< nothing: the input ended
  std::function<void(std::string_view)> show;
};

/// The user quits, or the input ends.
struct QuitImport {};

class QuestionDialog {
 public:
  explicit QuestionDialog(const Conversation& user) : user_(user) {}

  /// The table that is asked about. Pre-condition of all below but say(), report() and line().
  void set_table(lab::Proposal proposal, study::ImportChoices choices) {
    proposal_ = std::move(proposal);
    choices_ = std::move(choices);
  }
  const lab::Proposal& proposal() const { return proposal_; }
  study::ImportChoices& choices() { return choices_; }
  const study::ImportChoices& choices() const { return choices_; }
  /// True once a question was asked.
  bool has_asked() const { return has_asked_; }

  void say(std::string_view text) const { user_.show(text); }
  /// Sentences, in lines.
  void report(const std::string& text) const;
  /// Returns the text that the user types behind `prompt`. Throws QuitImport.
  std::string line(const std::string& prompt) const;

  /// Each once: an answer that leaves its question open is not asked for again. Throws QuitImport.
  void ask_open_questions();
  /// "c N": asks for quantity, unit and sign of a column. False for any other text. Throws
  /// QuitImport.
  bool correct_column(const std::string& text);

 private:
  bool ask(const study::ImportQuestion& question);

  const Conversation& user_;
  lab::Proposal proposal_;
  study::ImportChoices choices_;
  std::set<std::pair<std::size_t, std::string>> asked_;
  bool has_asked_ = false;
};

}  // namespace triax::src

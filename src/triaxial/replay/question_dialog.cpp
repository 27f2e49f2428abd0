// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/triaxial/replay/question_dialog.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "lab/base/text.hpp"
#include "src/output/table.hpp"
#include "src/output/terminal.hpp"
#include "src/output/wrapping.hpp"
#include "src/study/intake/column_questions.hpp"
#include "src/study/intake/import_answers.hpp"
#include "src/study/intake/import_questions.hpp"

namespace triax::src {
namespace {

using study::ImportAnswer;
using study::ImportQuestion;

/// The number N of "c N".
std::optional<std::size_t> column_to_correct(std::string_view text) {
  if (!text.starts_with("c ")) return std::nullopt;
  const auto number = lab::whole_text_as<std::int64_t>(lab::trimmed(text.substr(2)));
  if (!number || *number < 1) return std::nullopt;
  return static_cast<std::size_t>(*number);
}

std::string list_of(const ImportQuestion& question) {
  std::string out = fmt::format("\n{}\n", question.text);
  for (std::size_t i = 0; i < question.answers.size(); ++i)
    out += fmt::format("  {:>2}  {}\n", i + 1, question.answers[i].text);
  return out;
}

/// The answer that Enter accepts, as the user sees it.
std::string usual_of(const ImportQuestion& question) {
  const auto found = std::ranges::find(question.answers, question.usual, &ImportAnswer::value);
  if (found == question.answers.end()) return question.usual;
  return fmt::format("{}", found - question.answers.begin() + 1);
}

/// The number of an answer in the list as its value; any other text as it is.
std::string value_of(const ImportQuestion& question, const std::string& text) {
  if (text.empty()) return question.usual;
  const auto number = lab::whole_text_as<std::int64_t>(text);
  if (number && *number >= 1 && static_cast<std::size_t>(*number) <= question.answers.size())
    return question.answers[static_cast<std::size_t>(*number) - 1].value;
  return text;
}

}  // namespace

void QuestionDialog::report(const std::string& text) const {
  for (const std::string& one : wrapped(on_one_line(text), text_width())) say(one + "\n");
}

std::string QuestionDialog::line(const std::string& prompt) const {
  say(prompt);
  const auto typed = user_.read_line();
  if (!typed) throw QuitImport();
  std::string text(lab::trimmed(*typed));
  if (text == "q") throw QuitImport();
  return text;
}

void QuestionDialog::ask_open_questions() {
  while (true) {
    const auto open = study::open_questions(proposal_, choices_);
    const auto next = std::ranges::find_if(open, [&](const ImportQuestion& one) {
      return !asked_.contains({one.position, one.text});
    });
    if (next == open.end()) return;
    has_asked_ = true;
    if (ask(*next)) asked_.insert({next->position, next->text});
  }
}

/// True if the question is answered, false if another column was corrected instead.
bool QuestionDialog::ask(const ImportQuestion& question) {
  say(list_of(question));
  const bool is_measured = question.about == ImportQuestion::About::value;
  const bool has_default = !is_measured && !question.usual.empty();
  const std::string prompt =
      is_measured    ? fmt::format("answer in {}, such as {}{}: ", question.unit, question.usual,
                                question.is_optional ? ", or Enter to read it without" : "")
      : !has_default ? "answer: "
                     : fmt::format("answer{}{} [{}]: ", question.unit.empty() ? "" : " in ",
                                   question.unit, usual_of(question));
  while (true) {
    const std::string text = line(prompt);
    if (question.is_optional && text.empty()) return true;
    if (!has_default && text.empty()) {
      report(fmt::format("The file does not contain this {}. Type it, or q to quit.",
                         is_measured ? "value" : "unit"));
      continue;
    }
    if (text == "?") {
      report(question.explanation +
             (question.answers.empty() ? "" : " Another answer of this kind can be typed."));
      continue;
    }
    if (correct_column(text)) return false;
    const std::string fault = study::give_answer(choices_, question, value_of(question, text));
    if (fault.empty()) return true;
    report(fault);
  }
}

bool QuestionDialog::correct_column(const std::string& text) {
  const auto position = column_to_correct(text);
  if (!position) return false;
  if (!choices_.at(*position)) {
    report(fmt::format("the table has no column {}", *position));
    return true;
  }
  has_asked_ = true;
  if (!ask(study::quantity_question(proposal_, choices_, *position))) return true;
  if (const auto unit = study::unit_question(proposal_, choices_, *position))
    if (!ask(*unit)) return true;
  if (const auto sign = study::sign_question(choices_, *position)) ask(*sign);
  return true;
}

}  // namespace triax::src

// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/programmes/operator_reader.hpp"

#include <fmt/format.h>

#include "lab/base/text.hpp"
#include "lab/base/toml_reader.hpp"

namespace triax::lab {
namespace {

using Kind = OperatorAction::Kind;

Kind read_kind(const TomlTable& table) {
  const std::string word = table.required_text("action");
  if (word == "hold") return Kind::hold;
  if (word == "resume") return Kind::resume;
  if (word == "abort") return Kind::abort;
  table.fail("action", fmt::format("{} is not valid; known: hold, resume, abort", excerpt(word)));
}

}  // namespace

std::vector<OperatorAction> read_operator(const std::vector<TomlTable>& tables) {
  std::vector<OperatorAction> actions;
  for (const TomlTable& table : tables) {
    OperatorAction action;
    action.kind = read_kind(table);
    action.at_s = 60 * table.required_number("at_min", {.at_least = 0, .at_most = 1e6});
    table.finish();
    const bool holding = !actions.empty() && actions.back().kind == Kind::hold;
    if (!actions.empty() && action.at_s <= actions.back().at_s)
      table.fail("at_min", "is not later than the action before");
    if (!actions.empty() && actions.back().kind == Kind::abort)
      table.fail("action", "comes after an abort, which ends the test");
    if (action.kind == Kind::resume && !holding) table.fail("action", "no hold to resume");
    if (action.kind == Kind::hold && holding)
      table.fail("action", "the test is on hold already: resume it first");
    actions.push_back(action);
  }
  if (!actions.empty() && actions.back().kind == Kind::hold)
    tables.back().fail("action", "nothing ends this hold: add a resume or an abort");
  return actions;
}

}  // namespace triax::lab

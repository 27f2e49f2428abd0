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
  table.fail("action", invalid_value(word, {"hold", "resume", "abort"}));
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
      table.fail("at_min", "must be later than the previous action");
    if (!actions.empty() && actions.back().kind == Kind::abort)
      table.fail("action", "comes after an abort, which ends the test");
    if (action.kind == Kind::resume && !holding) table.fail("action", "no hold to resume");
    if (action.kind == Kind::hold && holding)
      table.fail("action", "the test is held already; resume it first");
    actions.push_back(action);
  }
  if (!actions.empty() && actions.back().kind == Kind::hold)
    tables.back().fail("action", "this hold does not end; add a resume or an abort");
  return actions;
}

}  // namespace triax::lab

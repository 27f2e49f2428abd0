// SPDX-License-Identifier: GPL-3.0-or-later
// Tests that the page runs.
#include <algorithm>
#include <cmath>

#include "lab/base/bad_input.hpp"
#include "lab/base/text.hpp"
#include "src/page/api/changes_api.hpp"
#include "src/page/api/json_body.hpp"
#include "src/page/api/programme_form.hpp"

namespace triax::src {
namespace {

using study::Json;

/// A number of JSON as TOML has it.
std::string edit_value(const Json& value) {
  if (value.is_string()) return value.get<std::string>();
  if (value.is_number() || value.is_boolean()) return value.dump();
  throw Refused(400, "set: a value has to be a number or a text");
}

std::vector<lab::TomlEdit> edits_of(const Json& body) {
  std::vector<lab::TomlEdit> edits;
  const auto set = body.find("set");
  if (set == body.end() || set->is_null()) return edits;
  if (!set->is_object()) throw Refused(400, "set: expected an object of keys and values");
  for (const auto& [key, value] : set->items())
    edits.push_back({key == "seed" ? "test.seed" : key, edit_value(value)});
  return edits;
}

/// One line of people's text.
std::string who_of(const Json& body) {
  std::string who(lab::trimmed(text_in(body, "who")));
  constexpr std::size_t kMost = 100;
  const auto is_control = [](unsigned char c) { return c < ' ' || c == 0x7f; };
  if (who.empty() || who.size() > kMost || !lab::is_utf8(who) ||
      std::ranges::any_of(who, is_control))
    throw Refused(400, "who: expected the operator, one line of at most 100 bytes");
  return who;
}

}  // namespace

PageAnswer begin_run(PageLaboratory& laboratory, const std::string& body) {
  const Json asked = json_body(body);
  RunAsked run;
  run.programme = programme_of(text_in(asked, "programme"), edits_of(asked));
  if (const auto seed = number_in(asked, "seed")) {
    if (*seed < 0 || *seed > 9e15 || *seed != std::floor(*seed))
      throw Refused(400, "seed: expected an integer, 0 or more");
    run.seed = static_cast<std::uint64_t>(*seed);
  }
  run.speed = number_in(asked, "speed").value_or(0);
  if (!(run.speed >= 0) || !(run.speed <= 1e9))
    throw Refused(400, "speed: expected a factor of real time, or 0 for no limit");
  if (flag_in(asked, "rig")) {
    if (laboratory.rig.empty())
      throw Refused(409, "triax open was started without a rig: `triax open RIG.toml`");
    run.rig = laboratory.rig;
  }
  const Json answer = {{"test", laboratory.live.run(std::move(run))}};
  return json_answer(answer.dump());
}

PageAnswer order_run(PageLaboratory& laboratory, std::int64_t test, RunOrder::Kind kind,
                     const std::string& body) {
  laboratory.live.order(test, {kind, who_of(json_body(body))});
  return json_answer("{\"accepted\":true}");
}

PageAnswer another_browser(PageLaboratory& laboratory) {
  const Json answer = {{"address", laboratory.new_address()}};
  return json_answer(answer.dump());
}

PageAnswer list_of_programmes() {
  static const std::string list = Json({{"programmes", programme_forms()}}).dump();
  return json_answer(list);
}

}  // namespace triax::src

// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/wire/remote/control_line.hpp"

#include <fmt/format.h>

#include <memory>
#include <optional>

#include "lab/base/bad_input.hpp"
#include "lab/base/text.hpp"

namespace triax::lab {
namespace {

/// One line of text for one of text.
Exchange line_of_text(const std::string& question) {
  return {.request = question + "\n",
          .whole = [](std::string_view received) { return received.find('\n') + 1; },
          .answered = true,
          .values = {},
          .text =
              [](std::string_view answer) {
                answer.remove_suffix(1);
                if (answer.ends_with('\r')) answer.remove_suffix(1);
                return std::string(answer);
              }};
}

}  // namespace

ControlLine::ControlLine(LineLoop& loop, const LinkAddress& link) : loop_(loop), line_(loop, link) {
  const auto opened = std::make_shared<std::optional<std::string>>();
  line_.open(loop.now_s() + kPatience_s, [opened](const std::string& why) { *opened = why; });
  loop.run_until([&opened] { return opened->has_value(); }, loop.now_s() + kPatience_s + 1);
  const std::string why = opened->value_or("no response");
  if (!why.empty())
    throw WorkFailed(
        fmt::format("the rig control at {} cannot be reached: {}", to_text(link), why));
}

std::string ControlLine::ask(const std::string& question) {
  // The line may call the handler after this has thrown.
  const auto asked = std::make_shared<Asked>(Asked{.why = "too late"});
  const auto over = std::make_shared<bool>(false);
  line_.ask(line_of_text(question), loop_.now_s() + kPatience_s, [asked, over](const Asked& a) {
    *asked = a;
    *over = true;
  });
  loop_.run_until([&over] { return *over; }, loop_.now_s() + kPatience_s + 1);
  if (asked->kind == Asked::Kind::answered) return asked->text;
  throw WorkFailed(fmt::format("the rig control at {} did not respond to {}: {}",
                               to_text(line_.link()), question, asked->why));
}

RigTime ControlLine::ask_time() {
  const std::string mode = ask("CLOCk:MODE?");
  if (mode == "LOCK") return {.speed = 1, .lock_step = true};
  const auto speed = whole_text_as<double>(mode.substr(std::min(mode.size(), sizeof("REAL,") - 1)));
  if (!speed || !(*speed > 0))
    throw WorkFailed(fmt::format("the rig control sent {} as its clock", excerpt(mode)));
  return {.speed = *speed};
}

FrameState ControlLine::step(double dt_s) {
  const std::string answer = ask(fmt::format("CLOCk:STEP? {}", dt_s));
  const auto state = whole_text_as<int>(answer.substr(answer.find(',') + 1));
  if (!state || *state < 0 || *state > static_cast<int>(FrameState::cannot_follow))
    throw WorkFailed(fmt::format("the rig control responded {} to a step", excerpt(answer)));
  return static_cast<FrameState>(*state);
}

}  // namespace triax::lab

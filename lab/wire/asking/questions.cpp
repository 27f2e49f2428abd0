// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/wire/asking/questions.hpp"

#include <fmt/format.h>

#include "lab/base/bad_input.hpp"
#include "lab/wire/asking/modbus_questions.hpp"

namespace triax::lab {

std::unique_ptr<Questions> questions_for(const Personality& personality, const LinkAddress& link) {
  const bool text = personality.speaks(Protocol::scpi) || personality.speaks(Protocol::lines);
  if (link.is_modbus() && !personality.speaks(Protocol::modbus))
    throw BadInput(fmt::format("{}: a {} has no Modbus interface; expected tcp:// or serial://",
                               to_text(link), personality.title));
  if (!link.is_modbus() && !text)
    throw BadInput(
        fmt::format("{}: a {} has a Modbus interface only; expected modbus-tcp:// or modbus-rtu://",
                    to_text(link), personality.title));
  if (!link.is_modbus()) return text_questions(personality);
  const bool tcp = link.kind == LinkAddress::Kind::modbus_tcp;
  return modbus_questions(personality, tcp ? ModbusFraming::tcp : ModbusFraming::rtu, link.unit);
}

}  // namespace triax::lab

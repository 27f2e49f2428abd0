// SPDX-License-Identifier: GPL-3.0-or-later
// Any bytes as what a client sends to a scanner, in pieces and with silences (bytes 0): they are
// done, or are an error in its queue; nothing is thrown, and what is kept is bounded.
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "lab/wire/instruments/scanner_34970a.hpp"
#include "lab/wire/scpi/scpi_conversation.hpp"

using namespace triax::lab;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  WireDevice device{.name = "fuzz", .identity = Scanner34970A::kIdentity};
  for (int i = 0; i < 30; ++i)
    device.points.push_back({"channel_V", [i] { return i * 0.1; }, nullptr});
  Scanner34970A scanner(device, 0);
  ScpiConversation client(scanner.table(), device);
  std::string_view text(reinterpret_cast<const char*>(data), size);
  double now_s = 0;
  std::string reply;
  while (!text.empty()) {
    const std::string_view piece = text.substr(0, text.find('\0'));
    client.take(piece, reply);
    if (client.waits_s()) client.silent(reply);
    if (client.waits_s() || reply.size() > 2 * ScpiConversation::kLongestReply) std::abort();
    scanner.process(now_s += 1);
    reply.clear();
    text.remove_prefix(piece.size() < text.size() ? piece.size() + 1 : text.size());
  }
  return 0;
}

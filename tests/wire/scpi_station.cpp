// SPDX-License-Identifier: GPL-3.0-or-later
// For the scripts of this folder.
//     scpi_station                      serves instruments at free ports, a line "NAME
//     HOST:PORT" each scpi_station --serial PATH        serves the serial pad there too
//     scpi_station --ask LINK TEXT...   asks with our own line: what came, or what became of
//     it
// The server ends with who started it.
#include <unistd.h>

#include <chrono>
#include <cmath>
#include <cstdio>
#include <string_view>

#include "lab/wire/instruments/multimeter_34401a.hpp"
#include "lab/wire/instruments/number_logger.hpp"
#include "lab/wire/instruments/scanner_34970a.hpp"
#include "lab/wire/instruments/serial_pad.hpp"
#include "lab/wire/line/line.hpp"
#include "lab/wire/line/wire_server.hpp"
#include "lab/wire/scpi/scpi_conversation.hpp"

namespace {
using namespace triax::lab;

/// A device whose points never move: 1.25, 2.25 ...
WireDevice still(const char* identity, int points) {
  WireDevice device{.name = "still", .identity = identity};
  for (int i = 0; i < points; ++i)
    device.points.push_back(
        {"channel" + std::to_string(i + 1) + "_V", [i] { return i + 1.25; }, nullptr});
  return device;
}

int ask(int argc, char** argv) {
  LineLoop loop;
  Line line(loop, parse_link(argv[2]));
  int open = -1, status = 0;
  line.open(loop.now_s() + 3, [&](const std::string& why) {
    open = why.empty();
    if (!open) std::printf("not open: %s\n", why.c_str());
  });
  loop.run_until([&] { return open >= 0; }, loop.now_s() + 4);
  if (open != 1) return 1;
  int waiting = argc - 3;
  for (int i = 3; i < argc; ++i) {
    Exchange exchange{.request = std::string(argv[i]) + "\n",
                      .whole =
                          [](std::string_view came) {
                            const std::size_t end = came.find('\n');
                            return end == came.npos ? 0 : end + 1;
                          },
                      .text = [](std::string_view answer) { return std::string(answer); }};
    exchange.answered =
        exchange.request.find('?') != std::string::npos || exchange.request == "SS\n";
    line.ask(exchange, loop.now_s() + 3, [&](const Asked& asked) {
      --waiting;
      if (asked.kind != Asked::Kind::answered) status = 1;
      std::fputs((asked.text + asked.why + (asked.why.empty() ? "" : "\n")).c_str(), stdout);
    });
  }
  loop.run_until([&] { return waiting == 0; }, loop.now_s() + 10);
  return status;
}

int serve(const char* serial) {
  const WireDevice meter_device = still(Multimeter34401A::kIdentity, 1);
  const WireDevice scanner_device = still(Scanner34970A::kIdentity, 22);
  const WireDevice pad_device = still("", 8);
  const Multimeter34401A meter(meter_device);
  const double epoch_s =
      std::chrono::duration<double>(std::chrono::system_clock::now().time_since_epoch()).count();
  Scanner34970A scanner(scanner_device, epoch_s);
  LineLoop loop;
  WireServer server(loop);
  const WireLimits limits{.clients = 2000};
  const auto listen = [&](const char* name, const auto& conversation) {
    const LinkAddress link = server.listen(parse_link("tcp://127.0.0.1:0"), conversation, limits);
    std::printf("%s %s:%d\n", name, link.host.c_str(), link.port);
  };
  listen("34401A", [&] { return std::make_unique<ScpiConversation>(meter.table(), meter_device); });
  listen("34970A",
         [&] { return std::make_unique<ScpiConversation>(scanner.table(), scanner_device); });
  listen("pad", [&] { return std::make_unique<SerialPad>(pad_device); });
  listen("number", [&] { return std::make_unique<NumberLogger>(pad_device); });
  if (serial)
    server.listen(parse_link(serial), [&] { return std::make_unique<SerialPad>(pad_device); });
  std::puts("ready");
  std::fflush(stdout);
  LineTimer tick;
  const auto parent = ::getppid();
  bool alone = false;
  const std::function<void()> move_on = [&] {
    scanner.process(loop.now_s());
    alone = ::getppid() != parent;
    tick = loop.at(loop.now_s() + 0.01, move_on);
  };
  move_on();
  loop.run_until([&] { return alone; }, 1e9);
  return 0;
}
}  // namespace

int main(int argc, char** argv) {
  const std::string_view what = argc > 1 ? argv[1] : "";
  if (what == "--ask" && argc > 3) return ask(argc, argv);
  return serve(what == "--serial" && argc > 2 ? argv[2] : nullptr);
}

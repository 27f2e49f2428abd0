// SPDX-License-Identifier: GPL-3.0-or-later
// For bench/wire/scans.py.
//     bench_seven_meters               serves seven 34401A at free ports, a line "PORT DELAY_MS"
//     each; each answers so much
//                                      later, as a meter that integrates does
//     bench_seven_meters --time RIG N  median time of a scan in ms, N of each kind in turn: all
//     instruments of the rig file at once,
//                                      then each alone
#include <fmt/format.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <memory>
#include <string_view>

#include "lab/base/statistics.hpp"
#include "lab/wire/instruments/multimeter_34401a.hpp"
#include "lab/wire/line/wire_server.hpp"
#include "lab/wire/remote/wire_instruments.hpp"
#include "lab/wire/scpi/scpi_conversation.hpp"

namespace {
using namespace triax::lab;

constexpr double kDelays_ms[] = {3, 5, 8, 12, 16, 20, 25};  // 0.15 to 1.25 cycles of the mains

int serve() {
  const WireDevice device{.name = "meter",
                          .identity = Multimeter34401A::kIdentity,
                          .points = {{"voltage_V", [] { return 1.25; }, nullptr}}};
  const Multimeter34401A meter(device);
  LineLoop loop;
  WireServer server(loop);
  for (const double delay_ms : kDelays_ms) {
    const LinkAddress link =
        server.listen(parse_link("tcp://127.0.0.1:0"),
                      [&] { return std::make_unique<ScpiConversation>(meter.table(), device); },
                      {.clients = 2000});
    server.set_fault(link, WireFault::slow, delay_ms / 1e3);
    fmt::print("{} {}\n", link.port, delay_ms);
  }
  std::fflush(stdout);
  const auto parent = ::getppid();
  loop.run_until([&] { return ::getppid() != parent; }, 1e9);
  return 0;
}

/// The instruments of a rig, ready to be scanned.
struct Scanned {
  Scanned(LineLoop& l, const RigFile& r)
      : loop(l), rig(r), all(l, rig, [](const auto&) { return std::vector<std::string>(); }) {
    const std::string missing = all.connect(10, {});
    if (!missing.empty()) throw std::runtime_error(missing);
  }
  /// A scan's time, ms; a missing value ends the program: what is not read takes no time.
  double scan_ms() {
    const double start_s = all.scan([](const WireInstrument&, const WireInstrument::Scan& scan) {
      if (!scan.why.empty()) throw std::runtime_error(scan.why);
    });
    return (loop.now_s() - start_s) * 1e3;
  }
  LineLoop& loop;
  RigFile rig;
  WireInstruments all;
  std::vector<double> taken_ms;
};

int time_scans(const char* file, int scans) {
  const RigFile rig = load_rig_file(file);
  LineLoop loop;
  std::vector<std::unique_ptr<Scanned>> kinds;
  kinds.push_back(std::make_unique<Scanned>(loop, rig));
  for (const RigInstrument& one : rig.instruments) {
    RigFile alone = rig;
    alone.instruments = {one};
    kinds.push_back(std::make_unique<Scanned>(loop, alone));
  }
  for (int i = 0; i < scans; ++i)
    for (const auto& kind : kinds) kind->taken_ms.push_back(kind->scan_ms());
  fmt::print("all {:.3f}\n", median(kinds[0]->taken_ms));
  for (std::size_t i = 1; i < kinds.size(); ++i)
    fmt::print("{} {:.3f}\n", rig.instruments[i - 1].name, median(kinds[i]->taken_ms));
  return 0;
}
}  // namespace

int main(int argc, char** argv) {
  if (argc == 4 && std::string_view(argv[1]) == "--time")
    return time_scans(argv[2], std::atoi(argv[3]));
  return serve();
}

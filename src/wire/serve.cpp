// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/wire/serve.hpp"

#include <fmt/format.h>

#include <cstdio>
#include <memory>

#include "lab/programmes/programme_reader.hpp"
#include "lab/wire/served/served_rig.hpp"
#include "src/cli/interruption.hpp"
#include "src/output/notice.hpp"

namespace triax::src {
namespace {

struct ServeOptions {
  std::string rig;
  lab::ServingOptions serving;
};

/// What is open, before the first client can come.
void print_open(const lab::RigFile& rig, const lab::ServedRig& served,
                const lab::ServingOptions& options) {
  fmt::print("{}: simulated, {} (seed {}), {}\n", rig.name, served.plant().programme().name,
             served.plant().seed(),
             options.lock_step ? "its clock is set by the client"
                               : fmt::format("{:g} times real time", options.speed));
  for (const auto& one : served.open()) fmt::print("  {:<20} {}\n", one.name, to_text(one.link));
  std::fflush(stdout);
}

void run_serve(const ServeOptions& o) {
  const lab::RigFile rig = lab::load_rig_file(o.rig);
  lab::LineLoop loop;
  const lab::ServedRig served(loop, rig, lab::load_programme(rig.served().programme), o.serving);
  print_open(rig, served, o.serving);
  for (const auto& one : served.open())
    if (!one.link.is_local())
      notify(fmt::format("{} can be reached from other computers: instruments have no passwords",
                         one.name));
  const Interruption interruption;
  while (!interruption.requested())
    loop.run_until([&interruption] { return interruption.requested(); }, loop.now_s() + 3600);
  if (served.lost_s() > 0)
    notify(fmt::format("the simulation of the specimen was {:.1f} s too slow for real time",
                       served.lost_s()));
}

}  // namespace

Command serve_command() {
  return {.name = "serve",
          .purpose = "Serve the instruments of a virtual rig over the network",
          .description = {"Every instrument of RIG.toml listens at its address and responds in its "
                          "own protocol: SCPI, Modbus or plain lines. They all test the "
                          "same virtual specimen, which the programme in [plant] describes. `triax "
                          "run` and other programs drive such a rig like a real one.",
                          "The rig can be reached from this machine only, unless --listen gives "
                          "another address. The open addresses are printed. Instruments have no "
                          "passwords: keep them on a separate network.",
                          "With [plant] control = \"tcp://...\" the rig has an additional port for "
                          "reading its clock and for switching on faults while it runs.",
                          "Ctrl-C stops it."},
          .diagnostics =
              {{"FILE:LINE: ...", "correct this line of the rig file"},
               {"cannot listen at ADDRESS: ...",
                "stop the program that uses this address, or change the link in the rig file"}},
          .examples = {{"triax serve samples/rigs/csu_26.toml --speed 60",
                        "run hours of the test in minutes"},
                       {"triax serve samples/rigs/icu_6.toml --lock-step",
                        "let `triax run` advance the time"}},
          .set_up = [](CLI::App& app) -> std::function<void()> {
            const auto o = std::make_shared<ServeOptions>();
            app.add_option("RIG.toml", o->rig, "rig file")->required()->type_name("");
            app.add_option("--listen", o->serving.listen, "address to listen at [127.0.0.1]")
                ->type_name("ADDRESS");
            auto* speed = app.add_option("--speed", o->serving.speed,
                                         "run N times faster than real time, 0.01 to 10000 [1]")
                              ->check(CLI::Range(0.01, 10'000.0).description(""))
                              ->type_name("N");
            app.add_flag("--lock-step", o->serving.lock_step,
                         "advance the time only when the client requests it; excludes --speed")
                ->excludes(speed);
            app.add_option("--clients", o->serving.clients,
                           "maximum number of clients of one instrument, 1 to 100000 [64]")
                ->check(CLI::Range(1, 100'000).description(""))
                ->type_name("N");
            return [o] { run_serve(*o); };
          }};
}

}  // namespace triax::src

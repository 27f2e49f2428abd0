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
             options.lock_step ? "its clock is turned by the client"
                               : fmt::format("{:g} times the clock", options.speed));
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
      notify(fmt::format("{} can be reached by others: instruments have no passwords", one.name));
  const Interruption interruption;
  while (!interruption.requested())
    loop.run_until([&interruption] { return interruption.requested(); }, loop.now_s() + 3600);
  if (served.lost_s() > 0)
    notify(fmt::format("the specimen was too slow for the clock by {:.1f} s", served.lost_s()));
}

}  // namespace

Command serve_command() {
  return {
      .name = "serve",
      .purpose = "put the instruments of a virtual rig on the wire",
      .description =
          {"Every instrument of RIG.toml listens at its link and answers in its own language, "
           "SCPI, "
           "Modbus or plain lines; behind all of them stands one virtual specimen, that of the "
           "programme named in [plant]. `triax run` drives such a rig as it drives a real one, and "
           "so does any other program.",
           "Only this machine can reach it unless --listen names another address; what is open is "
           "printed. Instruments have no passwords: keep them on a network of their own.",
           "With [plant] control = \"tcp://...\" the rig has one more port, on which its clock can "
           "be read and its faults be switched on while it runs (docs/how-to/instruments.md).",
           "Ctrl-C ends it."},
      .diagnostics = {{"FILE:LINE: ...", "the rig's file is not valid at this line"},
                      {"ADDRESS: Address already in use", "another program listens there"}},
      .examples = {{"triax serve samples/rigs/csu_26.toml --speed 60",
                    "a rig whose hours take minutes"},
                   {"triax serve samples/rigs/icu_6.toml --lock-step",
                    "a rig that waits for `triax run` to turn its clock"}},
      .set_up = [](CLI::App& app) -> std::function<void()> {
        const auto o = std::make_shared<ServeOptions>();
        app.add_option("RIG.toml", o->rig, "the rig's file")->required()->type_name("");
        app.add_option("--listen", o->serving.listen, "address to listen at [127.0.0.1]")
            ->type_name("ADDRESS");
        auto* speed = app.add_option("--speed", o->serving.speed,
                                     "test time runs so many times faster than the clock [1]")
                          ->check(CLI::Range(0.01, 10'000.0))
                          ->type_name("N");
        app.add_flag("--lock-step", o->serving.lock_step, "time passes only as the client turns it")
            ->excludes(speed);
        app.add_option("--clients", o->serving.clients, "most clients of one instrument [64]")
            ->check(CLI::Range(1, 100'000))
            ->type_name("N");
        return [o] { run_serve(*o); };
      }};
}

}  // namespace triax::src

// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/wire/rig.hpp"

#include <fmt/format.h>

#include <cmath>
#include <memory>

#include "lab/base/bad_input.hpp"
#include "lab/wire/remote/rig_check.hpp"
#include "src/cli/interruption.hpp"
#include "src/output/table.hpp"

namespace triax::src {
namespace {

constexpr double kConnect_s = 5;

struct RigOptions {
  std::string action, rig;
};

std::string or_dash(double value, const char* format) {
  return std::isnan(value) ? "–" : fmt::format(fmt::runtime(format), value);
}

Table instrument_table(const std::vector<lab::InstrumentCheck>& checks) {
  Table table{.columns = {{"Instrument"},
                          {"Link"},
                          {"Who it is"},
                          {"Answer (ms)", Align::right},
                          {"What is wrong"}},
              .rows = {}};
  for (const auto& one : checks)
    table.rows.push_back({one.name, one.link, one.identity.empty() ? "–" : one.identity,
                          or_dash(one.answer_s * 1e3, "{:.1f}"), one.trouble});
  return table;
}

Table channel_table(const std::vector<lab::InstrumentCheck>& checks) {
  Table table{.columns = {{"Channel"},
                          {"Instrument"},
                          {"Value", Align::right},
                          {"Noise", Align::right},
                          {"Unit"},
                          {"What is wrong"}},
              .rows = {}};
  for (const auto& one : checks)
    for (const auto& channel : one.channels)
      table.rows.push_back({channel.name, one.name, or_dash(channel.value, "{:.6g}"),
                            or_dash(channel.noise, "{:.2g}"), channel.unit, channel.trouble});
  return table;
}

void run_rig(const RigOptions& o) {
  const lab::RigFile rig = lab::load_rig_file(o.rig);
  const Interruption interruption;
  const auto checks =
      lab::check_rig(rig, kConnect_s, [&interruption] { return interruption.requested(); });
  fmt::print("{}\n\n{}\n{}", rig.name, to_text(instrument_table(checks)),
             to_text(channel_table(checks)));
  if (!lab::all_well(checks))
    throw lab::WorkFailed(fmt::format("{}: not all is well with the rig, see above", o.rig));
}

}  // namespace

Command rig_command() {
  return {
      .name = "rig",
      .purpose = "check a rig: who answers, what each channel says, what is wrong",
      .description =
          {"Asks every instrument of RIG.toml who it is, reads every channel eight times within "
           "four seconds and prints the first value, the noise (standard deviation) and the time "
           "that an answer takes. What is wrong is said in words: an instrument that does not "
           "answer or is another one, a channel without a value or beyond its calibrated range, a "
           "value that no triaxial apparatus measures, a calibration without a date, a drive that "
           "stands. Nothing is set.",
           "The status is 0 where all is well, else 1."},
      .diagnostics = {{"FILE:LINE: ...", "the rig's file is not valid at this line"}},
      .examples = {{"triax rig check samples/rigs/csu_26.toml",
                    "the rig that `triax serve samples/rigs/csu_26.toml` puts on the wire"}},
      .set_up = [](CLI::App& app) -> std::function<void()> {
        const auto o = std::make_shared<RigOptions>();
        app.add_option("ACTION", o->action, "what is to be done")
            ->required()
            ->check(CLI::IsMember({"check"}).description(""))
            ->type_name("check");
        app.add_option("RIG.toml", o->rig, "the rig's file")->required()->type_name("");
        return [o] { run_rig(*o); };
      }};
}

}  // namespace triax::src

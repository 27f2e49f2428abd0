// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/wire/rig.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>

#include "lab/base/bad_input.hpp"
#include "lab/base/text.hpp"
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
                          {"Identity"},
                          {"Response (ms)", Align::right},
                          {"Fault"}},
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
                          {"Fault"}},
              .rows = {}};
  for (const auto& one : checks)
    for (const auto& channel : one.channels)
      table.rows.push_back({channel.name, one.name, or_dash(channel.value, "{:.6g}"),
                            or_dash(channel.noise, "{:.2g}"), channel.unit, channel.trouble});
  return table;
}

/// "4 of 4 instruments did not respond", "2 of 4 instruments have faults, ...", or both.
std::string faults_found(const std::vector<lab::InstrumentCheck>& checks) {
  std::size_t silent = 0, faulty = 0;
  for (const auto& one : checks) {
    const bool has_fault =
        !one.trouble.empty() || std::ranges::any_of(one.channels, [](const auto& channel) {
          return !channel.trouble.empty();
        });
    if (std::isnan(one.answer_s))
      ++silent;
    else if (has_fault)
      ++faulty;
  }
  const auto count = [&](std::size_t some) {
    return fmt::format("{} of {} instruments", some, checks.size());
  };
  return lab::joined({silent > 0 ? count(silent) + " did not respond" : "",
                      faulty > 0 ? count(faulty) + " have faults, listed on standard output" : ""},
                     "; ");
}

void run_rig(const RigOptions& o) {
  const lab::RigFile rig = lab::load_rig_file(o.rig);
  const Interruption interruption;
  const auto checks =
      lab::check_rig(rig, kConnect_s, [&interruption] { return interruption.requested(); });
  fmt::print("{}\n\n{}\n{}", rig.name, to_text(instrument_table(checks)),
             to_text(channel_table(checks)));
  if (!lab::all_well(checks))
    throw lab::WorkFailed(fmt::format("{}: rig check failed: {}", o.rig, faults_found(checks)));
}

}  // namespace

Command rig_command() {
  return {
      .name = "rig",
      .purpose = "Check the instruments of a rig",
      .description =
          {"Queries the identity of every instrument of RIG.toml, reads every channel eight times "
           "within four seconds and prints the first value, the noise (standard deviation) and the "
           "response time. The faults that it can report are: an instrument that does not respond "
           "or has another identity, a channel without a value or beyond its calibrated range, a "
           "value outside the range of triaxial apparatus, a calibration without a date, and a "
           "drive at the end of its travel. No setpoint is changed.",
           "The exit status is 0 if no fault was found, otherwise 1."},
      .diagnostics = {{"FILE:LINE: ...", "correct this line of the rig file"}},
      .examples = {{"triax rig check samples/rigs/csu_26.toml",
                    "check the rig that `triax serve samples/rigs/csu_26.toml` serves"}},
      .set_up = [](CLI::App& app) -> std::function<void()> {
        const auto o = std::make_shared<RigOptions>();
        app.add_option("ACTION", o->action,
                       "check: identify the instruments, read their channels and list faults")
            ->required()
            ->check(CLI::IsMember({"check"}).description(""))
            ->type_name("check");
        app.add_option("RIG.toml", o->rig, "rig file")->required()->type_name("");
        return [o] { run_rig(*o); };
      }};
}

}  // namespace triax::src

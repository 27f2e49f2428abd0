// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/wire/record.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <memory>

#include "lab/base/bad_input.hpp"
#include "lab/wire/remote/rig_log.hpp"
#include "src/cli/ended_early.hpp"
#include "src/cli/interruption.hpp"
#include "src/output/notice.hpp"
#include "src/output/progress_bar.hpp"

namespace triax::src {
namespace {

struct RecordOptions {
  std::string rig, record;
  double interval_s = 0, minutes = 0;
  std::int64_t readings = 0;
};

void run_record(const RecordOptions& o) {
  const lab::RigFile rig = lab::load_rig_file(o.rig);
  const Interruption interruption;
  ProgressBar bar(rig.name);
  const double whole_s = o.minutes * 60;
  const lab::RigLogged logged = lab::log_rig(
      rig, o.record,
      {.interval_s = o.interval_s > 0 ? o.interval_s : rig.interval_s,
       .for_s = whole_s,
       .readings = o.readings,
       .stop = [&interruption] { return interruption.requested(); },
       .say = notify,
       .progressed =
           [&](std::int64_t readings, double time_s) {
             if (whole_s > 0) bar.show(time_s / whole_s);
             if (o.readings > 0)
               bar.show(static_cast<double>(readings) / static_cast<double>(o.readings));
           }});
  fmt::print("{}: {} readings, {} cells missing{}\n", o.record, logged.readings,
             logged.missing_cells, logged.simulated ? "; SIMULATED, not measured" : "");
  if (!logged.silent.empty())
    throw EndedEarly(EarlyEnd::failed_rig,
                     fmt::format("{}: no readings at the end from {}", o.record,
                                 fmt::join(logged.silent, "; from ")));
  if (logged.stopped && (o.minutes > 0 || o.readings > 0))
    throw EndedEarly(EarlyEnd::aborted,
                     fmt::format("{}: ended by the operator before the end of {}", o.record,
                                 o.minutes > 0 ? "--for" : "--readings"));
}

}  // namespace

Command record_command() {
  return {
      .name = "record",
      .purpose = "Record the readings of a rig without controlling it",
      .description =
          {"Reads all channels of RIG.toml at the same time, at regular intervals, and writes them "
           "as rows of a record that `triax replay` reads. A channel that does not belong to a "
           "triaxial test, such as the room temperature, has a column of its own after the others. "
           "No setpoint is changed.",
           "Each row is written to the file as soon as it has been read. A missing value is an "
           "empty cell, and its cause is reported. A lost connection is opened again. Readings "
           "that are missed while triax waits for a response or is suspended are reported and not "
           "replaced.",
           "Without --for and --readings, recording continues until Ctrl-C. The record has no "
           "description of the specimen: give it to triax replay (--set specimen.height_mm=140)."},
      .diagnostics = {{"FILE: file exists already; ...",
                       "choose another file: an existing file is never overwritten"},
                      {"FILE: no instrument responded; ...",
                       "check power, connections and addresses with `triax rig check RIG.toml`"}},
      .examples = {{"triax record bench.toml --record today.csv --interval 10 --for 480",
                    "record for eight hours, one row every ten seconds"}},
      .statuses =
          {{"3", "the record is saved; an instrument gave no readings at the end"},
           {"4",
            "the record is saved; the operator stopped it before --for or --readings was reached"}},
      .set_up = [](CLI::App& app) -> std::function<void()> {
        const auto o = std::make_shared<RecordOptions>();
        app.add_option("RIG.toml", o->rig, "rig file")->required()->type_name("");
        app.add_option("--record", o->record, "record file to write")
            ->required()
            ->type_name("OUT.csv");
        app.add_option(
               "--interval", o->interval_s,
               "time between readings in seconds, 0.01 to 86400 [scan_interval_s of the rig file]")
            ->check(CLI::Range(0.01, 86400.0).description(""))
            ->type_name("S");
        app.add_option("--for", o->minutes, "duration in minutes [until Ctrl-C]")
            ->check(CLI::PositiveNumber.description(""))
            ->type_name("MIN");
        app.add_option("--readings", o->readings, "number of readings [until Ctrl-C]")
            ->check(CLI::PositiveNumber.description(""))
            ->type_name("N");
        return [o] { run_record(*o); };
      }};
}

}  // namespace triax::src

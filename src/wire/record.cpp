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
                     fmt::format("{}: ended by the operator before {} was over", o.record,
                                 o.minutes > 0 ? "--for" : "--readings"));
}

}  // namespace

Command record_command() {
  return {
      .name = "record",
      .purpose = "read the instruments of a rig and keep what they say, while others control",
      .description =
          {"All channels of RIG.toml are read at one instant, again and again, and written as rows "
           "of a record that `triax replay` reads. A channel that is none of a triaxial test, the "
           "temperature of the room say, stands in a column of its own behind the others. Nothing "
           "is set.",
           "A row is in the file as soon as it was read. What does not come is an empty cell, and "
           "its cause is told; a link that was lost is taken up again. Instants that pass while "
           "an answer is awaited, or while triax stands still, are reported and not made up for.",
           "Without --for and --readings it goes on until Ctrl-C. What the specimen is, the record "
           "does not know: replay asks for it (--set specimen.height_mm=140)."},
      .diagnostics = {{"FILE: is there already: ...", "a log never writes over what is there"},
                      {"FILE: no instrument is there: ...", "none of the rig answered"}},
      .examples = {{"triax record bench.toml --record today.csv --interval 10 --for 480",
                    "eight hours, a row in ten seconds"}},
      .statuses = {{"3", "the record is kept; an instrument gave no readings when it ended"},
                   {"4", "the record is kept; the operator ended it before --for or --readings"}},
      .set_up = [](CLI::App& app) -> std::function<void()> {
        const auto o = std::make_shared<RecordOptions>();
        app.add_option("RIG.toml", o->rig, "the rig's file")->required()->type_name("");
        app.add_option("--record", o->record, "the file to write")
            ->required()
            ->type_name("OUT.csv");
        app.add_option("--interval", o->interval_s,
                       "seconds between readings [the file's scan_interval_s]")
            ->check(CLI::Range(0.01, 86400.0))
            ->type_name("S");
        app.add_option("--for", o->minutes, "how long, minutes")
            ->check(CLI::PositiveNumber)
            ->type_name("MIN");
        app.add_option("--readings", o->readings, "how many readings")
            ->check(CLI::PositiveNumber)
            ->type_name("N");
        return [o] { run_record(*o); };
      }};
}

}  // namespace triax::src

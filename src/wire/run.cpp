// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/wire/run.hpp"

#include <fmt/format.h>

#include <memory>

#include "lab/base/bad_input.hpp"
#include "lab/programmes/programme_reader.hpp"
#include "lab/wire/remote/remote_rig.hpp"
#include "src/cli/ended_early.hpp"
#include "src/cli/interruption.hpp"
#include "src/cli/output_guard.hpp"
#include "src/cli/shared_options.hpp"
#include "src/output/notice.hpp"
#include "src/output/progress_bar.hpp"
#include "src/output/written_files.hpp"
#include "src/study/triaxial/earlier_tests.hpp"
#include "src/study/triaxial/stored_record.hpp"
#include "src/study/triaxial/test_run.hpp"
#include "src/triaxial/print_tests.hpp"
#include "src/triaxial/shown_on.hpp"

namespace triax::src {
namespace {

struct RunOptions {
  std::string programme, rig, record, db = "triax.db";
  bool json = false;
  std::vector<std::string> earlier;
};

void throw_if_ended_early(const lab::TestEnding& ending) {
  using Kind = lab::TestEnding::Kind;
  const auto stored = [&ending](const char* what) {
    return fmt::format("{}; the test is stored up to its last reading ({})", what, ending.reason);
  };
  switch (ending.kind) {
    case Kind::completed:
      return;
    case Kind::safe_state:
      throw EndedEarly(EarlyEnd::failed_rig, stored("the test ended in the safe state of the rig"));
    case Kind::aborted:
      throw EndedEarly(EarlyEnd::aborted, stored("the test was aborted by the operator"));
    case Kind::unfinished:
      throw EndedEarly(EarlyEnd::unfinished, stored("a stage of the test did not reach its end"));
  }
}

void run_programme(const RunOptions& o) {
  const lab::Programme programme = lab::load_programme(o.programme);
  const lab::RigFile rig_file = lab::load_rig_file(o.rig);
  refuse_overwriting("--record", o.record, programme.files, "part of the programme");
  refuse_overwriting("--record", o.record, {o.rig}, "the rig's file");
  refuse_overwriting("--record", o.record, database_files(o.db), "the database");
  const lab::EarlierTests earlier = study::earlier_tests(o.db, o.earlier);
  const Interruption interruption;
  const auto stop = [&interruption] { return interruption.requested(); };
  lab::LineLoop loop;
  lab::RemoteRig rig(loop, rig_file, programme, stop);
  const WrittenFile file(o.record);
  study::StoredRecord record(o.record, rig.header());
  ProgressBar bar(rig.header().name);
  std::string db = o.db;
  const auto id = study::run_test(rig, {.reduction = {}, .stop = stop, .earlier = earlier}, db,
                                  {shown_on(bar)}, {.say = notify, .stop = stop});
  const std::string unwritten = record.write(rig, db, id);
  if (unwritten.empty()) file.is_there();
  print_tests(db, {id}, o.json);
  if (!unwritten.empty()) throw lab::WorkFailed(unwritten);
  throw_if_ended_early(rig.ending());
}

}  // namespace

Command run_command() {
  return {
      .name = "run",
      .purpose = "Run a test on the instruments of a rig",
      .description =
          {"Runs the stages, control loops, supervision and intervention of the virtual apparatus "
           "on the instruments of RIG.toml, over TCP and serial lines. The instruments are real "
           "ones, or those of `triax serve`. All of them are queried at the same time. A missing "
           "response becomes a missing value, and an event reports its cause. If a channel that "
           "the test needs is missing for 3 s, the rig goes to its safe state: crosshead locked, "
           "pressures kept. The same happens if triax itself was suspended for 3 s (Ctrl-Z, a "
           "paused machine). A shorter stall is reported as a gap.",
           "Every instrument is identified before the test begins and whenever it is connected "
           "again. Identity and calibration are stored in the record. If an instrument reports "
           "that its measurements are simulated, the test is marked as simulated.",
           "Ctrl-C stops the test in an orderly way: the drives stop, and the test is stored and "
           "assessed up to that point."},
      .diagnostics =
          {{"FILE:LINE: ...", "correct this line of the programme or of the rig file"},
           {"FILE: missing in the rig: ...",
            "add an instrument that measures or drives the missing quantity: every test needs it"},
           {"FILE: not all instruments responded; ...",
            "connect the instruments that are listed, or correct their links in the rig file"}},
      .examples =
          {{"triax run samples/programmes/csu_26.toml --rig samples/rigs/csu_26.toml",
            "run the programme on the rig that `triax serve samples/rigs/csu_26.toml` serves"}},
      .statuses = {{"3",
                    "the test is stored; the rig is in its safe state because an instrument, a "
                    "drive or triax failed"},
                   {"4", "the test is stored; the operator stopped it (Ctrl-C, SIGTERM)"},
                   {"5", "the test is stored; a stage did not reach its end (time limit, travel)"}},
      .set_up = [](CLI::App& app) -> std::function<void()> {
        const auto o = std::make_shared<RunOptions>();
        app.add_option("PROGRAMME.toml", o->programme, "programme file")->required()->type_name("");
        app.add_option("--rig", o->rig, "rig file")->required()->type_name("RIG.toml");
        app.add_option("--record", o->record, "also write the readings to a record")
            ->type_name("OUT.csv");
        add_db(app, o->db);
        add_earlier(app, o->earlier);
        add_json(app, o->json);
        return [o] { run_programme(*o); };
      }};
}

}  // namespace triax::src

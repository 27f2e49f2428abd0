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
    return fmt::format("{}; it is stored up to there: {}", what, ending.reason);
  };
  switch (ending.kind) {
    case Kind::completed:
      return;
    case Kind::safe_state:
      throw EndedEarly(EarlyEnd::failed_rig, stored("the test ended in the rig's safe state"));
    case Kind::aborted:
      throw EndedEarly(EarlyEnd::aborted, stored("the test was aborted by the operator"));
    case Kind::unfinished:
      throw EndedEarly(EarlyEnd::unfinished, stored("a stage of the test did not reach its end"));
  }
}

void run_programme(const RunOptions& o) {
  const lab::Programme programme = lab::load_programme(o.programme);
  const lab::RigFile rig_file = lab::load_rig_file(o.rig);
  refuse_overwriting("--record", o.record, programme.files, "what the programme is read from");
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
      .purpose = "run a programme on instruments, store and report the test",
      .description =
          {"The stages, control loops, supervision and guard of the virtual apparatus on the "
           "instruments of RIG.toml, over TCP and serial lines: real ones, or those of `triax "
           "serve`. All are asked at the same instant; what does not come is a missing cell, with "
           "an event that tells its cause. A channel that the test needs and that stays away for "
           "3 s leads to the safe state: crosshead locked, pressures held. The same happens after "
           "triax itself stood still for 3 s (Ctrl-Z, a paused machine); a shorter stall is "
           "reported as a gap.",
           "Every instrument says who it is before the test begins and when its link is taken up "
           "again; identity and calibration are kept in the record. Where an instrument says that "
           "what it measures is simulated, so does the test.",
           "Ctrl-C stops the test in an orderly way: the rig is brought to rest, the test is "
           "stored and judged as far as it went."},
      .diagnostics = {{"FILE:LINE: ...", "the programme or the rig's file is not valid there"},
                      {"FILE: the rig lacks ...",
                       "no instrument of the rig measures or drives what every test needs"},
                      {"FILE: not all instruments are there: ...",
                       "each that does not answer or is another one, and why"}},
      .examples = {{"triax run samples/programmes/csu_26.toml --rig samples/rigs/csu_26.toml",
                    "on the rig that `triax serve samples/rigs/csu_26.toml` puts on the wire"}},
      .statuses = {{"3",
                    "the test is stored; the rig is in its safe state: an instrument, a drive or "
                    "triax failed"},
                   {"4", "the test is stored; the operator ended it (Ctrl-C, SIGTERM)"},
                   {"5", "the test is stored; a stage did not reach its end (time limit, travel)"}},
      .set_up = [](CLI::App& app) -> std::function<void()> {
        const auto o = std::make_shared<RunOptions>();
        app.add_option("PROGRAMME.toml", o->programme, "programme file")->required()->type_name("");
        app.add_option("--rig", o->rig, "the rig's file")->required()->type_name("RIG.toml");
        app.add_option("--record", o->record, "also write the readings as a record")
            ->type_name("OUT.csv");
        add_db(app, o->db);
        add_earlier(app, o->earlier);
        add_json(app, o->json);
        return [o] { run_programme(*o); };
      }};
}

}  // namespace triax::src

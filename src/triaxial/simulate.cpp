// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/triaxial/simulate.hpp"

#include <fmt/format.h>

#include <memory>
#include <optional>

#include "lab/base/bad_input.hpp"
#include "lab/base/text.hpp"
#include "lab/programmes/programme_reader.hpp"
#include "lab/rig/simulated/virtual_rig.hpp"
#include "lab/rig/simulated/without_guard.hpp"
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
#include "src/triaxial/sweep_command.hpp"

namespace triax::src {
namespace {

struct SimulateOptions {
  std::string programme;
  std::optional<std::uint64_t> seed;
  std::string record;
  std::string db = "triax.db";
  double speed = 0;
  int jobs = 0;
  std::vector<std::string> sets, sweeps;
  bool json = false;
  std::vector<std::string> earlier;
};

std::vector<lab::TomlEdit> edits_of(const std::vector<std::string>& sets) {
  std::vector<lab::TomlEdit> edits;
  for (const auto& [key, value] : key_values(sets, "--set specimen.void_ratio=1.12"))
    edits.push_back({key == "seed" ? "test.seed" : key, value});
  return edits;
}

lab::Programme changed_programme(const SimulateOptions& o) {
  lab::Programme programme = lab::load_programme(o.programme, edits_of(o.sets));
  lab::name_after_changes(programme);
  return programme;
}

void run_test_of(const SimulateOptions& o) {
  const lab::Programme programme = changed_programme(o);
  refuse_overwriting("--record", o.record, programme.files, "what the programme is read from");
  refuse_overwriting("--record", o.record, database_files(o.db), "the database");
  refuse_overwriting("--db", o.db, programme.files, "what the programme is read from");
  const lab::EarlierTests earlier = study::earlier_tests(o.db, o.earlier);
  lab::VirtualRig rig(programme, o.seed);
  const WrittenFile file(o.record);
  study::StoredRecord record(o.record, rig.header());
  const Interruption interruption;
  ProgressBar bar(rig.header().name);
  const auto stop = [&interruption] { return interruption.requested(); };
  std::string db = o.db;
  const auto id = study::run_test(rig,
                                  {.reduction = {},
                                   .speed = o.speed,
                                   .stop = stop,
                                   .without_guard = lab::without_guard(programme, o.seed, stop),
                                   .earlier = earlier},
                                  db, {shown_on(bar)}, {.say = notify, .stop = stop});
  const std::string unwritten = record.write(rig, db, id);
  if (unwritten.empty()) file.is_there();
  print_tests(db, {id}, o.json);
  if (!unwritten.empty()) throw lab::WorkFailed(unwritten);
  if (interruption.requested())
    throw lab::WorkFailed("the test was aborted by the operator; it is stored up to there");
}

void run_simulate(const SimulateOptions& o) {
  if (o.sweeps.empty()) {
    if (o.jobs > 0) throw lab::BadInput("--jobs needs --sweep: a single test runs on one core");
    return run_test_of(o);
  }
  if (o.seed)
    throw lab::BadInput(
        fmt::format("--seed and --sweep exclude each other: write --sweep seed={}", *o.seed));
  if (!o.record.empty())
    throw lab::BadInput(
        "--record and --sweep exclude each other: the tests of a sweep are in the database");
  if (!o.earlier.empty())
    throw lab::BadInput("--earlier and --sweep exclude each other: it is for one test at a time");
  run_sweep_command({o.programme, edits_of(o.sets), o.sweeps, o.db, o.speed, o.jobs, o.json});
}

// The conversion to a number alone would take -1 for the largest seed there is.
std::string refusal_of_seed(const std::string& text) {
  const auto seed = lab::whole_text_as<std::uint64_t>(text);
  if (seed && *seed <= lab::kLargestSeed) return {};
  return fmt::format("'{}' is not a whole number from 0 to {}", text, lab::kLargestSeed);
}

}  // namespace

Command simulate_command() {
  return {
      .name = "simulate",
      .purpose = "run a programme on the virtual apparatus, store and report the test",
      .description =
          {"The specimen, its pore water, the frame, the pressure controllers and noisy "
           "transducers of limited resolution are simulated as the programme says; readings then "
           "are processed like real ones. The test is marked as simulated wherever it appears, "
           "and the report adds the true onset (model): when the specimen itself became unstable.",
           "The same programme and seed give the same readings, to the bit. --record also writes "
           "them as a logger would; replaying that file gives the same states and the same "
           "verdict.",
           "A programme may have a guard, which acts on what the alarm says; where it did, the "
           "test is run once more without it, and the report tells what was gained.",
           "--set changes keys of the programme for this run, as "
           "--set specimen.void_ratio=1.12; the name of the test and a warning say so. --seed "
           "overrides "
           "the seed of the programme and of --set.",
           "--sweep runs the programme with every combination of the values given for some of its "
           "keys, several tests at a time, and stores all of them. KEY is written as in the file: "
           "seed, specimen.void_ratio, rig.transducers.axial_force.noise_N, "
           "stages.4.axial_rate_mm_per_min (the fourth stage). VALUES are separated by commas; "
           "a range is FROM:TO:STEP (1:200:1, 1.0:1.2:0.02) or FROM:TO/COUNT (1.0:1.2/11). A test "
           "that fails is reported with its values, and the others continue. Results and their "
           "order "
           "do not depend on --jobs.",
           "Ctrl-C stops a test in an orderly way: it is stored and judged as far as it went, "
           "and its record is written. Of a sweep the completed tests are stored. Another Ctrl-C "
           "more than five seconds later kills the program."},
      .diagnostics = {{"FILE:LINE: ...", "the programme is not valid at this line"},
                      {"--sweep [KEY VALUE, ...]: ...",
                       "with these values the programme is not valid, or the test failed"}},
      .examples = {{"triax simulate samples/programmes/csu_26.toml", "test 26 of Table 2"},
                   {"triax simulate csu_26.toml --seed 7 --record csu_26.csv",
                    "other noise, and the record as a file"},
                   {"triax simulate csu_26.toml --set specimen.void_ratio=1.12",
                    "a denser or looser specimen"},
                   {"triax simulate csu_26.toml --speed 60", "an hour of test in a minute"},
                   {"triax simulate csu_26.toml --sweep seed=1:50:1 --sweep "
                    "specimen.void_ratio=1.05:1.15:0.05",
                    "150 tests; triax query sweep then gives eta at collapse by seed and void "
                    "ratio"}},
      .set_up = [](CLI::App& app) -> std::function<void()> {
        const auto o = std::make_shared<SimulateOptions>();
        app.add_option("PROGRAMME.toml", o->programme, "programme file")->required()->type_name("");
        app.add_option("--seed", o->seed, "seed of the noise; overrides the programme's")
            ->check(CLI::Validator(refusal_of_seed, ""))
            ->type_name("N");
        app.add_option("--set", o->sets,
                       "another value for a key of the programme; may be repeated")
            ->type_name("KEY=VALUE")
            ->allow_extra_args(false);
        app.add_option("--record", o->record, "also write the readings as a record")
            ->type_name("OUT.csv");
        app.add_option("--sweep", o->sweeps,
                       "run with each of these values; may be repeated for every combination")
            ->type_name("KEY=VALUES")
            ->allow_extra_args(false);
        add_jobs(app, o->jobs, "tests of a sweep that run at a time");
        add_db(app, o->db);
        add_speed(app, o->speed);
        add_earlier(app, o->earlier);
        add_json(app, o->json);
        return [o] { run_simulate(*o); };
      }};
}

}  // namespace triax::src

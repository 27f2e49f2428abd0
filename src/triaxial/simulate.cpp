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
  refuse_overwriting("--record", o.record, programme.files, "part of the programme");
  refuse_overwriting("--record", o.record, database_files(o.db), "the database");
  refuse_overwriting("--db", o.db, programme.files, "part of the programme");
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
    throw lab::WorkFailed(
        "the test was aborted by the operator; the test is stored up to its last reading");
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
        "--record and --sweep exclude each other: the tests of a sweep are stored in the database "
        "only");
  if (!o.earlier.empty())
    throw lab::BadInput("--earlier and --sweep exclude each other: --earlier is for one test");
  run_sweep_command({o.programme, edits_of(o.sets), o.sweeps, o.db, o.speed, o.jobs, o.json});
}

// The conversion to a number alone would take -1 for the largest seed there is.
std::string refusal_of_seed(const std::string& text) {
  const auto seed = lab::whole_text_as<std::uint64_t>(text);
  if (seed && *seed <= lab::kMaxSeed) return {};
  return fmt::format("'{}' is not an integer from 0 to {}", text, lab::kMaxSeed);
}

}  // namespace

Command simulate_command() {
  return {
      .name = "simulate",
      .purpose = "Simulate a test on the virtual apparatus",
      .description =
          {"Simulates the specimen, its pore water, the load frame, the pressure controllers and "
           "noisy transducers of limited resolution as PROGRAMME.toml describes them. The readings "
           "are processed like those of a real test. The test is marked as simulated everywhere, "
           "and the report adds the true onset (model): the time at which the specimen itself "
           "became unstable.",
           "The same programme and seed give bit-identical readings. --record also writes them in "
           "the format of a logger. Replaying that file gives the same states and the same "
           "assessment.",
           "A programme can have an intervention ([guard]), which acts at a warning level of the "
           "alarm. If it acted, the test is simulated again without it, and the report compares "
           "both.",
           "--set changes keys of the programme for this run, for example --set "
           "specimen.void_ratio=1.12. The change becomes part of the name of the test and is "
           "reported in a warning. --seed overrides the seed of the programme and of --set.",
           "--sweep runs the programme with every combination of the given values, several tests "
           "in parallel, and stores all of them. KEY is written as in the file: seed, "
           "specimen.void_ratio, rig.transducers.axial_force.noise_N, "
           "stages.4.axial_rate_mm_per_min (the fourth stage). VALUES are separated by commas. A "
           "range is FROM:TO:STEP (1:200:1, 1.0:1.2:0.02) or FROM:TO/COUNT (1.0:1.2/11). A test "
           "that fails is reported with its values, and the others continue. Results and their "
           "order do not depend on --jobs.",
           "Ctrl-C stops a test in an orderly way: the test is stored and assessed up to that "
           "point, and its record is written. For a sweep, the completed tests are stored. A "
           "second Ctrl-C more than five seconds later kills the program."},
      .diagnostics =
          {{"FILE:LINE: ...", "correct this line of the programme"},
           {"--sweep [KEY VALUE, ...]: ...",
            "correct these values: the programme is not valid with them, or the test failed"}},
      .examples = {{"triax simulate samples/programmes/csu_26.toml",
                    "simulate test 26 of Table 2 of Darve et al. (2007)"},
                   {"triax simulate csu_26.toml --seed 7 --record csu_26.csv",
                    "use another seed and write the record"},
                   {"triax simulate csu_26.toml --set specimen.void_ratio=1.12",
                    "change the void ratio of the specimen"},
                   {"triax simulate csu_26.toml --speed 60", "run one hour of test in one minute"},
                   {"triax simulate csu_26.toml --sweep seed=1:50:1 --sweep "
                    "specimen.void_ratio=1.05:1.15:0.05",
                    "simulate 150 tests; triax query sweep then lists eta at collapse by seed and "
                    "void ratio"}},
      .set_up = [](CLI::App& app) -> std::function<void()> {
        const auto o = std::make_shared<SimulateOptions>();
        app.add_option("PROGRAMME.toml", o->programme, "programme file")->required()->type_name("");
        app.add_option("--seed", o->seed, "seed of the noise [seed of the programme]")
            ->check(CLI::Validator(refusal_of_seed, ""))
            ->type_name("N");
        app.add_option("--set", o->sets, "set a key of the programme (repeatable)")
            ->type_name("KEY=VALUE")
            ->allow_extra_args(false);
        app.add_option("--record", o->record, "also write the readings to a record")
            ->type_name("OUT.csv");
        app.add_option("--sweep", o->sweeps,
                       "run with each of these values and with all combinations of several sweeps "
                       "(repeatable)")
            ->type_name("KEY=VALUES")
            ->allow_extra_args(false);
        add_jobs(app, o->jobs, "number of tests of a sweep that run in parallel");
        add_db(app, o->db);
        add_speed(app, o->speed);
        add_earlier(app, o->earlier);
        add_json(app, o->json);
        return [o] { run_simulate(*o); };
      }};
}

}  // namespace triax::src

#include "src/triaxial/simulate.hpp"
#include "src/output/progress_bar.hpp"

#include <fmt/format.h>

#include <memory>
#include <optional>

#include "lab/base/bad_input.hpp"
#include "lab/base/text.hpp"
#include "lab/programmes/programme_reader.hpp"
#include "lab/records/record_writer.hpp"
#include "lab/rig/virtual_rig.hpp"
#include "src/cli/interruption.hpp"
#include "src/cli/output_guard.hpp"
#include "src/cli/shared_options.hpp"
#include "src/study/triaxial/test_run.hpp"
#include "src/triaxial/print_tests.hpp"
#include "src/triaxial/sweep_command.hpp"

namespace triax::src {
namespace {

lab::SessionListener shown_on(ProgressBar& bar) {
  return {.progressed = [&bar](double fraction) { bar.show(fraction); }};
}

struct Options {
  std::string programme;
  std::optional<std::uint64_t> seed;
  std::string record;
  std::string db = "triax.db";
  double speed = 0;
  int jobs = 0;
  std::vector<std::string> sweeps;
  bool json = false;
};

void run_test_of(const Options& o) {
  const lab::Programme programme = lab::load_programme(o.programme);
  refuse_overwriting("--record", o.record, programme.files, "what the programme is read from");
  refuse_overwriting("--record", o.record, database_files(o.db), "the database");
  refuse_overwriting("--db", o.db, programme.files, "what the programme is read from");
  lab::VirtualRig rig(programme, o.seed);
  std::optional<lab::RecordWriter> writer;
  if (!o.record.empty()) writer.emplace(o.record, rig.header());
  const Interruption interruption;
  ProgressBar bar(rig.header().name);
  lab::SessionListeners also = {shown_on(bar)};
  if (writer)
    also.push_back({.scanned = [&writer](const lab::Reading& reading, const lab::State&) {
      writer->write(reading);
    }});
  const auto id = study::run_test(
      rig, {.reduction = {}, .speed = o.speed, .stop = [&] { return interruption.requested(); }},
      o.db, also);
  if (writer) writer->finish(rig.truth());
  print_tests(o.db, {id}, o.json);
  if (interruption.requested())
    throw lab::WorkFailed("the test was aborted by the operator; it is stored up to there");
}

void run(const Options& o) {
  if (o.sweeps.empty()) {
    if (o.jobs > 0)
      throw lab::BadInput("--jobs without --sweep: one test runs on one core; leave it out");
    return run_test_of(o);
  }
  if (o.seed)
    throw lab::BadInput(fmt::format("--seed beside --sweep: write --sweep seed={}", *o.seed));
  if (!o.record.empty())
    throw lab::BadInput(
        "--record beside --sweep: a sweep has many tests, all of them in the database");
  run_sweep_command({o.programme, o.sweeps, o.db, o.speed, o.jobs, o.json});
}

// The conversion to a number alone would take -1 for the largest seed there is.
std::string refusal_of_seed(const std::string& text) {
  const auto seed = lab::whole_text_as<std::uint64_t>(text);
  if (seed && *seed <= lab::kLargestSeed) return {};
  return fmt::format("'{}' is no whole number from 0 to {}", text, lab::kLargestSeed);
}

}  // namespace

Command simulate_command() {
  return {
      .name = "simulate",
      .purpose = "run a programme on the virtual apparatus, keep and report the test",
      .description =
          {"The specimen, its pore water, the frame, the pressure controllers and noisy "
           "transducers of limited resolution are simulated as the programme says; readings then "
           "go the way of real ones. The test is marked as simulated wherever it appears, and the "
           "report adds the truth: when the specimen itself lost sustainability.",
           "The same programme and seed give the same readings, to the bit. --record also writes "
           "them as a logger would; replaying that file gives the same states and the same "
           "verdict.",
           "--sweep runs the programme with every combination of the values given for some of its "
           "keys, several tests at a time, and stores all of them. KEY is written as in the file: "
           "seed, specimen.void_ratio, rig.transducers.axial_force.noise_N, "
           "stages.4.axial_rate_mm_per_min (the fourth stage). VALUES are separated by commas; "
           "1..200 is a range of whole numbers, 1.0:1.2:0.02 goes from 1.0 to 1.2 by 0.02. A test "
           "that fails is reported with its values, and the others go on. Results and their order "
           "do not depend on the number of threads.",
           "Ctrl-C breaks a test off in an orderly way: it is stored and judged as far as it went, "
           "and its record is written. Of a sweep the finished tests stay. A second Ctrl-C kills."},
      .diagnostics = {{"FILE:LINE: ...", "the programme could not be understood there"},
                      {"--sweep [KEY VALUE, ...]: ...",
                       "with these values the programme makes no sense or the test failed"}},
      .examples = {{"triax simulate samples/programmes/csu_26.toml", "test 26 of Table 2"},
                   {"triax simulate csu_26.toml --seed 7 --record csu_26.csv",
                    "other noise, and the record as a file"},
                   {"triax simulate csu_26.toml --speed 60", "an hour of test in a minute"},
                   {"triax simulate csu_26.toml --sweep seed=1..50 --sweep "
                    "specimen.void_ratio=1.05:1.15:0.05",
                    "150 tests; triax query sweep then gives eta at collapse by seed and void "
                    "ratio"}},
      .set_up = [](CLI::App& app) -> std::function<void()> {
        const auto o = std::make_shared<Options>();
        app.add_option("PROGRAMME.toml", o->programme, "programme file")->required()->type_name("");
        app.add_option("--seed", o->seed, "seed of the noise, instead of the programme's own")
            ->check(CLI::Validator(refusal_of_seed, ""))
            ->type_name("N");
        app.add_option("--record", o->record, "also write the readings as a record")
            ->type_name("OUT.csv");
        app.add_option("--sweep", o->sweeps,
                       "run with each of these values; may be repeated for every combination")
            ->type_name("KEY=VALUES")
            ->allow_extra_args(false);
        app.add_option("--jobs", o->jobs, "tests of a sweep that run at a time [all cores]")
            ->check(CLI::Range(1, 1024).description(""))
            ->type_name("N");
        add_db(app, o->db);
        add_speed(app, o->speed);
        add_json(app, o->json);
        return [o] { run(*o); };
      }};
}

}  // namespace triax::src

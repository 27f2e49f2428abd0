#include "src/commands/simulate.hpp"

#include <fmt/format.h>

#include <charconv>
#include <memory>
#include <optional>

#include "lab/programmes/programme_reader.hpp"
#include "lab/records/record_writer.hpp"
#include "lab/rig/virtual_rig.hpp"
#include "src/commands/output_guard.hpp"
#include "src/commands/shared_options.hpp"
#include "src/commands/test_run.hpp"

namespace triax::src {
namespace {

struct Options {
  std::string programme;
  std::optional<std::uint64_t> seed;
  std::string record;
  std::string db = "triax.db";
  double speed = 0;
  bool json = false;
};

void run(const Options& o) {
  const lab::Programme programme = lab::load_programme(o.programme);
  refuse_overwriting("--record", o.record, programme.files, "what the programme is read from");
  refuse_overwriting("--record", o.record, database_files(o.db), "the database");
  refuse_overwriting("--db", o.db, programme.files, "what the programme is read from");
  lab::VirtualRig rig(programme, o.seed);
  std::optional<lab::RecordWriter> writer;
  if (!o.record.empty()) writer.emplace(o.record, rig.header());
  const auto id = run_test(
      rig, {.reduction = {}, .speed = o.speed}, o.db, rig.header().name,
      [&](lab::Session& session) {
        if (!writer) return;
        QObject::connect(&session, &lab::Session::scanned,
                         [&writer](const lab::Reading& reading) { writer->write(reading); });
      });
  if (writer) writer->finish(rig.truth());
  print_tests(o.db, {id}, o.json);
}

// The conversion to a number alone would take -1 for the largest seed there is.
std::string refusal_of_seed(const std::string& text) {
  std::uint64_t seed = 0;
  const char* const end = text.data() + text.size();
  const auto [stopped, error] = std::from_chars(text.data(), end, seed);
  if (error == std::errc() && stopped == end && seed <= lab::kLargestSeed) return {};
  return fmt::format("'{}' is no whole number from 0 to {}", text, lab::kLargestSeed);
}

}  // namespace

Command simulate_command() {
  return {
      .name = "simulate",
      .purpose = "run a programme on the virtual apparatus, keep and report the test",
      .description =
          {"The specimen, its pore water, the frame, the pressure controllers and noisy "
           "transducers of "
           "limited resolution are simulated as the programme says; readings then go the way of "
           "real "
           "ones. The test is marked as simulated wherever it appears, and the report adds the "
           "truth: "
           "when the specimen itself lost sustainability.",
           "The same programme and seed give the same readings, to the bit. --record also writes "
           "them "
           "as a logger would; replaying that file gives the same states and the same verdict."},
      .diagnostics = {{"FILE:LINE: ...", "the programme could not be understood there"}},
      .examples = {{"triax simulate samples/programmes/csu_26.toml", "test 26 of Table 2"},
                   {"triax simulate csu_26.toml --seed 7 --record csu_26.csv",
                    "other noise, and the record as a file"},
                   {"triax simulate csu_26.toml --speed 60", "an hour of test in a minute"}},
      .set_up = [](CLI::App& app) -> std::function<void()> {
        const auto o = std::make_shared<Options>();
        app.add_option("PROGRAMME.toml", o->programme, "programme file")->required()->type_name("");
        app.add_option("--seed", o->seed, "seed of the noise, instead of the programme's own")
            ->check(CLI::Validator(refusal_of_seed, ""))
            ->type_name("N");
        app.add_option("--record", o->record, "also write the readings as a record")
            ->type_name("OUT.csv");
        add_db(app, o->db);
        add_speed(app, o->speed);
        add_json(app, o->json);
        return [o] { run(*o); };
      }};
}

}  // namespace triax::src

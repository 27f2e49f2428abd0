// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/triaxial/replay.hpp"

#include <fmt/format.h>

#include <cstdio>
#include <filesystem>
#include <map>
#include <memory>

#include "lab/base/bad_input.hpp"
#include "lab/reduction/reduction.hpp"
#include "lab/rig/otherwise.hpp"
#include "lab/rig/recorded.hpp"
#include "src/cli/interruption.hpp"
#include "src/cli/output_guard.hpp"
#include "src/cli/shared_options.hpp"
#include "src/output/notice.hpp"
#include "src/output/progress_bar.hpp"
#include "src/output/table.hpp"
#include "src/output/terminal.hpp"
#include "src/reference/reference_files.hpp"
#include "src/study/triaxial/earlier_tests.hpp"
#include "src/study/triaxial/test_run.hpp"
#include "src/triaxial/print_replayed.hpp"
#include "src/triaxial/shown_on.hpp"

namespace triax::src {
namespace {

struct ReplayOptions {
  std::vector<std::string> records;
  std::string dialect;
  std::string sheet;
  std::vector<std::string> sets;
  lab::MembraneCorrection membrane = lab::MembraneCorrection::none;
  std::string db = "triax.db";
  double speed = 0;
  bool json = false;
  bool live = false;
  std::vector<std::string> earlier;
};

/// What went wrong with single records; told at once, and counted for the end.
class BadRecords {
 public:
  explicit BadRecords(std::size_t records) : records_(records) {}

  /// The only record of a call fails as any command does.
  void add(const lab::BadInput& error) {
    if (records_ == 1) throw error;
    ++bad_;
    std::fprintf(stderr, "%s %s\n", alarming("triax:", stderr).c_str(),
                 on_one_line(error.what()).c_str());
  }
  void finish() const {
    if (bad_ > 0)
      throw lab::BadInput(
          fmt::format("{} of {} records could not be read (see above)", bad_, records_));
  }

 private:
  std::size_t records_, bad_ = 0;
};

/// Ctrl-C or SIGTERM amid a record.
struct Stopped : lab::WorkFailed {
  Stopped()
      : WorkFailed(
            "stopped by the operator; this record is stored as interrupted, the records after it "
            "were not read") {}
};

/// A record that was looked at: opened, so that whatever can be seen in its head is told before the
/// first has run for minutes. Beyond the first hundred files are closed again.
struct Looked {
  std::string path;
  std::unique_ptr<lab::RecordedRig> rig;
};

std::vector<Looked> look_at_all(const ReplayOptions& o, const lab::RecordOptions& options,
                                const lab::ReductionOptions& reduction, ReferenceFiles& references,
                                BadRecords& bad) {
  constexpr std::size_t kMostOpen = 100;
  std::vector<Looked> good;
  for (const auto& path : o.records) {
    try {
      if (!std::filesystem::exists(path)) throw lab::BadInput(path, 0, "file does not exist");
      if (o.dialect.empty() && references.take(path)) continue;
      auto rig = lab::open_record(path, options);
      const lab::Reduction can_be_reduced(rig->header(), reduction);
      good.push_back({path, good.size() < kMostOpen ? std::move(rig) : nullptr});
    } catch (const lab::BadInput& error) {
      bad.add(error);
    }
  }
  return good;
}

void run_replay(const ReplayOptions& o) {
  const lab::RecordOptions record{
      .dialect = o.dialect, .sheet = o.sheet, .sets = key_values(o.sets, "specimen.height_mm=140")};
  const lab::ReductionOptions reduction{.membrane = o.membrane};
  refuse_overwriting("--db", o.db, o.records, "a record that is read");
  BadRecords bad(o.records.size());
  const lab::EarlierTests earlier = study::earlier_tests(o.db, o.earlier);
  std::vector<std::int64_t> ids;
  ReferenceFiles references;
  std::vector<Looked> records = look_at_all(o, record, reduction, references, bad);
  references.store(o.db);
  std::string db = o.db;
  const Interruption interruption;
  // Thrown through the session: what was read stays, marked as interrupted.
  const auto stop = [&interruption]() -> bool {
    if (interruption.requested()) throw Stopped();
    return false;
  };
  bool stopped = false;
  for (Looked& one : records) {
    try {
      const auto rig = one.rig ? std::move(one.rig) : lab::open_record(one.path, record);
      ProgressBar bar(std::filesystem::path(one.path).filename().string());
      const auto otherwise = [&] {
        return lab::judge_otherwise(rig->header(), reduction, [&](const lab::Guess::Said& said) {
          lab::RecordOptions other = record;
          other.sets.emplace_back(said.key, said.value);
          return lab::open_record(one.path, other);
        });
      };
      ids.push_back(study::run_test(*rig,
                                    {.reduction = reduction,
                                     .speed = o.speed,
                                     .stop = stop,
                                     .otherwise = otherwise,
                                     .earlier = earlier},
                                    db, {shown_on(bar)}, {.say = notify, .stop = [&interruption] {
                                                            return interruption.requested();
                                                          }}));
    } catch (const lab::BadInput& error) {
      bad.add(error);
    } catch (const Stopped&) {
      stopped = true;
      break;
    }
  }
  print_replayed(db, ids, references, o.json, o.live);
  if (stopped) throw Stopped();
  bad.finish();
}

}  // namespace

Command replay_command() {
  return {
      .name = "replay",
      .purpose = "Replay recorded tests: reduce, assess and store them",
      .description = {"Reads records in the formats of loggers: the CSV format of triax, GDSLab "
                      ".gds, the Karlsruhe tables and others. The dialect is recognised from the "
                      "content. --dialect names a dialect or the file that describes a new one. "
                      "Readings pass one at a time through data reduction and the collapse monitor "
                      "into the database, and the report is read from the database.",
                      "Use --set to give values that the file lacks: specimen.height_mm, "
                      "specimen.diameter_mm, specimen.void_ratio, "
                      "specimen.limit_friction_angle_deg, stages.N.role and others.",
                      "--live lists, reading by reading, what was reported during the test: "
                      "events, the forecast onset, the distance and time left until the onset, "
                      "and how the forecast compares with the result.",
                      "An AGS4 file contains results of triaxial tests but no readings. The "
                      "results are stored as reference values, which `triax query "
                      "reference_results` lists. Reading the same file again replaces them."},
      .diagnostics = {{"... the height of the specimen is missing ...",
                       "give --set specimen.height_mm=..."},
                      {"... AGS4 without a triaxial result ...",
                       "use a file with rows in one of the groups TREG, TRET, TRIG and TRIT"},
                      {"FILE:LINE: ...",
                       "correct this line; nothing of this file is stored. Other records are "
                       "stored and reported, and the exit status is 2"}},
      .examples =
          {{"triax replay test.csv", "replay a record in the format of triax"},
           {"triax replay delivery.ags", "store results of an AGS4 file as reference values"},
           {"triax replay test.csv --live", "list what was reported during the test, and when"},
           {"triax replay *.gds --json", "replay several files and print one JSON document"},
           {"triax replay raw.csv --set specimen.height_mm=140 --set specimen.diameter_mm=70",
            "give the dimensions that the file lacks"},
           {"triax replay lab.txt --dialect my_lab.toml", "read the files of your own logger"}},
      .set_up = [](CLI::App& app) -> std::function<void()> {
        const auto o = std::make_shared<ReplayOptions>();
        app.add_option("RECORD", o->records, "record files")->required()->type_name("");
        app.add_option("--dialect", o->dialect,
                       "dialect of the records: a name, or a file that describes it [recognised "
                       "from the content]")
            ->type_name("NAME|FILE.toml");
        app.add_option("--sheet", o->sheet,
                       "worksheet to read from a workbook [first that is recognised]")
            ->type_name("NAME");
        app.add_option("--set", o->sets,
                       "value that the file lacks or has wrong, such as specimen.height_mm=140 "
                       "(repeatable)")
            ->type_name("KEY=VALUE")
            ->allow_extra_args(false);
        const std::map<std::string, lab::MembraneCorrection> membranes = {
            {"none", lab::MembraneCorrection::none},
            {"astm", lab::MembraneCorrection::astm},
            {"iso", lab::MembraneCorrection::iso}};
        app.add_option("--membrane", o->membrane,
                       "membrane correction: astm (D4767) or iso (17892-9) [none]")
            ->transform(CLI::CheckedTransformer(membranes).description(""))
            ->type_name("none|astm|iso");
        add_db(app, o->db);
        add_speed(app, o->speed);
        add_live(app, o->live);
        add_earlier(app, o->earlier);
        add_json(app, o->json);
        return [o] { run_replay(*o); };
      }};
}

}  // namespace triax::src

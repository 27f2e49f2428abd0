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
            "stopped by the operator; what was read of this record is stored as interrupted, "
            "records behind it were not read") {}
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
      if (!std::filesystem::exists(path)) throw lab::BadInput(path, 0, "no such file");
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
      .purpose = "reduce recorded tests, compute their second-order work, store and report them",
      .description =
          {"Reads records as loggers write them: triax's own CSV, GDSLab .gds, the Karlsruhe "
           "tables and others. The dialect is recognised from the content; --dialect names one or "
           "gives the description of a new one. Readings go one at a time through reduction and "
           "collapse monitor into the database; the report is then read back from there.",
           "What a file does not hold is given with --set: specimen.height_mm, "
           "specimen.diameter_mm, "
           "specimen.void_ratio, specimen.limit_friction_angle_deg, stages.N.role and so on.",
           "With --live it tells, reading by reading, what would have been said while the test "
           "ran: "
           "events, the onset as it was forecast, what was left until then, and how that compares "
           "with the result.",
           "An AGS4 file has no readings of triaxial tests but their results: these are stored as "
           "reference values, which `triax query reference_results` lists. The same file read "
           "again replaces them."},
      .diagnostics =
          {{"... does not say the height of the specimen ...", "give --set specimen.height_mm=..."},
           {"... AGS4 without a triaxial result ...",
            "the file has none of the groups TREG, TRET, TRIG and TRIT, or no row in them"},
           {"FILE:LINE: ...",
            "the file is not valid at this line; nothing of it is stored. Of several "
            "records the others are stored and reported, and the status at the end is 2"}},
      .examples =
          {{"triax replay test.csv", "a record in triax's own form"},
           {"triax replay delivery.ags", "results of AGS4, as reference values"},
           {"triax replay test.csv --live", "what would have been said when"},
           {"triax replay *.gds --json", "several files, as one JSON document"},
           {"triax replay raw.csv --set specimen.height_mm=140 --set specimen.diameter_mm=70",
            "the file lacks the specimen"},
           {"triax replay lab.txt --dialect my_lab.toml", "your own logger"}},
      .set_up = [](CLI::App& app) -> std::function<void()> {
        const auto o = std::make_shared<ReplayOptions>();
        app.add_option("RECORD", o->records, "record files")->required()->type_name("");
        app.add_option("--dialect", o->dialect, "name of a dialect, or file that describes one")
            ->type_name("NAME|FILE.toml");
        app.add_option("--sheet", o->sheet,
                       "sheet of a workbook; the first that is recognised if not given")
            ->type_name("NAME");
        app.add_option("--set", o->sets,
                       "what the file does not hold, or holds wrongly; may be repeated")
            ->type_name("KEY=VALUE")
            ->allow_extra_args(false);
        const std::map<std::string, lab::MembraneCorrection> membranes = {
            {"none", lab::MembraneCorrection::none},
            {"astm", lab::MembraneCorrection::astm},
            {"iso", lab::MembraneCorrection::iso}};
        app.add_option("--membrane", o->membrane,
                       "membrane correction: none, astm (D4767) or iso (17892-9) [none]")
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

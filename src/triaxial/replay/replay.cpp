// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/triaxial/replay/replay.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <filesystem>
#include <iterator>
#include <map>
#include <memory>
#include <system_error>
#include <thread>

#include "lab/base/bad_input.hpp"
#include "lab/records/dialect_memory.hpp"
#include "lab/records/stated/job_file.hpp"
#include "lab/reduction/reduction.hpp"
#include "src/cli/interruption.hpp"
#include "src/cli/output_guard.hpp"
#include "src/cli/shared_options.hpp"
#include "src/output/notice.hpp"
#include "src/output/output.hpp"
#include "src/output/table.hpp"
#include "src/output/terminal.hpp"
#include "src/reference/reference_files.hpp"
#include "src/study/triaxial/earlier_tests.hpp"
#include "src/triaxial/replay/answer_input.hpp"
#include "src/triaxial/replay/folder_replay.hpp"
#include "src/triaxial/replay/folder_watch.hpp"
#include "src/triaxial/replay/interactive.hpp"
#include "src/triaxial/replay/print_replayed.hpp"
#include "src/triaxial/replay/propose.hpp"
#include "src/triaxial/replay/record_replay.hpp"

namespace triax::src {
namespace {

namespace fs = std::filesystem;

struct ReplayOptions {
  std::vector<std::string> records;
  std::string dialect;
  std::string sheet;
  std::string job;
  std::vector<std::string> sets;
  lab::MembraneCorrection membrane = lab::MembraneCorrection::none;
  std::string db = "triax.db";
  double speed = 0;
  bool json = false;
  bool live = false;
  bool watch = false;
  bool propose = false;
  bool interactive = false;
  ProposalFormat format = ProposalFormat::dialect;
  std::vector<std::string> earlier;
};

/// A sentence about one record on standard error.
void report_error(const std::string& sentence) {
  std::fprintf(stderr, "%s %s\n", alarming("triax:", stderr).c_str(),
               on_one_line(sentence).c_str());
}

/// Faults of single records: reported at once, and counted for the end.
class BadRecords {
 public:
  explicit BadRecords(std::size_t records) : records_(records) {}

  /// A file holds more records than one.
  void expect_more(std::size_t records) { records_ += records; }
  /// The only record of a call fails as any command does.
  void add(const lab::BadInput& error) {
    if (records_ == 1) throw error;
    ++bad_;
    report_error(error.what());
  }
  void finish() const {
    if (bad_ > 0)
      throw lab::BadInput(
          fmt::format("{} of {} records could not be read (see above)", bad_, records_));
  }

 private:
  std::size_t records_, bad_ = 0;
};

/// A record whose head was read, so that whatever can be seen in it is reported before the first
/// record has run for minutes. Beyond the first hundred, files are closed again.
struct OpenedRecord {
  std::string path;
  TestOfFile test;
  std::unique_ptr<lab::RecordedRig> rig;
};

void open_one(const std::string& path, const TestOfFile& test, const ReplayRequest& request,
              std::vector<OpenedRecord>& good, BadRecords& bad) {
  constexpr std::size_t kMaxOpen = 100;
  try {
    auto rig = open_to_replay(request, path, test);
    good.push_back({path, test, good.size() < kMaxOpen ? std::move(rig) : nullptr});
  } catch (const lab::BadInput& error) {
    bad.add(error);
  }
}

void open_tests(const std::string& path, const std::vector<TestOfFile>& tests,
                const ReplayRequest& request, std::vector<OpenedRecord>& good, BadRecords& bad) {
  bad.expect_more(tests.size() - 1);
  for (const TestOfFile& test : tests) open_one(path, test, request, good, bad);
}

std::vector<OpenedRecord> open_all(const ReplayOptions& o, const ReplayRequest& request,
                                   ReferenceFiles& references, BadRecords& bad) {
  std::vector<OpenedRecord> good;
  for (const auto& path : o.records) {
    try {
      if (!fs::exists(path)) throw lab::BadInput(path, 0, "file does not exist");
      if (o.dialect.empty() && references.take(path)) continue;
      const auto tests = study::tests_of(request.tests_in(path)(lab::Extent::sample));
      open_tests(path, tests, request, good, bad);
    } catch (const lab::BadInput& error) {
      bad.add(error);
    }
  }
  return good;
}

void replay_files(const ReplayOptions& o, const ReplayRequest& request) {
  BadRecords bad(o.records.size());
  std::vector<std::int64_t> ids;
  ReferenceFiles references;
  std::vector<OpenedRecord> records = open_all(o, request, references, bad);
  references.store(o.db);
  std::string db = o.db;
  const Interruption interruption;
  bool stopped = false;
  // Its tests, if it turns out that the record has several.
  const auto replay_one = [&](OpenedRecord one) -> std::vector<OpenedRecord> {
    const auto rig = one.rig ? std::move(one.rig)
                             : lab::open_record(one.path, request.options_for(one.path, one.test));
    try {
      ids.push_back(replay_record(request, one.path, *rig, db, interruption, one.test));
    } catch (const lab::SeveralTests& error) {
      if (one.test.number > 0) throw;
      std::vector<OpenedRecord> parts;
      open_tests(one.path, study::tests_in_all_rows(request.tests_in(one.path), error), request,
                 parts, bad);
      return parts;
    }
    return {};
  };
  for (std::size_t next = 0; next < records.size(); ++next) {
    try {
      auto parts = replay_one(std::move(records[next]));
      records.insert(records.begin() + static_cast<std::ptrdiff_t>(next) + 1,
                     std::make_move_iterator(parts.begin()), std::make_move_iterator(parts.end()));
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

/// The files of the folders among the records, and the other records as they are.
std::vector<std::string> records_of(const ReplayOptions& o) {
  std::vector<std::string> all;
  for (const std::string& record : o.records) {
    if (!fs::is_directory(record)) {
      all.push_back(record);
      continue;
    }
    for (const std::string& file : files_of_folder(record)) {
      std::error_code none;
      if (!fs::equivalent(file, o.db, none)) all.push_back(file);
    }
  }
  return all;
}

bool is_problem(const FileOutcome& outcome) {
  using enum FileOutcome::Kind;
  return outcome.kind == no_record || outcome.kind == failed || outcome.kind == delayed;
}

/// Status 2 where a file that looks like a record failed, or where there was no record at all.
void finish_folder(const std::vector<FileOutcome>& outcomes) {
  const auto count = [&](FileOutcome::Kind kind) {
    return std::ranges::count(outcomes, kind, &FileOutcome::kind);
  };
  using enum FileOutcome::Kind;
  if (count(delayed) > 0)
    throw lab::WorkFailed(fmt::format("{} of {} files could not be stored (see above)",
                                      count(delayed), outcomes.size()));
  if (count(failed) > 0)
    throw lab::BadInput(fmt::format("{} of {} files could not be read (see above)", count(failed),
                                    outcomes.size()));
  if (count(no_record) == static_cast<std::ptrdiff_t>(outcomes.size()))
    throw lab::BadInput("no record found");
}

void replay_folder(const ReplayOptions& o, const ReplayRequest& request) {
  const Interruption interruption;
  FolderReplay replay(request, o.db);
  std::vector<FileOutcome> outcomes;
  const auto finish = [&] {
    if (o.json || o.live)
      print_replayed(replay.db(), replay.tests(), replay.references(), o.json, o.live);
    if (!o.json) print(outcome_table(outcomes));
  };
  for (const std::string& path : records_of(o)) {
    try {
      outcomes.push_back(replay.read(path, interruption));
    } catch (const Stopped&) {
      finish();
      throw;
    }
    if (is_problem(outcomes.back())) report_error(outcome_line(outcomes.back()));
  }
  finish();
  finish_folder(outcomes);
}

/// The lines of a watched folder: what became of each file as it came.
void print_outcomes(const std::vector<std::string>& settled, FolderWatch& watch,
                    FolderReplay& replay, const Interruption& interruption) {
  constexpr std::chrono::seconds kUntilNextTry{10};
  for (const std::string& path : settled) {
    if (interruption.requested()) return;
    const FileOutcome outcome = replay.read(path, interruption);
    if (outcome.kind == FileOutcome::Kind::delayed)
      watch.repeat(path, FolderWatch::Clock::now(), kUntilNextTry);
    if (outcome.kind != FileOutcome::Kind::no_record || fs::exists(path))
      print(outcome_line(outcome) + '\n');
  }
}

void watch_folder(const ReplayOptions& o, const ReplayRequest& request) {
  constexpr std::chrono::milliseconds kLook{250};
  const Interruption interruption;
  FolderReplay replay(request, o.db);
  FolderWatch watch([&o] { return records_of(o); });
  print(fmt::format("watching {}; Ctrl-C ends\n", on_one_line(o.records.front())));
  while (!interruption.requested()) {
    try {
      print_outcomes(watch.settled(FolderWatch::Clock::now()), watch, replay, interruption);
    } catch (const lab::BadInput& error) {  // the folder cannot be read now
      notify(error.what());
    } catch (const Stopped&) {
      print("stopped by the operator; the last record is stored as interrupted\n");
      return;
    }
    std::this_thread::sleep_for(kLook);
  }
}

ReplayRequest request_of(const ReplayOptions& o) {
  ReplayRequest request;
  request.record = {.dialect = o.dialect,
                    .dialect_folder = lab::DialectMemory::folder_of(o.db),
                    .sheet = o.sheet,
                    .job = {},
                    .sets = key_values(o.sets, "specimen.height_mm=140")};
  if (!o.job.empty()) request.job = lab::JobFile::read(o.job);
  request.reduction = {.membrane = o.membrane};
  request.speed = o.speed;
  request.earlier = study::earlier_tests(o.db, o.earlier);
  return request;
}

void propose(const ReplayOptions& o, const ReplayRequest& request) {
  if (o.records.size() != 1 || fs::is_directory(o.records.front()))
    throw lab::BadInput("--propose needs one file: triax replay FILE --propose");
  const std::string& path = o.records.front();
  print(proposal_of(path, request.options_for(path), o.format));
}

/// The options that the user confirmed. Nothing is stored if the user quits.
lab::RecordOptions confirmed_options(const ReplayOptions& o, const ReplayRequest& request) {
  if (o.records.size() != 1 || fs::is_directory(o.records.front()))
    throw lab::BadInput("--interactive needs one file: triax replay FILE --interactive");
  if (!o.dialect.empty())
    throw lab::BadInput("--interactive finds the columns itself; leave out --dialect");
  if (o.json) throw lab::BadInput("--interactive prints questions; leave out --format json");
  const Interruption interruption;
  AnswerInput input(interruption);
  const Conversation user{.read_line =
                              [&] {
                                auto line = input.next();
                                if (!input.is_terminal())
                                  print(on_one_line(line.value_or("")) + "\n");
                                return line;
                              },
                          .show = [](std::string_view text) { print(text); }};
  const std::string& path = o.records.front();
  auto confirmed = confirm_import(path, request.options_for(path), user);
  if (!confirmed) throw lab::BadInput(path, 0, "not confirmed: nothing was read or stored");
  return *confirmed;
}

void run_replay(const ReplayOptions& o) {
  const bool has_folder =
      std::ranges::any_of(o.records, [](const auto& record) { return fs::is_directory(record); });
  if (o.watch && (o.records.size() != 1 || !has_folder))
    throw lab::BadInput("--watch needs one folder: triax replay FOLDER --watch");
  if (o.watch && (o.json || o.live))
    throw lab::BadInput("--watch prints one line for each file; leave out --json and --live");
  refuse_overwriting("--db", o.db, o.records, "a record that is read");
  ReplayRequest request = request_of(o);
  if (o.propose) return propose(o, request);
  if (o.interactive) request.record.dialect_text = confirmed_options(o, request).dialect_text;
  if (o.watch) return watch_folder(o, request);
  for (const std::string& sentence : request.job.unmatched(records_of(o))) notify(sentence);
  if (has_folder) return replay_folder(o, request);
  replay_files(o, request);
}

}  // namespace

Command replay_command() {
  return {
      .name = "replay",
      .purpose = "Replay recorded tests: reduce, assess and store them",
      .description =
          {"Reads records in the formats of loggers: the CSV format of triax, GDSLab "
           ".gds, the Karlsruhe tables and others. The dialect is recognised from the "
           "content. --dialect names a dialect or the file that describes a new one. "
           "Readings pass one at a time through data reduction and the collapse monitor "
           "into the database, and the report is read from the database.",
           "Use --set to give values that the file lacks: specimen.height_mm, "
           "specimen.diameter_mm, specimen.void_ratio, "
           "specimen.limit_friction_angle_deg, specimen.cohesion_kPa, "
           "test.cell_pressure_kPa, stages.N.role, labels.borehole and "
           "others. --job names a TOML file with such values for many records: tables "
           "[test], [specimen], [stages.1] and [labels], and sections [[file]] with a "
           "pattern match = \"ICU-*.csv\" for some of them. --set is stronger than the "
           "job file, which is stronger than the record.",
           "--interactive shows the first values of each column with the quantity, unit and sign "
           "as understood, asks what the file does not decide (unit of a time, order of day and "
           "month, height, diameter, held pressures), shows what is read with the answers, and "
           "stores the test if you confirm it. Answer s saves the answers beside the record as a "
           "dialect. Answers can come from a pipe.",
           "For a folder, all files in it are read, by name. Hidden files, databases, .toml "
           "files and folders in it are left out. A file that is stored already, byte by "
           "byte, is not read again. A table gives the outcome and the test of each "
           "file. The exit status is 2 if a file failed that looks like a record: three "
           "rows of numbers, or a workbook. Other files are listed with the reason.",
           "--watch waits for new and changed files in a folder, reads each when it has "
           "not changed for 2 s, prints one line for it, and ends with Ctrl-C.",
           "--live lists, reading by reading, what was reported during the test: "
           "events, the forecast onset, the distance and time left until the onset, "
           "and how the forecast compares with the result.",
           "A DIGGS file (XML, version 2.6) is read by the names of its elements. Each "
           "triaxial test in it, and each trial of a test, is a record. Readings are "
           "shearing increments, or a table of results. A test with results but "
           "without readings is an error; the other tests are stored.",
           "An AGS4 file contains results of triaxial tests but no readings. The "
           "results are stored as reference values, which `triax query "
           "reference_results` lists. Reading the same file again replaces them."},
      .diagnostics = {{"... the height of the specimen is missing ...",
                       "give --set specimen.height_mm=..."},
                      {"... channels are missing: ... cell_pressure_kPa ...",
                       "if the cell pressure was held, give --set test.cell_pressure_kPa=..."},
                      {"... a test in total stresses needs no effective stress ...",
                       "give --set test.programme=UU, or UC if it is unconfined"},
                      {"... AGS4 without a triaxial result ...",
                       "use a file with rows in one of the groups TREG, TRET, TRIG and TRIT"},
                      {"FILE: not confirmed: nothing was read or stored",
                       "answer y or s to the last question of --interactive"},
                      {"FILE:LINE: triaxial test ... has no readings, only results; ...",
                       "request the readings: elements shearingIncrement, or a table of results"},
                      {"FILE:LINE: ...",
                       "correct this line; nothing of this file is stored. Other records are "
                       "stored and reported, and the exit status is 2"}},
      .examples =
          {{"triax replay test.csv", "replay a record in the format of triax"},
           {"triax replay tests.xml", "replay all triaxial tests of a DIGGS file"},
           {"triax replay delivery.ags", "store results of an AGS4 file as reference values"},
           {"triax replay test.csv --live", "list what was reported during the test, and when"},
           {"triax replay *.gds --json", "replay several files and print one JSON document"},
           {"triax replay raw.csv --set specimen.height_mm=140 --set specimen.diameter_mm=70",
            "give the dimensions that the file lacks"},
           {"triax replay records/ --job job.toml",
            "replay the files of a folder with common values"},
           {"triax replay records/ --watch", "replay files as a logger writes them"},
           {"triax replay lab.txt --interactive", "answer questions about an unknown table"},
           {"triax replay lab.txt --dialect my_lab.toml", "read the files of your own logger"}},
      .set_up = [](CLI::App& app) -> std::function<void()> {
        const auto o = std::make_shared<ReplayOptions>();
        app.add_option("RECORD", o->records, "record files, or folders with such files")
            ->required()
            ->type_name("");
        app.add_option("--dialect", o->dialect,
                       "dialect of the records: a name, or a file that describes it [recognised "
                       "from the content]")
            ->type_name("NAME|FILE.toml");
        app.add_option("--sheet", o->sheet,
                       "worksheet to read from a workbook [the first with readings, and those with "
                       "its headings]")
            ->type_name("NAME");
        app.add_option("--set", o->sets,
                       "value that the file lacks or has wrong, such as specimen.height_mm=140 "
                       "(repeatable)")
            ->type_name("KEY=VALUE")
            ->allow_extra_args(false);
        app.add_option("--job", o->job, "TOML file with values for many records")
            ->type_name("FILE.toml");
        app.add_flag("--watch", o->watch, "wait for new and changed files in a folder");
        app.add_flag("--propose", o->propose,
                     "print what is understood of a table as a dialect, with evidence and "
                     "questions, and store nothing");
        auto* const interactive = app.add_flag(
            "--interactive", o->interactive,
            "show what is understood of a table, ask what is missing, and read it as confirmed");
        for (const char* other : {"--propose", "--watch"})
          interactive->excludes(app.get_option(other));
        const std::map<std::string, ProposalFormat> formats = {
            {"dialect", ProposalFormat::dialect}, {"expected", ProposalFormat::meaning}};
        app.add_option("--proposal-format", o->format,
                       "of --propose: a dialect, or the columns in canonical units [dialect]")
            ->transform(CLI::CheckedTransformer(formats).description(""))
            ->type_name("dialect|expected");
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

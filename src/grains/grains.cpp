// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/grains/grains.hpp"

#include <fmt/format.h>

#include <memory>

#include "lab/base/bad_input.hpp"
#include "lab/grains/grain_programme_reader.hpp"
#include "src/cli/interruption.hpp"
#include "src/cli/output_guard.hpp"
#include "src/cli/shared_options.hpp"
#include "src/grains/grain_data.hpp"
#include "src/grains/grain_figures.hpp"
#include "src/grains/grain_json.hpp"
#include "src/grains/grain_outputs.hpp"
#include "src/grains/grain_text.hpp"
#include "src/output/notice.hpp"
#include "src/output/output.hpp"
#include "src/output/task_progress.hpp"
#include "src/study/grains/grain_pieces.hpp"
#include "src/study/grains/grain_run.hpp"

namespace triax::src {
namespace {

struct Options {
  std::string programme;
  std::vector<std::string> sets;
  std::string piece;
  std::vector<std::string> merge;
  std::string db = "triax.db";
  std::string output;  // folder; with `piece` a file
  std::string prefix() const { return prefix_in(output, "grains"); }
  int jobs = 0;
  bool json = false;
};

lab::GrainProgramme programme_of(const Options& o) {
  std::vector<lab::TomlEdit> edits;
  for (const auto& [key, value] : key_values(o.sets, "--set specimen.seed=7"))
    edits.push_back({key, value});
  return lab::load_grain_programme(o.programme, edits);
}

void check_piece(const Options& o) {
  if (o.output.empty()) throw lab::BadInput("--piece needs --output FILE");
  if (o.json)
    throw lab::BadInput("--piece excludes --json: it writes to --output and prints nothing");
  if (!o.merge.empty())
    throw lab::BadInput(
        "--piece and --merge exclude each other: first compute all pieces, then merge them");
}

void check_output(const Options& o, const lab::GrainProgramme& programme,
                  std::vector<std::string> files) {
  refuse_overwriting("--db", o.db, programme.files, "part of the programme");
  if (o.output.empty()) return;
  files.push_back(o.piece.empty() ? o.prefix() + ".json" : o.output);
  (o.piece.empty() ? check_folder : check_targets)("--output", o.output, files);
  for (const auto& file : files) {
    refuse_overwriting("--output", file, programme.files, "part of the programme");
    refuse_overwriting("--output", file, o.merge, "a piece of --merge");
    refuse_overwriting("--output", file, database_files(o.db), "the database");
  }
}

void write_and_print(const Options& o, const db::StoredGrainRun& run) {
  const lab::GrainReport& report = run.report;
  if (!o.output.empty()) {
    make_folder("--output", o.output);
    write_file(o.prefix() + ".json", grain_json(report));
    for (const NamedBytes& csv : grain_csvs(report)) write_file(o.prefix() + csv.suffix, csv.bytes);
    for (const NamedFigure& figure : grain_figures(report)) write_named_figure(figure, o.prefix());
  }
  print(o.json ? grain_json(report) : grain_text(run));
}

constexpr const char* kStopped = "stopped by the operator; the completed stages are stored";
constexpr const char* kStoppedAfterMerge =
    "stopped by the operator; the run is stored, no file is written";
constexpr const char* kStoppedEarly = "stopped by the operator before the specimen was built";

/// Shows the progress until the operator stops it.
sim::GrainProgress shown_in(TaskProgress& progress, const Interruption& interruption) {
  return [&progress, &interruption](double share, const std::string& what) {
    progress.show(share, what);
    return !interruption.requested();
  };
}

std::optional<db::StoredGrainRun> run_stages(const Options& o,
                                             const lab::GrainProgramme& programme) {
  const Interruption interruption;
  GrainOutputs outputs(programme, o.prefix(), [&] { return interruption.requested(); });
  TaskProgress progress(static_cast<int>(programme.stages.size()) + 1);
  progress.next("specimen");
  lab::GrainListener listener;
  listener.stage_started = [&](const lab::GrainStage& stage, const sim::GrainState& state) {
    progress.next(stage.name);
    outputs.begins(stage, state);
  };
  listener.point_kept = [&](const lab::GrainStage& stage, const sim::GrainState& state,
                            const sim::GrainPathPoint& point) {
    outputs.point(stage, state, point.time_s);
  };
  listener.stage_ended = [&](const lab::GrainStage& stage, const sim::GrainState& state,
                             const lab::GrainStageResult& /*result*/) {
    outputs.ends(stage, state);
  };
  return study::run_grains(programme, {chosen_jobs(o.jobs), shown_in(progress, interruption)}, o.db,
                           listener,
                           {.say = notify, .stop = [&] { return interruption.requested(); }});
}

void run_piece(const Options& o, const lab::GrainProgramme& programme) {
  check_piece(o);
  check_output(o, programme, {});
  const Piece piece = piece_of(o.piece);
  const Interruption interruption;
  TaskProgress progress(1);
  progress.next("piece " + o.piece);
  const auto made = study::make_grain_piece(programme, piece.index, piece.count,
                                            chosen_jobs(o.jobs), shown_in(progress, interruption));
  if (!made) throw lab::WorkFailed("stopped by the operator; nothing is written");
  write_file(o.output, study::grain_piece_json(*made));
}

/// The whole run is stored before a signal ends the process.
db::StoredGrainRun stored_merge(const Options& o, const lab::GrainProgramme& programme) {
  const Interruption interruption;
  db::StoredGrainRun stored =
      study::merge_grains(programme, chosen_jobs(o.jobs), o.db, o.merge,
                          {.say = notify, .stop = [&] { return interruption.requested(); }});
  if (interruption.requested()) throw lab::WorkFailed(kStoppedAfterMerge);
  return stored;
}

void run_merge(const Options& o, const lab::GrainProgramme& programme) {
  study::stage_for_pieces(programme);
  check_output(o, programme, {});
  write_and_print(o, stored_merge(o, programme));
}

void run(const Options& o) {
  const lab::GrainProgramme programme = programme_of(o);
  if (!o.piece.empty()) return run_piece(o, programme);
  if (!o.merge.empty()) return run_merge(o, programme);
  const std::vector<std::string> files = GrainOutputs(programme, o.prefix()).files();
  check_output(o, programme, files);
  if (!files.empty()) make_folder("--output", o.output);
  const auto stored = run_stages(o, programme);
  if (!stored) throw lab::WorkFailed(kStoppedEarly);
  write_and_print(o, *stored);
  if (stored->status != db::TestStatus::complete) throw lab::WorkFailed(kStopped);
}

}  // namespace

Command grains_command() {
  return {
      .name = "grains",
      .purpose = "Simulate tests on a specimen of grains (discrete elements)",
      .description =
          {"Makes a specimen of spheres in a box of six frictionless walls (a cloud compressed "
           "with the friction that gives the requested density), or loads one, and runs stages on "
           "it: isotropic, drained and undrained compression or extension, proportional strain "
           "paths, relaxation to equilibrium, stress probes in all directions with the "
           "second-order work of walls and contacts, and perturbations of an equilibrium. The "
           "contacts follow section 5 of Darve, Sibille, Daouadji and Nicot (2007): linear "
           "stiffness, Coulomb friction, no tension.",
           "Each stage starts from the previous stage, or from the stage or mark that it names. "
           "Every stage is stored when it ends and is marked as simulated. The same programme "
           "gives bit-identical results on any number of threads, and a run that continues from a "
           "saved state gives the same results as an uninterrupted run.",
           "--output FOLDER writes grains.json, a CSV file for each stage, the figures, and the "
           "files that stages request: states, files for ParaView, the stage for LAMMPS. Ctrl-C "
           "stops after the current step, and completed stages are stored.",
           "Probes of a saved state are independent of each other: --piece I/N makes only probes "
           "I, I+N, I+2N, ... as one task of a batch system. --merge combines the pieces to "
           "bit-identical results of a single run."},
      .diagnostics =
          {{"FILE:LINE: ...", "correct this line of the programme"},
           {"a porosity of ... was not reached, ...",
            "choose another porosity, or the friction of compaction that gives the nearest one"},
           {"stage '...': its start '...' was never reached",
            "start from a mark before the peak that the path reached: the path ended before this "
            "mark"}},
      .examples = {{"triax grains samples/grains/quick.toml",
                    "simulate a small specimen in some seconds"},
                   {"triax grains samples/grains/dense.toml --output dense",
                    "probe 10,000 grains and draw figures 13 to 15 of the paper"},
                   {"triax grains samples/grains/medium.toml --output medium --jobs 1",
                    "run strain paths and perturbed equilibria (figures 16 to 18) on one core"},
                   {"triax grains dense.toml --set specimen.seed=7 --set contact.damping=0.1",
                    "use another specimen and another damping"},
                   {"triax grains probes.toml --piece $SLURM_ARRAY_TASK_ID/37 --jobs 1 --output "
                    "piece_$SLURM_ARRAY_TASK_ID.json",
                    "run one task of an array job 1-37"},
                   {"triax grains probes.toml --merge piece_*.json --output probes",
                    "merge the pieces of all tasks"}},
      .set_up = [](CLI::App& app) -> std::function<void()> {
        const auto o = std::make_shared<Options>();
        app.add_option("PROGRAMME.toml", o->programme, "programme file")->required()->type_name("");
        app.add_option("--set", o->sets, "set a key of the programme (repeatable)")
            ->type_name("KEY=VALUE")
            ->allow_extra_args(false);
        app.add_option("--output", o->output,
                       "also write grains.json, data and figures to FOLDER; with --piece, the "
                       "file of the piece")
            ->type_name("FOLDER");
        add_jobs(app, o->jobs, "number of threads, without effect on the results", 64);
        app.add_option("--piece", o->piece,
                       "compute only probes I, I+N, I+2N, ... and write them to the file --output")
            ->type_name("I/N");
        app.add_option("--merge", o->merge,
                       "use the probes of these pieces instead of computing them")
            ->type_name("FILE...");
        add_db(app, o->db);
        add_json(app, o->json);
        return [o] { run(*o); };
      }};
}

}  // namespace triax::src

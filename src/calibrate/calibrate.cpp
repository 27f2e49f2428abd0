// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/calibrate/calibrate.hpp"

#include <fmt/format.h>

#include <memory>

#include "lab/base/bad_input.hpp"
#include "src/calibrate/calibrate_figures.hpp"
#include "src/calibrate/calibrate_options.hpp"
#include "src/calibrate/calibrate_text.hpp"
#include "src/cli/interruption.hpp"
#include "src/cli/output_guard.hpp"
#include "src/cli/shared_options.hpp"
#include "src/output/output.hpp"
#include "src/output/task_progress.hpp"
#include "src/study/calibrate/calibrated_set.hpp"
#include "src/study/calibrate/calibration_json.hpp"
#include "src/study/calibrate/calibration_piece.hpp"
#include "src/study/calibrate/requested_calibration.hpp"
#include "src/triaxial/left_waiting.hpp"

namespace triax::src {
namespace {

study::CalibrationRequest requested(const CalibrateOptions& o) {
  tell_of_gaps(o.db);
  auto request = study::requested_calibration(start_wish(o), o.db, o.tests);
  request.searches = o.searches;
  request.seed = o.seed;
  request.threads = o.jobs;
  request.void_ratio_error = o.void_ratio_error;
  return request;
}

/// Nothing that is read may be replaced, and what is to be written must be possible.
void check_output(const CalibrateOptions& o) {
  if (!o.output.empty()) {
    check_targets("--output", o.output, {o.output});
    refuse_overwriting("--output", o.output, database_files(o.db), "the database");
    refuse_overwriting("--output", o.output, o.merge, "a piece of --merge");
    if (const auto end = o.start.find(".toml"); end != std::string::npos)
      refuse_overwriting("--output", o.output, {o.start.substr(0, end + 5)}, "the file of --start");
  }
  if (!o.figures.empty())
    check_folder("--figures", o.figures,
                 files_of_prefix(prefix_in(o.figures, "calibrate"),
                                 {"_undrained", "_drained", "_stress_path", "_domain"}));
}

study::Progress shown_in(TaskProgress& progress) {
  return [&progress](const std::string& what, double share) { progress.show(share, what); };
}

void run_piece(const CalibrateOptions& o, const study::CalibrationRequest& request) {
  const Piece piece = piece_of(o.piece);
  if (piece.count > o.searches)
    throw lab::BadInput(fmt::format("--piece {}: only {} searches; give --searches {}", o.piece,
                                    o.searches, piece.count));
  const Interruption interruption;
  TaskProgress progress(1);
  progress.next("piece " + o.piece);
  const auto ends = study::run_searches(request, piece.index, piece.count, shown_in(progress),
                                        [&] { return !interruption.requested(); });
  if (interruption.requested())
    throw lab::WorkFailed("stopped by the operator; nothing is written");
  write_file(o.output, study::calibration_piece_json(request, ends, piece.index, piece.count));
}

study::Calibration computed(const CalibrateOptions& o, const study::CalibrationRequest& request) {
  const Interruption interruption;
  TaskProgress progress(1);
  progress.next(o.law);
  const auto go_on = [&] { return !interruption.requested(); };
  if (o.merge.empty()) return study::calibrate(request, shown_in(progress), go_on);
  return study::conclude(request, study::merged_searches(request, o.merge), shown_in(progress),
                         go_on);
}

void run(const CalibrateOptions& o) {
  check_output(o);
  const study::CalibrationRequest request = requested(o);
  if (!o.piece.empty()) return run_piece(o, request);
  const study::Calibration found = computed(o, request);
  if (!o.output.empty())
    write_file(o.output, study::calibrated_toml(found, study::set_name_from(o.output)));
  if (!o.figures.empty()) {
    make_folder("--figures", o.figures);
    for (const NamedFigure& figure : calibrate_figures(found))
      write_named_figure(figure, prefix_in(o.figures, "calibrate"));
  }
  print(o.json ? study::calibration_json(found) : calibrate_text(found));
  if (found.interrupted)
    throw lab::WorkFailed("stopped by the operator; the result is the best so far");
}

}  // namespace

Command calibrate_command() {
  return {
      .name = "calibrate",
      .purpose = "Calibrate the parameters of a law against tests",
      .description =
          {"The law is driven through the shear stage of each test under the control that was "
           "applied (undrained, drained, or along a stress path). The results are compared with "
           "the measurements: q and p' of undrained tests, q and the change of volume of drained "
           "tests. They are compared along the arc length of the path, so that parts with many "
           "readings have no extra weight. Global searches by differential evolution, followed by "
           "least squares from the best members of each search, find the parameters within the "
           "ranges of the law's parameter file.",
           "The results have intervals and correlations. Parameters that the tests do not "
           "determine, and other optima with a similar fit, are listed. The stress ratio at "
           "collapse of each test is predicted from the other tests. The bifurcation domain and "
           "the cones of unstable directions of the set are computed, with their scatter over 200 "
           "sets drawn from the estimate (10 for a UMAT). --output writes a parameter file in the "
           "format of those that ship with the program. If it is stopped by Ctrl-C, triax prints "
           "the best results so far, marks them as such and ends with status 1.",
           "Searches are independent of each other: --piece I/N runs only searches I, I+N, I+2N, "
           "... as one task of a batch system. --merge, with the same tests and options, combines "
           "the pieces."},
      .diagnostics =
          {{"test ... has no void ratio: ...",
            "replay the record with --set specimen.void_ratio=E: the state of the soil is unknown "
            "without it"},
           {"tests of two soils: ...",
            "name the tests of one soil: a parameter set describes one soil"},
           {"N free parameters from M tests: ...",
            "fix some parameters, or add tests: each test determines four numbers at most"},
           {"not determined (in the table of parameters)",
            "fix it, or add a test that is sensitive to it (another density, pressure or "
            "drainage): a misfit of 2 % leaves most of its range open"},
           {"FILE: is a piece of another calibration: ...",
            "give --merge the law, tests and options of the pieces"}},
      .examples =
          {{"triax calibrate hypoplastic --output my_sand.toml",
            "calibrate all parameters with a search range against all tests of the database"},
           {"triax calibrate sanisand TMD1 TMD3 TMU1 --fix poisson_ratio=0.05 --figures curves",
            "use three tests, keep one parameter fixed, and draw measured and computed curves"},
           {"triax calibrate norsand --start soil/soil.toml --output my_norsand.toml",
            "start from the results of triax soil"},
           {"triax calibrate hypoplastic --searches 64 --piece $SLURM_ARRAY_TASK_ID/64 --output "
            "piece_$SLURM_ARRAY_TASK_ID.json",
            "run one task of an array job 1-64"}},
      .set_up = [](CLI::App& app) -> std::function<void()> {
        const auto o = std::make_shared<CalibrateOptions>();
        add_calibrate_options(app, *o);
        return [o] {
          check_calibrate_options(*o);
          run(*o);
        };
      }};
}

}  // namespace triax::src

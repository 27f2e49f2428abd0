// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/domain/domain.hpp"

#include <fmt/format.h>

#include <memory>

#include "lab/base/bad_input.hpp"
#include "src/cli/output_guard.hpp"
#include "src/cli/shared_options.hpp"
#include "src/domain/domain_figures.hpp"
#include "src/domain/domain_options.hpp"
#include "src/domain/domain_text.hpp"
#include "src/output/output.hpp"
#include "src/output/progress_bar.hpp"
#include "src/output/table.hpp"
#include "src/study/domain/domain_cones.hpp"
#include "src/study/domain/domain_counts.hpp"
#include "src/study/domain/domain_inputs.hpp"
#include "src/study/domain/domain_piece.hpp"
#include "src/study/domain/domain_run.hpp"
#include "src/triaxial/left_waiting.hpp"

namespace triax::src {
namespace {

/// The states of a piece, or of the whole domain.
study::ReportedDomain compute(const DomainOptions& o, const lab::MaterialSet& material,
                              const Piece& piece) {
  const study::DomainSettings::Grid grid = chosen_grid(o, material);
  if (piece.count > grid.columns)
    throw lab::BadInput(
        fmt::format("--piece {}: the grid has only {} columns to share", o.piece, grid.columns));
  return study::run_domain({.material = material,
                            .grid = grid,
                            .threads = o.jobs,
                            .piece = piece.index,
                            .pieces = piece.count},
                           progress_bars());
}

study::ReportedDomain merge(const DomainOptions& o) {
  std::vector<study::DomainPiece> pieces;
  for (const auto& file : o.merge) pieces.push_back(study::load_piece(file));
  study::ReportedDomain domain = merged(std::move(pieces));
  if (const auto& plane = domain.settings.grid.plane; !o.tests.empty() && plane != "axisymmetric")
    throw lab::BadInput(
        fmt::format("--test is for the figures of cones of the axisymmetric plane; the pieces of "
                    "--merge are of {}",
                    plane));
  return domain;
}

/// Data, and the figure drawn from the same values.
void write_files(const study::ReportedDomain& domain, const std::vector<study::TestedState>& tests,
                 const std::string& prefix) {
  write_file(prefix + ".csv", domain_states_csv(domain));
  write_file(prefix + "_boundaries.csv", domain_boundaries_csv(domain));
  write_file(prefix + ".json", study::domain_json(domain));
  write_figure(domain_map(domain), prefix);
  if (domain.settings.grid.plane != "axisymmetric") return;
  for (const auto& figure : domain_cones(domain, study::cones_picture(domain, tests)))
    write_named_figure(figure, prefix);
}

/// The measured increments that the figures of cones are to show.
std::vector<study::TestedState> tests_on_top(const DomainOptions& o) {
  if (o.tests.empty()) return {};
  tell_of_gaps(o.db);
  // An arrow needs stresses only; a void ratio that a test does not know must not be in its way.
  return study::tested_states(o.db, o.tests, "collapse", o.material.void_ratio.value_or(1));
}

/// Nothing that is read may be replaced, and what is to be written must be possible, before an hour
/// is spent on it.
void check_output(const DomainOptions& o, const std::optional<lab::MaterialSet>& material) {
  if (o.output.empty()) return;
  const auto files =
      o.piece.empty()
          ? files_of_prefix(o.prefix(), {"", "_boundaries", "_cones_pq", "_cones_rendulic"})
          : std::vector{o.output};
  (o.piece.empty() ? check_folder : check_targets)("--output", o.output, files);
  for (const auto& file : files) {
    refuse_overwriting("--output", file, o.merge, "a piece of --merge");
    if (!o.material.file.empty())
      refuse_overwriting("--output", file, {o.material.file}, "the file of --materials");
    if (material)
      refuse_overwriting("--output", file, study::files_named_by(*material),
                         "named by " + material->name);
    if (!o.tests.empty())
      refuse_overwriting("--output", file, database_files(o.db), "the database");
  }
}

/// A map of refusals is no result. A piece may be one, as the rest of its domain may be more.
void refuse_if_nothing_is_answered(const study::ReportedDomain& domain) {
  if (study::any_answer(domain)) return;
  const study::ReportedColumn& first = domain.columns.front();
  throw lab::WorkFailed(
      fmt::format("{} gives no result at any state of the grid; at p' {:g} kPa first: {}",
                  domain.settings.material.name, first.p_eff_kPa, on_one_line(first.refusal)));
}

void run(const DomainOptions& o) {
  std::optional<lab::MaterialSet> material;
  if (o.merge.empty()) material = chosen_material(o.material);
  check_output(o, material);
  if (!o.piece.empty()) {
    const Piece piece = piece_of(o.piece);
    return write_file(o.output,
                      study::piece_json(compute(o, *material, piece), piece.index, piece.count));
  }
  const std::vector<study::TestedState> tests = tests_on_top(o);
  const study::ReportedDomain domain = material ? compute(o, *material, {}) : merge(o);
  refuse_if_nothing_is_answered(domain);
  if (!o.output.empty()) {
    make_folder("--output", o.output);
    write_files(domain, tests, o.prefix());
  }
  print(o.json ? study::domain_json(domain) : domain_text(domain));
}

}  // namespace

Command domain_command() {
  return {
      .name = "domain",
      .purpose = "map the bifurcation domain of a material in the p'-q plane",
      .description =
          {"Every state (p', q) of a grid at one void ratio is probed with stress increments in "
           "all directions of the plane: stable where the second-order work is positive in all of "
           "them, unstable inside the bifurcation domain, unknown where the law has no "
           "answer in some directions "
           "and the others are stable. Between the rows the boundary is "
           "isolated: the first unstable state with its direction, isotropic unloading (dq = 0 "
           "with falling p', where undrained tests have their peak and tests at constant q "
           "collapse), and the plastic limit. States have no memory of a reversal.",
           "Columns of one p' are independent of each other. They run on all cores, and --piece "
           "I/N computes every N-th of them only, as one task of a batch system or of MPI; --merge "
           "puts the pieces together to what a run in one go gives, to the byte."},
      .diagnostics =
          {{"... gives no result at any state of the grid; ...",
            "all of them are out of the law's range, for the reason that follows: choose another "
            "void ratio, or correct the UMAT that fails"},
           {"--merge: piece I of N is missing", "run that piece again, with the same options"},
           {"FILE: is a piece of another domain: ...", "its settings differ from the first file's"},
           {"FILE: is not a complete JSON document; ...",
            "the task that wrote it was killed: run it again"},
           {"--plane plane-strain: ... is not formulated for it",
            "the law is one of axisymmetry only"}},
      .examples =
          {{"triax domain --material inl2/S28-general --void-ratio 1.086",
            "200 x 200 states with 360 directions each"},
           {"triax domain --material octolinear/S28-general --void-ratio 0.85 --p-kPa 50:800/100 "
            "--q-kPa -400:900/260 --output dense",
            "extension too, as dense.csv and dense.json"},
           {"triax domain --materials my_umat.toml --material umat/sand --void-ratio 0.8 --plane "
            "plane-strain --json",
            "your own law in plane strain"},
           {"triax domain --material inl2/S28-general --void-ratio 1.086 --piece "
            "$SLURM_ARRAY_TASK_ID/64 --output piece_$SLURM_ARRAY_TASK_ID.json",
            "one task of an array job 1-64"},
           {"triax domain --merge piece_*.json --output loose", "all tasks put together"},
           {"triax domain --material inl2/S28-general --void-ratio 1.1 --p-kPa 100:900/9 "
            "--q-kPa 0:900/10 --test 27 --test 58 --output fig12",
            "cones at some states, and the increments of two tests at collapse on top"},
           {"triax domain --material inl2/S28-general --void-ratio 1.086 --jobs 1 --piece "
            "$((OMPI_COMM_WORLD_RANK+1))/$OMPI_COMM_WORLD_SIZE --output "
            "piece_$OMPI_COMM_WORLD_RANK.json",
            "the same under MPI: what mpirun -n 8 sh -c '...' is given, a process a piece"}},
      .set_up = [](CLI::App& app) -> std::function<void()> {
        const auto o = std::make_shared<DomainOptions>();
        add_domain_options(app, *o);
        return [o, &app] {
          check_domain_options(app, *o);
          run(*o);
        };
      }};
}

}  // namespace triax::src

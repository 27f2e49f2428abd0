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
        fmt::format("--piece {}: the grid has only {} columns", o.piece, grid.columns));
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
      fmt::format("{} gives no result at any state of the grid; first at p' {:g} kPa: {}",
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
      .purpose = "Map the bifurcation domain of a material in the p'-q plane",
      .description =
          {"Probes every state (p', q) of a grid at one void ratio with stress increments in all "
           "directions of the plane. A state is stable if the second-order work is positive in all "
           "of them, unstable if it is inside the bifurcation domain, and unknown if the law gives "
           "no result in some directions and the others are stable. The boundary is located "
           "between the rows: the first unstable state with its direction, isotropic unloading (dq "
           "= 0 with decreasing p', the direction of undrained tests at their peak and of tests at "
           "constant q at collapse), and the plastic limit. States have no memory of a reversal.",
           "Columns of one p' are independent of each other and run on all cores. --piece I/N "
           "computes only columns I, I+N, I+2N, ... as one task of a batch system or of MPI. "
           "--merge combines the pieces to the same bytes as a single run."},
      .diagnostics = {{"... gives no result at any state of the grid; ...",
                       "choose another void ratio, or correct the UMAT: every state is out of the "
                       "range of the law for the reason given"},
                      {"--merge: piece I of N is missing",
                       "run that piece again with the same options"},
                      {"FILE: is a piece of another domain: ...",
                       "merge only pieces with the same settings"},
                      {"FILE: is not a complete JSON document; ...",
                       "run its task again: it was killed while writing the file"},
                      {"--plane plane-strain: ... is not formulated for it",
                       "use --plane axisymmetric: the law is formulated for axisymmetry only"}},
      .examples =
          {{"triax domain --material inl2/S28-general --void-ratio 1.086",
            "map 200 x 200 states with 360 directions each"},
           {"triax domain --material octolinear/S28-general --void-ratio 0.85 --p-kPa 50:800/100 "
            "--q-kPa -400:900/260 --output dense",
            "include extension and write the results to folder dense"},
           {"triax domain --materials my_umat.toml --material umat/sand --void-ratio 0.8 --plane "
            "plane-strain --json",
            "map your own law in plane strain"},
           {"triax domain --material inl2/S28-general --void-ratio 1.086 --piece "
            "$SLURM_ARRAY_TASK_ID/64 --output piece_$SLURM_ARRAY_TASK_ID.json",
            "run one task of an array job 1-64"},
           {"triax domain --merge piece_*.json --output loose", "merge the pieces of all tasks"},
           {"triax domain --material inl2/S28-general --void-ratio 1.1 --p-kPa 100:900/9 --q-kPa "
            "0:900/10 --test 27 --test 58 --output fig12",
            "draw the cones at some states with the measured increments of two tests at collapse"},
           {"triax domain --material inl2/S28-general --void-ratio 1.086 --jobs 1 --piece "
            "$((OMPI_COMM_WORLD_RANK+1))/$OMPI_COMM_WORLD_SIZE --output "
            "piece_$OMPI_COMM_WORLD_RANK.json",
            "run one piece per process under MPI, as the argument of mpirun -n 8 sh -c '...'"}},
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

#include "src/commands/domain.hpp"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <memory>
#include <numeric>
#include <stdexcept>

#include "db/store.hpp"
#include "lab/records/bad_input.hpp"
#include "lab/records/text.hpp"
#include "sim/stability/domain_criteria.hpp"
#include "sim/stability/domain_run.hpp"
#include "src/commands/material_option.hpp"
#include "src/commands/output_guard.hpp"
#include "src/commands/shared_options.hpp"
#include "src/output/output.hpp"
#include "src/output/progress_bar.hpp"
#include "src/report/domain_figures.hpp"
#include "src/report/domain_piece.hpp"

namespace triax::src {
namespace {

struct Options {
  MaterialOptions material;
  std::string p, q;
  std::string plane = "axisymmetric";
  int directions = 360;
  int threads = 0;
  std::string piece;
  std::vector<std::string> pieces;
  std::string output;
  std::vector<std::string> tests;
  std::string db = "triax.db";
  bool localisation = false;
  bool json = false;
};

struct Line {
  double from = 0, to = 0;
  int count = 200;
};

template <class Number>
bool read(std::string_view text, Number& value) {
  const char* const end = text.data() + text.size();
  const auto [stopped, error] = std::from_chars(text.data(), end, value);
  return error == std::errc() && stopped == end;
}

std::vector<std::string_view> split(std::string_view text, char at) {
  std::vector<std::string_view> parts;
  for (std::size_t end = text.find(at); end != text.npos; end = text.find(at)) {
    parts.push_back(text.substr(0, end));
    text.remove_prefix(end + 1);
  }
  parts.push_back(text);
  return parts;
}

/// FROM:TO or FROM:TO:COUNT; `usual` where nothing is given.
Line line(const char* option, const std::string& text, const Line& usual) {
  if (text.empty()) return usual;
  const auto parts = split(text, ':');
  Line found = usual;
  const bool good = (parts.size() == 2 || parts.size() == 3) && read(parts[0], found.from) &&
                    read(parts[1], found.to) &&
                    (parts.size() == 2 || read(parts[2], found.count)) &&
                    std::isfinite(found.from) && std::isfinite(found.to);
  if (!good)
    throw lab::BadInput(fmt::format("{} {}: FROM:TO:COUNT is wanted, as in 10:300:200", option,
                                    lab::excerpt(text)));
  return found;
}

/// What the set is for, within the stresses of the triaxial tests that are usual.
Line usual_p(const lab::MaterialSet& material) {
  Line p{10, 300, 200};
  if (!material.p_eff_range_kPa) return p;
  const auto [low, high] = *material.p_eff_range_kPa;
  p.from = std::max(p.from, low);
  if (high > p.from) p.to = std::min(p.to, high);
  return p;
}

/// From isotropic stress to the critical stress ratio at the highest p′.
Line usual_q(const lab::MaterialSet& material, const Line& p) {
  const auto* law = material.material.axisymmetric.get();
  const double ratio = (law != nullptr ? law->limit_stress_ratio() : std::nullopt).value_or(1.5);
  return {0, 10 * std::ceil(ratio * p.to / 10), 200};
}

DomainSettings::Grid chosen_grid(const Options& o, const lab::MaterialSet& material) {
  const Line p = line("--p-kPa", o.p, usual_p(material));
  const Line q = line("--q-kPa", o.q, usual_q(material, p));
  const DomainSettings::Grid grid{.p_from_kPa = p.from,
                                  .p_to_kPa = p.to,
                                  .q_from_kPa = q.from,
                                  .q_to_kPa = q.to,
                                  .columns = p.count,
                                  .rows = q.count,
                                  .void_ratio = chosen_void_ratio(o.material, material),
                                  .plane = o.plane,
                                  .directions = o.directions,
                                  .localisation = o.localisation};
  check_grid(grid, "the grid");
  return grid;
}

void check_law(const lab::MaterialSet& material, const DomainSettings::Grid& grid) {
  const bool axisymmetric = grid.plane == "axisymmetric";
  const auto& law = material.material;
  if (axisymmetric ? law.axisymmetric != nullptr : law.tensor != nullptr) return;
  throw lab::BadInput(
      fmt::format("--plane {}: {} has no form for it{}", grid.plane, material.name,
                  !axisymmetric && !law.no_tensor.empty() ? ", " + law.no_tensor : std::string()));
}

struct Piece {
  int index = 1, count = 1;
};

Piece chosen_piece(const Options& o) {
  Piece piece;
  if (o.piece.empty()) return piece;
  const auto parts = split(o.piece, '/');
  if (parts.size() != 2 || !read(parts[0], piece.index) || !read(parts[1], piece.count) ||
      piece.index < 1 || piece.index > piece.count)
    throw lab::BadInput(fmt::format("--piece {}: I/N with I from 1 to N is wanted, as in 3/8",
                                    lab::excerpt(o.piece)));
  if (o.output.empty())
    throw lab::BadInput("--piece needs --output FILE, where the piece is to be written");
  return piece;
}

std::vector<sim::DomainColumn> computed(const Options& o, const lab::MaterialSet& material,
                                        const sim::DomainGrid& grid, const Piece& piece) {
  ProgressBar bar("domain");
  return sim::run_domain(grid, sim::columns_of_piece(grid, piece.index, piece.count),
                         [&] {
                           sim::DomainWorker worker{lab::made_anew(material), {}};
                           worker.criteria =
                               sim::domain_criteria(worker.material, grid, o.localisation);
                           return worker;
                         },
                         {.threads = o.threads, .progress = [&bar](double share) {
                            bar.show(share);
                            return true;
                          }});
}

/// The states of a piece, or of the whole domain.
ReportedDomain compute(const Options& o, const Piece& piece) {
  const lab::MaterialSet material = chosen_material(o.material);
  const DomainSettings::Grid grid = chosen_grid(o, material);
  check_law(material, grid);
  if (piece.count > grid.columns)
    throw lab::BadInput(
        fmt::format("--piece {}: the grid has only {} columns to share", o.piece, grid.columns));
  ReportedDomain domain{.settings = domain_settings(material, grid)};
  for (const auto& column : computed(o, material, domain_grid(grid), piece))
    domain.columns.push_back(reported_column(column));
  return domain;
}

ReportedDomain merge(const Options& o) {
  for (const auto& [given, option] :
       {std::pair(!o.material.name.empty(), "--material"), std::pair(!o.p.empty(), "--p-kPa"),
        std::pair(!o.q.empty(), "--q-kPa"), std::pair(!o.piece.empty(), "--piece"),
        std::pair(o.material.void_ratio.has_value(), "--void-ratio")})
    if (given)
      throw lab::BadInput(fmt::format("{} and --merge: the pieces say it already", option));
  std::vector<DomainPiece> pieces;
  for (const auto& file : o.pieces) pieces.push_back(load_piece(file));
  return merged(std::move(pieces));
}

/// Data, and the figure drawn from the same values.
void write_files(const ReportedDomain& domain, const std::vector<TestedState>& tests,
                 const std::string& prefix) {
  write_file(prefix + ".csv", domain_states_csv(domain));
  write_file(prefix + "_boundaries.csv", domain_boundaries_csv(domain));
  write_file(prefix + ".json", domain_json(domain));
  write_figure(domain_map(domain), prefix);
  for (const auto& figure : domain_cones(domain, tests)) write_named_figure(figure, prefix);
}

std::vector<std::string> files_of(const std::string& prefix) {
  std::vector<std::string> files;
  if (prefix.empty()) return files;
  files.push_back(prefix + "_boundaries.csv");
  for (const char* name : {"", "_cones_pq", "_cones_rendulic"})
    for (const char* ending : {".csv", ".json", ".svg", ".png", ".pdf"})
      files.push_back(prefix + name + ending);
  return files;
}

/// The measured increments that the figures of cones are to show.
std::vector<TestedState> tests_on_top(const Options& o) {
  std::vector<TestedState> tests;
  if (o.tests.empty()) return tests;
  if (o.output.empty() || !o.piece.empty() || o.plane != "axisymmetric")
    throw lab::BadInput(
        "--test is for the figures of cones: it needs --output, the "
        "axisymmetric plane and no --piece");
  const db::Store store(o.db);
  // An arrow needs stresses only; a void ratio that a test does not know must not be in its way.
  const double void_ratio = o.material.void_ratio.value_or(1);
  for (const auto& name : o.tests)
    tests.push_back(tested_state(store, name, "collapse", void_ratio));
  return tests;
}

void run(const Options& o) {
  const Piece piece = chosen_piece(o);
  if (!o.piece.empty() && o.pieces.empty()) {
    const ReportedDomain columns = compute(o, piece);
    return write_file(o.output, piece_json(columns, piece.index, piece.count));
  }
  const std::vector<TestedState> tests = tests_on_top(o);
  for (const auto& file : files_of(o.output)) {
    refuse_overwriting("--output", file, o.pieces, "a piece of --merge");
    if (!o.tests.empty())
      refuse_overwriting("--output", file, database_files(o.db), "the database");
  }
  const ReportedDomain domain = o.pieces.empty() ? compute(o, piece) : merge(o);
  if (!o.output.empty()) write_files(domain, tests, o.output);
  print(o.json ? domain_json(domain) : domain_text(domain));
}

}  // namespace

Command domain_command() {
  return {
      .name = "domain",
      .purpose = "map the bifurcation domain of a material in the p'-q plane",
      .description =
          {"Every state (p', q) of a grid at one void ratio is probed with stress increments in "
           "all directions of the plane: stable where the second-order work is positive in all of "
           "them, unstable inside the bifurcation domain. Between the rows the boundary is "
           "isolated: the first unstable state with its direction, isotropic unloading (dq = 0 "
           "with falling p', where undrained tests have their peak and tests at constant q "
           "collapse), and the plastic limit. States have no memory of a reversal.",
           "Columns of one p' are independent of each other. They run on all cores, and --piece "
           "I/N computes every N-th of them only, as one task of a batch system or of MPI; --merge "
           "puts the pieces together to what a run in one go gives, to the byte."},
      .diagnostics =
          {{"--merge: piece I of N is missing", "run that piece again, with the same options"},
           {"FILE: is a piece of another domain: ...", "its settings differ from the first file's"},
           {"FILE: is no whole JSON document; ...",
            "the task that wrote it was killed: run it again"},
           {"--plane plane-strain: ... has no form for it", "the law is one of axisymmetry only"}},
      .examples =
          {{"triax domain --material inl2/S28-general --void-ratio 1.086",
            "200 x 200 states with 360 directions each"},
           {"triax domain --material octolinear/S28-general --void-ratio 0.85 --p-kPa 50:800:100 "
            "--q-kPa -400:900:260 --output dense",
            "extension too, as dense.csv and dense.json"},
           {"triax domain --materials my_umat.toml --material umat/sand --void-ratio 0.8 --plane "
            "plane-strain --json",
            "a law of one's own in plane strain"},
           {"triax domain --material inl2/S28-general --void-ratio 1.086 --piece "
            "$SLURM_ARRAY_TASK_ID/64 --output piece_$SLURM_ARRAY_TASK_ID.json",
            "one task of an array job 1-64"},
           {"triax domain --merge piece_*.json --output loose", "all tasks put together"},
           {"triax domain --material inl2/S28-general --void-ratio 1.1 --p-kPa 100:900:9 "
            "--q-kPa 0:900:10 --test 27 --test 58 --output fig12",
            "cones at some states, and the increments of two tests at collapse on top"},
           {"triax domain --material inl2/S28-general --void-ratio 1.086 --threads 1 --piece "
            "$((OMPI_COMM_WORLD_RANK+1))/$OMPI_COMM_WORLD_SIZE --output "
            "piece_$OMPI_COMM_WORLD_RANK.json",
            "the same under MPI: what mpirun -n 8 sh -c '...' is given, a process a piece"}},
      .set_up = [](CLI::App& app) -> std::function<void()> {
        const auto o = std::make_shared<Options>();
        add_material(app, o->material);
        app.add_option("--p-kPa", o->p,
                       "mean effective stresses [10:300:200 within the set's range]")
            ->type_name("FROM:TO:COUNT");
        app.add_option("--q-kPa", o->q,
                       "deviator stresses, below 0 in extension [0 to M times the highest p', 200]")
            ->type_name("FROM:TO:COUNT");
        app.add_option("--plane", o->plane, "plane of the stress increments [axisymmetric]")
            ->check(CLI::IsMember({"axisymmetric", "plane-strain"}).description(""))
            ->type_name("axisymmetric|plane-strain");
        app.add_option("--directions", o->directions, "directions at each state")
            ->capture_default_str()
            ->type_name("N");
        app.add_flag(
            "--localisation", o->localisation,
            "look for vanishing acoustic tensors (Rice) too, which takes ten times as long");
        app.add_option("--threads", o->threads,
                       "number of threads; the result does not depend on it [all cores]")
            ->check(CLI::Range(1, 4096).description(""))
            ->type_name("N");
        app.add_option("--piece", o->piece,
                       "compute every N-th column from the I-th on only, and "
                       "write them to the file --output")
            ->type_name("I/N");
        app.add_option("--merge", o->pieces, "put these pieces together instead of computing")
            ->type_name("FILE...");
        app.add_option(
               "--output", o->output,
               "write PREFIX.csv (states), PREFIX_boundaries.csv, PREFIX.json, the map as "
               "PREFIX.svg, .png and .pdf, and the cones at some states as PREFIX_cones_pq and "
               "PREFIX_cones_rendulic; with --piece the file of the piece")
            ->type_name("PREFIX");
        app.add_option("--test", o->tests,
                       "put the measured increment of this test at its collapse on the figures of "
                       "cones; may be repeated")
            ->type_name("TEST")
            ->allow_extra_args(false);
        add_db(app, o->db);
        add_json(app, o->json);
        return [o] { run(*o); };
      }};
}

}  // namespace triax::src

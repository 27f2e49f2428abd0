// SPDX-License-Identifier: GPL-3.0-or-later
#include "db/grain_writer.hpp"

#include <limits>
#include <utility>

#include "db/exact_row.hpp"
#include "db/grain_columns.hpp"

namespace triax::db {
namespace {

/// Rows of what came of one stage.
class StageRows {
 public:
  StageRows(SQLite::Database& database, std::int64_t run, std::int64_t stage)
      : database_(database), run_(run), stage_(stage) {}

  void operator()(const lab::ReportedGrainPath& came) {
    const PathRow asked{lab::word(came.path.kind), came.path};
    insert("grain_paths", {}, [&](auto& row) { visit_path(row, asked); });
    for (std::size_t k = 0; k < came.points.size(); ++k)
      insert("grain_points", k, [&](auto& row) { visit_point(row, came.points[k]); });
    for (std::size_t k = 0; k < came.marks.size(); ++k) {
      const auto& [name, at] = came.marks[k];
      const MarkRow mark{name, at.has_value(), at.value_or(never_passed())};
      insert("grain_marks", k, [&](auto& row) { visit_mark(row, mark); });
    }
  }
  void operator()(const lab::ReportedGrainRest& came) {
    const RestRow rest{came.strain_held ? "walls" : "stresses", came.rest};
    insert("grain_rests", {}, [&](auto& row) { visit_rest(row, rest); });
  }
  void operator()(const lab::ReportedGrainRose& came) {
    const bool by_stress = came.kind == sim::ProbeKind::stress;
    const RoseRow row{lab::word(came.kind), by_stress ? std::optional(came.norm_pa) : std::nullopt,
                      by_stress ? std::nullopt : std::optional(came.norm_strain), came.made.stress};
    insert("grain_roses", {}, [&](auto& to) { visit_rose(to, row); });
    const sim::ProbeRose& rose = came.made.rose;
    probe(0, rose.null_probe, std::nullopt, by_stress);
    for (std::size_t k = 0; k < rose.probes.size(); ++k)
      probe(k + 1, rose.probes[k], rose.probes[k].angle, by_stress);
  }
  void operator()(const lab::ReportedPerturbation& came) {
    insert("grain_perturbations", {}, [&](auto& row) { visit_perturbation(row, came); });
    for (std::size_t k = 0; k < came.points.size(); ++k)
      insert("grain_perturbation_points", k,
             [&](auto& row) { visit_perturbation_point(row, came.points[k]); });
  }
  void ledger(std::int64_t number, const sim::GrainLedger& l) {
    const EnergyRow energy{number, l, l.energy_error_j()};
    insert("grain_energies", {}, [&](auto& row) { visit_energy(row, energy); });
    for (std::size_t a = 0; a < kMomentumAxes.size(); ++a) {
      const MomentumRow momentum{number,
                                 kMomentumAxes[a],
                                 l.walls_impulse[a],
                                 l.damping_impulse[a],
                                 l.stopped_impulse[a],
                                 l.momentum_start[a],
                                 l.momentum_end[a]};
      insert("grain_momenta", {}, [&](auto& row) { visit_momentum(row, momentum); });
    }
  }
  void measures(const char* moment, const sim::GrainMeasures& measures) {
    insert("grain_measures", {}, [&](auto& row) {
      row("moment", std::string(moment));
      visit_measures(row, measures);
    });
  }

 private:
  template <class Visit>
  void insert(const char* table, std::optional<std::size_t> number, const Visit& visit) {
    std::vector<Key> keys = {{"run_id", run_}, {"stage", stage_}};
    if (number) keys.push_back({"number", static_cast<std::int64_t>(*number)});
    insert_row(database_, table, keys, visit);
  }
  void probe(std::size_t number, const sim::GrainProbe& p, std::optional<double> angle,
             bool by_stress) {
    const sim::GrainWork& w = p.work;
    const ProbeRow all{p,
                       angle,
                       by_stress ? std::optional(p.norm_pa) : std::nullopt,
                       w.eulerian(),
                       w.microscopic(),
                       w.non_permanent_share()};
    insert("grain_probes", number, [&](auto& row) { visit_probe(row, all); });
    const auto place = static_cast<std::int64_t>(number);
    const GapRow gap{place, w.contacts_turning, w.grains_turning, w.out_of_balance, w.gap_left()};
    insert("grain_gaps", {}, [&](auto& row) { visit_gap(row, gap); });
    ledger(place, p.ledger);
  }
  static sim::GrainPathPoint never_passed() {
    constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
    return {kNaN, {kNaN, kNaN}, kNaN, {kNaN, kNaN}, kNaN, kNaN, kNaN, kNaN, kNaN, kNaN, kNaN, kNaN};
  }

  SQLite::Database& database_;
  std::int64_t run_, stage_;
};

std::optional<double> ratio_of(const lab::GrainStage& stage) {
  if (const auto* path = std::get_if<lab::GrainPathStage>(&stage.work))
    return path->path.kind == sim::GrainPathKind::strain_path ? std::optional(path->path.ratio)
                                                              : std::nullopt;
  if (const auto* perturbed = std::get_if<lab::GrainPerturbationStage>(&stage.work))
    return perturbed->perturbation.ratio;
  return std::nullopt;
}

}  // namespace

std::int64_t insert_grain_run(SQLite::Database& database, const lab::GrainProgramme& programme,
                              const lab::GrainsMade& made, const std::string& recorded_at) {
  SpecimenRow specimen{
      lab::reported(programme.grains, made), lab::word(made.state.law.reading), {}, {}};
  if (programme.grains.made()) {
    specimen.seed = static_cast<std::int64_t>(specimen.told.seed);
    specimen.compactions = specimen.told.trials;
  }
  insert_row(database, "grain_runs", {}, [&](auto& row) {
    row("name", programme.name);
    row("source", programme.source);
    row("programme", programme.text);
    row.or_null("settings", programme.settings);
    row("status", std::string("running"));
    row("recorded_at", recorded_at);
    visit_specimen(row, std::as_const(specimen));
  });
  const std::int64_t run = database.getLastInsertRowid();
  StageRows(database, run, 0).measures("made", made.measures);
  return run;
}

void insert_grain_stage(SQLite::Database& database, std::int64_t run, std::int64_t number,
                        const lab::GrainStageResult& result) {
  const auto at_rest = lab::at_rest(result);
  StageRow stage{
      lab::reported(result), number, lab::ending(result), {}, ratio_of(*result.stage), {}, 0};
  if (at_rest) stage.at_rest = *at_rest ? 1 : 0;
  if (result.seconds > 0) stage.seconds = result.seconds;
  const auto& stress = result.after.wall_stress_pa;
  stage.radial_stress_pa = 0.5 * (stress[sim::kRadial[0]] + stress[sim::kRadial[1]]);
  insert_row(database, "grain_stages", {{"run_id", run}},
             [&](auto& row) { visit_stage(row, std::as_const(stage)); });
  StageRows rows(database, run, number);
  rows.measures("before", result.before);
  rows.measures("after", result.after);
  if (stage.told.ledger) rows.ledger(0, *stage.told.ledger);
  std::visit(rows, stage.told.came);
}

}  // namespace triax::db

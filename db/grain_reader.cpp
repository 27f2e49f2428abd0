// SPDX-License-Identifier: GPL-3.0-or-later
#include "db/grain_reader.hpp"

#include <SQLiteCpp/Statement.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <type_traits>

#include "db/exact_row.hpp"
#include "db/grain_columns.hpp"
#include "db/test_reader.hpp"
#include "lab/base/bad_input.hpp"

namespace triax::db {
namespace {

/// The value of an enumeration that is written so; its first one where none is.
template <class Enum>
Enum of_word(const std::string& text) {
  constexpr int kMostValues = 8;
  for (int k = 0; k < kMostValues; ++k)
    if (lab::word(static_cast<Enum>(k)) == text) return static_cast<Enum>(k);
  return {};
}

/// Rows of one stage of one run.
class StageReader {
 public:
  StageReader(SQLite::Database& database, std::int64_t run, std::int64_t stage)
      : database_(database), run_(run), stage_(stage) {}

  /// Fills measures where they are stored; says whether they are.
  bool measures(const std::string& moment, sim::GrainMeasures& measures) const {
    struct Moment {
      std::string name;
      sim::GrainMeasures measures;
    };
    for (const Moment& row : rows<Moment>("grain_measures", "", [](auto&row, auto&m) {
           row("moment", m.name);
           visit_measures(row, m.measures);
         }))
      if (row.name == moment) {
        const Eigen::Matrix3d stress = measures.stress_pa;
        measures = row.measures;
        measures.stress_pa = stress;
        return true;
      }
    return false;
  }

  /// By the number of the probe, 0 of a stage; empty where none is stored.
  std::map<std::int64_t, sim::GrainLedger> ledgers() const {
    std::map<std::int64_t, sim::GrainLedger> all;
    for (const EnergyRow& row :
         rows<EnergyRow>("grain_energies", "", [](auto&row, auto&e) { visit_energy(row, e); }))
      all[row.number] = row.ledger;
    for (const MomentumRow& row :
         rows<MomentumRow>("grain_momenta", "", [](auto&row, auto&m) { visit_momentum(row, m); })) {
      sim::GrainLedger& l = all[row.number];
      const auto a = static_cast<std::size_t>(
          std::find(kMomentumAxes.begin(), kMomentumAxes.end() - 1, row.axis) -
          kMomentumAxes.begin());
      l.walls_impulse[a] = row.walls;
      l.damping_impulse[a] = row.damping;
      l.stopped_impulse[a] = row.stopped;
      l.momentum_start[a] = row.start;
      l.momentum_end[a] = row.end;
    }
    return all;
  }

  void read(StageRow& stage) const {
    const auto perturbations = rows<lab::ReportedPerturbation>(
        "grain_perturbations", "", [](auto& row, auto& p) { visit_perturbation(row, p); });
    const auto probes =
        rows<ProbeRow>("grain_probes", "number", [](auto& row, auto& p) { visit_probe(row, p); });
    auto points = rows<sim::GrainPathPoint>("grain_points", "number",
                                            [](auto& row, auto& p) { visit_point(row, p); });
    const auto paths =
        rows<PathRow>("grain_paths", "", [](auto& row, auto& p) { visit_path(row, p); });
    if (!perturbations.empty())
      stage.told.came = perturbation(stage, perturbations.front());
    else if (!probes.empty())
      stage.told.came = rose(stage, probes);
    else if (!paths.empty() || !points.empty())
      stage.told.came = path(stage, paths, std::move(points));
    else
      stage.told.came = rest(stage);
    if (!probes.empty()) return;
    if (const auto kept = ledgers(); !kept.empty()) stage.told.ledger = kept.begin()->second;
  }

 private:
  template <class T, class Visit>
  std::vector<T> rows(const char* table, const char* order, const Visit& visit) const {
    return select_rows<T>(database_, table, {{"run_id", run_}, {"stage", stage_}}, visit, order);
  }

  lab::ReportedGrainPath path(const StageRow& stage, const std::vector<PathRow>& asked,
                              std::vector<sim::GrainPathPoint> points) const {
    lab::ReportedGrainPath came;
    came.points = std::move(points);
    came.end = of_word<sim::GrainPathEnd>(stage.ending);
    if (asked.empty()) {
      as_far_as_known(came, stage);
      return came;
    }
    came.path = asked.front().path;
    came.path.kind = of_word<sim::GrainPathKind>(asked.front().kind);
    for (const MarkRow& mark :
         rows<MarkRow>("grain_marks", "number", [](auto&row, auto&m) { visit_mark(row, m); }))
      came.marks.push_back({mark.name, mark.passed ? std::optional(mark.at) : std::nullopt});
    return came;
  }

  /// A path that an older version stored: its action and points say what it was and where it went.
  static void as_far_as_known(lab::ReportedGrainPath& came, const StageRow& stage) {
    came.marks_stored = false;
    came.path.kind = stage.strain_path_ratio            ? sim::GrainPathKind::strain_path
                     : stage.told.action == "isotropic" ? sim::GrainPathKind::isotropic
                                                        : sim::GrainPathKind::drained;
    came.path.ratio = stage.strain_path_ratio.value_or(1);
    came.path.samples = 0;
    if (!came.points.empty())
      came.path.strain_rate_per_s = std::copysign(1, came.points.back().strain.axial);
  }

  lab::ReportedGrainRest rest(const StageRow& stage) const {
    constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
    lab::ReportedGrainRest came;
    const auto found =
        rows<RestRow>("grain_rests", "", [](auto& row, auto& r) { visit_rest(row, r); });
    if (!found.empty()) {
      came.strain_held = found.front().held == "walls";
      came.rest = found.front().rest;
    } else {
      came.strain_held = stage.told.action == "equilibrium";
      came.rest.settling.steps = lab::kNotStored;
      came.rest.settling.unbalanced = came.rest.settling.stress_error_pa =
          came.rest.path_stress_pa = kNaN;
    }
    came.rest.at_rest = came.rest.settling.at_rest = stage.at_rest == 1;
    return came;
  }

  lab::ReportedGrainRose rose(const StageRow& stage, const std::vector<ProbeRow>& probes) const {
    lab::ReportedGrainRose came;
    const auto& walls = stage.told.after.wall_stress_pa;
    came.made.stress = {walls[sim::kAxial], walls[sim::kRadial[0]]};
    const auto found =
        rows<RoseRow>("grain_roses", "", [](auto& row, auto& r) { visit_rose(row, r); });
    if (!found.empty()) came.kind = of_word<sim::ProbeKind>(found.front().kind);
    const auto kept = ledgers();
    const auto gaps =
        rows<GapRow>("grain_gaps", "number", [](auto& row, auto& g) { visit_gap(row, g); });
    for (std::size_t k = 0; k < probes.size(); ++k) {
      const ProbeRow& row = probes[k];
      sim::GrainProbe probe = row.probe;
      probe.angle = row.angle.value_or(0);
      probe.norm_pa = row.norm_pa.value_or(0);
      if (came.kind == sim::ProbeKind::strain && row.angle)
        probe.norm_strain = found.front().norm_strain.value_or(0);
      const auto ledger = kept.find(static_cast<std::int64_t>(k));
      probe.ledger = ledger != kept.end() ? ledger->second : lab::ledger_not_stored();
      put_gap(probe.work, k < gaps.size() ? std::optional(gaps[k]) : std::nullopt);
      if (std::isnan(probe.work.normal_part)) {
        came.parts_stored = false;
        sum_of_parts(probe.work, row);
      }
      if (!row.angle) {
        came.made.rose.null_probe = probe;
        continue;
      }
      came.norm_pa = probe.norm_pa;
      came.made.angles.push_back(probe.angle);
      came.made.rose.probes.push_back(probe);
    }
    if (!found.empty()) {
      came.norm_pa = found.front().norm_pa.value_or(0);
      came.norm_strain = found.front().norm_strain.value_or(0);
      came.made.stress = found.front().stress;
    }
    return came;
  }

  static void put_gap(sim::GrainWork& work, const std::optional<GapRow>& gap) {
    constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
    work.contacts_turning = gap ? gap->contacts_turning : kNaN;
    work.grains_turning = gap ? gap->grains_turning : kNaN;
    work.out_of_balance = gap ? gap->out_of_balance : kNaN;
  }

  /// What an older version stored of contacts: their work as one sum, a share for their numbers.
  static void sum_of_parts(sim::GrainWork& work, const ProbeRow& row) {
    constexpr std::int64_t kWhole = std::int64_t{1} << 40;
    work.normal_part = row.microscopic;
    work.tangential_part = work.non_permanent_part = 0;
    work.contacts_before = kWhole;
    work.opened = std::llround(row.non_permanent_share * static_cast<double>(kWhole));
    work.closed = 0;
  }

  lab::ReportedPerturbation perturbation(const StageRow& stage,
                                         lab::ReportedPerturbation came) const {
    came.end = of_word<sim::PerturbationEnd>(stage.ending);
    came.how.ratio = stage.strain_path_ratio.value_or(came.how.ratio);
    came.seed_stored = !std::isnan(came.how.floating_share);
    came.points =
        rows<sim::PerturbationPoint>("grain_perturbation_points", "number",
                                     [](auto& row, auto& p) { visit_perturbation_point(row, p); });
    return came;
  }

  SQLite::Database& database_;
  std::int64_t run_, stage_;
};

/// A row of grain_runs beside the specimen.
struct RunRow {
  std::string name, source, recorded_at;
  SpecimenRow specimen;
  bool exact = true;
};

void read_specimen(SQLite::Database& database, std::int64_t run, SpecimenRow& row,
                   lab::GrainReport& report) {
  lab::ReportedGrains& told = report.specimen.emplace(row.told);
  told.law.reading = of_word<sim::StiffnessReading>(row.reading);
  told.seed = static_cast<std::uint64_t>(row.seed.value_or(0));
  told.trials = static_cast<int>(row.compactions.value_or(0));
  StageReader(database, run, 0).measures("made", told.measures);
}

void read_stages(SQLite::Database& database, std::int64_t run, lab::GrainReport& report) {
  for (StageRow& row : select_rows<StageRow>(
           database, "grain_stages", {{"run_id", run}},
           [](auto&row, StageRow&s) {
             s.told.before = s.told.after = lab::measures_not_stored();
             visit_stage(row, s);
           },
           "number")) {
    auto& after = row.told.after.wall_stress_pa;
    after[sim::kRadial[0]] = after[sim::kRadial[1]] = row.radial_stress_pa;
    row.told.seconds = row.seconds.value_or(0);
    // An older version: counted from the start of the stage itself.
    auto& start = row.told.strain_before;
    if (std::isnan(start.axial) || std::isnan(start.radial)) start = {};
    const StageReader reader(database, run, row.number);
    reader.measures("before", row.told.before);
    reader.measures("after", row.told.after);
    reader.read(row);
    report.stages.push_back(std::move(row.told));
  }
}

}  // namespace

StoredGrainRun read_grain_run(SQLite::Database& database, std::int64_t id) {
  auto found = select_rows<RunRow>(database, "grain_runs", {{"id", id}}, [](auto& row, RunRow& r) {
    r.specimen.told.measures = lab::measures_not_stored();
    row("name", r.name);
    row("source", r.source);
    row("recorded_at", r.recorded_at);
    visit_specimen(row, r.specimen);
    if constexpr (std::is_same_v<std::decay_t<decltype(row)>, RowReader>) r.exact = row.exact();
  });
  if (found.empty())
    throw lab::BadInput(fmt::format(
        "grain run {} does not exist; `triax query grain_runs` lists all grain runs", id));
  StoredGrainRun run;
  run.id = id;
  SQLite::Statement seen(
      database, "SELECT status, last_sign_of_life, silent_s FROM seen_grain_runs WHERE run_id = ?");
  seen.bind(1, id);
  seen.executeStep();
  Columns columns(seen);
  run.status = status_of(columns.text());
  run.sign_of_life = sign_of_life(columns);
  run.recorded_at = found.front().recorded_at;
  run.whole = found.front().exact;
  run.report.programme = found.front().name;
  run.report.source = found.front().source;
  read_specimen(database, id, found.front().specimen, run.report);
  read_stages(database, id, run.report);
  return run;
}

}  // namespace triax::db
